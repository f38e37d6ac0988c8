#include "Case/case_pictures.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/mesh_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/case_session.hpp"
#include "Case/mesh_pictures.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/geometry/movement_words.hpp"
#include "Core/geometry/saw_blade.hpp"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <limits>

namespace f2b
{
namespace
{

using nlohmann::json;

Surface cut_quads(const std::vector<Osteotomy>& osteotomies)
{
  TriangleMesh mesh;
  for (const SawFacet& facet : saw_facets(osteotomies))
  {
    const BoundedPlane& p = facet.plane;
    const int first = static_cast<int>(mesh.points.size());
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      mesh.points.push_back(p.center + a * p.half_u * p.u + b * p.half_v * p.v);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return to_polydata(mesh);
}

Surface surface_if_there(const CaseFolder& folder, const std::string& name)
{
  return folder.has(name) ? read_surface(folder.file(name)) : nullptr;
}

FragmentPicture fragment_picture(const CaseFolder& folder, const std::string& name)
{
  FragmentPicture fragment;
  fragment.name = name;
  fragment.rest = read_surface(folder.require("fragment_" + file_part(name) + ".vtp", "cut"));
  return fragment;
}

void add_plan(FragmentPicture& fragment, const CaseFolder& folder, const json& plan)
{
  for (const json& f : plan.at("methods").at("rigid-fit").at("fragments"))
    if (f.at("name") == fragment.name)
    {
      fragment.planned =
          read_surface(folder.require(file_part(fragment.name) + "_rigid-fit.vtp", "plan"));
      for (std::size_t i = 0; i < 16; ++i)
        fragment.matrix_ras[i] = f.at("matrix_ras").at(i).get<double>();
      for (std::size_t i = 0; i < 3; ++i)
        fragment.reference_point_ras[i] = f.at("reference_point_ras").at(i).get<double>();
      const json& t = f.at("translation_mm");
      fragment.movement =
          translation_phrase({t.at("right").get<double>(), t.at("anterior").get<double>(),
                              t.at("superior").get<double>()});
      fragment.intervals = plan_intervals(plan, fragment.name);
    }
}

vtkSmartPointer<vtkImageData> ct_image(const Path& path)
{
  const ScalarGrid grid = read_scalar_grid(path);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.size.x(), grid.size.y(), grid.size.z());
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(grid.values.size()));
  std::copy(grid.values.begin(), grid.values.end(), values->GetPointer(0));
  image->GetPointData()->SetScalars(values);
  return image;
}

} // namespace

std::optional<MovementIntervals> plan_intervals(const json& plan, const std::string& fragment)
{
  const json& method = plan.at("methods").at("rigid-fit");
  const json all = method.value("intervals", json::object()).value("fragments", json::object());
  if (!all.contains(fragment))
    return {};
  const json& mine = all.at(fragment);
  auto half = [&](const char* coordinate)
  {
    return mine.contains(coordinate) ? mine.at(coordinate).at("half_90").get<double>()
                                     : std::numeric_limits<double>::quiet_NaN();
  };
  return MovementIntervals{{half("right"), half("anterior"), half("superior")},
                           {half("pitch"), half("roll"), half("yaw")}};
}

PlanPictures case_pictures(const CaseFolder& folder, const PictureNeeds& needs)
{
  PlanPictures pictures;
  pictures.skin = read_surface(folder.require("skin.vtp", "segment"));
  pictures.uncut_bone = surface_if_there(folder, "uncut_bone.vtp");
  if (!pictures.uncut_bone)
    pictures.uncut_bone = read_surface(folder.require("bone.vtp", "segment"));
  if (folder.has("cuts.mrk.json"))
    pictures.cut_planes = cut_quads(placed_osteotomies(folder));
  pictures.target = surface_if_there(folder, "target.vtp");
  if (pictures.target)
  {
    std::vector<double> length;
    for (const Vec3& d : point_vectors(pictures.target, "displacement"))
      length.push_back(d.norm());
    add_point_array(pictures.skin, target_displacement_array, length);
  }
  pictures.predicted = surface_if_there(folder, "predicted_rigid-fit.vtp");
  if (folder.has("cut.json"))
  {
    const json cut = read_json(folder.file("cut.json"));
    for (const json& f : cut.at("fragments"))
      pictures.fragments.push_back(fragment_picture(folder, f.at("name").get<std::string>()));
  }
  if (folder.has("plan.json"))
  {
    const json plan = read_json(folder.file("plan.json"));
    for (FragmentPicture& fragment : pictures.fragments)
      add_plan(fragment, folder, plan);
  }
  if (needs.mesh && folder.has("mesh.vtu"))
    add_mesh_pictures(pictures, folder);
  if (needs.ct && folder.has("ct.nrrd"))
    pictures.ct = ct_image(folder.file("ct.nrrd"));
  return pictures;
}

} // namespace f2b
