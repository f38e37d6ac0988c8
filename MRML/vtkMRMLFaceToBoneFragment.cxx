#include "vtkMRMLFaceToBoneFragment.h"

#include "vtkMRMLFaceToBoneText.h"

namespace
{

constexpr std::size_t LongestName = 40;

void Add(std::vector<std::string>& pairs, const std::string& key, const std::string& value)
{
  if (!value.empty())
    pairs.push_back(key + "=" + value);
}

} // namespace

bool vtkMRMLFaceToBoneFragment::IsValidName(const std::string& name)
{
  const std::string alphanumeric = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
  return !name.empty() && name.size() <= LongestName &&
         alphanumeric.find(name[0]) != std::string::npos &&
         name.find_first_not_of(alphanumeric + " _-") == std::string::npos;
}

std::string vtkMRMLFaceToBoneFragment::ToText() const
{
  std::vector<std::string> pairs;
  Add(pairs, "name", this->Name);
  Add(pairs, "template", this->Template);
  Add(pairs, "kerfMm", vtkMRMLFaceToBoneText::FromNumber(this->KerfMm));
  Add(pairs, "point", this->Point.ToText());
  Add(pairs, "planeFileNames", vtkMRMLFaceToBoneText::FromList(this->PlaneFileNames));
  for (int c = 0; c < 6; ++c)
  {
    const std::string coordinate = CoordinateNames[c];
    Add(pairs, coordinate + ".locked", this->Rules[c].Locked ? "1" : "");
    Add(pairs, coordinate + ".bounds", this->Rules[c].Bounds.ToText());
    Add(pairs, coordinate + ".prior", this->Rules[c].Prior.ToText());
  }
  Add(pairs, "otherRules", this->OtherRules);
  Add(pairs, "otherSettings", this->OtherSettings);
  return vtkMRMLFaceToBoneText::FromList(pairs);
}

vtkMRMLFaceToBoneFragment vtkMRMLFaceToBoneFragment::FromText(const std::string& text)
{
  vtkMRMLFaceToBoneFragment fragment;
  for (const std::string& pair : vtkMRMLFaceToBoneText::ToList(text))
  {
    const std::size_t equals = pair.find('=');
    if (equals != std::string::npos)
      fragment.Read(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return fragment;
}

void vtkMRMLFaceToBoneFragment::Read(const std::string& key, const std::string& value)
{
  const std::size_t dot = key.find('.');
  if (dot != std::string::npos)
    this->ReadRule(key.substr(0, dot), key.substr(dot + 1), value);
  else if (key == "name")
    this->Name = value;
  else if (key == "template")
    this->Template = value;
  else if (key == "kerfMm")
    vtkMRMLFaceToBoneText::ToNumbers(value, &this->KerfMm, 1);
  else if (key == "point")
    this->Point.FromText(value);
  else if (key == "planeFileNames")
    this->PlaneFileNames = vtkMRMLFaceToBoneText::ToList(value);
  else if (key == "otherRules")
    this->OtherRules = value;
  else if (key == "otherSettings")
    this->OtherSettings = value;
}

void vtkMRMLFaceToBoneFragment::ReadRule(const std::string& coordinate, const std::string& which,
                                         const std::string& value)
{
  const auto* name = std::find(std::begin(CoordinateNames), std::end(CoordinateNames), coordinate);
  if (name == std::end(CoordinateNames))
    return;
  vtkMRMLFaceToBoneRule& rule = this->Rules[name - std::begin(CoordinateNames)];
  if (which == "locked")
    rule.Locked = value == "1";
  else if (which == "bounds")
    rule.Bounds.FromText(value);
  else if (which == "prior")
    rule.Prior.FromText(value);
}
