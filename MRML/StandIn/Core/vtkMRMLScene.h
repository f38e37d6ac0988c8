#pragma once

#include "vtkMRML.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkTimeStamp.h>

#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkCollection;
class vtkImageData;
class vtkMRMLMessageCollection;
class vtkMRMLNode;
class vtkMRMLStorableNode;
class vtkMRMLStorageNode;

/// The nodes of a case, their references to each other, and the way to files (.mrml, .mrb) and back.
///
/// Files are replaced as a whole (vtkMRMLSavedFiles.h). What a file holds that no registered class
/// knows - elements, attributes, text - stays with the scene and is written back.
class VTK_MRML_EXPORT vtkMRMLScene : public vtkObject
{
public:
  static vtkMRMLScene* New();
  vtkTypeMacro(vtkMRMLScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// \name Files
  ///@{
  void SetURL(const char* url);
  const char* GetURL();
  /// Folder that relative file names start from.
  void SetRootDirectory(const char* dir);
  const char* GetRootDirectory();
  /// Clears the scene and reads the file at the URL. \return 0 where it could not be read whole
  int Connect(vtkMRMLMessageCollection* userMessages = nullptr);
  /// Adds the file's nodes; ids that clash are changed in the added nodes and their references.
  int Import(vtkMRMLMessageCollection* userMessages = nullptr);
  /// Writes the scene, not the nodes' data. \param url  the scene's own where it is null
  int Commit(const char* url = nullptr, vtkMRMLMessageCollection* userMessages = nullptr);
  /// Writes the scene and all data into one zip file.
  bool WriteToMRB(const char* filename, vtkImageData* thumbnail = nullptr,
                  vtkMRMLMessageCollection* userMessages = nullptr);
  bool ReadFromMRB(const char* fullName, bool clear = false,
                   vtkMRMLMessageCollection* userMessages = nullptr);
  /// \return the .mrml file within the folder; empty on failure
  static std::string UnpackSlicerDataBundle(const char* sdbFilePath, const char* temporaryDirectory,
                                            vtkMRMLMessageCollection* userMessages = nullptr);
  /// Writes the scene and all data into an empty folder: NAME.mrml and Data/.
  bool SaveSceneToSlicerDataBundleDirectory(const char* sdbDir, vtkImageData* thumbnail = nullptr,
                                            vtkMRMLMessageCollection* userMessages = nullptr);
  vtkSetMacro(LoadFromXMLString, int);
  vtkGetMacro(LoadFromXMLString, int);
  vtkSetMacro(SaveToXMLString, int);
  vtkGetMacro(SaveToXMLString, int);
  void SetSceneXMLString(const std::string& xmlString);
  const std::string& GetSceneXMLString();
  /// Whether storable nodes read their files when a scene is read.
  vtkSetMacro(ReadDataOnLoad, int);
  vtkGetMacro(ReadDataOnLoad, int);
  int IsFilePathRelative(const char* filepath);
  /// File name without characters that file systems forbid.
  static std::string PercentEncode(std::string s);
  static std::string CreateUniqueFileName(const std::string& filename,
                                          const std::string& knownExtension = "");
  vtkSetStringMacro(LastLoadedVersion);
  vtkGetStringMacro(LastLoadedVersion);
  vtkSetStringMacro(LastLoadedExtensions);
  vtkGetStringMacro(LastLoadedExtensions);
  vtkSetStringMacro(Version);
  vtkGetStringMacro(Version);
  vtkSetStringMacro(Extensions);
  vtkGetStringMacro(Extensions);
  static bool ParseVersion(const char* versionString, std::string& application, int& major,
                           int& minor, int& patch, int& revision);
  bool GetModifiedSinceRead(vtkCollection* modifiedNodes = nullptr);
  bool GetStorableNodesModifiedSinceRead(vtkCollection* modifiedStorableNodes = nullptr);
  void SetStorableNodesModifiedSinceRead();
  vtkGetMacro(StoredTime, vtkMTimeType);
  ///@}

  /// \name Nodes
  ///@{
  /// Removes all nodes (singletons are only reset, unless they are to go too) and the undo stacks.
  void Clear(int removeSingletons = 0);
  void ResetNodes();
  /// A node of that class, set as the class's default node is; not added. For the caller to delete.
  vtkMRMLNode* CreateNodeByClass(const char* className);
  void RegisterNodeClass(vtkMRMLNode* node, const char* tagName);
  void RegisterNodeClass(vtkMRMLNode* node);
  void RegisterAbstractNodeClass(std::string className, std::string typeDisplayName);
  bool IsNodeClassRegistered(const std::string& className);
  void CopyRegisteredNodesToScene(vtkMRMLScene* scene);
  int GetNumberOfRegisteredNodeClasses();
  vtkMRMLNode* GetNthRegisteredNodeClass(int n);
  const char* GetClassNameByTag(const char* tagName);
  const char* GetTagByClassName(const char* className);
  std::string GetTypeDisplayNameByClassName(std::string className);
  void AddDefaultNode(vtkMRMLNode* node);
  vtkMRMLNode* GetDefaultNodeByClass(const char* className);
  void RemoveAllDefaultNodes();
  vtkCollection* GetNodes();
  /// Gives the node an id and, if it has none, a name. A singleton that is there already is
  /// overwritten and returned.
  vtkMRMLNode* AddNode(vtkMRMLNode* nodeToAdd);
  vtkMRMLNode* AddNewNodeByClass(std::string className, std::string nodeBaseName = "");
  vtkMRMLNode* AddNewNodeByClassWithID(std::string className, std::string nodeBaseName,
                                       std::string nodeID);
  vtkMRMLNode* CopyNode(vtkMRMLNode* n);
  /// Also drops all references to the node.
  void RemoveNode(vtkMRMLNode* n);
  int IsNodePresent(vtkMRMLNode* n);
  int GetNumberOfNodes();
  vtkMRMLNode* GetNthNode(int n);
  vtkMRMLNode* GetNodeByID(const char* name);
  vtkMRMLNode* GetNodeByID(std::string name);
  /// For the caller to delete, as the other collections that are returned.
  vtkCollection* GetNodesByName(const char* name);
  vtkMRMLNode* GetFirstNodeByName(const char* name);
  vtkMRMLNode* GetFirstNode(const char* byName = nullptr, const char* byClass = nullptr,
                            const int* byHideFromEditors = nullptr, bool exactNameMatch = true);
  vtkCollection* GetNodesByClassByName(const char* className, const char* name);
  vtkMRMLNode* GetNthNodeByClass(int n, const char* className);
  vtkMRMLNode* GetFirstNodeByClass(const char* className);
  int GetNumberOfNodesByClass(const char* className);
  int GetNodesByClass(const char* className, std::vector<vtkMRMLNode*>& nodes);
  vtkCollection* GetNodesByClass(const char* className);
  std::list<std::string> GetNodeClassesList();
  vtkMRMLNode* GetSingletonNode(const char* singletonTag, const char* className);
  vtkMRMLNode* GetSingletonNode(vtkMRMLNode* n);
  /// "Skin", then "Skin_1", "Skin_2", ...
  std::string GenerateUniqueName(const std::string& baseName);
  const char* GetUniqueNameByString(const char* baseName);
  bool IsReservedID(const std::string& id);
  void AddReservedID(const char* id);
  void RemoveReservedIDs();
  ///@}

  /// \name References, by the referencing nodes
  ///@{
  void AddReferencedNodeID(const char* id, vtkMRMLNode* refrencingNode);
  void RemoveReferencedNodeID(const char* id, vtkMRMLNode* refrencingNode);
  bool IsNodeReferencingNodeID(vtkMRMLNode* referencingNode, const char* id);
  int GetNumberOfNodeReferences();
  void RemoveNodeReferences(vtkMRMLNode* node);
  void RemoveReferencesToNode(vtkMRMLNode* node);
  void RemoveUnusedNodeReferences();
  /// Tells the nodes of ids that an import has changed.
  void UpdateNodeReferences(vtkCollection* checkNodes = nullptr);
  const char* GetChangedID(const char* id);
  /// The node and all that it refers to, directly or through others.
  vtkCollection* GetReferencedNodes(vtkMRMLNode* node, bool recursive = true);
  void GetReferencingNodes(vtkMRMLNode* referencedNode,
                           std::vector<vtkMRMLNode*>& referencingNodes);
  ///@}

  /// \name Undo of nodes whose UndoEnabled is on
  ///@{
  void SetUndoOn() { this->UndoFlag = true; }
  void SetUndoOff() { this->UndoFlag = false; }
  bool GetUndoFlag() { return this->UndoFlag; }
  void SetUndoFlag(bool flag) { this->UndoFlag = flag; }
  void Undo();
  void Redo();
  void ClearUndoStack();
  void ClearRedoStack();
  int GetNumberOfUndoLevels() { return static_cast<int>(this->UndoStack.size()); }
  int GetNumberOfRedoLevels() { return static_cast<int>(this->RedoStack.size()); }
  /// To be called before a change: which nodes there are, and copies of the nodes that will change.
  void SaveStateForUndo();
  void SaveStateForUndo(vtkMRMLNode* node);
  void SaveStateForUndo(vtkCollection* nodes);
  void SaveStateForUndo(std::vector<vtkMRMLNode*> nodes);
  void SetMaximumNumberOfSavedUndoStates(int stackSize);
  vtkGetMacro(MaximumNumberOfSavedUndoStates, int);
  ///@}

  /// \name States and events
  ///@{
  enum StateType
  {
    BatchProcessState = 0x0001,
    CloseState = 0x0002 | BatchProcessState,
    ImportState = 0x0004 | BatchProcessState,
    RestoreState = 0x0008 | BatchProcessState,
    SaveState = 0x0010,
    UndoState = 0x0020,
    RedoState = 0x0040,
  };
  int GetStates() const;
  bool IsBatchProcessing() const { return this->IsInState(BatchProcessState); }
  bool IsClosing() const { return this->IsInState(CloseState); }
  bool IsImporting() const { return this->IsInState(ImportState); }
  bool IsRestoring() const { return this->IsInState(RestoreState); }
  bool IsUndoing() const { return this->IsInState(UndoState); }
  bool IsRedoing() const { return this->IsInState(RedoState); }
  /// Nests; the events are sent for the outermost of a kind.
  void StartState(unsigned long state, int anticipatedMaxProgress = 0);
  void EndState(unsigned long state);
  void ProgressState(unsigned long state, int progress = 0);

  enum SceneEventType
  {
    NodeAboutToBeAddedEvent = 0x2000,
    NodeAddedEvent,
    NodeAboutToBeRemovedEvent,
    NodeRemovedEvent,
    NodeClassRegisteredEvent,
    NewSceneEvent = 66030,
    MetadataAddedEvent = 66032,
    ImportProgressFeedbackEvent,
    SaveProgressFeedbackEvent,

    StateEvent = 0x2000,
    StartEvent = 0x0100,
    EndEvent = 0x0200,
    ProgressEvent = 0x0400,
    StartBatchProcessEvent = StateEvent | StartEvent | BatchProcessState,
    EndBatchProcessEvent = StateEvent | EndEvent | BatchProcessState,
    ProgressBatchProcessEvent = StateEvent | ProgressEvent | BatchProcessState,
    StartCloseEvent = StateEvent | StartEvent | CloseState,
    EndCloseEvent = StateEvent | EndEvent | CloseState,
    ProgressCloseEvent = StateEvent | ProgressEvent | CloseState,
    StartImportEvent = StateEvent | StartEvent | ImportState,
    EndImportEvent = StateEvent | EndEvent | ImportState,
    StartRestoreEvent = StateEvent | StartEvent | RestoreState,
    EndRestoreEvent = StateEvent | EndEvent | RestoreState,
    StartSaveEvent = StateEvent | StartEvent | SaveState,
    EndSaveEvent = StateEvent | EndEvent | SaveState,
    ProgressSaveEvent = StateEvent | ProgressEvent | SaveState,
    StartUndoEvent = StateEvent | StartEvent | UndoState,
    EndUndoEvent = StateEvent | EndEvent | UndoState,
    StartRedoEvent = StateEvent | StartEvent | RedoState,
    EndRedoEvent = StateEvent | EndEvent | RedoState,
  };
  ///@}

protected:
  vtkMRMLScene();
  ~vtkMRMLScene() override;
  vtkMRMLScene(const vtkMRMLScene&) = delete;
  void operator=(const vtkMRMLScene&) = delete;

private:
  friend class vtkMRMLParser;
  friend class vtkMRMLStorageNode;

  bool IsInState(int state) const { return (this->GetStates() & state) == state; }
  void RegisterOwnNodeClasses();
  std::string GenerateUniqueID(vtkMRMLNode* node);
  vtkMRMLNode* AddNodeNoNotify(vtkMRMLNode* n);
  vtkMRMLNode* OverwriteSingleton(vtkMRMLNode* existing, vtkMRMLNode* n);
  void AddLoadedNodes(vtkCollection* loaded, vtkMRMLMessageCollection* messages);
  int LoadNodes(vtkCollection* loaded, vtkMRMLMessageCollection* messages);
  void RemoveStrayReferences(vtkMRMLNode* node);
  void KeepUnknown(vtkMRMLNode* node, const char** atts);
  void KeepBody(vtkMRMLNode* node, const std::string& body);
  void RenameInKept(vtkMRMLNode* node);
  void MakeFileNamesAbsolute();
  std::string NodeXML(vtkMRMLNode* node);
  std::string SceneXML();
  bool WriteHeldFiles(vtkMRMLMessageCollection* messages);

  /// The files that a node names.
  struct FileNames
  {
    vtkMRMLNode* Node;
    std::string Name;
    std::vector<std::string> List;
  };
  std::vector<FileNames> AllFileNames();
  static void SetFileNames(const FileNames& names);
  vtkMRMLStorableNode* DataInMemory(vtkMRMLNode* storageNode);
  bool SaveFilesInto(const std::string& folder, const FileNames& names,
                     vtkMRMLMessageCollection* messages);
  bool SaveDataInto(const std::string& folder, vtkMRMLStorageNode* storage,
                    vtkMRMLStorableNode* node, vtkMRMLMessageCollection* messages);
  bool CopyFileOrHeld(const std::string& source, const std::string& path);
  void TakeOutOfBundle(const std::string& unpacked, const std::string& besides);

  /// A node of an undo level, with a copy of what it held where it was going to change.
  struct SavedNode
  {
    vtkSmartPointer<vtkMRMLNode> Node;
    vtkSmartPointer<vtkMRMLNode> Copy;
  };
  using SavedState = std::vector<SavedNode>;
  SavedState UndoableNodes();
  static void SaveCopy(SavedState& state, vtkMRMLNode* node);
  /// Makes the scene hold what `target` does; `current` is given copies of what that overwrites.
  void RestoreNodes(const SavedState& target, SavedState& current);

  vtkNew<vtkCollection> Nodes;
  std::map<std::string, vtkMRMLNode*> NodeIDs;
  std::map<std::string, int> UniqueIDs;
  std::map<std::string, int> UniqueNames;
  std::string UniqueName;
  std::set<std::string> ReservedIDs;
  std::map<std::string, std::set<std::string>> NodeReferences; ///< referenced id -> referencing ids
  std::map<std::string, std::string> ReferencedIDChanges;

  struct RegisteredClass
  {
    std::string Tag;
    vtkSmartPointer<vtkMRMLNode> Node;
  };
  std::vector<RegisteredClass> RegisteredClasses;
  std::map<std::string, std::string> AbstractClasses;
  std::map<std::string, vtkSmartPointer<vtkMRMLNode>> DefaultNodes;

  std::vector<unsigned long> States;
  std::list<SavedState> UndoStack;
  std::list<SavedState> RedoStack;
  int MaximumNumberOfSavedUndoStates = 20;
  bool UndoFlag = false;

  std::string URL;
  std::string RootDirectory;
  std::string ReadFence; ///< where set, files outside of this folder are not read
  std::string SceneXMLString;
  std::map<std::string, std::string> KeptSceneAttributes;   ///< of the element MRML
  std::map<std::string, std::string> LoadedSceneAttributes; ///< of the file last parsed
  /// Files of a bundle whose content no node holds, by the absolute name beside the scene.
  std::map<std::string, std::shared_ptr<const std::string>> HeldFiles;
  std::vector<std::string> StagedFiles; ///< written, and waiting for the scene file
  int LoadFromXMLString = 0;
  int SaveToXMLString = 0;
  int ReadDataOnLoad = 1;
  char* Version = nullptr;
  char* Extensions = nullptr;
  char* LastLoadedVersion = nullptr;
  char* LastLoadedExtensions = nullptr;
  vtkTimeStamp StoredTime;
  vtkNew<vtkCallbackCommand> DeleteEventCallback;
};
