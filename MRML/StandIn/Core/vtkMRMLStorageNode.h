#pragma once

#include "vtkMRMLNode.h"

#include <vtkTimeStamp.h>

class vtkMRMLMessageCollection;
class vtkMRMLStorableNode;
class vtkStringArray;

/// The file of a storable node's data: its name, and how it is read and written.
///
/// Names are absolute in memory and relative to the scene in its file. Data are written beside their
/// place and renamed; within the scene's SaveState the scene's Commit renames them all together.
class VTK_MRML_EXPORT vtkMRMLStorageNode : public vtkMRMLNode
{
  friend class vtkMRMLScene;

public:
  vtkTypeMacro(vtkMRMLStorageNode, vtkMRMLNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;

  virtual vtkMRMLStorableNode* GetStorableNode();
  /// \return 0 on failure; GetUserMessages says why
  virtual int ReadData(vtkMRMLNode* refNode, bool temporaryFile = false);
  virtual int WriteData(vtkMRMLNode* refNode);
  virtual bool CanReadInReferenceNode(vtkMRMLNode* refNode) = 0;
  virtual bool CanWriteFromReferenceNode(vtkMRMLNode* refNode);
  vtkMRMLMessageCollection* GetUserMessages() { return this->UserMessages; }
  vtkTimeStamp GetStoredTime() { return this->StoredTime; }
  /// Forgets that the file holds the data.
  void InvalidateFile();

  vtkSetStringMacro(FileName);
  vtkGetStringMacro(FileName);
  std::string GetFullNameFromFileName();
  std::string GetFullNameFromNthFileName(int n);
  unsigned int AddFileName(const char* fileName);
  void ResetFileNameList();
  void ResetNthFileName(int n, const char* fileName);
  int GetNumberOfFileNames() const { return static_cast<int>(this->FileNameList.size()); }
  const char* GetNthFileName(int n) const;
  int FileNameIsInList(const char* fileName);
  /// Moves all names into another folder.
  void SetDataDirectory(const char* dataDirName);
  int IsFilePathRelative(const char* filepath);
  const char* GetAbsoluteFilePath(const char* inputPath);
  std::string GetFileNameWithoutExtension(const char* fileName = nullptr);
  static std::string GetLowercaseExtensionFromFileName(const std::string& filename);

  vtkGetMacro(UseCompression, int);
  vtkSetMacro(UseCompression, int);
  vtkBooleanMacro(UseCompression, int);
  vtkSetMacro(CompressionParameter, std::string);
  vtkGetMacro(CompressionParameter, std::string);

  /// "Poly Data (.vtk)", ...
  virtual vtkStringArray* GetSupportedReadFileTypes();
  virtual vtkStringArray* GetSupportedWriteFileTypes();
  virtual void GetFileExtensionsFromFileTypes(vtkStringArray* inputFileTypes,
                                              vtkStringArray* outputFileExtensions);
  virtual int SupportedFileType(const char* fileName);
  /// The longest that fits, with its dot; empty where none does.
  virtual std::string GetSupportedFileExtension(const char* fileName = nullptr,
                                                bool includeReadable = true,
                                                bool includeWriteable = true);
  virtual const char* GetDefaultWriteFileExtension();
  virtual void SetDefaultWriteFileExtension(const char* ext);

  enum
  {
    Idle,
    Pending,
    Scheduled,
    Transferring,
    TransferDone,
    Cancelled,
    SkippedNoData
  };
  vtkGetMacro(ReadState, int);
  vtkSetMacro(ReadState, int);
  vtkGetMacro(WriteState, int);
  vtkSetMacro(WriteState, int);
  void SetWriteStateSkippedNoData() { this->SetWriteState(SkippedNoData); }

  enum
  {
    CoordinateSystemRAS = 0,
    RAS = 0,
    CoordinateSystemLPS = 1,
    LPS = 1,
    CoordinateSystemType_Last
  };
  static const char* GetCoordinateSystemTypeAsString(int id);
  static int GetCoordinateSystemTypeFromString(const char* name);

protected:
  vtkMRMLStorageNode();
  ~vtkMRMLStorageNode() override;
  vtkMRMLStorageNode(const vtkMRMLStorageNode&) = delete;
  void operator=(const vtkMRMLStorageNode&) = delete;

  virtual int ReadDataInternal(vtkMRMLNode* refNode);
  virtual int WriteDataInternal(vtkMRMLNode* refNode);
  virtual void InitializeSupportedReadFileTypes();
  virtual void InitializeSupportedWriteFileTypes();

  /// Where WriteDataInternal writes: beside GetFullNameFromFileName().
  std::string GetTemporaryFileName();

  vtkStringArray* SupportedReadFileTypes;
  vtkStringArray* SupportedWriteFileTypes;
  std::string DefaultWriteFileExtension;
  vtkMRMLMessageCollection* UserMessages;
  char* FileName = nullptr;
  std::vector<std::string> FileNameList;
  int UseCompression = 1;
  std::string CompressionParameter;
  int ReadState = Idle;
  int WriteState = Idle;
  vtkTimeStamp StoredTime;

private:
  int ReadFile(vtkMRMLNode* refNode);
  std::string AbsoluteName(const std::string& name);
  std::string NameForXML(const std::string& name);
  void MakeFileNamesAbsolute();
  bool LiesWithin(const std::string& folder);

  vtkTimeStamp FailedTime;  ///< when the file last could not be read
  std::string AbsolutePath; ///< what GetAbsoluteFilePath last returned
};
