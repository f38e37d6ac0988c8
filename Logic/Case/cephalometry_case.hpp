#pragma once

#include "Core/geometry/bite.hpp"

#include <nlohmann/json.hpp>

/// What do the cephalometric measures become?
namespace f2b
{

/// The reference skin's vertices and two displacements of them [mm].
struct FaceStates
{
  const std::vector<Vec3>& skin;
  const std::vector<Vec3>& to_target;
  const std::vector<Vec3>& to_predicted;
};

/// `cephalometry` of plan.json. `measures` are objects with `name`, `unit`, `definition` and the
/// numbers `before`, `target` (of measures on the skin alone: the target is a face) and `predicted`.
/// `left_out` names measures for want of `missing_landmarks`. Landmarks of the skin go with the
/// nearest vertex of the reference skin.
/// \param moved  the landmarks where the bones that carry them have gone
nlohmann::json cephalometry_json(const Landmarks& rest, const Landmarks& moved,
                                 const FaceStates& face);

} // namespace f2b
