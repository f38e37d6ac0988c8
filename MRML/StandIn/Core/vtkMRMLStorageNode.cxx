#include "vtkMRMLStorageNode.h"

#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLSavedFiles.h"
#include "vtkMRMLScene.h"
#include "vtkMRMLStorableNode.h"

#include <vtkStringArray.h>

#include <algorithm>

vtkMRMLStorageNode::vtkMRMLStorageNode()
    : SupportedReadFileTypes(vtkStringArray::New()), SupportedWriteFileTypes(vtkStringArray::New()),
      UserMessages(vtkMRMLMessageCollection::New())
{
  this->HideFromEditors = 1;
}

vtkMRMLStorageNode::~vtkMRMLStorageNode()
{
  delete[] this->FileName;
  this->SupportedReadFileTypes->Delete();
  this->SupportedWriteFileTypes->Delete();
  this->UserMessages->Delete();
}

// --- XML ---------------------------------------------------------------------------------------

std::string vtkMRMLStorageNode::NameForXML(const std::string& name)
{
  if (name.empty() || !this->GetScene() || this->IsFilePathRelative(name.c_str()))
  {
    return this->XMLAttributeEncodeString(this->URLEncodeString(name.c_str()));
  }
  const std::string root =
      vtksys::SystemTools::CollapseFullPath(this->GetScene()->GetRootDirectory());
  const std::string relative = vtksys::SystemTools::RelativePath(root, name);
  // RelativePath gives nothing where there is no way, as between the drives of Windows.
  return this->XMLAttributeEncodeString(
      this->URLEncodeString(relative.empty() ? name.c_str() : relative.c_str()));
}

void vtkMRMLStorageNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  if (this->FileName)
  {
    of << " fileName=\"" << this->NameForXML(this->FileName) << "\"";
  }
  for (int n = 0; n < this->GetNumberOfFileNames(); ++n)
  {
    of << " fileListMember" << n << "=\"" << this->NameForXML(this->FileNameList[n]) << "\"";
  }
  of << " useCompression=\"" << this->UseCompression << "\"";
  if (!this->CompressionParameter.empty())
  {
    of << " compressionParameter=\"" << this->XMLAttributeEncodeString(this->CompressionParameter)
       << "\"";
  }
  if (this->GetDefaultWriteFileExtension())
  {
    of << " defaultWriteFileExtension=\""
       << this->XMLAttributeEncodeString(this->GetDefaultWriteFileExtension()) << "\"";
  }
  of << " readState=\"" << this->ReadState << "\" writeState=\"" << this->WriteState << "\"";
}

void vtkMRMLStorageNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  this->ResetFileNameList();
  vtkMRMLReadXMLBeginMacro(atts);
  if (!std::strcmp(xmlReadAttName, "fileName") && *xmlReadAttValue)
  {
    this->SetFileName(this->AbsoluteName(this->URLDecodeString(xmlReadAttValue)).c_str());
  }
  if (!std::strncmp(xmlReadAttName, "fileListMember", std::strlen("fileListMember")))
  {
    const std::string name = this->URLDecodeString(xmlReadAttValue);
    // Empty names count: they keep the others' places.
    this->AddFileName(name.empty() ? "" : this->AbsoluteName(name).c_str());
  }
  vtkMRMLReadXMLIntMacro(useCompression, UseCompression);
  vtkMRMLReadXMLStdStringMacro(compressionParameter, CompressionParameter);
  vtkMRMLReadXMLStringMacro(defaultWriteFileExtension, DefaultWriteFileExtension);
  vtkMRMLReadXMLIntMacro(readState, ReadState);
  vtkMRMLReadXMLIntMacro(writeState, WriteState);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLStorageNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  auto* source = vtkMRMLStorageNode::SafeDownCast(node);
  if (!source)
  {
    return;
  }
  this->SetFileName(source->FileName);
  this->FileNameList = source->FileNameList;
  this->SetUseCompression(source->UseCompression);
  this->SetCompressionParameter(source->CompressionParameter);
  this->SetReadState(source->ReadState);
  this->SetWriteState(source->WriteState);
  this->SetDefaultWriteFileExtension(source->DefaultWriteFileExtension.c_str());
}

// --- Names -------------------------------------------------------------------------------------

int vtkMRMLStorageNode::IsFilePathRelative(const char* filepath)
{
  return filepath && !vtksys::SystemTools::FileIsFullPath(filepath) ? 1 : 0;
}

std::string vtkMRMLStorageNode::AbsoluteName(const std::string& name)
{
  const std::string root = this->GetScene() ? this->GetScene()->GetRootDirectory() : ".";
  return vtksys::SystemTools::CollapseFullPath(name, vtksys::SystemTools::CollapseFullPath(root));
}

const char* vtkMRMLStorageNode::GetAbsoluteFilePath(const char* inputPath)
{
  this->AbsolutePath = inputPath ? this->AbsoluteName(inputPath) : "";
  return inputPath ? this->AbsolutePath.c_str() : nullptr;
}

std::string vtkMRMLStorageNode::GetFullNameFromFileName()
{
  return this->FileName && *this->FileName ? this->AbsoluteName(this->FileName) : "";
}

std::string vtkMRMLStorageNode::GetFullNameFromNthFileName(int n)
{
  const char* name = this->GetNthFileName(n);
  return name && *name ? this->AbsoluteName(name) : "";
}

const char* vtkMRMLStorageNode::GetNthFileName(int n) const
{
  return n < 0 || n >= this->GetNumberOfFileNames() ? nullptr : this->FileNameList[n].c_str();
}

int vtkMRMLStorageNode::FileNameIsInList(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  return std::any_of(this->FileNameList.begin(), this->FileNameList.end(),
                     [this, &name](const std::string& one)
                     { return this->AbsoluteName(one) == this->AbsoluteName(name); });
}

unsigned int vtkMRMLStorageNode::AddFileName(const char* fileName)
{
  if (fileName && (!*fileName || !this->FileNameIsInList(fileName)))
  {
    this->FileNameList.emplace_back(fileName);
  }
  return static_cast<unsigned int>(this->FileNameList.size());
}

void vtkMRMLStorageNode::ResetFileNameList()
{
  this->FileNameList.clear();
}

void vtkMRMLStorageNode::ResetNthFileName(int n, const char* fileName)
{
  if (fileName && n >= 0 && n < this->GetNumberOfFileNames())
  {
    this->FileNameList[n] = fileName;
  }
}

void vtkMRMLStorageNode::SetDataDirectory(const char* dataDirName)
{
  const auto moved = [dataDirName](const std::string& name)
  { return std::string(dataDirName) + "/" + vtksys::SystemTools::GetFilenameName(name); };
  if (this->FileName)
  {
    this->SetFileName(moved(this->FileName).c_str());
  }
  for (std::string& name : this->FileNameList)
  {
    name = moved(name);
  }
}

void vtkMRMLStorageNode::MakeFileNamesAbsolute()
{
  if (this->FileName && *this->FileName)
  {
    this->SetFileName(this->AbsoluteName(this->FileName).c_str());
  }
  for (std::string& name : this->FileNameList)
  {
    name = name.empty() ? name : this->AbsoluteName(name);
  }
}

bool vtkMRMLStorageNode::LiesWithin(const std::string& folder)
{
  std::vector<std::string> names = this->FileNameList;
  names.push_back(this->FileName ? this->FileName : "");
  return std::all_of(names.begin(), names.end(),
                     [this, &folder](const std::string& name)
                     {
                       return name.empty() ||
                              vtksys::SystemTools::GetRealPath(this->AbsoluteName(name))
                                      .rfind(vtksys::SystemTools::GetRealPath(folder) + "/", 0) ==
                                  0;
                     });
}

std::string vtkMRMLStorageNode::GetLowercaseExtensionFromFileName(const std::string& filename)
{
  std::string extension = vtksys::SystemTools::GetFilenameLastExtension(filename);
  if (extension == ".gz")
  {
    extension = vtksys::SystemTools::GetFilenameLastExtension(
                    vtksys::SystemTools::GetFilenameWithoutLastExtension(filename)) +
                extension;
  }
  return vtksys::SystemTools::LowerCase(extension);
}

std::string vtkMRMLStorageNode::GetFileNameWithoutExtension(const char* fileName)
{
  const std::string path = fileName ? fileName : this->FileName ? this->FileName : "";
  const std::string name = vtksys::SystemTools::GetFilenameName(path);
  const std::string extension = this->GetSupportedFileExtension(name.c_str());
  return name.substr(0, name.size() - extension.size());
}

// --- Types -------------------------------------------------------------------------------------

void vtkMRMLStorageNode::InitializeSupportedReadFileTypes() {}

void vtkMRMLStorageNode::InitializeSupportedWriteFileTypes() {}

vtkStringArray* vtkMRMLStorageNode::GetSupportedReadFileTypes()
{
  if (this->SupportedReadFileTypes->GetNumberOfValues() == 0)
  {
    this->InitializeSupportedReadFileTypes();
  }
  return this->SupportedReadFileTypes;
}

vtkStringArray* vtkMRMLStorageNode::GetSupportedWriteFileTypes()
{
  if (this->SupportedWriteFileTypes->GetNumberOfValues() == 0)
  {
    this->InitializeSupportedWriteFileTypes();
  }
  return this->SupportedWriteFileTypes;
}

void vtkMRMLStorageNode::GetFileExtensionsFromFileTypes(vtkStringArray* inputFileTypes,
                                                        vtkStringArray* outputFileExtensions)
{
  outputFileExtensions->Reset();
  for (vtkIdType i = 0; i < inputFileTypes->GetNumberOfValues(); ++i)
  {
    const std::string type = inputFileTypes->GetValue(i);
    const auto open = type.rfind('(');
    const auto close = type.rfind(')');
    outputFileExtensions->InsertNextValue(
        open == std::string::npos || close < open ? type : type.substr(open + 1, close - open - 1));
  }
}

std::string vtkMRMLStorageNode::GetSupportedFileExtension(const char* fileName,
                                                          bool includeReadable,
                                                          bool includeWriteable)
{
  const std::string name =
      vtksys::SystemTools::LowerCase(fileName ? fileName : this->GetFullNameFromFileName());
  std::string longest;
  const auto look = [&](vtkStringArray* types)
  {
    vtkNew<vtkStringArray> extensions;
    this->GetFileExtensionsFromFileTypes(types, extensions);
    for (vtkIdType i = 0; i < extensions->GetNumberOfValues(); ++i)
    {
      const std::string extension = vtksys::SystemTools::LowerCase(extensions->GetValue(i));
      if (name.size() > extension.size() && extension.size() > longest.size() &&
          vtksys::SystemTools::StringEndsWith(name, extension.c_str()))
      {
        longest = extension;
      }
    }
  };
  if (includeReadable)
  {
    look(this->GetSupportedReadFileTypes());
  }
  if (includeWriteable)
  {
    look(this->GetSupportedWriteFileTypes());
  }
  return longest;
}

int vtkMRMLStorageNode::SupportedFileType(const char* fileName)
{
  return this->GetSupportedFileExtension(fileName, true, false).empty() ? 0 : 1;
}

const char* vtkMRMLStorageNode::GetDefaultWriteFileExtension()
{
  return this->DefaultWriteFileExtension.empty() ? nullptr
                                                 : this->DefaultWriteFileExtension.c_str();
}

void vtkMRMLStorageNode::SetDefaultWriteFileExtension(const char* ext)
{
  const std::string extension = ext ? ext : "";
  if (extension != this->DefaultWriteFileExtension)
  {
    this->DefaultWriteFileExtension = extension;
    this->Modified();
  }
}

const char* vtkMRMLStorageNode::GetCoordinateSystemTypeAsString(int id)
{
  return id == CoordinateSystemRAS ? "RAS" : id == CoordinateSystemLPS ? "LPS" : "";
}

int vtkMRMLStorageNode::GetCoordinateSystemTypeFromString(const char* name)
{
  const std::string text = name ? name : "";
  // Slicer 4 wrote numbers.
  return text == "RAS" || text == "0"   ? CoordinateSystemRAS
         : text == "LPS" || text == "1" ? CoordinateSystemLPS
                                        : -1;
}

// --- Data --------------------------------------------------------------------------------------

vtkMRMLStorableNode* vtkMRMLStorageNode::GetStorableNode()
{
  std::vector<vtkMRMLNode*> nodes;
  if (this->GetScene())
  {
    this->GetScene()->GetNodesByClass("vtkMRMLStorableNode", nodes);
  }
  for (vtkMRMLNode* node : nodes)
  {
    auto* storable = static_cast<vtkMRMLStorableNode*>(node);
    if (storable->HasStorageNodeID(this->GetID()))
    {
      return storable;
    }
  }
  return nullptr;
}

bool vtkMRMLStorageNode::CanWriteFromReferenceNode(vtkMRMLNode* refNode)
{
  return this->CanReadInReferenceNode(refNode);
}

int vtkMRMLStorageNode::ReadDataInternal(vtkMRMLNode*)
{
  return 0;
}

int vtkMRMLStorageNode::WriteDataInternal(vtkMRMLNode*)
{
  return 0;
}

void vtkMRMLStorageNode::InvalidateFile()
{
  this->StoredTime = vtkTimeStamp();
}

std::string vtkMRMLStorageNode::GetTemporaryFileName()
{
  return vtkMRMLSavedFiles::Temporary(this->GetFullNameFromFileName());
}

int vtkMRMLStorageNode::ReadData(vtkMRMLNode* refNode, bool temporaryFile)
{
  const int read = this->ReadFile(refNode);
  if (!read)
  {
    this->FailedTime.Modified();
  }
  else if (!temporaryFile)
  {
    this->StoredTime.Modified();
  }
  return read;
}

int vtkMRMLStorageNode::ReadFile(vtkMRMLNode* refNode)
{
  if (!refNode || !refNode->GetAddToScene() || !this->CanReadInReferenceNode(refNode))
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "The file's data do not fit the node");
    return 0;
  }
  const std::string path = this->GetFullNameFromFileName();
  if (this->GetScene() && !this->GetScene()->GetReadDataOnLoad())
  {
    return 0;
  }
  if (this->GetScene() && !this->GetScene()->ReadFence.empty() &&
      !this->LiesWithin(this->GetScene()->ReadFence))
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "The file " << path << " lies outside of the bundle");
    return 0;
  }
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "There is no file " << (path.empty() ? "(no name)" : path));
    return 0;
  }
  if (!this->ReadDataInternal(refNode))
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "The file " << path << " cannot be read");
    return 0;
  }
  auto* storable = vtkMRMLStorableNode::SafeDownCast(refNode);
  if (storable && this->GetID())
  {
    storable->SetAndObserveStorageNodeID(this->GetID());
  }
  this->SetReadState(Idle);
  return 1;
}

int vtkMRMLStorageNode::WriteData(vtkMRMLNode* refNode)
{
  this->WriteState = Idle;
  const std::string path = this->GetFullNameFromFileName();
  if (!refNode || !this->CanWriteFromReferenceNode(refNode))
  {
    return 0;
  }
  if (path.empty())
  {
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "The data have no file name to be written to");
    return 0;
  }
  const std::string temporary = this->GetTemporaryFileName();
  const int errors = this->UserMessages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent);
  bool written = this->WriteDataInternal(refNode) != 0 &&
                 vtksys::SystemTools::FileExists(temporary, true) &&
                 this->UserMessages->GetNumberOfMessagesOfType(vtkCommand::ErrorEvent) == errors;
  if (this->WriteState == SkippedNoData)
  {
    return 1;
  }
  const bool staged = this->GetScene() && (this->GetScene()->GetStates() & vtkMRMLScene::SaveState);
  if (written && staged)
  {
    std::vector<std::string>& waiting = this->GetScene()->StagedFiles;
    if (std::find(waiting.begin(), waiting.end(), path) == waiting.end())
    {
      waiting.push_back(path);
    }
  }
  else
  {
    written = written && vtkMRMLSavedFiles::Publish(path);
  }
  if (!written)
  {
    vtksys::SystemTools::RemoveFile(temporary);
    vtkErrorToMessageCollectionMacro(this->UserMessages, this->GetClassName(),
                                     "The file " << path << " cannot be written");
    return 0;
  }
  this->StoredTime.Modified();
  return 1;
}
