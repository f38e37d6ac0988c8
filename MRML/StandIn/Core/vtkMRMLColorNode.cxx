#include "vtkMRMLColorNode.h"

#include <vtkLookupTable.h>

#include <algorithm>

vtkMRMLColorNode::vtkMRMLColorNode()
{
  this->SetNoName("(none)");
  this->SetTypeToUser();
}

vtkMRMLColorNode::~vtkMRMLColorNode()
{
  delete[] this->NoName;
}

void vtkMRMLColorNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLIntMacro(type, Type);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLColorNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  of << " type=\"" << this->Type << "\"";
}

void vtkMRMLColorNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  if (auto* source = vtkMRMLColorNode::SafeDownCast(node))
  {
    this->SetType(source->Type);
    this->SetNoName(source->NoName);
    this->Names = source->Names;
  }
}

void vtkMRMLColorNode::SetType(int type)
{
  if (this->Type != type)
  {
    this->Type = type;
    this->Modified();
    this->InvokeEvent(vtkMRMLColorNode::TypeModifiedEvent);
  }
}

const char* vtkMRMLColorNode::GetColorName(int ind)
{
  return ind < 0 || ind >= static_cast<int>(this->Names.size()) || this->Names[ind].empty()
             ? this->NoName
             : this->Names[ind].c_str();
}

int vtkMRMLColorNode::GetColorIndexByName(const char* name)
{
  const auto found = std::find(this->Names.begin(), this->Names.end(), name ? name : "");
  return found == this->Names.end() ? -1 : static_cast<int>(found - this->Names.begin());
}

std::string vtkMRMLColorNode::GetColorNameWithoutSpaces(int ind, const char* subst)
{
  std::string name = this->GetColorName(ind);
  vtksys::SystemTools::ReplaceString(name, " ", subst);
  return name;
}

int vtkMRMLColorNode::SetColorName(int ind, const char* name)
{
  if (ind < 0 || ind >= static_cast<int>(this->Names.size()) || !name)
  {
    return 0;
  }
  if (this->Names[ind] != name)
  {
    this->Names[ind] = name;
    this->StorableModified();
    this->Modified();
  }
  return 1;
}

int vtkMRMLColorNode::SetColorNameWithSpaces(int ind, const char* name, const char* subst)
{
  std::string spaced = name ? name : "";
  vtksys::SystemTools::ReplaceString(spaced, subst, " ");
  return this->SetColorName(ind, spaced.c_str());
}

bool vtkMRMLColorNode::GetColor(int, double color[4])
{
  std::fill(color, color + 4, 0.0);
  return false;
}

vtkScalarsToColors* vtkMRMLColorNode::GetScalarsToColors()
{
  return this->GetLookupTable();
}
