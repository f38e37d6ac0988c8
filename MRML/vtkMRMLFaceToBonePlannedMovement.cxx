#include "vtkMRMLFaceToBonePlannedMovement.h"

std::string vtkMRMLFaceToBonePlannedMovement::ToText() const
{
  std::vector<std::string> pairs = {"fragment=" + this->Fragment,
                                    "movement=" + this->Movement.ToText(),
                                    "reference=" + this->Reference.ToText()};
  for (int c = 0; c < 6; ++c)
    if (this->Intervals[c].Has)
      pairs.push_back("interval" + std::to_string(c) + "=" + this->Intervals[c].ToText());
  return vtkMRMLFaceToBoneText::FromList(pairs);
}

vtkMRMLFaceToBonePlannedMovement vtkMRMLFaceToBonePlannedMovement::FromText(const std::string& text)
{
  vtkMRMLFaceToBonePlannedMovement planned;
  for (const std::string& pair : vtkMRMLFaceToBoneText::ToList(text))
  {
    const std::size_t equals = pair.find('=');
    const std::string key = pair.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : pair.substr(equals + 1);
    if (key == "fragment")
      planned.Fragment = value;
    else if (key == "movement")
      planned.Movement.FromText(value);
    else if (key == "reference")
      planned.Reference.FromText(value);
    else if (key.size() == 9 && key.compare(0, 8, "interval") == 0 && key[8] >= '0' && key[8] < '6')
      planned.Intervals[key[8] - '0'].FromText(value);
  }
  return planned;
}
