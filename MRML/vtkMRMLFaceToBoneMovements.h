#ifndef __vtkMRMLFaceToBoneMovements_h
#define __vtkMRMLFaceToBoneMovements_h

#include "vtkMRMLFaceToBoneText.h"

#include <algorithm>
#include <array>
#include <map>

/// Movements by fragment: right, anterior, superior [mm], pitch, roll, yaw [degrees].
class vtkMRMLFaceToBoneMovements
{
public:
  /// Whether this changed anything.
  bool Set(const std::string& fragment, const double movement[6])
  {
    std::array<double, 6> values;
    std::copy(movement, movement + 6, values.begin());
    const auto known = this->ByFragment.find(fragment);
    if (known != this->ByFragment.end() && known->second == values)
      return false;
    this->ByFragment[fragment] = values;
    return true;
  }
  bool Get(const std::string& fragment, double movement[6]) const
  {
    const auto known = this->ByFragment.find(fragment);
    if (known == this->ByFragment.end())
      return false;
    std::copy(known->second.begin(), known->second.end(), movement);
    return true;
  }
  std::vector<std::string> Fragments() const
  {
    std::vector<std::string> fragments;
    for (const auto& movement : this->ByFragment)
      fragments.push_back(movement.first);
    return fragments;
  }
  bool Remove()
  {
    const bool had = !this->ByFragment.empty();
    this->ByFragment.clear();
    return had;
  }
  bool operator!=(const vtkMRMLFaceToBoneMovements& other) const
  {
    return this->ByFragment != other.ByFragment;
  }

  /// A list such as `mid-face:2 11 -5 5 2.5 0`.
  std::string ToText() const
  {
    std::vector<std::string> members;
    for (const auto& movement : this->ByFragment)
      members.push_back(movement.first + ":" +
                        vtkMRMLFaceToBoneText::FromNumbers(movement.second.data(), 6));
    return vtkMRMLFaceToBoneText::FromList(members);
  }
  void FromText(const std::string& text)
  {
    this->ByFragment.clear();
    for (const std::string& member : vtkMRMLFaceToBoneText::ToList(text))
    {
      const std::size_t colon = member.find(':');
      std::array<double, 6> values{};
      if (colon != std::string::npos &&
          vtkMRMLFaceToBoneText::ToNumbers(member.substr(colon + 1), values.data(), 6))
        this->ByFragment[member.substr(0, colon)] = values;
    }
  }

private:
  std::map<std::string, std::array<double, 6>> ByFragment;
};

#endif
