#pragma once

#include "vtkMRMLStorableNode.h"

class vtkLookupTable;
class vtkScalarsToColors;

/// Named colours, by index.
class VTK_MRML_EXPORT vtkMRMLColorNode : public vtkMRMLStorableNode
{
public:
  vtkTypeMacro(vtkMRMLColorNode, vtkMRMLStorableNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;

  enum
  {
    User = 13,
    File = 14,
  };
  enum
  {
    TypeModifiedEvent = 20002
  };
  virtual void SetType(int type);
  vtkGetMacro(Type, int);
  void SetTypeToUser() { this->SetType(User); }
  void SetTypeToFile() { this->SetType(File); }

  const char* GetColorName(int ind);
  int GetColorIndexByName(const char* name);
  std::string GetColorNameWithoutSpaces(int ind, const char* subst);
  int SetColorName(int ind, const char* name);
  int SetColorNameWithSpaces(int ind, const char* name, const char* subst);
  virtual int GetNumberOfColors() { return 0; }
  virtual bool GetColor(int ind, double color[4]);
  virtual vtkLookupTable* GetLookupTable() { return nullptr; }
  virtual vtkScalarsToColors* GetScalarsToColors();
  /// The name of colours that have none.
  vtkSetStringMacro(NoName);
  vtkGetStringMacro(NoName);

protected:
  vtkMRMLColorNode();
  ~vtkMRMLColorNode() override;
  vtkMRMLColorNode(const vtkMRMLColorNode&) = delete;
  void operator=(const vtkMRMLColorNode&) = delete;

  int Type = -1;
  std::vector<std::string> Names;
  char* NoName = nullptr;
};
