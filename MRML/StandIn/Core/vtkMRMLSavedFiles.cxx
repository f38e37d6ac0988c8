#include "vtkMRMLSavedFiles.h"

#include <vtksys/SystemTools.hxx>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{

const std::string journalEnd = "end";

std::string Folder(const std::string& path)
{
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

std::string Journal(const std::string& sceneFile)
{
  return vtkMRMLSavedFiles::Temporary(sceneFile) + ".journal";
}

/// The path within the folder; empty where it lies outside.
std::string Within(const std::string& folder, const std::string& path)
{
  return path.rfind(folder, 0) == 0 ? path.substr(folder.size()) : std::string();
}

bool IsPlainRelative(const std::string& path)
{
  const std::string framed = "/" + path + "/";
  return !path.empty() && path.front() != '/' && framed.find("/../") == std::string::npos;
}

/// One name a line: line breaks are written as in URLs.
std::string Escaped(std::string name)
{
  vtksys::SystemTools::ReplaceString(name, "%", "%25");
  vtksys::SystemTools::ReplaceString(name, "\n", "%0A");
  return name;
}

std::string Unescaped(std::string name)
{
  vtksys::SystemTools::ReplaceString(name, "%0A", "\n");
  vtksys::SystemTools::ReplaceString(name, "%25", "%");
  return name;
}

} // namespace

std::string vtkMRMLSavedFiles::Temporary(const std::string& path)
{
  const auto slash = path.rfind('/');
  const auto start = slash == std::string::npos ? 0 : slash + 1;
  return path.substr(0, start) + ".saving~" + path.substr(start);
}

bool vtkMRMLSavedFiles::WriteWhole(const std::string& path, const std::string& content)
{
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
  {
    return false;
  }
  std::size_t done = 0;
  while (done < content.size())
  {
    const ssize_t count = write(file, content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR)
    {
      break;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  const bool whole = done == content.size() && fsync(file) == 0;
  return close(file) == 0 && whole;
}

bool vtkMRMLSavedFiles::Publish(const std::string& path)
{
  return std::rename(Temporary(path).c_str(), path.c_str()) == 0;
}

bool vtkMRMLSavedFiles::PublishAll(const std::string& sceneFile,
                                   const std::vector<std::string>& dataFiles)
{
  const std::string folder = Folder(sceneFile);
  std::string journal;
  for (const std::string& path : dataFiles)
  {
    const std::string within = Within(folder, path);
    if (!within.empty())
    {
      journal += Escaped(within) + "\n";
    }
    else if (!Publish(path))
    {
      return false;
    }
  }
  if (journal.empty())
  {
    return Publish(sceneFile);
  }
  journal += Escaped(Within(folder, sceneFile)) + "\n" + journalEnd + "\n";
  const std::string name = Journal(sceneFile);
  if (!WriteWhole(Temporary(name), journal) || !Publish(name))
  {
    return false;
  }
  Recover(sceneFile);
  return !vtksys::SystemTools::FileExists(Temporary(sceneFile));
}

void vtkMRMLSavedFiles::Recover(const std::string& sceneFile)
{
  const std::string name = Journal(sceneFile);
  std::ifstream journal(name);
  if (!journal)
  {
    return;
  }
  std::vector<std::string> names;
  std::string line;
  while (std::getline(journal, line) && line != journalEnd)
  {
    names.push_back(Unescaped(line));
  }
  if (line == journalEnd)
  {
    for (const std::string& within : names)
    {
      // A journal that somebody else wrote cannot reach out of the folder.
      if (IsPlainRelative(within))
      {
        Publish(Folder(sceneFile) + within);
      }
    }
  }
  unlink(name.c_str());
}
