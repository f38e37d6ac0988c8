#ifndef __vtkMRMLFaceToBoneFragment_h
#define __vtkMRMLFaceToBoneFragment_h

#include "vtkMRMLFaceToBoneOptional.h"

#include <string>
#include <vector>

/// What does an osteotomy node know of one fragment?

/// What one coordinate of its movement may be.
struct vtkMRMLFaceToBoneRule
{
  bool Locked = false;
  vtkMRMLFaceToBoneOptional<2> Bounds; ///< least, most
  vtkMRMLFaceToBoneOptional<2> Prior;  ///< expected value, standard deviation
};

struct vtkMRMLFaceToBoneFragment
{
  static constexpr const char* CoordinateNames[] = {"right", "anterior", "superior",
                                                    "pitch", "roll",     "yaw"};

  std::string Name, Template, OtherRules, OtherSettings;
  std::vector<std::string> PlaneFileNames;
  double KerfMm = 1;
  vtkMRMLFaceToBoneOptional<3> Point; ///< RAS [mm]
  vtkMRMLFaceToBoneRule Rules[6];     ///< in the order of CoordinateNames

  static bool IsValidName(const std::string& name);
  /// The value of an XML attribute: a list of `key=value`; what is not set is left out.
  std::string ToText() const;
  static vtkMRMLFaceToBoneFragment FromText(const std::string& text);

private:
  void Read(const std::string& key, const std::string& value);
  void ReadRule(const std::string& coordinate, const std::string& which, const std::string& value);
};

#endif
