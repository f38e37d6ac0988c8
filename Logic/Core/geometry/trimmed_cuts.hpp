#pragma once

#include "Core/geometry/osteotomy.hpp"

/// How far need a saw go?
namespace f2b
{

/// The osteotomies with every plane cut down to the bone that it parts and `margin_mm` around it, so
/// that a plane drawn wider than its fragment does no harm beyond. Planes that part nothing are left
/// out; curves stay as they were drawn.
std::vector<Osteotomy> trimmed_cuts(const BonePartition& partition, double margin_mm = 2);

/// How near does a saw come to a structure that it should spare?
struct SawClearance
{
  double distance_mm = 0; ///< from the kerf's wall; not positive: the saw goes through it
  Vec3 at = Vec3::Zero(); ///< the structure's point [mm, RAS]
  std::string cut;        ///< the plane or curve, as errors name it
};

/// \param structure  points on it, close together; at least one
/// Without any cut the distance is infinite.
SawClearance saw_clearance(const std::vector<Vec3>& structure,
                           const std::vector<Osteotomy>& osteotomies);

} // namespace f2b
