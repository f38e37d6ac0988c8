#include "Case/evaluation.hpp"

#include "Case/fragment_json.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

/// How far every point of the fragments is put from where it really went.
struct BoneErrors
{
  TriangleMesh surface;               ///< of all fragments together, where they really went
  std::vector<double> distance, area; ///< of its vertices [mm, mm^2]

  SkinError error() const { return skin_error(distance, area); }
};

BoneErrors bone_errors(const Evaluation& e, const std::vector<RigidMotion>& found,
                       const std::vector<RigidMotion>& actual)
{
  BoneErrors errors;
  for (std::size_t f = 0; f < found.size(); ++f)
  {
    const TriangleMesh rest = to_triangle_mesh(read_surface(e.session.folder.require(
        "fragment_" + file_part(e.face.mesh.fragments[f]) + ".vtp", "cut")));
    const int first = static_cast<int>(errors.surface.points.size());
    for (const Vec3& p : rest.points)
    {
      errors.surface.points.push_back(actual[f].apply(p));
      errors.distance.push_back((found[f].apply(p) - errors.surface.points.back()).norm());
    }
    for (const Triangle& t : rest.triangles)
      errors.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const std::vector<double> area = vertex_areas(rest);
    errors.area.insert(errors.area.end(), area.begin(), area.end());
  }
  return errors;
}

json motions_json(const Evaluation& e, const std::vector<RigidMotion>& motions)
{
  json list = json::array();
  for (std::size_t f = 0; f < motions.size(); ++f)
    list.push_back(motion_json(e.face.mesh.fragments[f], motions[f]));
  return list;
}

json sub_experiment(const Evaluation& e, const ActualOutcome& actual, const SkinTarget& target,
                    const std::string& name, const json& paper)
{
  const TwoPlans plans = plan_by_both(e, target);
  json methods = json::object();
  MapPanels maps;
  maps.is_signed = false;
  maps.bar_title = "found - actual place of the bone [mm]";
  for (const bool is_fit : {true, false})
  {
    const char* method = is_fit ? "rigid-fit" : "virtual-force";
    const auto& motions = is_fit ? plans.fit.motions : plans.dragged.motions;
    const BoneErrors errors = bone_errors(e, motions, actual.motions);
    methods[method] = {{"bone_error_mm", error_json(errors.error())},
                       {"fragments", motions_json(e, motions)}};
    auto surface = to_polydata(errors.surface);
    add_point_array(surface, MapPanel::values, errors.distance);
    maps.panels.push_back({surface, name + ": " + method, text_of(errors.error())});
  }
  const double rigid = methods["rigid-fit"]["bone_error_mm"]["mean"];
  const double dragged = methods["virtual-force"]["bone_error_mm"]["mean"];
  write_png(map_panels_picture(maps, {700, 900}), e.file("experiment2_" + name + ".png"));
  return {{"name", name},
          {"methods", methods},
          {"paper_mm", paper},
          {"virtual_force_over_rigid_fit", rigid > 0 ? json(dragged / rigid) : json()}};
}

} // namespace

json compare_bones(const Evaluation& e, const ActualOutcome& actual,
                   const std::vector<Vec3>& mixed_face)
{
  const SkinTarget own{mixed_face, std::vector<double>(mixed_face.size(), 1.0), {}};
  json s1 =
      sub_experiment(e, actual, own, "S1", {{"mean", 1.87}, {"variance", 2.93}, {"max", 3.57}});
  s1["target"] = "the face that nfm-em predicted in Experiment 1: a self-test, no truth";
  json s2 = sub_experiment(e, actual, actual.skin, "S2",
                           {{"mean", 1.58}, {"variance", 2.56}, {"max", 3.21}});
  s2["target"] = "the skin that was measured after the operation (" +
                 actual.document.at("kind").get<std::string>() + ")";
  return {{"rows", {s1, s2}}, {"actual", motions_json(e, actual.motions)}};
}

} // namespace f2b
