#pragma once

#include "Case/shell_of_case.hpp"
#include "Core/geometry/osteotomy_templates.hpp"
#include "Core/inverse/cut_suggestion.hpp"
#include "Core/inverse/rigid_fit.hpp"

/// What would cuts do to the face of a case that it has not made?
namespace f2b
{

/// Where the time of trials went [s].
struct TrialSeconds
{
  double mesh = 0, cut = 0, contact = 0, response = 0;
};

/// A case's face, on a mesh of its own, that is cut in one way after another: the tissue stays,
/// only what it hangs on changes.
class CutTrials
{
public:
  /// Meshes the uncut face. Throws Error where a file of `segment` is absent.
  /// \param density  of the mesh (mesh.density)
  CutTrials(const CaseSession& session, double density, const Progress& progress);

  /// The skin's answer to the fragments of these templates, cut together.
  /// Throws Error where a landmark is absent, where the cut does not free a fragment, or where two
  /// fragments are one piece.
  CutEffect effect_of(const std::vector<std::string>& templates);
  /// The full non-linear fit with these cuts; throws as above and as `fit_fragments`.
  RigidFitResult fit(const std::vector<std::string>& templates, const SkinTarget& target,
                     const RigidFitOptions& options, const Progress& progress);

  const MeshedFace& face() const { return m_face; }
  const TrialSeconds& seconds() const { return m_seconds; }

private:
  BonePartition cut(const std::vector<std::string>& templates);

  double m_release_margin_mm;
  ShellInputs m_inputs;
  Landmarks m_landmarks;
  TrialSeconds m_seconds;
  MixedMesh m_uncut;
  MeshedFace m_face; ///< with the contacts of the last cut
};

} // namespace f2b
