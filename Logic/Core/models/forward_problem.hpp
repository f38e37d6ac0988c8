#pragma once

#include "Core/assembly/discretization.hpp"
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

/// Control vectors at rest, but for each fragment's nodes, which are moved rigidly.
std::vector<Vec3> with_fragments_moved(const Discretization& tissue,
                                       const std::vector<RigidMotion>& motions);

/// What is given, while the rest of the tissue follows?
enum class Held
{
  BoneAndFragments, ///< Gamma_c, Gamma_n and the crop walls: fragments are moved
  BoneOnly,         ///< Gamma_c and the crop walls: Gamma_n is free of traction
};
/// One flag per node.
std::vector<char> held_nodes(const MixedMesh& mesh, Held held);
/// One flag per control vector.
std::vector<char> held_controls(const Discretization& tissue, Held held);

} // namespace f2b
