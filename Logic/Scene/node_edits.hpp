#pragma once

#include "Case/case_session.hpp"
#include "Scene/scene_settings.hpp"

class vtkMRMLStorableNode;

/// What did a user change on nodes since the case's files were written?
namespace f2b
{

/// Files for a step to read, made of nodes; gone with this.
class NodeEdits
{
public:
  NodeEdits() = default;
  ~NodeEdits();
  NodeEdits(const NodeEdits&) = delete;
  NodeEdits& operator=(const NodeEdits&) = delete;

  /// Cuts whose planes were moved, added or removed: the osteotomy node then says that these planes
  /// cut the fragment, and no longer a template. Throws Error where a fragment has no point.
  void collect_planes(const Path& folder, const CaseNodes& nodes);
  /// A target whose displacement was sculpted: the target node then says that its mesh is the
  /// target. Looks at the target skin's array, or at the reference skin's where there is no target.
  void collect_target(const Path& folder, const CaseNodes& nodes);
  /// Fiducials that were moved take their place in the case.
  void collect_landmarks(const Path& folder, const CaseNodes& nodes);

  bool has_target() const { return !m_target.empty(); }
  bool has_planes() const { return !m_planes.empty(); }
  /// Lets a session read the edits in place of the files that the settings will name once the step
  /// has written them.
  void apply(CaseSession& session) const;

private:
  Path temporary_file(const std::string& name);

  Path m_temporary;
  std::map<std::string, std::vector<Path>> m_planes; ///< by fragment
  Path m_target;
};

/// Writes a node's data with its own storage. Throws Error where that fails.
void write_node(vtkMRMLStorableNode* node, const Path& file);

} // namespace f2b
