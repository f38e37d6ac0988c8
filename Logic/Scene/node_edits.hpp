#pragma once

#include "Case/case_session.hpp"
#include "Scene/scene_settings.hpp"
#include "Scene/shown_cuts.hpp"

/// What did a user change on nodes since the case's files were written?
namespace f2b
{

/// One fragment's cuts.
struct CutFiles
{
  std::vector<Path> planes, curves;
};

/// Files for a step to read, made of nodes; gone with this.
class NodeEdits
{
public:
  NodeEdits() = default;
  ~NodeEdits();
  NodeEdits(const NodeEdits&) = delete;
  NodeEdits& operator=(const NodeEdits&) = delete;

  /// Cuts whose planes or curves were moved, added or removed: the osteotomy node then says that
  /// these cut the fragment, and no longer a template. Throws Error where a fragment has no point.
  void collect_cuts(const Path& folder, const CaseNodes& nodes);
  /// A target whose displacement was sculpted: the target node then says that its mesh is the
  /// target. Looks at the target skin's array, or at the reference skin's where there is no target.
  void collect_target(const Path& folder, const CaseNodes& nodes);
  /// Fiducials that were moved take their place in the case.
  void collect_landmarks(const Path& folder, const CaseNodes& nodes);

  bool has_target() const { return !m_target.empty(); }
  bool has_cuts() const { return !m_cuts.empty(); }
  /// Lets a session read the edits in place of the files that the settings will name once the step
  /// has written them.
  void apply(CaseSession& session) const;

private:
  Path temporary_file(const std::string& name);
  void keep_cuts(vtkMRMLFaceToBoneOsteotomyNode* osteotomy, int n, const ShownCuts& cuts,
                 const Osteotomy* placed);

  Path m_temporary;
  std::map<std::string, CutFiles> m_cuts; ///< by fragment
  Path m_target;
};

} // namespace f2b
