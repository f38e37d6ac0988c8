#include "Case/postoperative.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/fragment_json.hpp"
#include "Core/error.hpp"
#include "Core/mesh/skin_over_bone.hpp"
#include "Core/mesh/split_prisms.hpp"
#include "Imaging/postoperative_head.hpp"
#include "Imaging/read_ct.hpp"
#include "Imaging/resample_ct.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;

BonePartition partition_of(const CaseFolder& folder)
{
  BonePartition partition;
  partition.labels = read_label_grid(folder.require("bone_parts.nrrd", "cut"));
  return partition;
}

/// The planned movements, or rest where there is no plan.
std::vector<RigidMotion> planned_motions(const CaseFolder& folder, const json& cut)
{
  std::vector<RigidMotion> motions;
  if (folder.has("plan.json"))
  {
    const json plan = read_json(folder.file("plan.json"));
    for (const json& fragment : plan.at("methods").at("rigid-fit").at("fragments"))
      motions.push_back(motion_from(fragment));
    return motions;
  }
  for (const json& fragment : cut.at("fragments"))
  {
    RigidMotion rest;
    rest.reference_point = vec3_from(fragment.at("reference_point_ras"));
    motions.push_back(rest);
  }
  return motions;
}

/// The orbits' lower rims are the front of the Frankfort plane; a tilted head's ears lie lower or
/// higher, hence the margin.
UnalteredOptions unaltered_options(const CaseFolder& folder)
{
  constexpr double above_orbitale_mm = 8;
  UnalteredOptions options;
  if (!folder.has("landmarks.mrk.json"))
    return options;
  const Landmarks landmarks = read_landmarks(folder.file("landmarks.mrk.json"));
  const auto right = landmarks.find("Or_R"), left = landmarks.find("Or_L");
  if (right != landmarks.end() && left != landmarks.end())
    options.base_level_s = 0.5 * (right->second.z() + left->second.z()) + above_orbitale_mm;
  return options;
}

BinaryMask unaltered_region(const CaseFolder& folder, const WholeBone& whole,
                            const LabelGrid& parts, const PostoperativeOptions& options)
{
  if (options.box_ras && !options.mask.empty())
    throw Error("the registration of the post-operative CT", "both a box and a mask are given",
                "give one of them");
  if (options.box_ras)
    return unaltered_box(whole, parts, *options.box_ras);
  if (!options.mask.empty())
    return unaltered_mask(whole, parts, read_label_grid(options.mask));
  return unaltered_cranium(whole, parts, unaltered_options(folder));
}

/// As the case was segmented, but for the thresholds: the second scanner may be another one.
SegmentOptions segment_options(const CaseSession& session)
{
  SegmentOptions options;
  options.spacing_mm = session.settings.spacing_mm;
  options.head_closing_mm = session.settings.head_closing_mm;
  options.bone_closing_mm = session.settings.bone_closing_mm;
  options.skin_thickness_mm = session.settings.skin_thickness_mm;
  const json region = read_json(session.folder.require("segment.json", "segment")).at("region_ras");
  options.region_ras = Box{vec3_from(region.at("min")), vec3_from(region.at("max"))};
  return options;
}

json registration_json(const CtRegistration& r)
{
  json told = motion_json("head", r.to_postoperative);
  told.erase("name");
  told.update(
      {{"mutual_information_nat", r.mutual_information},
       {"points", r.samples},
       {"iterations", r.iterations},
       {"overlap", r.overlap},
       {"bone_median_mm", r.bone_median_mm},
       {"bone_within_1_5_mm", r.bone_within_1_5_mm},
       {"spread_of_disturbed_starts", {{"mm", r.spread_mm}, {"deg", r.spread_deg}}},
       {"from_surface_fit", {{"mm", r.from_surface_fit_mm}, {"deg", r.from_surface_fit_deg}}}});
  return told;
}

double mean_difference(const RigidMotion& a, const RigidMotion& b,
                       const std::vector<SurfaceSample>& points)
{
  double sum = 0;
  for (const SurfaceSample& p : points)
    sum += (a.apply(p.point) - b.apply(p.point)).norm();
  return sum / static_cast<double>(points.size());
}

/// Faces of the case against the real one.
class FaceComparison
{
public:
  FaceComparison(const CaseSession& session, const BonePartition& partition)
      : m_folder(session.folder)
  {
    const TriangleMesh rest =
        to_triangle_mesh(read_surface(m_folder.require("skin.vtp", "segment")));
    m_area = vertex_areas(rest);
    m_fragment_below =
        fragments_below(read_scalar_grid(m_folder.require("closed_bone_distance.nrrd", "segment")),
                        partition.labels, rest.points);
    leave_out_walls(rest.points);
    for (const char* name : {"predicted_rigid-fit", "predicted_virtual-force"})
      leave_out_unknown(name);
  }

  json compared(const PostoperativeFindings& findings) const;

private:
  /// Where the region ends, the reference skin closes through the head.
  void leave_out_walls(const std::vector<Vec3>& rest);
  /// Vertices whose face nobody computed count in no face.
  void leave_out_unknown(const std::string& name);
  json errors(const PostoperativeFindings& findings, const std::vector<Vec3>& points) const;

  const CaseFolder& m_folder;
  std::vector<double> m_area;
  std::vector<int> m_fragment_below; ///< -1: bone that stays
};

void FaceComparison::leave_out_walls(const std::vector<Vec3>& rest)
{
  constexpr double on_skin_mm = 0.5, from_wall_mm = 3;
  const ScalarGrid skin = read_scalar_grid(m_folder.require("skin_distance.nrrd", "segment"));
  const Vec3 first = skin.origin + Vec3::Constant(from_wall_mm);
  const Vec3 last = lattice_of(skin).last() - Vec3::Constant(from_wall_mm);
  for (std::size_t v = 0; v < rest.size(); ++v)
    if (std::abs(skin.value(rest[v])) > on_skin_mm ||
        !((rest[v].array() >= first.array()).all() && (rest[v].array() <= last.array()).all()))
      m_area[v] = 0;
}

void FaceComparison::leave_out_unknown(const std::string& name)
{
  if (!m_folder.has(name + ".vtp"))
    return;
  const std::vector<double> distance =
      point_scalars(read_surface(m_folder.file(name + ".vtp")), "signed_distance_mm");
  for (std::size_t v = 0; v < std::min(m_area.size(), distance.size()); ++v)
    if (std::isnan(distance[v]))
      m_area[v] = 0;
}

json FaceComparison::errors(const PostoperativeFindings& findings,
                            const std::vector<Vec3>& points) const
{
  json result = error_json(distance_to_postoperative(findings, points, m_area));
  for (const bool cut : {true, false})
  {
    std::vector<double> area = m_area;
    for (std::size_t v = 0; v < area.size(); ++v)
      if ((m_fragment_below[v] >= 0) != cut)
        area[v] = 0;
    result[cut ? "cut" : "outside_cut"] =
        error_json(distance_to_postoperative(findings, points, area));
  }
  return result;
}

json FaceComparison::compared(const PostoperativeFindings& findings) const
{
  json told = json::object();
  const std::pair<const char*, const char*> faces[] = {
      {"rest", "skin"},
      {"target", "target"},
      {"predicted", "predicted"},
      {"predicted_rigid-fit", "predicted_rigid-fit"},
      {"predicted_virtual-force", "predicted_virtual-force"}};
  for (const auto& [key, file] : faces)
  {
    const std::string name = std::string(file) + ".vtp";
    if (!m_folder.has(name))
      continue;
    const std::vector<Vec3> points = points_of(read_surface(m_folder.file(name)));
    if (points.size() == m_area.size())
      told[key] = errors(findings, points);
  }
  return told;
}

} // namespace

SkinError distance_to_postoperative(const PostoperativeFindings& findings,
                                    const std::vector<Vec3>& points,
                                    const std::vector<double>& area)
{
  std::vector<double> distance;
  std::vector<double> counting = area;
  const Vec3 last = lattice_of(findings.skin).last();
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const Vec3& p = points[v];
    if (!((p.array() >= findings.skin.origin.array()).all() && (p.array() <= last.array()).all()))
      counting[v] = 0;
    distance.push_back(findings.skin.value(p));
  }
  return skin_error(distance, counting);
}

PostoperativeFindings postoperative_findings(const CaseSession& session, const Path& ct,
                                             const PostoperativeOptions& options)
{
  const Stopwatch watch;
  const CaseFolder& folder = session.folder;
  const json cut = read_json(folder.require("cut.json", "cut"));
  const BonePartition partition = partition_of(folder);
  json warnings = json::array();
  std::vector<std::string> notes;
  const CtImage::Pointer after = read_ct(ct, &notes);
  for (const std::string& note : notes)
    warnings.push_back(note);
  const CtImage::Pointer before = read_ct(session.settings.ct, nullptr, session.settings.reading);
  const WholeBone whole = find_whole_bone(*before, session.settings.ct.string());
  const PostoperativeHead seen = find_postoperative_head(
      *before, whole, unaltered_region(folder, whole, partition.labels, options), *after,
      segment_options(session), options.registration, session.progress);

  PostoperativeFindings findings;
  findings.registration = seen.registration;
  findings.skin = seen.head.skin;
  const ScalarGrid bone = read_scalar_grid(folder.require("bone_distance.nrrd", "segment"));
  const std::vector<RigidMotion> planned = planned_motions(folder, cut);
  json fragments = json::array();
  for (std::size_t f = 0; f < planned.size(); ++f)
  {
    const std::string name = cut.at("fragments").at(f).at("name").get<std::string>();
    session.progress("measuring how '" + name + "' moved", 0.9);
    const auto label = static_cast<unsigned char>(BonePartition::first_fragment + f);
    const auto surface = fragment_surface(bone, partition, label);
    const FragmentMovement movement =
        measure_fragment_movement(surface, seen.head.bone, planned[f], name);
    json told = motion_json(name, movement.fit.motion);
    told.update({{"surface_rms_mm", movement.fit.rms_mm},
                 {"surface_share", movement.fit.inlier_share},
                 {"doubtful", movement.doubtful()}});
    if (folder.has("plan.json"))
    {
      told["from_plan_mm"] = mean_difference(movement.fit.motion, planned[f], surface);
      told["from_plan_deg"] = angle_between(movement.fit.motion, planned[f]) / degree;
    }
    if (movement.doubtful())
      warnings.push_back("'" + name + "' may have been found at a wrong place: " +
                         std::to_string(std::lround(100 * movement.fit.inlier_share)) +
                         " % of its surface meets bone");
    fragments.push_back(told);
    findings.movements.push_back(movement);
  }
  findings.document = {{"ct", ct.string()},
                       {"frame", "scanner RAS of the pre-operative CT"},
                       {"registration", registration_json(seen.registration)},
                       {"fragments", fragments},
                       {"warnings", warnings},
                       {"segmentation_notes", seen.head.notes}};
  findings.document["skin_distance_mm"] = FaceComparison(session, partition).compared(findings);
  findings.document["seconds"] = watch.seconds();
  return findings;
}

CtImage::Pointer synthetic_postoperative_ct(const CaseSession& session,
                                            const std::vector<RigidMotion>& motions,
                                            const MixedMesh& mesh, const std::vector<Vec3>& x,
                                            const PostoperativeCtOptions& options)
{
  const CaseFolder& folder = session.folder;
  const CtImage::Pointer ct = read_ct(session.settings.ct, nullptr, session.settings.reading);
  const ScalarGrid hu =
      resample_ct(*ct, lattice_over(extent_ras(*ct), session.settings.spacing_mm, anchor_ras(*ct)));
  const ScalarGrid bone = read_scalar_grid(folder.require("bone_distance.nrrd", "segment"));
  const BonePartition partition = partition_of(folder);
  const std::vector<std::array<int, 4>> tets = split_prisms(mesh).tets;
  return synthesize_postoperative_ct({hu, bone, partition, motions, tets, mesh.X, x}, options);
}

} // namespace f2b
