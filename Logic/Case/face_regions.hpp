#pragma once

#include "Case/case_folder.hpp"
#include "Core/geometry/vectors.hpp"

#include <vector>

/// Which part of the face does a skin vertex belong to?
namespace f2b
{

struct FaceRegions
{
  /// Per vertex: the nearest point on the closed bone lies on a cut fragment.
  std::vector<char> over_fragment;
};

FaceRegions face_regions(const CaseFolder& folder, const std::vector<Vec3>& reference_skin);

} // namespace f2b
