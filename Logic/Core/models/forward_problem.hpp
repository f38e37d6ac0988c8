#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Core/material/material_set.hpp"
#include "Core/mesh/mixed_mesh.hpp"

/// What does a prediction of the face start from, whichever model or engine makes it?
namespace f2b
{

/// A face whose bone fragments are moved; uncut bone and the crop walls stay. RAS, mm, MPa. Mesh and
/// materials outlive the problem.
struct ForwardProblem
{
  const MixedMesh& mesh;
  const MaterialSet& materials;
  std::vector<RigidMotion> motions; ///< one per fragment of the mesh
};

/// Displacement of the nodes on fragments [mm]; zero for all others.
std::vector<Vec3> fragment_displacements(const ForwardProblem& problem);

/// One flag per node: it lies on uncut bone, a crop wall or a fragment, so its position is given.
std::vector<char> held_nodes(const MixedMesh& mesh);

} // namespace f2b
