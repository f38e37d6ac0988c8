#ifndef __vtkMRMLFaceToBoneOptional_h
#define __vtkMRMLFaceToBoneOptional_h

#include "vtkMRMLFaceToBoneText.h"

#include <algorithm>

/// Numbers that may be absent.
template <int Count>
struct vtkMRMLFaceToBoneOptional
{
  bool Has = false;
  double Values[Count] = {};

  /// Whether this changed anything.
  bool Set(const double* values)
  {
    if (this->Has && std::equal(values, values + Count, this->Values))
      return false;
    std::copy(values, values + Count, this->Values);
    return this->Has = true;
  }
  bool Get(double* values) const
  {
    if (this->Has)
      std::copy(this->Values, this->Values + Count, values);
    return this->Has;
  }
  bool Remove()
  {
    const bool had = this->Has;
    this->Has = false;
    return had;
  }
  std::string ToText() const
  {
    return this->Has ? vtkMRMLFaceToBoneText::FromNumbers(this->Values, Count) : std::string();
  }
  void FromText(const std::string& text)
  {
    this->Has = vtkMRMLFaceToBoneText::ToNumbers(text, this->Values, Count);
  }
};

#endif
