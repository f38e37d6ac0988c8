#include "vtkMRMLParser.h"

#include "vtkMRMLScene.h"
#include "vtkMRMLStorageNode.h"
#include "vtkMRMLUnknownNode.h"

#include <vtkCollection.h>
#include <vtkObjectFactory.h>
#include <vtksys/SystemTools.hxx>

#include <cctype>

vtkStandardNewMacro(vtkMRMLParser);

namespace
{

std::string Encoded(const std::string& text)
{
  std::string encoded;
  for (const char c : text)
  {
    encoded += c == '&'    ? "&amp;"
               : c == '<'  ? "&lt;"
               : c == '>'  ? "&gt;"
               : c == '"'  ? "&quot;"
               : c == '\r' ? "&#13;"
                           : std::string(1, c);
  }
  return encoded;
}

} // namespace

void vtkMRMLParser::StartElement(const char* name, const char** atts)
{
  ++this->Depth;
  if (!this->Fault.empty())
  {
    return;
  }
  if (this->Depth == 1)
  {
    this->StartRoot(name, atts);
  }
  else if (this->Depth == 2)
  {
    this->StartNode(name, atts);
  }
  else if (this->Node)
  {
    this->Body += std::string("<") + name;
    for (; atts[0] && atts[1]; atts += 2)
    {
      this->Body +=
          std::string(" ") + atts[0] + "=\"" + this->Node->XMLAttributeEncodeString(atts[1]) + "\"";
    }
    this->Body += ">";
    this->BodyMeans = true;
  }
}

void vtkMRMLParser::StartRoot(const std::string& name, const char** atts)
{
  if (name != "MRML")
  {
    this->Fault = "the root element is <" + name + ">, not <MRML>";
    return;
  }
  for (; atts[0] && atts[1]; atts += 2)
  {
    const std::string attribute = atts[0];
    if (attribute == "version")
    {
      this->MRMLScene->SetLastLoadedVersion(atts[1]);
    }
    else if (attribute == "extensions")
    {
      this->MRMLScene->SetLastLoadedExtensions(atts[1]);
    }
    else
    {
      this->MRMLScene->LoadedSceneAttributes[attribute] = atts[1];
    }
  }
}

void vtkMRMLParser::StartNode(const std::string& name, const char** atts)
{
  const char* registered = this->MRMLScene->GetClassNameByTag(name.c_str());
  std::string className = registered ? registered : "vtkMRML" + name;
  if (!registered && !vtksys::SystemTools::StringEndsWith(name, "Node"))
  {
    className += "Node";
  }
  auto node =
      vtkSmartPointer<vtkMRMLNode>::Take(this->MRMLScene->CreateNodeByClass(className.c_str()));
  if (!node)
  {
    const auto unknown = vtkSmartPointer<vtkMRMLUnknownNode>::New();
    unknown->SetNodeTagName(name);
    node = unknown;
  }
  if (node->IsA("vtkMRMLStorageNode") || node->IsA("vtkMRMLUnknownNode"))
  {
    node->SetScene(this->MRMLScene); // relative file names start from its folder
  }
  node->ReadXMLAttributes(atts);
  this->MRMLScene->KeepUnknown(node, atts);
  this->Node = node;
  this->Body.clear();
  this->BodyMeans = false;
}

void vtkMRMLParser::CharacterDataHandler(const char* data, int length)
{
  if (this->Depth < 2 || !this->Node)
  {
    return;
  }
  for (int i = 0; i < length; ++i)
  {
    this->BodyMeans = this->BodyMeans || !std::isspace(static_cast<unsigned char>(data[i]));
  }
  this->Body += Encoded(std::string(data, static_cast<std::size_t>(length)));
}

void vtkMRMLParser::EndElement(const char* name)
{
  if (this->Depth > 2 && this->Node)
  {
    this->Body += std::string("</") + name + ">";
  }
  else if (this->Depth == 2 && this->Node)
  {
    if (this->BodyMeans)
    {
      this->MRMLScene->KeepBody(this->Node, this->Body);
    }
    if (this->Node->GetAddToScene())
    {
      this->NodeCollection->AddItem(this->Node);
    }
    this->Node = nullptr;
  }
  --this->Depth;
}

void vtkMRMLParser::ReportXmlParseError()
{
  this->Fault =
      "it is no well-formed XML (near byte " + std::to_string(this->GetXMLByteIndex()) + ")";
}
