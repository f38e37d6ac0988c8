#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/reachability.hpp"

/// Which part of the face, and over which bone, does each vertex of a case's skin lie?
namespace f2b
{

/// Point array of skin.vtp: FaceRegion. `segment` makes it from the landmarks, as it makes all of
/// skin.vtp; what a user writes into it there is what `plan` tells errors and reachability by.
inline constexpr const char* skin_region_array = "region";

/// The array as skin.vtp carries it; all Other where it has none. Throws Error on a value that is
/// no region.
std::vector<FaceRegion> regions_of_skin(vtkPolyData* skin);
/// Writes the array.
void add_regions(vtkPolyData* skin, const std::vector<FaceRegion>& regions);

/// What a plan tells about the skin by.
SkinParts skin_parts(const CaseFolder& folder, const LoadedFace& face);

/// For segment.json: the regions' names by value, where they come from, and their areas [mm^2].
/// \param missing  landmarks without which no region could be told
nlohmann::json regions_json(const TriangleMesh& skin, const std::vector<FaceRegion>& regions,
                            const std::vector<std::string>& missing);
/// One sentence on landmarks that are missing.
std::string regions_note(const std::vector<std::string>& missing);

} // namespace f2b
