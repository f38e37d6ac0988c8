#include <Case/fragment_json.hpp>
#include <Case/patient_frame_json.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;

/// A head that lies turned by 90 degrees about S: its front points to the scanner's right.
Landmarks turned_head()
{
  return {{"N", {80, 0, 0}},
          {"Or_R", {66, -32, -24}},
          {"Or_L", {66, 32, -24}},
          {"Po_R", {-10, -60, -24}},
          {"Po_L", {-10, 60, -24}}};
}

TEST(PatientFrameJson, SameMovementAlongThePatientsAxes)
{
  RigidMotion forwards;
  forwards.translation = {5, -2, 1};
  forwards.rotation = rotation_from({0, 0, 4 * degree});
  nlohmann::json plan = {
      {"methods", {{"rigid-fit", {{"fragments", {motion_json("maxilla", forwards)}}}}}}};
  add_patient_frame(plan, turned_head());
  const auto& told = plan["methods"]["rigid-fit"]["fragments"][0]["in_patient_frame"];
  EXPECT_NEAR(told["translation_mm"]["anterior"].get<double>(), 5, 1e-9);
  EXPECT_NEAR(told["translation_mm"]["right"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(told["translation_mm"]["superior"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(told["rotation_deg"]["yaw"].get<double>(), 4, 1e-9);
  EXPECT_NEAR(told["rotation_deg"]["pitch"].get<double>(), 0, 1e-9);
  const auto& kept = plan["methods"]["rigid-fit"]["fragments"][0]["translation_mm"];
  EXPECT_NEAR(kept["right"].get<double>(), 5, 1e-12) << "the scanner's numbers stay";
}

TEST(PatientFrameJson, MissingLandmarksAreNamed)
{
  Landmarks few = turned_head();
  few.erase("Po_L");
  nlohmann::json plan = {{"methods", nlohmann::json::object()}};
  add_patient_frame(plan, few);
  EXPECT_EQ(plan["patient_frame"]["missing_landmarks"], nlohmann::json({"Po_L"}));
}

} // namespace
} // namespace f2b
