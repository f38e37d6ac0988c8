#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/material_file.hpp"
#include "Case/face_regions.hpp"
#include "Case/file_checksum.hpp"
#include "Case/input_records.hpp"
#include "Case/library_versions.hpp"
#include "Case/verbs.hpp"
#include "Case/warp_points.hpp"
#include "Core/error.hpp"
#include "Core/sculpting/mirror_plane.hpp"
#include "Imaging/read_ct.hpp"
#include "Imaging/segment_head.hpp"
#include "Meshing/isosurface.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

void require_file(const Path& path, const char* key)
{
  if (!path.empty() && !std::filesystem::is_regular_file(path))
    throw Error(path.string(), "there is no such file",
                std::string("correct '") + key + "' in the case file");
}

/// Reads the cuts' inputs; returns the names of the fragments.
std::vector<std::string> check_cuts(const CaseSettings& s)
{
  require_file(s.landmarks, "/landmarks");
  const Landmarks landmarks = s.landmarks.empty() ? Landmarks{} : read_landmarks(s.landmarks);
  std::vector<std::string> fragments;
  for (const OsteotomySettings& o : s.osteotomies)
  {
    for (const Path& planes : o.planes)
    {
      require_file(planes, "/osteotomies/planes");
      (void)read_planes(planes);
    }
    for (const CurveSettings& curve : o.curves)
    {
      require_file(curve.markup, "/osteotomies/curves/markup");
      (void)read_points(curve.markup);
    }
    // a list without points is one that is placed later, on the surfaces that this step makes
    const bool placed_later = !o.fragment.empty() && landmarks.empty() && !s.landmarks.empty();
    fragments.push_back(
        o.template_name.empty() || placed_later
            ? o.fragment
            : osteotomy_from_template(o.template_name, o.fragment, landmarks, o.kerf_mm).fragment);
  }
  require_distinct_fragments(fragments, "'/osteotomies'");
  return fragments;
}

void check_target(const TargetSettings& target)
{
  require_file(target.mesh, "/target/mesh");
  require_file(target.warp_from, "/target/warp/from");
  require_file(target.warp_to, "/target/warp/to");
  if (!target.mesh.empty())
    (void)read_surface(target.mesh);
  if (!target.warp_from.empty())
    (void)read_warp_points(target);
}

/// What later steps will read is looked at now, not after minutes of work.
void check_inputs(const CaseSettings& s)
{
  const std::vector<std::string> fragments = check_cuts(s);
  for (const ProtectedSettings& p : s.protected_structures)
  {
    require_file(p.curve, "/protected/curve");
    require_file(p.mesh, "/protected/mesh");
  }
  require_file(s.seeds, "/segmentation/seeds");
  require_file(s.labels, "/segmentation/labels");
  check_target(s.target);
  require_known_fragments(s.target.movements, fragments, "'/target/from_movement'");
  require_known_fragments(s.predict, fragments, "'/predict'");
  (void)read_materials(s.materials);
}

LevelSetBoneOptions level_set_options(const Path& seeds)
{
  LevelSetBoneOptions options;
  if (seeds.empty())
    return options;
  for (const ControlPoint& point : read_points(seeds).points)
    options.seeds_ras.push_back(point.position);
  options.contour.propagation = 0.5;
  return options;
}

SegmentOptions segment_options(const CaseSettings& s)
{
  SegmentOptions options;
  options.skin_threshold_hu = s.skin_threshold_hu;
  options.bone_threshold_hu = s.bone_threshold_hu;
  options.region_ras = s.region_ras;
  options.spacing_mm = s.spacing_mm;
  options.head_closing_mm = s.head_closing_mm;
  options.bone_closing_mm = s.bone_closing_mm;
  options.skin_thickness_mm = s.skin_thickness_mm;
  if (s.level_set)
    options.level_set = level_set_options(s.seeds);
  if (!s.labels.empty())
    options.edits = read_label_edits(s.labels);
  return options;
}

json surface_facts(vtkPolyData* surface)
{
  const SurfaceCheck check = check_surface(surface);
  return {{"points", surface->GetNumberOfPoints()},
          {"triangles", surface->GetNumberOfPolys()},
          {"open_edges", check.open_edges},
          {"non_manifold_edges", check.non_manifold_edges}};
}

/// Where the middle of the face is, by its symmetry alone. Skin at the walls of the region is a cut
/// through the head, and does not count.
json midline_guess(const TriangleMesh& skin, const Box& region)
{
  constexpr double wall_mm = 3;
  std::vector<int> inside;
  for (std::size_t v = 0; v < skin.points.size(); ++v)
    if (((skin.points[v] - region.min).array() > wall_mm).all() &&
        ((region.max - skin.points[v]).array() > wall_mm).all())
      inside.push_back(static_cast<int>(v));
  const std::optional<MirrorPlane> found = mirror_plane(skin, inside);
  if (!found)
    return nullptr;
  return {{"point_ras", to_json(found->plane.point)},
          {"normal_ras", to_json(found->plane.normal)},
          {"asymmetry_mm", found->asymmetry_mm},
          {"note", "a guess from the symmetry of the skin; landmarks say it better"}};
}

} // namespace

void segment_case(CaseSession& session)
{
  const Stopwatch watch;
  check_inputs(session.settings);
  session.folder.require_replaceable(case_file_names(), "segment");
  session.progress("reading the CT", 0);
  const json inputs = segment_inputs(session.settings);
  std::vector<std::string> notes;
  const CtImage::Pointer ct = read_ct(session.settings.ct, &notes, session.settings.reading);
  const HeadSegmentation head =
      segment_head(*ct, segment_options(session.settings), session.progress);

  session.progress("making surfaces", 0.8);
  SurfaceOptions skin_options;
  skin_options.decimation_error_mm = session.settings.surface_error_mm;
  SurfaceOptions bone_options = skin_options;
  skin_options.largest_component = true;
  const auto skin = watertight_isosurface(head.skin, 0, skin_options);
  const auto bone = watertight_isosurface(head.bone, 0, bone_options);

  const Landmarks landmarks =
      session.settings.landmarks.empty() ? Landmarks{} : read_landmarks(session.settings.landmarks);
  const TriangleMesh skin_mesh = to_triangle_mesh(skin);
  const std::vector<FaceRegion> made = face_regions(skin_mesh.points, landmarks);
  const auto edited = edited_regions(session, skin_mesh, made);
  const std::vector<FaceRegion>& regions = edited ? *edited : made;
  add_regions(skin, regions);
  const std::vector<std::string> missing = missing_for_face_regions(landmarks);
  notes.insert(notes.end(), head.notes.begin(), head.notes.end());
  if (!missing.empty())
    notes.push_back(regions_note(missing));
  if (edited)
    notes.push_back("the regions of the face that were edited in skin.vtp are kept");
  json told_regions = regions_json(skin_mesh, regions, missing);
  told_regions[made_area_key] = region_areas(skin_mesh, made);

  session.progress("writing", 0.9);
  CaseChange change(session.folder);
  session.write_settings(change.folder());
  const Path ct_file = change.file("ct.nrrd");
  write_grid(ct_file, head.hu);
  write_grid(change.file("labels.nrrd"), head.labels);
  write_grid(change.file("skin_distance.nrrd"), head.skin);
  write_grid(change.file("bone_distance.nrrd"), head.bone);
  write_grid(change.file("closed_bone_distance.nrrd"), head.closed_bone);
  write_surface(change.file("skin.vtp"), skin);
  write_surface(change.file("skin.ply"), skin);
  write_surface(change.file("bone.vtp"), bone);
  if (!session.settings.landmarks.empty())
    write_landmarks(change.file("landmarks.mrk.json"), landmarks);
  write_json(change.file("segment.json"),
             {{"seconds", watch.seconds()},
              {"ct_nrrd_sha256", sha256_of(ct_file)},
              {"skin_threshold_hu", head.skin_threshold_hu},
              {"bone_threshold_hu", head.bone_threshold_hu},
              {"region_ras",
               {{"min", to_json(head.region_ras.min)}, {"max", to_json(head.region_ras.max)}}},
              {"skin", surface_facts(skin)},
              {"bone", surface_facts(bone)},
              {"regions", told_regions},
              {"midline_guess", midline_guess(skin_mesh, head.region_ras)},
              {"versions", library_versions()},
              {"inputs", inputs},
              {"notes", notes}});
  change.commit("segment");
  session.progress("segmented", 1);
}

} // namespace f2b
