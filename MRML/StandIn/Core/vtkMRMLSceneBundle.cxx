// vtkMRMLScene's data bundles: a folder with the scene and all of its data, and the zip file (.mrb) of
// such a folder.
#include "vtkMRMLScene.h"

#include "vtkArchive.h"
#include "vtkMRMLMessageCollection.h"
#include "vtkMRMLSavedFiles.h"
#include "vtkMRMLStorableNode.h"
#include "vtkMRMLStorageNode.h"
#include "vtkMRMLUnknownNode.h"

#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtksys/Glob.hxx>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace
{

/// A folder that goes with the object.
class TemporaryFolder
{
public:
  /// What a killed program left there goes first.
  explicit TemporaryFolder(const std::string& path)
  {
    vtksys::SystemTools::RemoveADirectory(path);
    if (mkdir(path.c_str(), 0700) == 0)
    {
      this->Path = path;
    }
  }
  ~TemporaryFolder()
  {
    if (!this->Path.empty())
    {
      vtksys::SystemTools::RemoveADirectory(this->Path);
    }
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  std::string Path; ///< empty where it could not be made
};

/// A name of our own below the system's folder for temporary files.
std::string UnpackingFolder()
{
  const char* parent = std::getenv("TMPDIR");
  static int count = 0;
  return std::string(parent && *parent ? parent : "/tmp") + "/mrb~" + std::to_string(getpid()) +
         "-" + std::to_string(++count);
}

} // namespace

std::string vtkMRMLScene::PercentEncode(std::string s)
{
  const std::string plain = " -_.,@#$%^&()[]{}<>+=";
  std::string encoded;
  for (const char c : s)
  {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = std::isalnum(byte) || plain.find(c) != std::string::npos;
    // File systems take UTF-8; what they forbid is written as in URLs.
    char code[8];
    std::snprintf(code, sizeof code, "%%%02x", byte);
    encoded += letter || byte >= 0x80 ? std::string(1, c) : std::string(code);
  }
  return encoded;
}

std::string vtkMRMLScene::CreateUniqueFileName(const std::string& filename,
                                               const std::string& knownExtension)
{
  const std::string extension = knownExtension.empty()
                                    ? vtksys::SystemTools::GetFilenameLastExtension(filename)
                                    : knownExtension;
  std::string base = filename.substr(0, filename.size() - extension.size());
  std::string name = filename;
  int suffix = 0;
  const auto bar = base.find_last_of('_');
  if (bar != std::string::npos && bar + 1 < base.size() &&
      std::all_of(base.begin() + static_cast<std::ptrdiff_t>(bar) + 1, base.end(),
                  [](unsigned char c) { return std::isdigit(c); }) &&
      base.size() - bar < 9)
  {
    suffix = std::stoi(base.substr(bar + 1));
    base.resize(bar);
  }
  while (vtksys::SystemTools::FileExists(name))
  {
    name = base + "_" + std::to_string(++suffix) + extension;
  }
  return name;
}

// --- Writing -----------------------------------------------------------------------------------

bool vtkMRMLScene::WriteToMRB(const char* filename, vtkImageData* thumbnail,
                              vtkMRMLMessageCollection* userMessages)
{
  const std::string path = vtksys::SystemTools::CollapseFullPath(filename ? filename : "");
  const TemporaryFolder work(vtkMRMLSavedFiles::Temporary(path) + ".folder");
  const std::string folder =
      work.Path + "/" + vtksys::SystemTools::GetFilenameWithoutLastExtension(path);
  const bool written =
      !work.Path.empty() && vtksys::SystemTools::MakeDirectory(folder) &&
      this->SaveSceneToSlicerDataBundleDirectory(folder.c_str(), thumbnail, userMessages) &&
      vtkArchive::Zip(path.c_str(), folder.c_str());
  if (!written)
  {
    vtkErrorToMessageCollectionMacro(
        userMessages, "vtkMRMLScene::WriteToMRB",
        "The bundle " << path << " cannot be written: is its folder there, with room?");
  }
  return written;
}

bool vtkMRMLScene::SaveSceneToSlicerDataBundleDirectory(const char* sdbDir, vtkImageData* thumbnail,
                                                        vtkMRMLMessageCollection* userMessages)
{
  const std::string folder = sdbDir ? sdbDir : "";
  if (!vtksys::SystemTools::FileIsFullPath(folder) || !vtksys::SystemTools::FileIsDirectory(folder))
  {
    vtkErrorToMessageCollectionMacro(
        userMessages, "vtkMRMLScene",
        "A bundle needs the absolute name of a folder that exists, not '" << folder << "'");
    return false;
  }
  const std::string data = folder + "/Data";
  vtksys::SystemTools::RemoveADirectory(folder);
  vtksys::SystemTools::MakeDirectory(data);
  const std::string oldURL = this->URL;
  const std::string oldRoot = this->RootDirectory;
  this->MakeFileNamesAbsolute();

  std::vector<vtkMRMLNode*> storables;
  this->GetNodesByClass("vtkMRMLStorableNode", storables);
  for (vtkMRMLNode* one : storables)
  {
    static_cast<vtkMRMLStorableNode*>(one)->AddDefaultStorageNode();
  }
  const std::vector<FileNames> names = this->AllFileNames();
  bool written = true;
  for (const FileNames& one : names)
  {
    written =
        (!one.Node->GetSaveWithScene() || this->SaveFilesInto(data, one, userMessages)) && written;
  }
  const std::string base = folder + "/" + vtksys::SystemTools::GetFilenameName(folder);
  if (thumbnail)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(thumbnail);
    writer->SetFileName((base + ".png").c_str());
    writer->Write();
  }
  written = this->Commit((base + ".mrml").c_str(), userMessages) && written;
  for (const FileNames& one : names)
  {
    SetFileNames(one);
  }
  this->URL = oldURL;
  this->RootDirectory = oldRoot;
  return written;
}

/// Of storage nodes, and of elements of unknown classes.
std::vector<vtkMRMLScene::FileNames> vtkMRMLScene::AllFileNames()
{
  std::vector<FileNames> names;
  for (int n = 0; n < this->GetNumberOfNodes(); ++n)
  {
    vtkMRMLNode* node = this->GetNthNode(n);
    if (auto* storage = vtkMRMLStorageNode::SafeDownCast(node))
    {
      names.push_back({node, storage->FileName ? storage->FileName : "", storage->FileNameList});
    }
    else if (auto* unknown = vtkMRMLUnknownNode::SafeDownCast(node))
    {
      names.push_back({node, "", unknown->GetFiles()});
    }
  }
  return names;
}

void vtkMRMLScene::SetFileNames(const FileNames& names)
{
  if (auto* storage = vtkMRMLStorageNode::SafeDownCast(names.Node))
  {
    storage->SetFileName(names.Name.empty() ? nullptr : names.Name.c_str());
    storage->FileNameList = names.List;
  }
  else if (auto* unknown = vtkMRMLUnknownNode::SafeDownCast(names.Node))
  {
    unknown->SetFiles(names.List);
  }
}

/// The node whose data a storage node's file holds, where they are in memory.
vtkMRMLStorableNode* vtkMRMLScene::DataInMemory(vtkMRMLNode* storageNode)
{
  auto* storage = vtkMRMLStorageNode::SafeDownCast(storageNode);
  vtkMRMLStorableNode* node = storage ? storage->GetStorableNode() : nullptr;
  const bool failed = node && storage->FailedTime.GetMTime() > 0 &&
                      storage->FailedTime > storage->StoredTime &&
                      storage->FailedTime > node->StorableModifiedTime;
  return failed ? nullptr : node;
}

bool vtkMRMLScene::SaveFilesInto(const std::string& folder, const FileNames& names,
                                 vtkMRMLMessageCollection* messages)
{
  if (vtkMRMLStorableNode* node = this->DataInMemory(names.Node))
  {
    return this->SaveDataInto(folder, static_cast<vtkMRMLStorageNode*>(names.Node), node, messages);
  }
  // Files of what is not in memory go along as they are.
  bool written = true;
  const auto taken = [this, &folder, &written](const std::string& source)
  {
    if (source.empty())
    {
      return source;
    }
    const std::string path =
        CreateUniqueFileName(folder + "/" + vtksys::SystemTools::GetFilenameName(source));
    written = this->CopyFileOrHeld(source, path) && written;
    return path;
  };
  FileNames moved = names;
  moved.Name = taken(names.Name);
  std::transform(names.List.begin(), names.List.end(), moved.List.begin(), taken);
  SetFileNames(moved);
  return written;
}

/// As Slicer does, in the format that bundles have for this kind of data.
bool vtkMRMLScene::SaveDataInto(const std::string& folder, vtkMRMLStorageNode* storage,
                                vtkMRMLStorableNode* node, vtkMRMLMessageCollection* messages)
{
  const std::string name = node->GetName() ? node->GetName() : "Data";
  const std::string source = storage->GetFullNameFromFileName();
  const char* ending = storage->GetDefaultWriteFileExtension();
  const std::string extension =
      ending ? std::string(".") + vtksys::SystemTools::LowerCase(ending) : "";
  const std::string base =
      source.empty() ? name : storage->GetFileNameWithoutExtension(source.c_str());
  storage->ResetFileNameList();
  storage->SetFileName(
      CreateUniqueFileName(folder + "/" + PercentEncode(base) + extension, extension).c_str());
  storage->GetUserMessages()->ClearMessages();
  const bool written = storage->WriteData(node) != 0;
  if (messages)
  {
    messages->AddMessages(storage->GetUserMessages(), name + ": ");
  }
  return written;
}

bool vtkMRMLScene::CopyFileOrHeld(const std::string& source, const std::string& path)
{
  const auto held = this->HeldFiles.find(source);
  if (held == this->HeldFiles.end())
  {
    return !vtksys::SystemTools::FileExists(source, true) ||
           vtksys::SystemTools::CopyFileAlways(source, path).IsSuccess();
  }
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetParentDirectory(path));
  std::ofstream file(path, std::ios::binary);
  file << *held->second;
  file.close();
  return file.good();
}

// --- Reading -----------------------------------------------------------------------------------

std::string vtkMRMLScene::UnpackSlicerDataBundle(const char* sdbFilePath,
                                                 const char* temporaryDirectory,
                                                 vtkMRMLMessageCollection* userMessages)
{
  std::string fault = "it is damaged, or names files outside of itself";
  std::vector<std::string> scenes;
  if (vtkArchive::UnZip(sdbFilePath, temporaryDirectory))
  {
    vtksys::Glob glob;
    glob.RecurseOn();
    glob.RecurseThroughSymlinksOff();
    glob.FindFiles(std::string(temporaryDirectory) + "/*.mrml");
    scenes = glob.GetFiles();
    fault = "it holds no scene (.mrml)";
  }
  if (scenes.empty() && userMessages)
  {
    userMessages->AddMessage(vtkCommand::ErrorEvent, std::string("The bundle ") + sdbFilePath +
                                                         " cannot be read: " + fault);
  }
  return scenes.empty() ? "" : scenes.front();
}

bool vtkMRMLScene::ReadFromMRB(const char* fullName, bool clear,
                               vtkMRMLMessageCollection* userMessages)
{
  vtkSmartPointer<vtkMRMLMessageCollection> messages = userMessages;
  if (!messages)
  {
    messages = vtkSmartPointer<vtkMRMLMessageCollection>::New();
  }
  const std::string path = vtksys::SystemTools::CollapseFullPath(fullName ? fullName : "");
  const TemporaryFolder work(UnpackingFolder());
  const std::string scene =
      work.Path.empty() ? "" : UnpackSlicerDataBundle(path.c_str(), work.Path.c_str(), messages);
  if (scene.empty())
  {
    if (messages->GetNumberOfMessages() == 0)
    {
      messages->AddMessage(vtkCommand::ErrorEvent, "There is no temporary folder to unpack to");
    }
    return false;
  }
  const std::string oldURL = this->URL;
  const std::string oldRoot = this->RootDirectory;
  this->URL = scene;
  this->ReadFence = work.Path;
  const bool read = clear ? this->Connect(messages) != 0 : this->Import(messages) != 0;
  this->ReadFence.clear();
  const std::string unpacked = vtksys::SystemTools::GetParentDirectory(scene);
  const std::string besides = vtksys::SystemTools::GetParentDirectory(path);
  this->TakeOutOfBundle(unpacked, besides);
  if (read || clear)
  {
    this->URL =
        besides + "/" + vtksys::SystemTools::GetFilenameWithoutLastExtension(path) + ".mrml";
    this->RootDirectory = besides;
  }
  else
  {
    this->URL = oldURL;
    this->RootDirectory = oldRoot;
  }
  return read;
}

/// The unpacked files go: names become those that they will have beside the scene, and what is not in
/// memory is held.
void vtkMRMLScene::TakeOutOfBundle(const std::string& unpacked, const std::string& besides)
{
  const auto renamed = [&](vtkMRMLNode* node, const std::string& name)
  {
    if (name.rfind(unpacked + "/", 0) != 0)
    {
      return name;
    }
    const std::string path = besides + name.substr(unpacked.size());
    std::ifstream file(name, std::ios::binary);
    if (file && !this->DataInMemory(node))
    {
      this->HeldFiles[path] = std::make_shared<const std::string>(
          std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return path;
  };
  for (FileNames names : this->AllFileNames())
  {
    const bool ofBundle =
        names.Name.rfind(unpacked + "/", 0) == 0 ||
        std::any_of(names.List.begin(), names.List.end(),
                    [&](const std::string& name) { return name.rfind(unpacked + "/", 0) == 0; });
    if (!ofBundle)
    {
      continue;
    }
    names.Name = renamed(names.Node, names.Name);
    for (std::string& name : names.List)
    {
      name = renamed(names.Node, name);
    }
    SetFileNames(names);
    if (vtkMRMLStorableNode* node = this->DataInMemory(names.Node))
    {
      node->StorableModified(); // its file is not there
    }
  }
}
