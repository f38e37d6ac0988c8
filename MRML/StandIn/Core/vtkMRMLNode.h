#pragma once

#include "vtkLoggingMacros.h"
#include "vtkMRML.h"
#include "vtkMRMLNodePropertyMacros.h"
#include "vtkObserverManager.h"

#include <vtkCommand.h>
#include <vtkIntArray.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkCallbackCommand;
class vtkMRMLScene;
class vtkStringArray;

#ifndef vtkSetAndObserveMRMLObjectMacro
#define vtkSetAndObserveMRMLObjectMacro(node, value)                                               \
  {                                                                                                \
    this->MRMLObserverManager->SetAndObserveObject(vtkObjectPointer(&(node)), (value));            \
  };
#endif

#ifndef vtkSetAndObserveMRMLObjectEventsMacro
#define vtkSetAndObserveMRMLObjectEventsMacro(node, value, events)                                 \
  {                                                                                                \
    this->MRMLObserverManager->SetAndObserveObjectEvents(vtkObjectPointer(&(node)), (value),       \
                                                         (events));                                \
  };
#endif

#ifndef vtkMRMLNodeNewMacro
#define vtkMRMLNodeNewMacro(newClass)                                                              \
  vtkStandardNewMacro(newClass);                                                                   \
  vtkMRMLNode* newClass::CreateNodeInstance()                                                      \
  {                                                                                                \
    return newClass::New();                                                                        \
  }
#endif

/// The class copies its content (CopyContent) without its references.
#ifndef vtkMRMLCopyContentMacro
#define vtkMRMLCopyContentMacro(thisClassName)                                                     \
  void CopyContent(vtkMRMLNode* node, bool deepCopy = true) override;                              \
  bool HasCopyContent() const override                                                             \
  {                                                                                                \
    return std::string(#thisClassName) == this->GetClassNameInternal();                            \
  }
#endif

/// As vtkMRMLCopyContentMacro, where the class adds nothing to its parent's content.
#ifndef vtkMRMLCopyContentDefaultMacro
#define vtkMRMLCopyContentDefaultMacro(thisClassName)                                              \
  bool HasCopyContent() const override                                                             \
  {                                                                                                \
    return std::string(#thisClassName) == this->GetClassNameInternal();                            \
  }
#endif

/// What is common to all that lives in a scene: id, name, attributes, references to other nodes by
/// named role, one modified event for a batch of changes, and the way to XML and back.
class VTK_MRML_EXPORT vtkMRMLNode : public vtkObject
{
  friend class vtkMRMLScene;

public:
  vtkTypeMacro(vtkMRMLNode, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// A new node of the same class, for the caller to delete.
  virtual vtkMRMLNode* CreateNodeInstance() = 0;
  virtual const char* GetNodeTagName() = 0;
  virtual const char* GetTypeDisplayName() { return this->GetNodeTagName(); }
  virtual bool HasCopyContent() const;

  /// \param atts  name, value, name, value, ..., nullptr
  virtual void ReadXMLAttributes(const char** atts);
  /// Writes ` name="value"` of each attribute.
  virtual void WriteXML(ostream& of, int indent);
  virtual void WriteNodeBodyXML(ostream& of, int indent);
  virtual void ProcessChildNode(vtkMRMLNode*) {}

  /// Called when all nodes of an imported scene are there.
  virtual void UpdateScene(vtkMRMLScene*) { this->UpdateNodeReferences(); }
  virtual void OnNodeAddedToScene() { this->UpdateNodeReferences(); }

  /// Everything but the id and the scene; the node's class must be the source's or derived from it.
  virtual void Copy(vtkMRMLNode* node);
  /// The node's own content, neither its name nor references.
  virtual void CopyContent(vtkMRMLNode* node, bool deepCopy = true);
  virtual void CopyReferences(vtkMRMLNode* node);
  /// Copy, and the id and the scene too.
  void CopyWithScene(vtkMRMLNode* node);
  virtual void Reset(vtkMRMLNode* defaultNode);

  /// From StartModify to the outermost EndModify the events of Modified and InvokeCustomModifiedEvent
  /// are held back; then each is sent once. \return the state to hand to EndModify
  virtual int StartModify();
  virtual int EndModify(int previousDisableModifiedEventState);
  vtkGetMacro(DisableModifiedEvent, int);
  void SetDisableModifiedEvent(int onOff) { this->DisableModifiedEvent = onOff; }
  void DisableModifiedEventOn() { this->SetDisableModifiedEvent(1); }
  void DisableModifiedEventOff() { this->SetDisableModifiedEvent(0); }
  vtkGetMacro(ModifiedEventPending, int);
  int GetCustomModifiedEventPending(int eventId);
  void Modified() override;
  virtual int InvokePendingModifiedEvent();
  virtual void InvokeCustomModifiedEvent(int eventId, void* callData = nullptr);

  /// Free texts; nullptr removes one.
  void SetAttribute(const char* name, const char* value);
  void RemoveAttribute(const char* name);
  const char* GetAttribute(const char* name);
  std::vector<std::string> GetAttributeNames();
  void GetAttributeNames(vtkStringArray* attributeNames);

  vtkGetMacro(HideFromEditors, int);
  vtkSetMacro(HideFromEditors, int);
  vtkBooleanMacro(HideFromEditors, int);
  vtkGetMacro(Selectable, int);
  vtkSetMacro(Selectable, int);
  vtkBooleanMacro(Selectable, int);
  vtkGetMacro(Selected, int);
  vtkSetMacro(Selected, int);
  vtkBooleanMacro(Selected, int);
  vtkGetMacro(UndoEnabled, bool);
  vtkSetMacro(UndoEnabled, bool);
  vtkBooleanMacro(UndoEnabled, bool);
  vtkGetMacro(SaveWithScene, int);
  vtkSetMacro(SaveWithScene, int);
  vtkBooleanMacro(SaveWithScene, int);
  vtkGetMacro(AddToScene, int);
  vtkSetMacro(AddToScene, int);
  vtkBooleanMacro(AddToScene, int);
  vtkSetStringMacro(Description);
  vtkGetStringMacro(Description);
  vtkSetStringMacro(Name);
  vtkGetStringMacro(Name);
  vtkGetStringMacro(ID);
  /// One node of a class and a tag lives in a scene: adding another overwrites it.
  vtkSetStringMacro(SingletonTag);
  vtkGetStringMacro(SingletonTag);
  void SetSingletonOn() { this->SetSingletonTag("Singleton"); }
  void SetSingletonOff() { this->SetSingletonTag(nullptr); }
  bool IsSingleton() { return this->GetSingletonTag() != nullptr; }

  virtual vtkMRMLScene* GetScene();
  virtual void SetScene(vtkMRMLScene* scene);
  virtual void SetSceneReferences();
  virtual void UpdateReferenceID(const char* oldID, const char* newID);
  /// Drops references to nodes that are no longer in the scene.
  virtual void UpdateReferences();

  virtual void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData);
  vtkGetMacro(InMRMLCallbackFlag, int);
  void SetInMRMLCallbackFlag(int flag) { this->InMRMLCallbackFlag = flag; }
  /// Events that mean that the content has changed.
  vtkGetObjectMacro(ContentModifiedEvents, vtkIntArray);

  const char* URLEncodeString(const char* inString);
  const char* URLDecodeString(const char* inString);
  std::string XMLAttributeEncodeString(const std::string& inString);
  std::string XMLAttributeDecodeString(const std::string& inString);

  /// \name References: ids of other nodes by role, the n-th of each.
  /// A role's name may end with '/': then it stands for all roles that begin with it.
  /// \param events  what of the referenced node reaches ProcessMRMLEvents
  ///@{
  void AddNodeReferenceRole(const char* referenceRole, const char* mrmlAttributeName = nullptr,
                            vtkIntArray* events = nullptr);
  vtkMRMLNode* SetNodeReferenceID(const char* referenceRole, const char* referencedNodeID);
  vtkMRMLNode* AddNodeReferenceID(const char* referenceRole, const char* referencedNodeID);
  vtkMRMLNode* SetNthNodeReferenceID(const char* referenceRole, int n,
                                     const char* referencedNodeID);
  vtkMRMLNode* SetAndObserveNodeReferenceID(const char* referenceRole, const char* referencedNodeID,
                                            vtkIntArray* events = nullptr);
  vtkMRMLNode* AddAndObserveNodeReferenceID(const char* referenceRole, const char* referencedNodeID,
                                            vtkIntArray* events = nullptr);
  /// An empty or null id removes the n-th.
  vtkMRMLNode* SetAndObserveNthNodeReferenceID(const char* referenceRole, int n,
                                               const char* referencedNodeID,
                                               vtkIntArray* events = nullptr);
  void RemoveNthNodeReferenceID(const char* referenceRole, int n);
  /// All roles where the role is null.
  void RemoveNodeReferenceIDs(const char* referenceRole);
  bool HasNodeReferenceID(const char* referenceRole, const char* referencedNodeID);
  int GetNumberOfNodeReferences(const char* referenceRole);
  const char* GetNthNodeReferenceID(const char* referenceRole, int n);
  const char* GetNodeReferenceID(const char* referenceRole);
  vtkMRMLNode* GetNthNodeReference(const char* referenceRole, int n);
  vtkMRMLNode* GetNodeReference(const char* referenceRole);
  void GetNodeReferences(const char* referenceRole, std::vector<vtkMRMLNode*>& nodes);
  void GetNodeReferenceIDs(const char* referenceRole, std::vector<const char*>& referencedNodeIDs);
  void GetNodeReferenceRoles(std::vector<std::string>& roles);
  int GetNumberOfNodeReferenceRoles();
  const char* GetNthNodeReferenceRole(int n);
  ///@}

  enum
  {
    HierarchyModifiedEvent = 16000,
    IDChangedEvent = 16001,
    ReferenceAddedEvent,
    ReferenceModifiedEvent,
    ReferenceRemovedEvent,
    ReferencedNodeModifiedEvent
  };

protected:
  /// One reference: the id, and the node once it is in the scene.
  class VTK_MRML_EXPORT vtkMRMLNodeReference : public vtkObject
  {
  public:
    static vtkMRMLNodeReference* New();
    vtkTypeMacro(vtkMRMLNodeReference, vtkObject);
    vtkSetStringMacro(ReferenceRole);
    vtkGetStringMacro(ReferenceRole);
    vtkSetStringMacro(ReferencedNodeID);
    vtkGetStringMacro(ReferencedNodeID);
    void SetReferencingNode(vtkMRMLNode* node) { this->ReferencingNode = node; }
    vtkMRMLNode* GetReferencingNode() const { return this->ReferencingNode; }
    void SetReferencedNode(vtkMRMLNode* node) { this->ReferencedNode = node; }
    vtkMRMLNode* GetReferencedNode() const { return this->ReferencedNode; }
    std::vector<int> ObservedEvents; ///< the stand-in's own

  protected:
    vtkMRMLNodeReference() = default;
    ~vtkMRMLNodeReference() override;

    char* ReferenceRole = nullptr;
    char* ReferencedNodeID = nullptr;
    vtkWeakPointer<vtkMRMLNode> ReferencingNode;
    vtkSmartPointer<vtkMRMLNode> ReferencedNode;
  };
  using NodeReferenceListType = std::vector<vtkSmartPointer<vtkMRMLNodeReference>>;

  vtkMRMLNode();
  ~vtkMRMLNode() override;
  vtkMRMLNode(const vtkMRMLNode&) = delete;
  void operator=(const vtkMRMLNode&) = delete;

  static void MRMLCallback(vtkObject* caller, unsigned long eid, void* clientData, void* callData);

  virtual const char* GetReferenceRoleFromMRMLAttributeName(const char* attName);
  virtual const char* GetMRMLAttributeNameFromReferenceRole(const char* refRole);
  virtual bool IsReferenceRoleGeneric(const char* refRole);
  virtual void UpdateNodeReferences(const char* referenceRole = nullptr);
  virtual void UpdateNthNodeReference(const char* referenceRole, int n);
  /// Lets go of the referenced nodes, but keeps their ids.
  virtual void InvalidateNodeReferences();
  void RemoveInvalidReferences(const std::set<std::string>& validNodeIDs);

  virtual void OnNodeReferenceAdded(vtkMRMLNodeReference* reference);
  virtual void OnNodeReferenceModified(vtkMRMLNodeReference* reference);
  virtual void OnNodeReferenceRemoved(vtkMRMLNodeReference* reference);

  void ParseReferencesAttribute(const char* attValue, std::set<std::string>& references);

  vtkCallbackCommand* MRMLCallbackCommand;
  vtkObserverManager* MRMLObserverManager;
  vtkIntArray* ContentModifiedEvents;

  char* ID = nullptr;
  char* Name = nullptr;
  char* Description = nullptr;
  char* SingletonTag = nullptr;
  int HideFromEditors = 0;
  int Selectable = 1;
  int Selected = 0;
  int AddToScene = 1;
  bool UndoEnabled = false;
  int SaveWithScene = 1;
  int InMRMLCallbackFlag = 0;
  vtkWeakPointer<vtkMRMLScene> Scene;
  std::map<std::string, std::string> Attributes;
  std::map<std::string, NodeReferenceListType> NodeReferences;
  std::map<std::string, std::string> NodeReferenceMRMLAttributeNames;
  std::map<std::string, std::vector<int>> NodeReferenceEvents;

private:
  void SetID(const char* newID);
  std::vector<int> EventsOfRole(const std::string& role, vtkIntArray* events);
  void ObserveReferencedNode(vtkMRMLNode* referenced);
  vtkMRMLNode* SetReference(const std::string& role, int n, const std::string& referencedID,
                            const std::vector<int>& events);
  vtkMRMLNode* RemoveReference(const std::string& role, int n);
  void TellSceneOfReference(const std::string& oldID, const std::string& newID);
  void NotifyReference(vtkMRMLNodeReference* reference, vtkMRMLNode* before);

  int DisableModifiedEvent = 0;
  int ModifiedEventPending = 0;
  std::map<int, int> CustomModifiedEventPending;
  std::map<vtkMRMLNode*, std::vector<unsigned long>> ReferenceObservations;
  std::string EncodedText; ///< what URLEncodeString last returned

  /// \name What a file's element held that the class does not know; written back by the scene.
  ///@{
  std::vector<std::pair<std::string, std::string>> KeptAttributes;
  std::string KeptBody; ///< XML between the node's tags
  ///@}
};

/// StartModify in the constructor, EndModify in the destructor.
class VTK_MRML_EXPORT MRMLNodeModifyBlocker
{
public:
  explicit MRMLNodeModifyBlocker(vtkMRMLNode* node)
      : Node(node), WasModifying(node ? node->StartModify() : 0)
  {
  }
  ~MRMLNodeModifyBlocker()
  {
    if (this->Node)
    {
      this->Node->EndModify(this->WasModifying);
    }
  }
  MRMLNodeModifyBlocker(const MRMLNodeModifyBlocker&) = delete;
  void operator=(const MRMLNodeModifyBlocker&) = delete;

  vtkWeakPointer<vtkMRMLNode> Node;
  int WasModifying;
};
