#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/verbs.hpp"
#include "Core/geometry/virtual_patient.hpp"
#include "Imaging/synthetic_ct.hpp"
#include "Imaging/write_ct.hpp"
#include "Meshing/isosurface.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

struct TrueDistances
{
  ScalarGrid skin, bone;
};

/// The patient's own distances over its field of view: what a segmentation should find.
TrueDistances sampled(const VirtualPatient& patient, const SyntheticCtOptions& ct)
{
  constexpr double spacing =
      1.5; // smooth shapes: the surface between samples is 0.1 mm off at most
  ScalarGrid grid;
  grid.origin = ct.lower_ras;
  grid.spacing = spacing;
  grid.size = ((ct.upper_ras - ct.lower_ras) / spacing).cast<int>() + Eigen::Vector3i::Ones();
  grid.values.resize(grid.count());
  TrueDistances distances{grid, grid};
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
      {
        const TissueDistances d = patient.distances(grid.position(i, j, k));
        distances.skin.values[grid.index(i, j, k)] = static_cast<float>(d.skin);
        distances.bone.values[grid.index(i, j, k)] = static_cast<float>(d.bone);
      }
  return distances;
}

/// Where the mid-face should go: forward by as much as it lies behind, the rest of the face held.
void write_warp(CaseChange& change, const VirtualPatient& patient)
{
  const double forward = patient.options().midface_retrusion_mm;
  const std::pair<const char*, double> moved[] = {
      {"prn", 1.0},   {"sn", 1.0},    {"ls", 1.0},  {"ch_R", 0.6}, {"ch_L", 0.6},
      {"Or'_R", 0.9}, {"Or'_L", 0.9}, {"N'", 0.35}, {"li", 0.2},   {"Pg'", 0.0}};
  PointMarkup from, to;
  for (const auto& [name, share] : moved)
  {
    const Vec3 p = patient.landmark(name);
    from.points.push_back({name, p});
    to.points.push_back({name, p + Vec3(0, share * forward, 0)});
  }
  write_points(change.file("target_from.mrk.json"), from);
  write_points(change.file("target_to.mrk.json"), to);
}

json sample_case(const VirtualPatient& patient)
{
  const Vec3 chin = patient.landmark("Me'"), nose = patient.landmark("prn"),
             root = patient.landmark("N'");
  return {{"schema", "facetobone-case/1"},
          {"name", "Virtual patient, retruded mid-face"},
          {"notes",
           "Made by 'facetobone sample'. The mid-face lies behind; the target brings it forward."},
          {"ct", "ct.nrrd"},
          {"landmarks", "landmarks.mrk.json"},
          {"region_ras",
           {{"min", to_json(Vec3(-76, root.y() - 105, chin.z() - 12))},
            {"max", to_json(Vec3(76, nose.y() + 8, root.z() + 45))}}},
          {"osteotomies", {{{"fragment", "mid-face"}, {"template", "le-fort-3"}}}},
          {"target",
           {{"warp",
             {{"from", "target_from.mrk.json"}, {"to", "target_to.mrk.json"}, {"radius_mm", 80}}},
            {"mask_mm", 1.0}}},
          {"materials", "table1-stable"}};
}

} // namespace

void write_sample(const Path& folder, const SampleOptions& options, const Progress& progress)
{
  VirtualPatientOptions patient_options;
  patient_options.midface_retrusion_mm = options.midface_retrusion_mm;
  const VirtualPatient patient(patient_options);
  SyntheticCtOptions ct;
  ct.spacing_mm = Vec3::Constant(options.spacing_mm);
  ct.noise_sd_hu = options.noise_sd_hu;
  ct.seed = options.seed;
  ct.streaks = options.streaks;
  ct.head_rest = options.head_rest;

  CaseFolder destination(folder);
  CaseChange change(destination);
  progress("scanning the virtual patient", 0);
  write_ct(*synthesize_ct(patient, ct), change.file("ct.nrrd"));
  progress("writing its true surfaces", 0.5);
  const TrueDistances truth = sampled(patient, ct);
  write_surface(change.file("true_skin.vtp"), watertight_isosurface(truth.skin));
  write_surface(change.file("true_bone.vtp"), watertight_isosurface(truth.bone));
  Landmarks landmarks;
  for (const NamedPoint& point : patient.landmarks())
    landmarks[point.name] = point.point_ras;
  write_landmarks(change.file("landmarks.mrk.json"), landmarks);
  write_warp(change, patient);
  write_json(change.file(case_settings_name), sample_case(patient));
  change.commit("sample");
  progress("sample made", 1);
}

} // namespace f2b
