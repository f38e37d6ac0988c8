#include "vtkMRMLNode.h"

#include "vtkMRMLScene.h"

#include <vtkCallbackCommand.h>
#include <vtkStringArray.h>

#include <sstream>

namespace
{

/// "a:1;b:2" without its first `separator`; what follows where there is none is empty.
std::pair<std::string, std::string> SplitAt(const std::string& text, char separator)
{
  const auto position = text.find(separator);
  return position == std::string::npos
             ? std::make_pair(text, std::string())
             : std::make_pair(text.substr(0, position), text.substr(position + 1));
}

std::string Replaced(std::string text,
                     const std::vector<std::pair<const char*, const char*>>& pairs)
{
  for (const auto& [from, to] : pairs)
  {
    vtksys::SystemTools::ReplaceString(text, from, to);
  }
  return text;
}

} // namespace

vtkMRMLNode::vtkMRMLNode()
    : MRMLCallbackCommand(vtkCallbackCommand::New()),
      MRMLObserverManager(vtkObserverManager::New()), ContentModifiedEvents(vtkIntArray::New())
{
  this->ContentModifiedEvents->InsertNextValue(vtkCommand::ModifiedEvent);
  this->MRMLCallbackCommand->SetClientData(this);
  this->MRMLCallbackCommand->SetCallback(vtkMRMLNode::MRMLCallback);
  this->MRMLObserverManager->AssignOwner(this);
  this->MRMLObserverManager->GetCallbackCommand()->SetClientData(this);
  this->MRMLObserverManager->GetCallbackCommand()->SetCallback(vtkMRMLNode::MRMLCallback);
}

vtkMRMLNode::~vtkMRMLNode()
{
  this->InvalidateNodeReferences();
  this->NodeReferences.clear();
  this->MRMLObserverManager->Delete();
  this->MRMLCallbackCommand->SetClientData(nullptr);
  this->MRMLCallbackCommand->Delete();
  this->ContentModifiedEvents->Delete();
  delete[] this->ID;
  delete[] this->Name;
  delete[] this->Description;
  delete[] this->SingletonTag;
}

void vtkMRMLNode::PrintSelf(ostream& os, vtkIndent indent)
{
  vtkMRMLPrintBeginMacro(os, indent);
  vtkMRMLPrintStringMacro(ID);
  vtkMRMLPrintStringMacro(ClassName);
  vtkMRMLPrintStringMacro(Name);
  vtkMRMLPrintStringMacro(Description);
  vtkMRMLPrintStringMacro(SingletonTag);
  vtkMRMLPrintBooleanMacro(HideFromEditors);
  vtkMRMLPrintBooleanMacro(Selectable);
  vtkMRMLPrintBooleanMacro(Selected);
  vtkMRMLPrintEndMacro();
  for (const auto& [name, value] : this->Attributes)
  {
    os << indent << "Attribute " << name << ": " << value << "\n";
  }
  for (const auto& [role, references] : this->NodeReferences)
  {
    for (const auto& reference : references)
    {
      os << indent << "Reference " << role << ": " << reference->GetReferencedNodeID() << "\n";
    }
  }
}

bool vtkMRMLNode::HasCopyContent() const
{
  return false;
}

// --- XML ---------------------------------------------------------------------------------------

void vtkMRMLNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLStringMacro(id, ID);
  vtkMRMLReadXMLStringMacro(name, Name);
  vtkMRMLReadXMLStringMacro(description, Description);
  vtkMRMLReadXMLBooleanMacro(hideFromEditors, HideFromEditors);
  vtkMRMLReadXMLBooleanMacro(selectable, Selectable);
  vtkMRMLReadXMLBooleanMacro(selected, Selected);
  vtkMRMLReadXMLStringMacro(singletonTag, SingletonTag);
  vtkMRMLReadXMLBooleanMacro(undoEnabled, UndoEnabled);
  if (!std::strcmp(xmlReadAttName, "attributes"))
  {
    for (const std::string& entry : vtksys::SystemTools::SplitString(xmlReadAttValue, ';'))
    {
      const auto [name, value] = SplitAt(entry, ':');
      if (!name.empty())
      {
        this->SetAttribute(name.c_str(), Replaced(value, {{"%3B", ";"}, {"%25", "%"}}).c_str());
      }
    }
  }
  vtkMRMLReadXMLEndMacro();

  // An attribute of its own for each role is Slicer 4's way; "references" goes before it.
  std::set<std::string> references;
  vtkMRMLReadXMLBeginMacro(atts);
  if (!std::strcmp(xmlReadAttName, "references"))
  {
    this->ParseReferencesAttribute(xmlReadAttValue, references);
  }
  vtkMRMLReadXMLEndMacro();
  vtkMRMLReadXMLBeginMacro(atts);
  const char* found = this->GetReferenceRoleFromMRMLAttributeName(xmlReadAttName);
  const std::string role = found ? found : "";
  if (found && references.count(role) == 0)
  {
    std::istringstream ids(xmlReadAttValue);
    for (std::string id; ids >> id;)
    {
      this->AddNodeReferenceID(role.c_str(), id.c_str());
      references.insert(role);
    }
  }
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLNode::ParseReferencesAttribute(const char* attValue, std::set<std::string>& references)
{
  for (const std::string& entry : vtksys::SystemTools::SplitString(attValue, ';'))
  {
    const auto [role, ids] = SplitAt(entry, ':');
    if (role.empty() || references.count(role) > 0)
    {
      continue;
    }
    std::istringstream words(ids);
    for (std::string id; words >> id;)
    {
      this->AddNodeReferenceID(role.c_str(), id.c_str());
      references.insert(role);
    }
  }
}

void vtkMRMLNode::WriteXML(ostream& of, int)
{
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLStringMacro(id, ID);
  vtkMRMLWriteXMLStringMacro(name, Name);
  vtkMRMLWriteXMLStringMacro(description, Description);
  vtkMRMLWriteXMLBooleanMacro(hideFromEditors, HideFromEditors);
  vtkMRMLWriteXMLBooleanMacro(selectable, Selectable);
  vtkMRMLWriteXMLBooleanMacro(selected, Selected);
  vtkMRMLWriteXMLStringMacro(singletonTag, SingletonTag);
  if (this->UndoEnabled)
  {
    vtkMRMLWriteXMLBooleanMacro(undoEnabled, UndoEnabled);
  }
  vtkMRMLWriteXMLEndMacro();

  std::string attributes;
  for (const auto& [name, value] : this->Attributes)
  {
    attributes += (attributes.empty() ? "" : ";") + this->XMLAttributeEncodeString(name) + ":" +
                  this->XMLAttributeEncodeString(Replaced(value, {{"%", "%25"}, {";", "%3B"}}));
  }
  if (!attributes.empty())
  {
    of << " attributes=\"" << attributes << "\"";
  }
  std::string references;
  for (const auto& [role, list] : this->NodeReferences)
  {
    std::string ids;
    for (const auto& reference : list)
    {
      ids += (ids.empty() ? "" : " ") + std::string(reference->GetReferencedNodeID());
    }
    if (!ids.empty())
    {
      references += this->XMLAttributeEncodeString(role + ":" + ids + ";");
    }
  }
  if (!references.empty())
  {
    of << " references=\"" << references << "\"";
  }
}

void vtkMRMLNode::WriteNodeBodyXML(ostream&, int) {}

const char* vtkMRMLNode::URLEncodeString(const char* inString)
{
  this->EncodedText = !inString ? "(null)"
                                : Replaced(inString, {{"%", "%25"},
                                                      {" ", "%20"},
                                                      {"'", "%27"},
                                                      {">", "%3E"},
                                                      {"<", "%3C"},
                                                      {"\"", "%22"}});
  return this->EncodedText.c_str();
}

const char* vtkMRMLNode::URLDecodeString(const char* inString)
{
  this->EncodedText = !inString ? "(null)"
                                : Replaced(inString, {{"%22", "\""},
                                                      {"%3C", "<"},
                                                      {"%3E", ">"},
                                                      {"%27", "'"},
                                                      {"%20", " "},
                                                      {"%25", "%"}});
  return this->EncodedText.c_str();
}

std::string vtkMRMLNode::XMLAttributeEncodeString(const std::string& inString)
{
  return Replaced(inString, {{"&", "&amp;"},
                             {"\"", "&quot;"},
                             {"'", "&apos;"},
                             {"<", "&lt;"},
                             {">", "&gt;"},
                             {"\n", "&#10;"},
                             {"\r", "&#13;"},
                             {"\t", "&#9;"}});
}

std::string vtkMRMLNode::XMLAttributeDecodeString(const std::string& inString)
{
  return Replaced(
      inString, {{"&quot;", "\""}, {"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}});
}

// --- Copies ------------------------------------------------------------------------------------

void vtkMRMLNode::CopyWithScene(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  if (node->GetScene())
  {
    this->SetScene(node->GetScene());
  }
  if (node->GetID())
  {
    this->SetID(node->GetID());
  }
  this->Copy(node);
}

void vtkMRMLNode::Copy(vtkMRMLNode* node)
{
  if (!node || node == this)
  {
    return;
  }
  MRMLNodeModifyBlocker blocker(this);
  if (node->GetName() && node->GetName()[0])
  {
    this->SetName(node->GetName());
  }
  this->SetHideFromEditors(node->GetHideFromEditors());
  this->SetAddToScene(node->GetAddToScene());
  if (node->GetSingletonTag())
  {
    this->SetSingletonTag(node->GetSingletonTag());
  }
  this->SetUndoEnabled(node->GetUndoEnabled());
  this->CopyContent(node);
  this->CopyReferences(node);
  this->KeptAttributes = node->KeptAttributes;
  this->KeptBody = node->KeptBody;
}

void vtkMRMLNode::CopyContent(vtkMRMLNode* node, bool)
{
  MRMLNodeModifyBlocker blocker(this);
  this->SetDescription(node->GetDescription());
  this->SetSelectable(node->GetSelectable());
  if (this->Attributes != node->Attributes)
  {
    this->Attributes = node->Attributes;
    this->Modified();
  }
}

void vtkMRMLNode::Reset(vtkMRMLNode* defaultNode)
{
  vtkSmartPointer<vtkMRMLNode> fresh = defaultNode;
  if (!fresh)
  {
    fresh = vtkSmartPointer<vtkMRMLNode>::Take(this->CreateNodeInstance());
  }
  const int save = this->SaveWithScene;
  const int hide = this->HideFromEditors;
  const int selectable = this->Selectable;
  const std::string tag = this->SingletonTag ? this->SingletonTag : "";
  const bool singleton = this->SingletonTag != nullptr;

  MRMLNodeModifyBlocker blocker(this);
  this->CopyWithScene(fresh);
  this->SetSaveWithScene(save);
  this->SetHideFromEditors(hide);
  this->SetSelectable(selectable);
  this->SetSingletonTag(singleton ? tag.c_str() : nullptr);
}

// --- Events ------------------------------------------------------------------------------------

int vtkMRMLNode::StartModify()
{
  const int before = this->DisableModifiedEvent;
  this->DisableModifiedEventOn();
  return before;
}

int vtkMRMLNode::EndModify(int previousDisableModifiedEventState)
{
  this->SetDisableModifiedEvent(previousDisableModifiedEventState);
  return previousDisableModifiedEventState ? this->ModifiedEventPending
                                           : this->InvokePendingModifiedEvent();
}

int vtkMRMLNode::GetCustomModifiedEventPending(int eventId)
{
  const auto found = this->CustomModifiedEventPending.find(eventId);
  return found == this->CustomModifiedEventPending.end() ? 0 : found->second;
}

void vtkMRMLNode::Modified()
{
  if (this->DisableModifiedEvent)
  {
    ++this->ModifiedEventPending;
    return;
  }
  this->Superclass::Modified();
}

int vtkMRMLNode::InvokePendingModifiedEvent()
{
  int count = this->ModifiedEventPending;
  if (this->ModifiedEventPending)
  {
    this->ModifiedEventPending = 0;
    this->Superclass::Modified();
  }
  const std::map<int, int> pending = std::move(this->CustomModifiedEventPending);
  this->CustomModifiedEventPending.clear();
  for (const auto& [event, times] : pending)
  {
    count += times;
    this->InvokeEvent(event);
  }
  return count;
}

void vtkMRMLNode::InvokeCustomModifiedEvent(int eventId, void* callData)
{
  if (this->DisableModifiedEvent)
  {
    ++this->CustomModifiedEventPending[eventId];
    return;
  }
  this->InvokeEvent(eventId, callData);
}

void vtkMRMLNode::MRMLCallback(vtkObject* caller, unsigned long eid, void* clientData,
                               void* callData)
{
  auto* self = static_cast<vtkMRMLNode*>(clientData);
  if (!self || self->GetInMRMLCallbackFlag())
  {
    return;
  }
  self->SetInMRMLCallbackFlag(1);
  self->ProcessMRMLEvents(caller, eid, callData);
  self->SetInMRMLCallbackFlag(0);
}

void vtkMRMLNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event, void*)
{
  auto* node = vtkMRMLNode::SafeDownCast(caller);
  if (event == vtkCommand::ModifiedEvent && node && node->GetID() &&
      this->HasNodeReferenceID(nullptr, node->GetID()))
  {
    this->InvokeEvent(vtkMRMLNode::ReferencedNodeModifiedEvent, node);
  }
}

// --- Properties --------------------------------------------------------------------------------

void vtkMRMLNode::SetAttribute(const char* name, const char* value)
{
  if (!name || !*name)
  {
    vtkErrorMacro("SetAttribute: an attribute needs a name");
    return;
  }
  const char* before = this->GetAttribute(name);
  if ((!before && !value) || (before && value && std::string(before) == value))
  {
    return;
  }
  if (value)
  {
    this->Attributes[name] = value;
  }
  else
  {
    this->Attributes.erase(name);
  }
  this->Modified();
}

void vtkMRMLNode::RemoveAttribute(const char* name)
{
  this->SetAttribute(name, nullptr);
}

const char* vtkMRMLNode::GetAttribute(const char* name)
{
  const auto found = this->Attributes.find(name ? name : "");
  return found == this->Attributes.end() ? nullptr : found->second.c_str();
}

std::vector<std::string> vtkMRMLNode::GetAttributeNames()
{
  std::vector<std::string> names;
  for (const auto& attribute : this->Attributes)
  {
    names.push_back(attribute.first);
  }
  return names;
}

void vtkMRMLNode::GetAttributeNames(vtkStringArray* attributeNames)
{
  attributeNames->Reset();
  for (const auto& attribute : this->Attributes)
  {
    attributeNames->InsertNextValue(attribute.first);
  }
}

void vtkMRMLNode::SetID(const char* newID)
{
  const std::string before = this->ID ? this->ID : "";
  const std::string after = newID ? newID : "";
  if ((this->ID != nullptr) == (newID != nullptr) && before == after)
  {
    return;
  }
  delete[] this->ID;
  this->ID = newID ? vtksys::SystemTools::DuplicateString(after.c_str()) : nullptr;
  this->InvokeEvent(vtkMRMLNode::IDChangedEvent,
                    before.empty() ? nullptr : const_cast<char*>(before.c_str()));
  this->Modified();
}
