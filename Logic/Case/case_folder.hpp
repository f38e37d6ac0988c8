#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What does a case hold, and how does a new result take an old one's place?
namespace f2b
{

using Path = std::filesystem::path;

/// What a case will hold once a change is committed.
struct CaseOutlook
{
  Path folder;                    ///< of the case
  Path staging;                   ///< where the change's own files are until then
  std::vector<std::string> names; ///< of all files, sorted

  bool has(const std::string& name) const;
  /// Where a file can be read before the commit.
  Path file(const std::string& name) const;
};

/// Adds files to a change that is about to be committed, such as one that lists all others, in
/// the staging folder. May be called from any thread.
using CommitHook = std::function<void(const CaseOutlook&)>;

/// Finishes or drops what a killed process left in a case folder, if it left something there and no
/// other process has begun to.
void tidy_case_folder(const Path& folder) noexcept;

/// A folder of standard files that holds one case. Names of its files:
///
/// - segment: case.json segment.json ct.nrrd labels.nrrd {skin,bone,closed_bone}_distance.nrrd
///   skin.vtp skin.ply bone.vtp landmarks.mrk.json
/// - cut: cut.json cuts.mrk.json cut_NAME_N.mrk.json bone_parts.nrrd uncut_bone.vtp
///   fragment_NAME.vtp
/// - mesh: mesh.json mesh.vtu
/// - target: target.json target.vtp target_scan.vtp
/// - suggest: suggest.json
/// - plan: plan.json plan_METHOD.vtu predicted_METHOD.vtp NAME_METHOD.{tfm,h5,vtp}
/// - predict: predict.json predicted.vtp predicted.vtu NAME_moved.vtp
/// - export: export.inp export.feb export.vtu export.mrb print/*.stl print/*.ply, each a step of its own
/// - evaluate: evaluation/
/// - report: report.html report.pdf report.json pictures/ tables/
/// - every step: case.mrml, where a hook writes it
///
/// One process works on a case at a time: the folder is locked while it is open.
class CaseFolder
{
public:
  /// Opens a folder, making it where it is not there; finishes or drops what a killed process left.
  /// Throws Error if it cannot be made or written, or is in use.
  explicit CaseFolder(const Path& folder);
  ~CaseFolder();
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;

  const Path& path() const { return m_folder; }
  Path file(const std::string& name) const { return m_folder / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(file(name)); }
  /// The path of a file that an earlier step made; throws Error naming that step where it is
  /// absent.
  Path require(const std::string& name, const std::string& step) const;
  /// Throws Error if a file lies where a step's result is to go and the step may not replace it:
  /// the user's own, or that of a sample.
  void require_replaceable(const std::vector<std::string>& names, const std::string& step) const;

  /// Called at each commit.
  void set_commit_hook(CommitHook hook) { m_hook = std::move(hook); }

private:
  friend class CaseChange;

  /// Folders that were not there; those that stay empty are removed again.
  class MadeFolders
  {
  public:
    explicit MadeFolders(const Path& folder);
    ~MadeFolders();

  private:
    std::vector<Path> m_made; ///< innermost first
  };

  MadeFolders m_made;
  Path m_folder;
  int m_lock = -1; ///< the folder itself, open
  CommitHook m_hook;
};

/// New files for a case, all of which appear when `commit` is called, or none.
///
/// Files are made in a folder inside the case. Commit writes down what is to be done, then renames
/// file by file; a process killed between is finished by the next CaseFolder.
class CaseChange
{
public:
  explicit CaseChange(CaseFolder& folder);
  ~CaseChange(); ///< drops what was not committed

  /// Where to write the file that is to become `name`.
  Path file(const std::string& name) const;
  Path folder() const { return m_staging; }
  /// Puts the new files in place (Error if one of the user's own is in the way) and removes what an
  /// earlier run of this step made, and the results of later steps that rest on it: stale results
  /// are never shown as current.
  /// \param step  a step of the list above; a change that holds a whole case is a new `segment`
  void commit(const std::string& step);

private:
  CaseOutlook outlook(const std::vector<std::string>& remove) const;

  CaseFolder& m_case;
  Path m_staging;
};

/// What a case folder holds now.
CaseOutlook committed_files(const Path& folder);

/// The names of the table that depend on no fragment and no method.
const std::vector<std::string>& case_file_names();

/// The settings that the case was made from, with absolute paths.
inline constexpr const char* case_settings_name = "case.json";
/// The scene that shows the case in 3D Slicer.
inline constexpr const char* case_scene_name = "case.mrml";

} // namespace f2b
