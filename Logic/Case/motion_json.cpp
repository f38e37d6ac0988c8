#include "Case/motion_json.hpp"

#include "Case/case_session.hpp"

namespace f2b
{

using nlohmann::json;

json motion_json(const std::string& name, const RigidMotion& motion)
{
  constexpr double degree = 3.14159265358979323846 / 180;
  const EulerAngles angles = euler_angles(motion.rotation);
  const Mat4 m = motion.matrix();
  json matrix = json::array();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix.push_back(m(r, c));
  const Vec3& t = motion.translation;
  return {{"name", name},
          {"matrix_ras", matrix},
          {"reference_point_ras", to_json(motion.reference_point)},
          {"translation_mm", {{"right", t.x()}, {"anterior", t.y()}, {"superior", t.z()}}},
          {"rotation_deg",
           {{"pitch", angles.pitch / degree},
            {"roll", angles.roll / degree},
            {"yaw", angles.yaw / degree}}}};
}

} // namespace f2b
