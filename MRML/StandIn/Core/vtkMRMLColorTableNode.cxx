#include "vtkMRMLColorTableNode.h"

#include "vtkMRMLColorTableStorageNode.h"

#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkMRMLNodeNewMacro(vtkMRMLColorTableNode);

vtkMRMLColorTableNode::vtkMRMLColorTableNode()
{
  this->SetNumberOfColors(0);
}

void vtkMRMLColorTableNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLIntMacro(numcolors, NumberOfColors);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLColorTableNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  of << " numcolors=\"" << this->GetNumberOfColors() << "\"";
}

void vtkMRMLColorTableNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  if (auto* source = vtkMRMLColorTableNode::SafeDownCast(node))
  {
    this->LookupTable->DeepCopy(source->LookupTable);
    this->Modified();
  }
}

void vtkMRMLColorTableNode::SetNumberOfColors(int n)
{
  const int count = std::clamp(n, 0, 1000000);
  if (static_cast<int>(this->Names.size()) == count &&
      this->LookupTable->GetNumberOfTableValues() == count)
  {
    return;
  }
  const auto before = static_cast<int>(this->Names.size());
  this->Names.resize(static_cast<std::size_t>(count));
  this->LookupTable->SetNumberOfTableValues(count);
  for (int i = before; i < count; ++i)
  {
    this->LookupTable->SetTableValue(i, 0.0, 0.0, 0.0, 0.0);
  }
  this->LookupTable->SetTableRange(0.0, std::max(count - 1, 0));
  this->StorableModified();
  this->Modified();
}

int vtkMRMLColorTableNode::GetNumberOfColors()
{
  return static_cast<int>(this->LookupTable->GetNumberOfTableValues());
}

int vtkMRMLColorTableNode::SetColor(int entry, double r, double g, double b, double a)
{
  if (entry < 0 || entry >= this->GetNumberOfColors())
  {
    vtkErrorMacro("SetColor: there is no entry " << entry);
    return 0;
  }
  this->LookupTable->SetTableValue(entry, r, g, b, a);
  this->StorableModified();
  this->Modified();
  return 1;
}

int vtkMRMLColorTableNode::SetColor(int entry, double r, double g, double b)
{
  return this->SetColor(entry, r, g, b, 1.0);
}

int vtkMRMLColorTableNode::SetColor(int entry, const char* name, double r, double g, double b,
                                    double a)
{
  MRMLNodeModifyBlocker blocker(this);
  return this->SetColor(entry, r, g, b, a) && this->SetColorName(entry, name) ? 1 : 0;
}

int vtkMRMLColorTableNode::SetOpacity(int entry, double opacity)
{
  double color[4];
  return this->GetColor(entry, color) ? this->SetColor(entry, color[0], color[1], color[2], opacity)
                                      : 0;
}

void vtkMRMLColorTableNode::AddColor(const char* name, double r, double g, double b, double a)
{
  MRMLNodeModifyBlocker blocker(this);
  this->SetNumberOfColors(this->GetNumberOfColors() + 1);
  this->SetColor(this->GetNumberOfColors() - 1, name, r, g, b, a);
}

bool vtkMRMLColorTableNode::GetColor(int entry, double color[4])
{
  if (entry < 0 || entry >= this->GetNumberOfColors())
  {
    return this->Superclass::GetColor(entry, color);
  }
  this->LookupTable->GetTableValue(entry, color);
  return true;
}

vtkMRMLStorageNode* vtkMRMLColorTableNode::CreateDefaultStorageNode()
{
  return vtkMRMLColorTableStorageNode::New();
}
