#pragma once

#include "Case/case_session.hpp"
#include "Meshing/shell_mesh.hpp"

/// How does a segmented case become the mesh of its facial shell, before any cut?
namespace f2b
{

/// The maps that `segment` made; throws Error where one is absent.
struct ShellInputs
{
  explicit ShellInputs(const CaseSession& session);

  ScalarGrid skin, bone, closed_bone, hu;
  std::optional<ScalarGrid> skin_thickness; ///< where the case tells one by region
};

/// Meshes the shell by the case's settings. All tissue on bone hangs on bone that stays; nothing is
/// cut yet. Throws Error (Numerical) if elements are inverted: they would give forces without
/// meaning.
/// \param density            elements relative to the default, in the place of the case's own
/// \param skin_thickness_mm  everywhere, in the place of the case's own
ShellMesh mesh_shell(const CaseSession& session, const ShellInputs& inputs, double density,
                     const Progress& progress, std::optional<double> skin_thickness_mm = {});

} // namespace f2b
