#include "Case/case_settings.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/resources.hpp"
#include "Case/schema_check.hpp"
#include "Case/settings_paths.hpp"
#include "Core/error.hpp"
#include "Core/geometry/face_regions.hpp"
#include "Core/geometry/osteotomy_templates.hpp"
#include "Imaging/volume_name.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>

namespace f2b
{
namespace
{

using nlohmann::json;

constexpr double degree = 3.14159265358979323846 / 180;

Vec3 point_from(const json& value)
{
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

/// Replaces ${NAME} by the environment variable of that name.
std::string with_environment(std::string text, const Path& source)
{
  for (auto begin = text.find("${"); begin != std::string::npos; begin = text.find("${", begin))
  {
    const auto end = text.find('}', begin);
    const std::string name =
        text.substr(begin + 2, end == std::string::npos ? end : end - begin - 2);
    const char* value = std::getenv(name.c_str());
    if (end == std::string::npos || !value)
      throw Error(source.string(), "the path '" + text + "' uses " + name + ", which is not set",
                  "set the environment variable " + name + " or write the path out");
    text.replace(begin, end - begin + 1, value);
    begin += std::strlen(value);
  }
  return text;
}

Path resolved(const std::string& written, const Path& source)
{
  const std::string text = with_environment(written, source);
  const Path path = std::filesystem::u8path(text);
  return path.is_absolute() ? path : std::filesystem::absolute(source).parent_path() / path;
}

template <class Value>
void take(const json& object, const char* key, Value& value)
{
  if (object.contains(key))
    value = object[key].get<Value>();
}

template <class Value>
void take(const json& object, const char* key, std::optional<Value>& value)
{
  if (object.contains(key))
    value = object[key].get<Value>();
}

void take_path(const json& object, const char* key, const Path& source, Path& value)
{
  if (object.contains(key))
    value = resolved(object[key].get<std::string>(), source);
}

StatedMovement movement_from(const json& value)
{
  StatedMovement movement;
  const json translation = value.value("translation_mm", json::object());
  const json rotation = value.value("rotation_deg", json::object());
  movement.translation = {translation.value("right", 0.0), translation.value("anterior", 0.0),
                          translation.value("superior", 0.0)};
  movement.rotation_deg = {rotation.value("pitch", 0.0), rotation.value("roll", 0.0),
                           rotation.value("yaw", 0.0)};
  return movement;
}

Movements movements_from(const json& value)
{
  Movements movements;
  for (const auto& [fragment, movement] : value.items())
    movements[fragment] = movement_from(movement);
  return movements;
}

void require_known_template(const std::string& name, const std::string& where, const Path& source)
{
  std::string known;
  for (const std::string& other : osteotomy_template_names())
  {
    if (name.empty() || name == other)
      return;
    known += (known.empty() ? "" : ", ") + other;
  }
  throw Error(source.string(), where + " has the template '" + name + "', which is not known",
              "use one of " + known);
}

CurveSettings curve_from(const json& value, const Path& source)
{
  CurveSettings curve;
  take_path(value, "markup", source, curve.markup);
  if (value.contains("direction_ras"))
    curve.direction = point_from(value["direction_ras"]);
  take(value, "depth_mm", curve.depth_mm);
  take(value, "lead_mm", curve.lead_mm);
  take(value, "straight", curve.straight);
  return curve;
}

std::vector<ProtectedSettings> protected_from(const json& document, const Path& source)
{
  std::vector<ProtectedSettings> structures;
  for (const json& value : document.value("protected", json::array()))
  {
    ProtectedSettings p;
    take(value, "name", p.name);
    take_path(value, "curve", source, p.curve);
    take_path(value, "mesh", source, p.mesh);
    take(value, "margin_mm", p.margin_mm);
    if (p.curve.empty() == p.mesh.empty())
      throw Error(source.string(),
                  "'/protected' has '" + p.name + "' with " +
                      (p.curve.empty() ? "neither" : "both") + " curve and mesh",
                  "give exactly one of them");
    structures.push_back(std::move(p));
  }
  return structures;
}

OsteotomySettings osteotomy_from(const json& value, std::size_t index, const Path& source)
{
  OsteotomySettings o;
  const std::string where = "'/osteotomies/" + std::to_string(index) + "'";
  take(value, "fragment", o.fragment);
  take(value, "template", o.template_name);
  take(value, "kerf_mm", o.kerf_mm);
  for (const json& file : value.value("planes", json::array()))
    o.planes.push_back(resolved(file.get<std::string>(), source));
  if (value.contains("fragment_point_ras"))
    o.fragment_point = point_from(value["fragment_point_ras"]);
  for (const json& curve : value.value("curves", json::array()))
    o.curves.push_back(curve_from(curve, source));
  if (o.template_name.empty() && !o.drawn())
    throw Error(source.string(), where + " has neither template nor planes nor curves",
                "give a template, or draw the cuts");
  if (o.template_name.empty() && (!o.fragment_point || o.fragment.empty()))
    throw Error(source.string(),
                where + " has drawn cuts but no fragment_point_ras or no fragment name",
                "name the fragment and give a point on the bone that is to be free");
  require_known_template(o.template_name, where, source);
  o.movement = value.value("movement", json());
  visit_rule_paths(o.movement,
                   [&](json& path) { path = resolved(path.get<std::string>(), source).string(); });
  return o;
}

TargetSettings target_from(const json& value, const Path& source)
{
  TargetSettings target;
  take_path(value, "mesh", source, target.mesh);
  if (value.contains("scan"))
  {
    take_path(value["scan"], "mesh", source, target.scan);
    take(value["scan"], "reach_mm", target.scan_reach_mm);
    target.registration_sd_mm = 0.3; // what registering two faces leaves, each component
  }
  if (value.contains("warp"))
  {
    take_path(value["warp"], "from", source, target.warp_from);
    take_path(value["warp"], "to", source, target.warp_to);
    take(value["warp"], "radius_mm", target.warp_radius_mm);
  }
  if (value.contains("from_movement"))
    target.movements = movements_from(value["from_movement"]);
  take(value, "mask_mm", target.mask_mm);
  take(value, "registration_sd_mm", target.registration_sd_mm);
  if (target.kinds() != 1)
    throw Error(source.string(),
                "'/target' has " + std::to_string(target.kinds()) +
                    " of mesh, scan, warp and from_movement",
                "give exactly one of them");
  return target;
}

VirtualForceSettings virtual_force_from(const json& value)
{
  VirtualForceSettings v;
  if (value.contains("stiffness_n_per_mm3") && value["stiffness_n_per_mm3"].is_string())
    v.stiffness_n_per_mm3.reset(); // auto
  else
    take(value, "stiffness_n_per_mm3", v.stiffness_n_per_mm3);
  take(value, "residual_mm", v.residual_mm);
  take(value, "rest_length_mm", v.rest_length_mm);
  take(value, "load", v.load);
  take(value, "landmarks", v.landmarks);
  return v;
}

void read_groups(const json& document, CaseSettings& s)
{
  const json none = json::object();
  const json thresholds = document.value("thresholds", none);
  take(thresholds, "skin_hu", s.skin_threshold_hu);
  take(thresholds, "bone_hu", s.bone_threshold_hu);
  const json segmentation = document.value("segmentation", none);
  take(segmentation, "spacing_mm", s.spacing_mm);
  take(segmentation, "head_closing_mm", s.head_closing_mm);
  take(segmentation, "bone_closing_mm", s.bone_closing_mm);
  take(segmentation, "surface_error_mm", s.surface_error_mm);
  s.level_set = segmentation.value("bone", "") == "level-set";
  const json mesh = document.value("mesh", none);
  take(mesh, "density", s.mesh_density);
  take(mesh, "tetrahedra", s.mesh_tetrahedra);
  take(mesh, "release_margin_mm", s.release_margin_mm);
  take(mesh, "contact_tolerance_mm", s.contact_tolerance_mm);
  const json solver = document.value("solver", none);
  take(solver, "threads", s.threads);
  take(solver, "max_newton_iterations", s.max_newton_iterations);
  take(solver, "max_fit_iterations", s.max_fit_iterations);
  take(solver, "step_tolerance_mm", s.step_tolerance_mm);
  s.virtual_force = virtual_force_from(solver.value("virtual_force", none));
  take(solver, "predict_model", s.predict_model);
}

void require_region(const std::string& key, const Path& source)
{
  std::string known;
  for (const FaceRegion region : all_face_regions())
  {
    if (key_of(region) == key)
      return;
    known += (known.empty() ? "" : ", ") + key_of(region);
  }
  throw Error(source.string(),
              "'/skin_thickness_by_region_mm/" + key + "' is no region of the face",
              "use " + known);
}

/// What must fit together between one key and another.
void check_together(const CaseSettings& s, const Path& source)
{
  std::vector<std::string> named;
  for (const OsteotomySettings& o : s.osteotomies)
  {
    if (!o.fragment.empty())
      named.push_back(o.fragment);
    if (!o.template_name.empty() && s.landmarks.empty())
      throw Error(source.string(),
                  "the template '" + o.template_name +
                      "' needs landmarks, and '/landmarks' is absent",
                  "give a file of Slicer fiducials");
  }
  require_distinct_fragments(named, source.string());
  if (!s.virtual_force.landmarks.empty() && s.landmarks.empty())
    throw Error(source.string(),
                "'/solver/virtual_force/landmarks' names landmarks, and '/landmarks' is absent",
                "give a file of Slicer fiducials");
  for (const auto& [key, thickness] : s.skin_thickness_by_region_mm)
    require_region(key, source);
  if (!s.seeds.empty() && !s.level_set)
    throw Error(source.string(),
                "'/segmentation/seeds' is given, and '/segmentation/bone' is not "
                "level-set",
                "set it to level-set: the threshold grows from no seeds");
  if (s.region_ras && !(s.region_ras->min.array() < s.region_ras->max.array()).all())
    throw Error(source.string(), "'/region_ras' has a min that is not below its max on every axis",
                "exchange the coordinates of that axis");
  if (s.skin_threshold_hu && s.bone_threshold_hu && *s.skin_threshold_hu >= *s.bone_threshold_hu)
    throw Error(source.string(), "'/thresholds/skin_hu' is not below '/thresholds/bone_hu'",
                "give about -250 and 250");
}

} // namespace

RigidMotion StatedMovement::about(const Vec3& reference_point) const
{
  const Vec3 angles = rotation_deg * degree;
  return {rotation_from({angles[0], angles[1], angles[2]}), translation, reference_point};
}

json read_case(const Path& file)
{
  const bool folder = std::filesystem::is_directory(file);
  if (folder && std::filesystem::exists(file / "case.json"))
    throw Error(file.string(), "it is a case folder", "give its case.json");
  if (!folder && volume_format(file) == VolumeFormat::None)
    return read_json(file);
  return {{"schema", "facetobone-case/1"}, {"ct", std::filesystem::absolute(file).string()}};
}

void require_cuts(const CaseSettings& settings)
{
  if (settings.osteotomies.empty())
    throw Error("case.json", "'/osteotomies' is absent: there is nothing to cut",
                "name a template, such as {\"template\": \"le-fort-1\"}, or planes or curves");
}

void require_target(const CaseSettings& settings)
{
  if (settings.target.kinds() == 0)
    throw Error("case.json", "'/target' is absent: no face is to be reached",
                "give a mesh, a scan, a warp or from_movement");
}

CaseSettings parse_settings(const json& document, const Path& source)
{
  static const json schema = json::parse(*carried_resource("Schema/case.schema.json"));
  check_against_schema(document, schema, source.string());
  CaseSettings s;
  s.name = document.value("name", source.stem().string());
  take_path(document, "ct", source, s.ct);
  take_path(document, "landmarks", source, s.landmarks);
  take(document, "series", s.reading.series);
  s.reading.shifted_grey_values = document.value("grey_values", "") == "cbct";
  if (document.contains("region_ras"))
    s.region_ras =
        Box{point_from(document["region_ras"]["min"]), point_from(document["region_ras"]["max"])};
  take(document, "skin_thickness_mm", s.skin_thickness_mm);
  take(document, "skin_thickness_by_region_mm", s.skin_thickness_by_region_mm);
  read_groups(document, s);
  take_path(document.value("segmentation", json::object()), "seeds", source, s.seeds);
  take_path(document.value("segmentation", json::object()), "labels", source, s.labels);
  const json osteotomies = document.value("osteotomies", json::array());
  for (std::size_t i = 0; i < osteotomies.size(); ++i)
    s.osteotomies.push_back(osteotomy_from(osteotomies[i], i, source));
  s.protected_structures = protected_from(document, source);
  if (document.contains("target"))
    s.target = target_from(document["target"], source);
  s.predict = movements_from(document.value("predict", json::object()));
  check_together(s, source);
  take(document, "materials", s.materials);
  if (!carried_resource("materials/" + s.materials + ".json"))
    s.materials = resolved(s.materials, source).string();
  return s;
}

std::string file_part(std::string fragment)
{
  std::replace(fragment.begin(), fragment.end(), ' ', '_');
  return fragment;
}

void require_distinct_fragments(const std::vector<std::string>& names, const std::string& source)
{
  std::set<std::string> taken = {"predicted"}; // of the face: predicted_METHOD.vtp
  for (const std::string& name : names)
    if (!taken.insert(file_part(name)).second)
      throw Error(source, "the name '" + name + "' of a fragment is already taken",
                  "give each fragment its own name");
}

void require_known_fragments(const Movements& movements, const std::vector<std::string>& fragments,
                             const std::string& source)
{
  for (const auto& [name, movement] : movements)
  {
    if (std::find(fragments.begin(), fragments.end(), name) != fragments.end())
      continue;
    std::string known;
    for (const std::string& fragment : fragments)
      known += (known.empty() ? "'" : ", '") + fragment + "'";
    throw Error(source, "it moves a fragment '" + name + "' that no cut frees", "use " + known);
  }
}

json with_absolute_paths(json document, const Path& source)
{
  visit_paths(document, [&](json& text)
              { text = resolved(text.get<std::string>(), source).lexically_normal().string(); });
  return document;
}

} // namespace f2b
