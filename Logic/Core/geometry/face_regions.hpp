#pragma once

#include "Core/geometry/osteotomy_templates.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Which part of the face is a vertex of the reference skin?
///
/// The borders follow the aesthetic units of the face: levels and widths are told by landmarks of
/// the bone (of the skin where they are given), in the patient's own axes. Frame RAS, mm.
namespace f2b
{

/// The values are those of the integer point array `region` in skin.vtp.
enum class FaceRegion
{
  Other, ///< ears, scalp, temples, nape above the jaw; and all skin where nothing is known
  Forehead,
  OrbitRight,
  OrbitLeft,
  Nose,
  CheekRight,
  CheekLeft,
  UpperLip,
  LowerLip,
  Chin,
  JawRight,
  JawLeft,
  Neck,
};

constexpr std::size_t face_region_count = 13;

/// In the order of the values.
std::array<FaceRegion, face_region_count> all_face_regions();

/// For files: "upper_lip", "orbit_right".
std::string key_of(FaceRegion region);
/// For people: "upper lip", "right orbit".
std::string name_of(FaceRegion region);
/// The region of an array's value, if it is one.
std::optional<FaceRegion> face_region_of(double value);

/// Landmarks that `face_regions` needs and that are not given; empty if it can work.
std::vector<std::string> missing_for_face_regions(const Landmarks& landmarks);

/// One region per point. Needs N, Or, Zy, Go (right and left), ANS, PNS, A, U1, B, Pg, Me; uses sn,
/// ls, li, ch and Me' if they are there. Without the needed ones every point is Other.
std::vector<FaceRegion> face_regions(const std::vector<Vec3>& skin, const Landmarks& landmarks);

} // namespace f2b
