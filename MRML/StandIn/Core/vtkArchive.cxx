#include "vtkArchive.h"

#include "vtkMRMLSavedFiles.h"

#include <vtkObjectFactory.h>
#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <memory>

vtkStandardNewMacro(vtkArchive);

namespace
{

using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;
using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

/// libarchive turns names into the thread's locale and back; in "C" it gives up at an umlaut.
class Utf8Locale
{
public:
  Utf8Locale()
      : Utf8(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)),
        Before(this->Utf8 ? uselocale(this->Utf8) : nullptr)
  {
  }
  ~Utf8Locale()
  {
    if (this->Utf8)
    {
      uselocale(this->Before);
      freelocale(this->Utf8);
    }
  }
  Utf8Locale(const Utf8Locale&) = delete;
  void operator=(const Utf8Locale&) = delete;

private:
  locale_t Utf8;
  locale_t Before;
};

Reader OpenZip(const char* path)
{
  Reader reader(archive_read_new(), archive_read_free);
  archive_read_support_format_zip(reader.get());
  if (!path || archive_read_open_filename(reader.get(), path, 1 << 16) != ARCHIVE_OK)
  {
    reader.reset();
  }
  return reader;
}

bool IsSafeName(const std::string& name)
{
  const std::string framed = "/" + name + "/";
  return !name.empty() && name[0] != '/' && framed.find("/../") == std::string::npos &&
         name.find('\\') == std::string::npos && name.find(':') != 1 &&
         name.find('\0') == std::string::npos;
}

/// Files below the folder, relative to it, in an order that does not depend on the disk.
void ListFiles(const std::string& folder, const std::string& below, std::vector<std::string>& files)
{
  vtksys::Directory directory;
  directory.Load(folder + below);
  std::vector<std::string> names;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    names.emplace_back(directory.GetFile(i));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names)
  {
    const std::string path = below + "/" + name;
    if (name == "." || name == ".." || vtksys::SystemTools::FileIsSymlink(folder + path))
    {
      continue;
    }
    if (vtksys::SystemTools::FileIsDirectory(folder + path))
    {
      ListFiles(folder, path, files);
    }
    else
    {
      files.push_back(path);
    }
  }
}

bool AddFile(archive* writer, const std::string& path, const std::string& name)
{
  struct stat status = {};
  std::ifstream file(path, std::ios::binary);
  if (!file || stat(path.c_str(), &status) != 0)
  {
    return false;
  }
  const Entry entry(archive_entry_new(), archive_entry_free);
  archive_entry_set_pathname_utf8(entry.get(), name.c_str());
  archive_entry_set_size(entry.get(), status.st_size);
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_mtime(entry.get(), status.st_mtime, 0);
  if (archive_write_header(writer, entry.get()) != ARCHIVE_OK)
  {
    return false;
  }
  std::vector<char> block(1 << 20);
  while (file)
  {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(file.gcount());
    if (count > 0 &&
        archive_write_data(writer, block.data(), count) != static_cast<la_ssize_t>(count))
    {
      return false;
    }
  }
  return file.eof();
}

bool ExtractFile(archive* reader, const std::string& path)
{
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetParentDirectory(path));
  std::ofstream file(path, std::ios::binary);
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  int result = ARCHIVE_OK;
  while ((result = archive_read_data_block(reader, &block, &size, &offset)) == ARCHIVE_OK)
  {
    file.seekp(offset);
    file.write(static_cast<const char*>(block), static_cast<std::streamsize>(size));
  }
  file.close();
  return result == ARCHIVE_EOF && file.good();
}

} // namespace

bool vtkArchive::Zip(const char* zipFileName, const char* directoryToZip)
{
  const Utf8Locale locale;
  const std::string folder = vtksys::SystemTools::CollapseFullPath(directoryToZip);
  const std::string temporary = vtkMRMLSavedFiles::Temporary(zipFileName);
  std::vector<std::string> files;
  ListFiles(folder, "", files);
  const Writer writer(archive_write_new(), archive_write_free);
  archive_write_set_format_zip(writer.get());
  // What is worth it is compressed already; the fastest level keeps saving bearable.
  archive_write_set_options(writer.get(), "zip:compression-level=1,hdrcharset=UTF-8");
  bool written = archive_write_open_filename(writer.get(), temporary.c_str()) == ARCHIVE_OK;
  for (const std::string& file : files)
  {
    written = written && AddFile(writer.get(), folder + file,
                                 vtksys::SystemTools::GetFilenameName(folder) + file);
  }
  written = archive_write_close(writer.get()) == ARCHIVE_OK && written &&
            vtkMRMLSavedFiles::Publish(zipFileName);
  if (!written)
  {
    vtksys::SystemTools::RemoveFile(temporary);
  }
  return written;
}

bool vtkArchive::UnZip(const char* zipFileName, const char* destinationDirectory)
{
  const Utf8Locale locale;
  const Reader reader = OpenZip(zipFileName);
  if (!reader || !vtksys::SystemTools::MakeDirectory(destinationDirectory))
  {
    return false;
  }
  archive_entry* entry = nullptr;
  int result = ARCHIVE_OK;
  while ((result = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK ||
         result == ARCHIVE_WARN)
  {
    const char* utf8 = archive_entry_pathname_utf8(entry);
    const char* raw = archive_entry_pathname(entry);
    const std::string name = utf8 ? utf8 : raw ? raw : "";
    const std::string path = std::string(destinationDirectory) + "/" + name;
    const auto type = archive_entry_filetype(entry);
    const bool folder = type == AE_IFDIR || (!name.empty() && name.back() == '/');
    if (!IsSafeName(name) || archive_entry_symlink(entry) || (!folder && type != AE_IFREG) ||
        (folder ? !vtksys::SystemTools::MakeDirectory(path).IsSuccess()
                : !ExtractFile(reader.get(), path)))
    {
      return false;
    }
  }
  return result == ARCHIVE_EOF;
}

bool vtkArchive::ListArchive(const char* archiveName, std::vector<std::string>& files)
{
  const Utf8Locale locale;
  const Reader reader = OpenZip(archiveName);
  archive_entry* entry = nullptr;
  int result = reader ? ARCHIVE_OK : ARCHIVE_FATAL;
  files.clear();
  while (reader && ((result = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK ||
                    result == ARCHIVE_WARN))
  {
    const char* name = archive_entry_pathname_utf8(entry);
    files.emplace_back(name ? name : "");
  }
  return result == ARCHIVE_EOF;
}
