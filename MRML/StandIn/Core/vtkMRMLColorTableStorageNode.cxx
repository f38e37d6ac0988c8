#include "vtkMRMLColorTableStorageNode.h"

#include "vtkMRMLColorTableNode.h"

#include <vtkObjectFactory.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <fstream>
#include <sstream>

vtkMRMLNodeNewMacro(vtkMRMLColorTableStorageNode);

namespace
{

const int largestIndex = 65535;

struct NamedColor
{
  int Index = -1;
  std::string Name;
  double Rgba[4] = {0.0, 0.0, 0.0, 255.0};
};

} // namespace

vtkMRMLColorTableStorageNode::vtkMRMLColorTableStorageNode()
{
  this->DefaultWriteFileExtension = "ctbl";
}

bool vtkMRMLColorTableStorageNode::CanReadInReferenceNode(vtkMRMLNode* refNode)
{
  return refNode && refNode->IsA("vtkMRMLColorTableNode");
}

void vtkMRMLColorTableStorageNode::InitializeSupportedReadFileTypes()
{
  this->SupportedReadFileTypes->InsertNextValue("Color Table (.ctbl)");
  this->SupportedReadFileTypes->InsertNextValue("Text (.txt)");
}

void vtkMRMLColorTableStorageNode::InitializeSupportedWriteFileTypes()
{
  this->SupportedWriteFileTypes->InsertNextValue("Color Table (.ctbl)");
  this->SupportedWriteFileTypes->InsertNextValue("Text (.txt)");
}

int vtkMRMLColorTableStorageNode::ReadDataInternal(vtkMRMLNode* refNode)
{
  std::ifstream file(this->GetFullNameFromFileName());
  std::vector<NamedColor> colours;
  int count = 0;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    NamedColor colour;
    if (line.empty() || line[0] == '#' || !(words >> colour.Index))
    {
      continue;
    }
    if (!(words >> colour.Name >> colour.Rgba[0] >> colour.Rgba[1] >> colour.Rgba[2]) ||
        colour.Index < 0 || colour.Index > largestIndex)
    {
      return 0;
    }
    words >> colour.Rgba[3];
    for (double& value : colour.Rgba)
    {
      value = std::clamp(value, 0.0, 255.0) / 255.0;
    }
    count = std::max(count, colour.Index + 1);
    colours.push_back(colour);
  }
  auto* table = static_cast<vtkMRMLColorTableNode*>(refNode);
  MRMLNodeModifyBlocker blocker(table);
  table->SetNumberOfColors(count);
  for (const NamedColor& colour : colours)
  {
    table->SetColor(colour.Index, colour.Rgba[0], colour.Rgba[1], colour.Rgba[2], colour.Rgba[3]);
    table->SetColorNameWithSpaces(colour.Index, colour.Name.c_str(), "_");
  }
  return 1;
}

int vtkMRMLColorTableStorageNode::WriteDataInternal(vtkMRMLNode* refNode)
{
  auto* table = static_cast<vtkMRMLColorTableNode*>(refNode);
  std::ofstream file(this->GetTemporaryFileName());
  file << "# Color table file " << this->GetFullNameFromFileName() << "\n# "
       << table->GetNumberOfColors() << " values\n";
  for (int i = 0; i < table->GetNumberOfColors(); ++i)
  {
    const std::string name = table->GetColorNameWithoutSpaces(i, "_");
    if (name == table->GetNoName())
    {
      continue; // Slicer's way: readers make it black and clear
    }
    double colour[4];
    table->GetColor(i, colour);
    file << i << " " << name;
    for (const double value : colour)
    {
      file << " " << vtkMRMLNumberText(value * 255.0);
    }
    file << "\n";
  }
  file.close();
  return file.good() ? 1 : 0;
}
