#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/reachability.hpp"

#include <optional>

/// Which part of the face, and over which bone, does each vertex of a case's skin lie?
namespace f2b
{

/// Point array of skin.vtp: FaceRegion. `segment` makes it from the landmarks, as it makes all of
/// skin.vtp; what a user writes into it there is what `plan` tells errors and reachability by, and
/// a new `segment` of the same CT keeps it.
inline constexpr const char* skin_region_array = "region";
/// Of `regions` in segment.json: the areas that `segment` gave, by which an edited array is told.
inline constexpr const char* made_area_key = "made_area_mm2";

/// The array as skin.vtp carries it; all Other where it has none. Throws Error on a value that is
/// no region.
std::vector<FaceRegion> regions_of_skin(vtkPolyData* skin);
/// Writes the array.
void add_regions(vtkPolyData* skin, const std::vector<FaceRegion>& regions);

/// What a plan tells about the skin by.
SkinParts skin_parts(const CaseFolder& folder, const LoadedFace& face);

/// What a user wrote into the array of the skin that a case has, carried over to a new skin of the
/// same CT by nearest vertices; vertices with none within 3 mm keep what is given. Nothing where
/// there is no earlier skin, or it is as `segment` made it.
/// \param made  regions of the new skin as `segment` makes them
std::optional<std::vector<FaceRegion>>
edited_regions(const CaseSession& session, const TriangleMesh& skin, std::vector<FaceRegion> made);
/// Area of each region by its key [mm^2].
nlohmann::json region_areas(const TriangleMesh& skin, const std::vector<FaceRegion>& regions);

/// For segment.json: the regions' names by value, where they come from, and their areas [mm^2].
/// \param missing  landmarks without which no region could be told
nlohmann::json regions_json(const TriangleMesh& skin, const std::vector<FaceRegion>& regions,
                            const std::vector<std::string>& missing);
/// One sentence on landmarks that are missing.
std::string regions_note(const std::vector<std::string>& missing);

} // namespace f2b
