#include "Core/models/forward_problem.hpp"

namespace f2b
{

std::vector<Vec3> fragment_displacements(const ForwardProblem& problem)
{
  const MixedMesh& mesh = problem.mesh;
  std::vector<Vec3> u(mesh.X.size(), Vec3::Zero());
  for (std::size_t n = 0; n < u.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
      u[n] = problem.motions[static_cast<std::size_t>(mesh.node_fragment[n])].apply(mesh.X[n]) -
             mesh.X[n];
  return u;
}

std::vector<Vec3> with_fragments_moved(const Discretization& tissue,
                                       const std::vector<RigidMotion>& motions)
{
  const MixedMesh& mesh = tissue.mesh();
  std::vector<Vec3> x = tissue.rest();
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
      x[n] = motions[static_cast<std::size_t>(mesh.node_fragment[n])].apply(mesh.X[n]);
  return x;
}

std::vector<char> held_nodes(const MixedMesh& mesh, Held held)
{
  std::vector<char> flags(mesh.X.size(), 0);
  for (std::size_t n = 0; n < flags.size(); ++n)
  {
    const Boundary part = mesh.node_boundary[n];
    flags[n] = part == Boundary::FixedBone || part == Boundary::Crop ||
               (held == Held::BoneAndFragments && part == Boundary::Fragment);
  }
  return flags;
}

std::vector<char> held_controls(const Discretization& tissue, Held held)
{
  return tissue.control_flags(held_nodes(tissue.mesh(), held));
}

} // namespace f2b
