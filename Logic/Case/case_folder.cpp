#include "Case/case_folder.hpp"

#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <set>
#include <thread>

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

/// Which files of a case a step has made, so that they can be told from the user's own.
constexpr const char* ledger_name = ".facetobone-files.json";

using Ledger = std::map<std::string, std::vector<std::string>>;

Ledger read_ledger(const Path& folder)
{
  std::ifstream file(folder / ledger_name);
  const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  try
  {
    return document.is_object() ? document.get<Ledger>() : Ledger{};
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error((folder / ledger_name).string(), "it is not as FaceToBone writes it",
                "remove it; files that FaceToBone made then count as your own");
  }
}

bool holds(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

void write_text(const Path& path, const std::string& text)
{
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file)
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
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
    {
      fs::remove(folder / name, ignored);
      if (Path(name).has_parent_path())
        fs::remove((folder / name).parent_path(), ignored); // unless something is left in it
    }
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
/// reference skin, so it outlives new cuts and meshes; suggested cuts rest on the target alone.
const std::vector<std::string>& outdated_by(const std::string& step)
{
  static const std::map<std::string, std::vector<std::string>> table = []
  {
    // what an export holds rests on the plan, or on what the plan rests on
    const std::vector<std::string> exports = {"export calculix", "export febio", "export vtu",
                                              "export stl", "export ply", "export mrb"};
    std::map<std::string, std::vector<std::string>> steps = {
        {"sample", {"sample"}},
        {"segment",
         {"segment", "cut", "mesh", "target", "suggest", "plan", "predict", "report", "evaluate"}},
        {"cut", {"cut", "mesh", "plan", "predict", "report", "evaluate"}},
        {"mesh", {"mesh", "plan", "predict", "report", "evaluate"}},
        {"target", {"target", "suggest", "plan", "predict", "report"}},
        {"suggest", {"suggest", "report"}},
        {"plan", {"plan", "predict", "report"}},
        {"predict", {"predict", "report"}},
        {"evaluate", {"evaluate"}},
        {"report", {"report"}}};
    for (const char* step_before : {"segment", "cut", "mesh", "target", "plan"})
      steps[step_before].insert(steps[step_before].end(), exports.begin(), exports.end());
    for (const std::string& one : exports)
      steps[one] = {one};
    return steps;
  }();
  return table.at(step);
}

/// Whether a file is no step's own: each writes it anew, none makes it stale.
bool stays_with_the_case(const std::string& name)
{
  return name == case_settings_name || name == case_scene_name;
}

/// Whether a step made a file, or a step whose results it outdates.
bool may_replace(const Ledger& ledger, const std::string& name, const std::string& step)
{
  if (stays_with_the_case(name))
    return step == "sample" ? ledger.count("sample") > 0 : ledger.size() > ledger.count("sample");
  for (const std::string& outdated : outdated_by(step))
    if (const auto made = ledger.find(outdated); made != ledger.end() && holds(made->second, name))
      return true;
  return false;
}

void make_folder(const Path& folder)
{
  std::error_code failed;
  if (folder.empty() || !(fs::create_directories(folder, failed), fs::is_directory(folder, failed)))
    throw Error(folder.empty() ? "the case folder" : folder.string(),
                fs::exists(folder, failed) ? "it is not a folder" : "the folder cannot be made",
                "choose another place or mend its permissions");
}

/// Opens a folder and keeps other processes out of it until it is closed.
int lock_folder(const Path& folder)
{
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0 || ::access(folder.c_str(), W_OK | X_OK) != 0)
  {
    ::close(handle);
    throw Error(folder.string(), "the folder is read-only",
                "choose a folder that you may write to");
  }
  // file systems without locks do without; a process that tidies up after a killed one is soon done
  bool is_taken = true;
  for (int tries = 0; is_taken && tries < 20; ++tries)
  {
    if (tries > 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    is_taken = ::flock(handle, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  if (is_taken)
  {
    ::close(handle);
    throw Error(folder.string(), "another FaceToBone is working on this case",
                "wait until it has finished");
  }
  return handle;
}

} // namespace

CaseFolder::MadeFolders::MadeFolders(const Path& folder)
{
  if (folder.empty())
    return;
  std::error_code ignored;
  Path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) // "out/" is "out"
    path = path.parent_path();
  for (; path.has_relative_path() && !fs::exists(path, ignored); path = path.parent_path())
    m_made.push_back(path);
}

CaseFolder::MadeFolders::~MadeFolders()
{
  std::error_code ignored;
  for (const Path& folder : m_made)
    fs::remove(folder, ignored); // does nothing where there is something in it
}

CaseFolder::CaseFolder(const Path& folder) : m_made(folder)
{
  make_folder(folder);
  m_folder = fs::canonical(folder);
  m_lock = lock_folder(m_folder);
  try
  {
    carry_out(m_folder);
  }
  catch (const std::exception&)
  {
    ::close(m_lock);
    throw Error((m_folder / staging_name).string(),
                "what a stopped run left there cannot be tidied up",
                "check permissions and free space, or remove it");
  }
}

void tidy_case_folder(const Path& folder) noexcept
{
  try
  {
    if (fs::exists(folder / staging_name))
      CaseFolder tidied(folder);
  }
  catch (...)
  {
    // the next process that opens the folder does it, or says why it cannot
  }
}

CaseFolder::~CaseFolder()
{
  ::close(m_lock);
}

Path CaseFolder::require(const std::string& name, const std::string& step) const
{
  if (!has(name))
    throw Error(m_folder.string(), "it holds no " + name,
                step == "segment"
                    ? "make the case first: facetobone segment CASE.json -o " + m_folder.string()
                    : "run 'facetobone " + step + "' on this folder first");
  return file(name);
}

void CaseFolder::require_replaceable(const std::vector<std::string>& names,
                                     const std::string& step) const
{
  const Ledger ledger = read_ledger(m_folder);
  for (const std::string& name : names)
  {
    const Path parent = file(name).parent_path();
    const Path in_the_way = fs::exists(parent) && !fs::is_directory(parent) ? parent
                            : has(name) && !may_replace(ledger, name, step) ? file(name)
                                                                            : Path();
    if (!in_the_way.empty())
      throw Error(in_the_way.string(),
                  "it is in the way of a result, and no earlier '" + step + "' made it",
                  "move it away, or write to another folder");
  }
}

const std::vector<std::string>& case_file_names()
{
  static const std::vector<std::string> names = {case_settings_name,
                                                 case_scene_name,
                                                 "segment.json",
                                                 "ct.nrrd",
                                                 "labels.nrrd",
                                                 "skin_distance.nrrd",
                                                 "bone_distance.nrrd",
                                                 "closed_bone_distance.nrrd",
                                                 "skin.vtp",
                                                 "skin.ply",
                                                 "bone.vtp",
                                                 "landmarks.mrk.json",
                                                 "cut.json",
                                                 "cuts.mrk.json",
                                                 "bone_parts.nrrd",
                                                 "uncut_bone.vtp",
                                                 "mesh.json",
                                                 "mesh.vtu",
                                                 "target.json",
                                                 "target.vtp",
                                                 "target_scan.vtp",
                                                 "suggest.json",
                                                 "plan.json",
                                                 "predict.json",
                                                 "predicted.vtp",
                                                 "predicted.vtu",
                                                 "export.inp",
                                                 "export.feb",
                                                 "export.vtu",
                                                 "export.mrb",
                                                 "report.html",
                                                 "report.json",
                                                 "report.pdf"};
  return names;
}

bool CaseOutlook::has(const std::string& name) const
{
  return std::binary_search(names.begin(), names.end(), name);
}

Path CaseOutlook::file(const std::string& name) const
{
  return fs::exists(staging / name) ? staging / name : folder / name;
}

CaseChange::CaseChange(CaseFolder& folder) : m_case(folder), m_staging(folder.path() / staging_name)
{
  std::error_code failed;
  fs::remove_all(m_staging, failed);
  fs::create_directory(m_staging, failed);
  if (failed)
    throw Error(folder.path().string(), "nothing can be written to it",
                "check its permissions and the free space");
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

CaseOutlook committed_files(const Path& folder)
{
  return {folder, folder, files_below(folder)};
}

CaseOutlook CaseChange::outlook(const std::vector<std::string>& remove) const
{
  std::set<std::string> names;
  for (const Path& folder : {m_case.path(), m_staging})
    for (std::string& name : files_below(folder))
      if (name.rfind(staging_name, 0) != 0)
        names.insert(std::move(name));
  for (const std::string& name : remove)
    names.erase(name);
  return {m_case.path(), m_staging, {names.begin(), names.end()}};
}

void CaseChange::commit(const std::string& step)
{
  std::vector<std::string> install = files_below(m_staging);
  m_case.require_replaceable(install, step);
  Ledger ledger = read_ledger(m_case.path());
  std::vector<std::string> remove;
  for (const std::string& outdated : outdated_by(step))
  {
    for (const std::string& name : ledger[outdated])
      if (!holds(install, name))
        remove.push_back(name);
    ledger.erase(outdated);
  }
  if (m_case.m_hook)
  {
    m_case.m_hook(outlook(remove));
    install = files_below(m_staging);
    m_case.require_replaceable(install, step);
  }
  else if (outdated_by(step).size() > 1) // the scene would name files that are no more
    remove.push_back(case_scene_name);
  // a whole case that was made aside brings its own ledger
  if (const Ledger made_aside = read_ledger(m_staging); !made_aside.empty())
    ledger = made_aside;
  else
    for (const std::string& name : install)
      if (!stays_with_the_case(name))
        ledger[step].push_back(name);
  for (const std::string& name : install)
    flush_to_disk(m_staging / name);
  write_text(m_staging / ledger_name, nlohmann::json(ledger).dump(1));
  nlohmann::json journal = {{"install", install}, {"remove", remove}};
  journal["install"].push_back(ledger_name);
  write_text(m_staging / "journal.new", journal.dump(1));
  flush_to_disk(m_staging / "journal.new");
  fs::rename(m_staging / "journal.new", m_staging / journal_name);
  try
  {
    carry_out(m_case.path());
  }
  catch (const fs::filesystem_error& error)
  {
    throw Error(error.path1().string(), "it cannot be put in place",
                "check permissions and free space; the next facetobone on this folder tries again");
  }
}

} // namespace f2b
