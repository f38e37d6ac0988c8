#include "Core/inverse/skin_sensitivity.hpp"

namespace f2b
{
namespace
{

/// Rigid velocity field of one fragment: of a turn for parameters 0-2, of a shift for 3-5.
std::vector<Vec3> unit_motion(const MixedMesh& mesh, const std::vector<Vec3>& x, int fragment,
                              const Vec3& center, int parameter)
{
  std::vector<Vec3> motion(x.size(), Vec3::Zero());
  const Vec3 axis = Vec3::Unit(parameter % 3);
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment && mesh.node_fragment[n] == fragment)
      motion[n] = parameter < 3 ? Vec3(axis.cross(x[n] - center)) : axis;
  return motion;
}

} // namespace

std::vector<std::vector<Vec3>> skin_sensitivity(const FaceModel& face, EquilibriumSolver& solver,
                                                const std::vector<Vec3>& x,
                                                const std::vector<RigidMotion>& motions)
{
  std::vector<std::vector<Vec3>> units;
  for (std::size_t f = 0; f < motions.size(); ++f)
    for (int p = 0; p < 6; ++p)
      units.push_back(unit_motion(face.tissue.mesh(), x, static_cast<int>(f),
                                  motions[f].reference_point + motions[f].translation, p));
  // by the linearity of the map from nodes to the reference skin
  std::vector<std::vector<Vec3>> columns;
  for (const auto& response : solver.respond(x, units))
    columns.push_back(face.skin.of_change(response));
  return columns;
}

} // namespace f2b
