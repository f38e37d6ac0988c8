#include "Case/case_folder.hpp"

#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* staging_name = ".facetobone-new";
constexpr const char* journal_name = "COMMIT";
constexpr const char* lock_name = ".facetobone-lock";

/// Which files of a case a step has made, so that they can be told from the user's own.
constexpr const char* ledger_name = ".facetobone-files.json";

using Ledger = std::map<std::string, std::vector<std::string>>;

Ledger read_ledger(const Path& folder)
{
  std::ifstream file(folder / ledger_name);
  const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  return document.is_object() ? document.get<Ledger>() : Ledger{};
}

void write_text(const Path& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file)
    throw Error(path.string(), "it cannot be written", "check the folder's permissions and free space");
}

void flush_to_disk(const Path& path)
{
  const int handle = ::open(path.c_str(), O_RDONLY);
  if (handle >= 0)
  {
    ::fsync(handle);
    ::close(handle);
  }
}

/// Renames every staged file into place and removes the outdated ones; may be repeated.
void carry_out(const Path& folder)
{
  const Path staging = folder / staging_name;
  std::ifstream journal(staging / journal_name);
  const nlohmann::json plan = nlohmann::json::parse(journal, nullptr, false);
  if (plan.is_object())
  {
    std::error_code ignored;
    for (const std::string& name : plan.value("install", std::vector<std::string>()))
      if (fs::exists(staging / name))
      {
        fs::create_directories((folder / name).parent_path());
        fs::rename(staging / name, folder / name);
      }
    for (const std::string& name : plan.value("remove", std::vector<std::string>()))
      fs::remove(folder / name, ignored);
  }
  fs::remove_all(staging);
}

/// Hidden files are the folder's own book-keeping.
std::vector<std::string> files_below(const Path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename().string()[0] != '.')
      names.push_back(entry.path().lexically_relative(folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The steps whose results are stale once a step has been done anew. The target is drawn on the
/// reference skin, so it outlives new cuts and meshes.
const std::vector<std::string>& outdated_by(const std::string& step)
{
  static const std::map<std::string, std::vector<std::string>> table = {
      {"sample", {"sample"}},
      {"segment", {"segment", "cut", "mesh", "target", "plan", "predict", "report"}},
      {"cut", {"cut", "mesh", "plan", "predict", "report"}},
      {"mesh", {"mesh", "plan", "predict", "report"}},
      {"target", {"target", "plan", "predict", "report"}},
      {"plan", {"plan", "predict", "report"}},
      {"predict", {"predict", "report"}},
      {"report", {"report"}}};
  return table.at(step);
}

} // namespace

CaseFolder::CaseFolder(const Path& folder)
{
  std::error_code failed;
  m_made = fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder))
    throw Error(folder.string(), "the folder cannot be made", "choose another place or mend its permissions");
  m_folder = fs::canonical(folder);
  m_lock = ::open((m_folder / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (m_lock < 0)
    throw Error(folder.string(), "the folder is read-only", "choose a folder that you may write to");
  if (::flock(m_lock, LOCK_EX | LOCK_NB) != 0)
  {
    ::close(m_lock);
    throw Error(folder.string(), "another FaceToBone is working on this case", "wait until it has finished");
  }
  carry_out(m_folder);
}

CaseFolder::~CaseFolder()
{
  std::error_code ignored;
  if (m_made && std::distance(fs::directory_iterator(m_folder, ignored), {}) == 1)
  {
    fs::remove(m_folder / lock_name, ignored);
    fs::remove(m_folder, ignored);
  }
  ::close(m_lock);
}

Path CaseFolder::require(const std::string& name, const std::string& step) const
{
  if (!has(name))
    throw Error(m_folder.string(), "it holds no " + name,
                "run 'facetobone " + step + "' on this folder first");
  return file(name);
}

std::vector<std::string> CaseFolder::matching(const std::string& begin, const std::string& end) const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(m_folder))
  {
    const std::string name = entry.path().filename().string();
    if (name.size() >= begin.size() + end.size() && name.compare(0, begin.size(), begin) == 0 &&
        name.compare(name.size() - end.size(), end.size(), end) == 0)
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

CaseChange::CaseChange(CaseFolder& folder) : m_case(folder), m_staging(folder.path() / staging_name)
{
  std::error_code failed;
  fs::remove_all(m_staging, failed);
  fs::create_directory(m_staging, failed);
  if (failed)
    throw Error(folder.path().string(), "the folder is read-only", "choose a folder that you may write to");
}

CaseChange::~CaseChange()
{
  std::error_code ignored;
  fs::remove_all(m_staging, ignored);
}

Path CaseChange::file(const std::string& name) const
{
  const Path path = m_staging / name;
  fs::create_directories(path.parent_path());
  return path;
}

void CaseChange::commit(const std::string& step)
{
  const std::vector<std::string> install = files_below(m_staging);
  Ledger ledger = read_ledger(m_case.path());
  std::vector<std::string> remove;
  for (const std::string& outdated : outdated_by(step))
  {
    for (const std::string& name : ledger[outdated])
      if (std::find(install.begin(), install.end(), name) == install.end())
        remove.push_back(name);
    ledger.erase(outdated);
  }
  // a whole case that was made aside brings its own ledger
  if (const Ledger made_aside = read_ledger(m_staging); !made_aside.empty())
    ledger = made_aside;
  else
    for (const std::string& name : install)
      if (name != case_settings_name) // stays, whichever step is done anew
        ledger[step].push_back(name);
  for (const std::string& name : install)
    flush_to_disk(m_staging / name);
  write_text(m_staging / ledger_name, nlohmann::json(ledger).dump(1));
  nlohmann::json journal = {{"install", install}, {"remove", remove}};
  journal["install"].push_back(ledger_name);
  write_text(m_staging / "journal.new", journal.dump(1));
  flush_to_disk(m_staging / "journal.new");
  fs::rename(m_staging / "journal.new", m_staging / journal_name);
  carry_out(m_case.path());
}

} // namespace f2b
