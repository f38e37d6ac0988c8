#include "Case/fragment_json.hpp"

#include "Case/case_session.hpp"

namespace f2b
{

using nlohmann::json;

namespace
{
constexpr double degree = 3.14159265358979323846 / 180;
} // namespace

json motion_json(const std::string& fragment, const RigidMotion& motion)
{
  const EulerAngles angles = euler_angles(motion.rotation);
  const Mat4 m = motion.matrix();
  json matrix = json::array();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix.push_back(m(r, c));
  const Vec3& t = motion.translation;
  return {{"name", fragment},
          {"matrix_ras", matrix},
          {"reference_point_ras", to_json(motion.reference_point)},
          {"translation_mm", {{"right", t.x()}, {"anterior", t.y()}, {"superior", t.z()}}},
          {"rotation_deg",
           {{"pitch", angles.pitch / degree},
            {"roll", angles.roll / degree},
            {"yaw", angles.yaw / degree}}}};
}

RigidMotion motion_from(const json& fragment)
{
  RigidMotion motion;
  motion.reference_point = vec3_from(fragment.at("reference_point_ras"));
  const json& t = fragment.at("translation_mm");
  motion.translation = {t.at("right").get<double>(), t.at("anterior").get<double>(),
                        t.at("superior").get<double>()};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      motion.rotation(r, c) =
          fragment.at("matrix_ras").at(static_cast<std::size_t>(4 * r + c)).get<double>();
  return motion;
}

json error_json(const SkinError& e)
{
  return {{"mean", e.mean},
          {"sd", e.sd},
          {"variance", e.variance},
          {"median", e.median},
          {"p90", e.p90},
          {"p95", e.p95},
          {"max", e.max},
          {"under_1mm", e.under_1mm},
          {"under_2mm", e.under_2mm},
          {"signed_mean", e.signed_mean},
          {"area_mm2", e.area_mm2}};
}

} // namespace f2b
