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

std::vector<char> held_nodes(const MixedMesh& mesh)
{
  std::vector<char> held(mesh.X.size(), 0);
  for (std::size_t n = 0; n < held.size(); ++n)
  {
    const Boundary part = mesh.node_boundary[n];
    held[n] = part == Boundary::FixedBone || part == Boundary::Crop || part == Boundary::Fragment;
  }
  return held;
}

} // namespace f2b
