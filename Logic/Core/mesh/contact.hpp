#pragma once

#include "Core/geometry/osteotomy.hpp"
#include "Core/mesh/mixed_mesh.hpp"

/// Which tissue hangs on which bone?
namespace f2b
{

/// Contact nodes by what they hang on.
struct ContactReport
{
  int fixed = 0;              ///< Gamma_c
  std::vector<int> fragments; ///< Gamma_n per fragment
  int released = 0;           ///< freed along the cuts
  int released_between = 0;   ///< freed where one element would hang on two bodies
};

/// Splits the nodes on bone into Gamma_c and Gamma_n by the bone that lies nearest, and frees those
/// within the release margin of a cut (the periosteum is lifted there), and those of elements that
/// would hang on two bodies at once.
///
/// Nodes that are FixedBone, Fragment or were released before are assigned anew; call it on the
/// mesh as it was meshed. Throws Error if a fragment is left with under three nodes.
///
/// \param release_margin_mm  distance to the cut faces [mm]
ContactReport assign_contacts(MixedMesh& mesh, const BonePartition& partition,
                              double release_margin_mm);

/// The label of the bone nearest to a point, looked for within a few voxels; uncut if there is
/// none.
unsigned char nearest_bone(const LabelGrid& labels, const Vec3& point_ras);

/// The mean of points, weighted by the area of the faces around them: where a fragment's movement
/// is told about.
Vec3 area_centroid(const TriangleMesh& mesh);

} // namespace f2b
