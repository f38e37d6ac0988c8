#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/bone_part_surface.hpp"
#include "Case/verbs.hpp"
#include "Core/mesh/contact.hpp"
#include "Meshing/isosurface.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

Osteotomy osteotomy_from(const OsteotomySettings& o, const Landmarks& landmarks)
{
  if (!o.template_name.empty())
  {
    Osteotomy osteotomy =
        osteotomy_from_template(o.template_name, o.fragment, landmarks, o.kerf_mm);
    if (o.fragment_point)
      osteotomy.fragment_point = *o.fragment_point;
    return osteotomy;
  }
  Osteotomy osteotomy;
  osteotomy.fragment = o.fragment;
  osteotomy.fragment_point = *o.fragment_point;
  osteotomy.kerf_mm = o.kerf_mm;
  for (const Path& file : o.planes)
    for (BoundedPlane& plane : read_planes(file))
      osteotomy.planes.push_back(std::move(plane));
  return osteotomy;
}

} // namespace

void cut_case(CaseSession& session)
{
  const Stopwatch watch;
  const CaseFolder& folder = session.folder;
  const ScalarGrid bone = read_scalar_grid(folder.require("bone_distance.nrrd", "segment"));
  const ScalarGrid closed =
      read_scalar_grid(folder.require("closed_bone_distance.nrrd", "segment"));
  const Landmarks landmarks = folder.has("landmarks.mrk.json")
                                  ? read_landmarks(folder.file("landmarks.mrk.json"))
                                  : Landmarks{};
  std::vector<Osteotomy> osteotomies;
  for (const OsteotomySettings& o : session.settings.osteotomies)
    osteotomies.push_back(osteotomy_from(o, landmarks));

  session.progress("cutting the bone", 0.1);
  const BonePartition partition = cut_bone(bone, closed, osteotomies);

  CaseChange change(session.folder);
  write_json(change.file(case_settings_name), session.document);
  std::vector<BoundedPlane> planes;
  json fragments = json::array();
  for (std::size_t f = 0; f < osteotomies.size(); ++f)
  {
    session.progress("cutting the bone",
                     0.3 + 0.5 * static_cast<double>(f) / static_cast<double>(osteotomies.size()));
    const auto label = static_cast<unsigned char>(BonePartition::first_fragment + f);
    const auto surface = bone_part_surface(bone, partition, label);
    const SurfaceCheck check = check_surface(surface);
    const Osteotomy& o = osteotomies[f];
    write_surface(change.file("fragment_" + file_part(o.fragment) + ".vtp"), surface);
    planes.insert(planes.end(), o.planes.begin(), o.planes.end());
    fragments.push_back({{"name", o.fragment},
                         {"reference_point_ras", to_json(area_centroid(to_triangle_mesh(surface)))},
                         {"fragment_point_ras", to_json(o.fragment_point)},
                         {"kerf_mm", o.kerf_mm},
                         {"planes", o.planes.size()},
                         {"volume_mm3", check.volume_mm3},
                         {"open_edges", check.open_edges}});
  }
  write_surface(change.file("uncut_bone.vtp"),
                bone_part_surface(bone, partition, BonePartition::uncut));
  write_planes(change.file("cuts.mrk.json"), planes);
  write_grid(change.file("bone_parts.nrrd"), partition.labels);
  write_json(change.file("cut.json"), {{"seconds", watch.seconds()}, {"fragments", fragments}});
  change.commit("cut");
  session.progress("cut", 1);
}

} // namespace f2b
