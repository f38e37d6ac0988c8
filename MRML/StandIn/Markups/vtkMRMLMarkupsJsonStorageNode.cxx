#include "vtkMRMLMarkupsJsonStorageNode.h"

#include "vtkMRMLMarkupsJson.h"
#include "vtkMRMLMarkupsNode.h"
#include "vtkMRMLMessageCollection.h"

#include <vtkObjectFactory.h>
#include <vtkStringArray.h>

#include <fstream>
#include <stdexcept>

vtkMRMLNodeNewMacro(vtkMRMLMarkupsJsonStorageNode);

namespace
{

// The name of a format, nothing that is fetched.
const char* const schema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/"
                           "Loadable/Markups/Resources/Schema/"
                           "markups-schema-v1.0.3.json#";

} // namespace

vtkMRMLMarkupsJsonStorageNode::vtkMRMLMarkupsJsonStorageNode()
{
  this->DefaultWriteFileExtension = "mrk.json";
}

void vtkMRMLMarkupsJsonStorageNode::Copy(vtkMRMLNode* node)
{
  this->Superclass::Copy(node);
  if (auto* source = vtkMRMLMarkupsJsonStorageNode::SafeDownCast(node))
  {
    this->KeptJson = source->KeptJson;
  }
}

void vtkMRMLMarkupsJsonStorageNode::InitializeSupportedReadFileTypes()
{
  this->SupportedReadFileTypes->InsertNextValue("Markups JSON (.mrk.json)");
  this->SupportedReadFileTypes->InsertNextValue("Markups JSON (.json)");
}

void vtkMRMLMarkupsJsonStorageNode::InitializeSupportedWriteFileTypes()
{
  this->SupportedWriteFileTypes->InsertNextValue("Markups JSON (.mrk.json)");
  this->SupportedWriteFileTypes->InsertNextValue("Markups JSON (.json)");
}

int vtkMRMLMarkupsJsonStorageNode::ReadDataInternal(vtkMRMLNode* refNode)
{
  const std::string path = this->GetFullNameFromFileName();
  try
  {
    std::ifstream file(path);
    const vtkMRMLMarkupsJson document = vtkMRMLMarkupsJson::parse(file);
    const vtkMRMLMarkupsJson& markup = document.at("markups").at(0);
    bool lps = true;
    vtkMRMLMarkupsFromJson(markup, lps, static_cast<vtkMRMLMarkupsNode*>(refNode));
    this->CoordinateSystem = lps ? CoordinateSystemLPS : CoordinateSystemRAS;
    this->KeptJson = markup.dump();
  }
  catch (const std::exception& exception)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     path << ": " << exception.what());
    return 0;
  }
  return 1;
}

int vtkMRMLMarkupsJsonStorageNode::WriteDataInternal(vtkMRMLNode* refNode)
{
  auto* node = static_cast<vtkMRMLMarkupsNode*>(refNode);
  try
  {
    vtkMRMLMarkupsJson markup = this->KeptJson.empty() ? vtkMRMLMarkupsJson::object()
                                                       : vtkMRMLMarkupsJson::parse(this->KeptJson);
    vtkMRMLMarkupsToJson(node, this->CoordinateSystem == CoordinateSystemLPS, markup);
    vtkMRMLMarkupsJson document;
    document["@schema"] = schema;
    document["markups"] = vtkMRMLMarkupsJson::array({markup});
    std::ofstream file(this->GetTemporaryFileName());
    // Labels that are no UTF-8 are mended, not refused.
    file << document.dump(4, ' ', false, vtkMRMLMarkupsJson::error_handler_t::replace) << "\n";
    file.close();
    return file.good() ? 1 : 0;
  }
  catch (const std::exception& exception)
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(), exception.what());
    return 0;
  }
}
