#include "vtkMRMLUnknownNode.h"

#include "vtkMRMLScene.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLUnknownNode);

void vtkMRMLUnknownNode::ReadXMLAttributes(const char** atts)
{
  this->Superclass::ReadXMLAttributes(atts);
  this->Files.clear();
  vtkMRMLReadXMLBeginMacro(atts);
  const bool isFile =
      !std::strcmp(xmlReadAttName, "fileName") ||
      !std::strncmp(xmlReadAttName, "fileListMember", std::strlen("fileListMember"));
  if (isFile && *xmlReadAttValue)
  {
    const std::string name = this->URLDecodeString(xmlReadAttValue);
    const std::string root = this->GetScene() ? this->GetScene()->GetRootDirectory() : ".";
    this->Files.push_back({xmlReadAttName, vtksys::SystemTools::CollapseFullPath(
                                               name, vtksys::SystemTools::CollapseFullPath(root))});
  }
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLUnknownNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  for (const File& file : this->Files)
  {
    const std::string root = this->GetScene() ? this->GetScene()->GetRootDirectory() : ".";
    const std::string name =
        vtksys::SystemTools::RelativePath(vtksys::SystemTools::CollapseFullPath(root), file.Path);
    of << " " << file.Attribute << "=\""
       << this->XMLAttributeEncodeString(this->URLEncodeString(name.c_str())) << "\"";
  }
}

void vtkMRMLUnknownNode::Copy(vtkMRMLNode* node)
{
  if (auto* source = vtkMRMLUnknownNode::SafeDownCast(node))
  {
    this->TagName = source->TagName;
    this->Files = source->Files;
  }
  this->Superclass::Copy(node);
}

std::vector<std::string> vtkMRMLUnknownNode::GetFiles() const
{
  std::vector<std::string> paths;
  for (const File& file : this->Files)
  {
    paths.push_back(file.Path);
  }
  return paths;
}

void vtkMRMLUnknownNode::SetFiles(const std::vector<std::string>& paths)
{
  for (std::size_t i = 0; i < this->Files.size() && i < paths.size(); ++i)
  {
    this->Files[i].Path = paths[i];
  }
}
