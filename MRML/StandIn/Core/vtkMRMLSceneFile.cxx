// vtkMRMLScene's way to a .mrml file and back.
#include "vtkMRMLScene.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLParser.h"
#include "vtkMRMLSavedFiles.h"
#include "vtkMRMLStorableNode.h"
#include "vtkMRMLStorageNode.h"
#include "vtkMRMLUnknownNode.h"

#include <vtkCollection.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace
{

bool IsOfAWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-';
}

/// The text with each word that is a key replaced.
std::string WithWordsReplaced(const std::string& text, const std::map<std::string, std::string>& by)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t start = i;
    while (i < text.size() && IsOfAWord(text[i]))
    {
      ++i;
    }
    const std::string word = text.substr(start, i - start);
    const auto found = by.find(word);
    result += found == by.end() ? word : found->second;
    if (i < text.size())
    {
      result += text[i++];
    }
  }
  return result;
}

/// Names of the attributes in ` a="1" b="2"`.
std::set<std::string> AttributeNames(const std::string& xml)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < xml.size();)
  {
    const auto equals = xml.find("=\"", i);
    if (equals == std::string::npos)
    {
      break;
    }
    const auto start = xml.find_first_not_of(" \n", i);
    names.insert(xml.substr(start, equals - start));
    const auto quote = xml.find('"', equals + 2);
    i = quote == std::string::npos ? xml.size() : quote + 1;
  }
  return names;
}

} // namespace

void vtkMRMLScene::SetURL(const char* url)
{
  this->URL = url ? url : "";
}

const char* vtkMRMLScene::GetURL()
{
  return this->URL.c_str();
}

void vtkMRMLScene::SetRootDirectory(const char* dir)
{
  this->RootDirectory = dir ? dir : "";
}

const char* vtkMRMLScene::GetRootDirectory()
{
  return this->RootDirectory.c_str();
}

void vtkMRMLScene::SetSceneXMLString(const std::string& xmlString)
{
  this->SceneXMLString = xmlString;
}

const std::string& vtkMRMLScene::GetSceneXMLString()
{
  return this->SceneXMLString;
}

int vtkMRMLScene::IsFilePathRelative(const char* filepath)
{
  return filepath && !vtksys::SystemTools::FileIsFullPath(filepath) ? 1 : 0;
}

bool vtkMRMLScene::ParseVersion(const char* versionString, std::string& application, int& major,
                                int& minor, int& patch, int& revision)
{
  // "Slicer 5.2.2 31382", and without blank or revision "Slicer4.5.6" as Slicer 4 wrote it
  const std::string text = versionString ? versionString : "";
  const auto digit = text.find_first_of("0123456789");
  if (digit == std::string::npos)
  {
    return false;
  }
  const std::string name = text.substr(0, digit);
  int numbers[4] = {0, 0, 0, 0};
  if (std::sscanf(text.c_str() + digit, "%d.%d.%d %d", &numbers[0], &numbers[1], &numbers[2],
                  &numbers[3]) < 3)
  {
    return false;
  }
  application = name.substr(0, name.find_last_not_of(' ') + 1);
  major = numbers[0];
  minor = numbers[1];
  patch = numbers[2];
  revision = numbers[3];
  return true;
}

// --- Reading -----------------------------------------------------------------------------------

int vtkMRMLScene::Connect(vtkMRMLMessageCollection* userMessages)
{
  const bool undo = this->GetUndoFlag();
  this->StartState(BatchProcessState);
  vtkNew<vtkCollection> loaded;
  vtkSmartPointer<vtkMRMLMessageCollection> messages = userMessages;
  if (!messages)
  {
    messages = vtkSmartPointer<vtkMRMLMessageCollection>::New();
  }
  // Parsed before anything goes: a malformed file leaves the scene as it was.
  if (this->LoadNodes(loaded, messages))
  {
    this->Clear(0);
    this->KeptSceneAttributes = this->LoadedSceneAttributes;
    this->AddLoadedNodes(loaded, messages);
    this->StoredTime.Modified();
  }
  this->EndState(BatchProcessState);
  this->SetUndoFlag(undo);
  return messages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) == 0 ? 1 : 0;
}

int vtkMRMLScene::Import(vtkMRMLMessageCollection* userMessages)
{
  const bool wasModified = this->GetModifiedSinceRead();
  vtkSmartPointer<vtkMRMLMessageCollection> messages = userMessages;
  if (!messages)
  {
    messages = vtkSmartPointer<vtkMRMLMessageCollection>::New();
  }
  vtkNew<vtkCollection> loaded;
  if (this->LoadNodes(loaded, messages))
  {
    this->KeptSceneAttributes.insert(this->LoadedSceneAttributes.begin(),
                                     this->LoadedSceneAttributes.end());
    this->AddLoadedNodes(loaded, messages);
  }
  if (!wasModified)
  {
    this->StoredTime.Modified();
  }
  return messages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) == 0 ? 1 : 0;
}

int vtkMRMLScene::LoadNodes(vtkCollection* loaded, vtkMRMLMessageCollection* messages)
{
  this->LoadedSceneAttributes.clear();
  vtkNew<vtkMRMLParser> parser;
  parser->SetMRMLScene(this);
  parser->SetNodeCollection(loaded);
  int parsed = 0;
  if (this->LoadFromXMLString)
  {
    parsed = !this->SceneXMLString.empty() &&
             parser->Parse(this->SceneXMLString.c_str(),
                           static_cast<unsigned int>(this->SceneXMLString.size()));
  }
  else
  {
    const std::string folder = vtksys::SystemTools::GetParentDirectory(this->URL);
    this->RootDirectory = folder.empty() ? "./" : folder + "/";
    vtkMRMLSavedFiles::Recover(this->URL);
    if (!vtksys::SystemTools::FileExists(this->URL, true))
    {
      vtkErrorToMessageCollectionMacro(messages, "vtkMRMLScene",
                                       "There is no scene file " << this->URL);
      return 0;
    }
    parser->SetFileName(this->URL.c_str());
    parsed = parser->Parse();
  }
  if (!parsed || !parser->GetFault().empty())
  {
    loaded->RemoveAllItems();
    vtkErrorToMessageCollectionMacro(
        messages, "vtkMRMLScene",
        "The scene file " << this->URL << " cannot be read: "
                          << (parser->GetFault().empty() ? "it is empty" : parser->GetFault()));
    return 0;
  }
  return 1;
}

void vtkMRMLScene::AddLoadedNodes(vtkCollection* loaded, vtkMRMLMessageCollection* messages)
{
  const bool undo = this->GetUndoFlag();
  this->SetUndoOff();
  this->StartState(ImportState);
  this->ReferencedIDChanges.clear();
  std::vector<vtkMRMLNode*> nodes;
  for (int n = 0; n < loaded->GetNumberOfItems(); ++n)
  {
    nodes.push_back(static_cast<vtkMRMLNode*>(loaded->GetItemAsObject(n)));
    // New ids for nodes that clash are none of the file's either.
    this->AddReservedID(nodes.back()->GetID());
  }
  vtkNew<vtkCollection> added;
  for (vtkMRMLNode* node : nodes)
  {
    added->AddItem(this->AddNode(node));
  }
  for (int n = 0; n < added->GetNumberOfItems(); ++n)
  {
    auto* node = static_cast<vtkMRMLNode*>(added->GetItemAsObject(n));
    this->RemoveStrayReferences(node);
    this->RenameInKept(node);
  }
  this->UpdateNodeReferences(added);
  this->RemoveReservedIDs();
  this->InvokeEvent(NewSceneEvent, nullptr);
  for (int n = 0; n < added->GetNumberOfItems(); ++n)
  {
    auto* node = static_cast<vtkMRMLNode*>(added->GetItemAsObject(n));
    if (node->GetScene() == this && node->GetAddToScene())
    {
      const int errors = messages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent);
      messages->SetObservedObject(node);
      node->UpdateScene(this);
      messages->SetObservedObject(nullptr);
      auto* storable = vtkMRMLStorableNode::SafeDownCast(node);
      vtkMRMLStorageNode* storage = storable ? storable->GetStorageNode() : nullptr;
      // VTK's events are not sent where its messages are turned off.
      if (storage && storage->FailedTime > storage->StoredTime &&
          messages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) == errors)
      {
        messages->AddMessage(vtkCommand::ErrorEvent,
                             std::string("The data of '") + node->GetName() +
                                 "' could not be read:\n" +
                                 storage->GetUserMessages()->GetAllMessagesAsString());
      }
    }
  }
  this->Modified();
  this->RemoveUnusedNodeReferences();
  this->SetUndoFlag(undo);
  this->EndState(ImportState);
}

/// References to nodes that are not the file's: they must not hit a node that happens to have the id.
void vtkMRMLScene::RemoveStrayReferences(vtkMRMLNode* node)
{
  std::set<std::string> valid = this->ReservedIDs;
  if (node->IsA("vtkMRMLUnknownNode"))
  {
    // Its class may know better, such as Slicer's unit nodes, which are in no file.
    std::vector<std::string> roles;
    node->GetNodeReferenceRoles(roles);
    for (const std::string& role : roles)
    {
      std::vector<const char*> ids;
      node->GetNodeReferenceIDs(role.c_str(), ids);
      std::copy_if(ids.begin(), ids.end(), std::inserter(valid, valid.end()),
                   [this](const char* id) { return this->GetNodeByID(id) == nullptr; });
    }
  }
  node->RemoveInvalidReferences(valid);
}

void vtkMRMLScene::KeepUnknown(vtkMRMLNode* node, const char** atts)
{
  std::ostringstream written;
  node->WriteXML(written, 0);
  const std::set<std::string> known = AttributeNames(written.str());
  node->KeptAttributes.clear();
  for (; atts[0] && atts[1]; atts += 2)
  {
    if (known.count(atts[0]) == 0 && !node->GetReferenceRoleFromMRMLAttributeName(atts[0]))
    {
      node->KeptAttributes.emplace_back(atts[0], atts[1]);
    }
  }
}

void vtkMRMLScene::KeepBody(vtkMRMLNode* node, const std::string& body)
{
  node->KeptBody = body;
}

void vtkMRMLScene::RenameInKept(vtkMRMLNode* node)
{
  if (this->ReferencedIDChanges.empty())
  {
    return;
  }
  for (auto& [name, value] : node->KeptAttributes)
  {
    value = WithWordsReplaced(value, this->ReferencedIDChanges);
  }
  node->KeptBody = WithWordsReplaced(node->KeptBody, this->ReferencedIDChanges);
}

// --- Writing -----------------------------------------------------------------------------------

std::string vtkMRMLScene::NodeXML(vtkMRMLNode* node)
{
  std::ostringstream attributes;
  node->WriteXML(attributes, 1);
  const std::set<std::string> known = AttributeNames(attributes.str());
  for (const auto& [name, value] : node->KeptAttributes)
  {
    if (known.count(name) == 0)
    {
      attributes << " " << name << "=\"" << node->XMLAttributeEncodeString(value) << "\"";
    }
  }
  std::ostringstream body;
  node->WriteNodeBodyXML(body, 1);
  const std::string tag = node->GetNodeTagName();
  return " <" + tag + "\n " + attributes.str() + " >" + body.str() + node->KeptBody + "</" + tag +
         ">\n";
}

std::string vtkMRMLScene::SceneXML()
{
  vtkNew<vtkMRMLUnknownNode> encoder;
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<MRML";
  std::map<std::string, std::string> attributes = this->KeptSceneAttributes;
  attributes["version"] = this->Version ? this->Version : "";
  const std::string extensions = this->Extensions ? this->Extensions : "";
  if (!extensions.empty())
  {
    attributes["extensions"] = extensions;
  }
  for (const auto& [name, value] : attributes)
  {
    xml += " " + name + "=\"" + encoder->XMLAttributeEncodeString(value) + "\"";
  }
  xml += ">\n";
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    if (this->GetNthNode(n)->GetSaveWithScene())
    {
      xml += this->NodeXML(this->GetNthNode(n));
    }
  }
  return xml + "</MRML>\n";
}

int vtkMRMLScene::Commit(const char* url, vtkMRMLMessageCollection* userMessages)
{
  if (this->SaveToXMLString)
  {
    this->SceneXMLString = this->SceneXML();
    this->MakeFileNamesAbsolute();
    this->StoredTime.Modified();
    return 1;
  }
  const std::string path = vtksys::SystemTools::CollapseFullPath(url ? url : this->URL.c_str());
  if ((url ? std::string(url) : this->URL).empty())
  {
    vtkErrorToMessageCollectionMacro(userMessages, "vtkMRMLScene::Commit",
                                     "The scene cannot be saved: it has no file name");
    return 0;
  }
  this->RootDirectory = vtksys::SystemTools::GetParentDirectory(path);
  const std::string xml = this->SceneXML();
  this->MakeFileNamesAbsolute();
  if (!this->WriteHeldFiles(userMessages) ||
      !vtkMRMLSavedFiles::WriteWhole(vtkMRMLSavedFiles::Temporary(path), xml) ||
      !vtkMRMLSavedFiles::PublishAll(path, this->StagedFiles))
  {
    vtksys::SystemTools::RemoveFile(vtkMRMLSavedFiles::Temporary(path));
    vtkErrorToMessageCollectionMacro(
        userMessages, "vtkMRMLScene::Commit",
        "The scene file " << path << " cannot be written: is its folder there, with room, and may"
                          << " files be made in it?");
    return 0;
  }
  this->StagedFiles.clear();
  this->StoredTime.Modified();
  return 1;
}

/// So that they stay right where the scene is next saved elsewhere.
void vtkMRMLScene::MakeFileNamesAbsolute()
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass("vtkMRMLStorageNode", nodes);
  for (vtkMRMLNode* node : nodes)
  {
    static_cast<vtkMRMLStorageNode*>(node)->MakeFileNamesAbsolute();
  }
}

/// What came in a bundle and no node holds goes beside the scene.
bool vtkMRMLScene::WriteHeldFiles(vtkMRMLMessageCollection* messages)
{
  for (const FileNames& names : this->AllFileNames())
  {
    std::vector<std::string> paths = names.List;
    paths.push_back(names.Name);
    for (const std::string& path : paths)
    {
      if (this->HeldFiles.count(path) > 0 && !vtksys::SystemTools::FileExists(path) &&
          !this->CopyFileOrHeld(path, path))
      {
        vtkErrorToMessageCollectionMacro(messages, "vtkMRMLScene::Commit",
                                         "The file " << path << " cannot be written");
        return false;
      }
    }
  }
  return true;
}

bool vtkMRMLScene::GetModifiedSinceRead(vtkCollection* modifiedNodes)
{
  const int shown = 0;
  if (modifiedNodes)
  {
    modifiedNodes->RemoveAllItems();
  }
  if (!this->GetFirstNode(nullptr, "vtkMRMLDisplayableNode", &shown))
  {
    return false; // nothing that is worth saving
  }
  bool modified = false;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    vtkMRMLNode* node = this->GetNthNode(n);
    if (node->GetMTime() > this->StoredTime)
    {
      modified = true;
      if (modifiedNodes)
      {
        modifiedNodes->AddItem(node);
      }
    }
  }
  return modified;
}

bool vtkMRMLScene::GetStorableNodesModifiedSinceRead(vtkCollection* modifiedStorableNodes)
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass("vtkMRMLStorableNode", nodes);
  bool modified = false;
  for (vtkMRMLNode* one : nodes)
  {
    auto* node = static_cast<vtkMRMLStorableNode*>(one);
    if (!node->GetHideFromEditors() && node->GetModifiedSinceRead())
    {
      modified = true;
      if (modifiedStorableNodes)
      {
        modifiedStorableNodes->AddItem(node);
      }
    }
  }
  return modified;
}

void vtkMRMLScene::SetStorableNodesModifiedSinceRead()
{
  std::vector<vtkMRMLNode*> nodes;
  this->GetNodesByClass("vtkMRMLStorableNode", nodes);
  for (vtkMRMLNode* node : nodes)
  {
    if (!node->GetHideFromEditors())
    {
      static_cast<vtkMRMLStorableNode*>(node)->StorableModified();
    }
  }
}
