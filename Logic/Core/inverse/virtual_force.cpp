#include "Core/inverse/virtual_force.hpp"

#include "Core/error.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

std::vector<RigidMotion> register_contacts(const FaceModel& face, const std::vector<Vec3>& x)
{
  const MixedMesh& mesh = face.tissue.mesh();
  std::vector<RigidMotion> motions;
  for (std::size_t f = 0; f < face.reference_points.size(); ++f)
  {
    std::vector<Vec3> from, to;
    for (std::size_t n = 0; n < mesh.X.size(); ++n)
      if (mesh.node_boundary[n] == Boundary::Fragment &&
          mesh.node_fragment[n] == static_cast<int>(f))
      {
        from.push_back(mesh.X[n]);
        to.push_back(x[n]);
      }
    if (from.size() < 3)
      throw Error("fragment '" + mesh.fragments[f] + "'",
                  "has " + std::to_string(from.size()) + " soft-tissue contact nodes, 3 are needed",
                  "use a smaller release margin, a denser mesh or another cut",
                  ErrorKind::Numerical);
    motions.push_back(register_rigidly(from, to, face.reference_points[f]));
  }
  return motions;
}

} // namespace

VirtualForceResult drag_skin(const FaceModel& face, const SkinTarget& target,
                             const VirtualForceOptions& options, const Progress& progress)
{
  std::vector<double> area(face.skin_area.size());
  for (std::size_t v = 0; v < area.size(); ++v)
    area[v] = face.skin_area[v] * target.weight[v];
  ElasticModel model(face.tissue, face.materials, held_controls(face.tissue, Held::BoneOnly));
  EquilibriumSolver solver(model, options.equilibrium);

  VirtualForceResult result;
  result.x = face.tissue.rest();
  // The target is walked to in shares: a first pull over the whole way would invert elements.
  double reached = 0, step = 0.5;
  while (reached < 1)
  {
    const double share = std::min(1.0, reached + step);
    std::vector<Vec3> displacement = target.displacement;
    for (Vec3& d : displacement)
      d *= share;
    model.set_springs(make_skin_springs(face.tissue, face.skin, displacement, area),
                      options.stiffness_n_per_mm3);
    progress("pulling the skin by virtual forces", reached);
    const EquilibriumSummary solve = solver.relax(result.x);
    result.equilibrium.add(solve);
    reached = solve.converged() ? share : reached;
    step = solve.converged() ? 2 * step : step / 2;
    if (step < options.equilibrium.smallest_load_step)
      break;
  }
  result.equilibrium.load_reached = reached;
  result.motions = register_contacts(face, result.x);
  result.skin_displacement = face.skin.displacement(result.x);
  return result;
}

} // namespace f2b
