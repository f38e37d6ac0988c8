#include <Core/geometry/cephalometry.hpp>
#include <Core/geometry/patient_frame.hpp>
#include <Core/geometry/rigid_motion.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;

/// A head whose Frankfort horizontal is level and whose measures are known by construction.
Landmarks drawn_head()
{
  Landmarks l = {{"N", {0, 80, 0}},        {"Or_R", {32, 66, -24}},   {"Or_L", {-32, 66, -24}},
                 {"Po_R", {60, -10, -24}}, {"Po_L", {-60, -10, -24}}, {"ANS", {0, 78, -50}},
                 {"PNS", {0, 30, -50}},    {"Me", {0, 72, -110}},     {"prn", {0, 100, -35}},
                 {"Pg'", {0, 90, -100}},   {"ls", {0, 93, -60}},      {"Go_R", {45, 10, -80}},
                 {"Go_L", {-45, 10, -80}}};
  // S-N rises forwards by 7 degrees; A 82 and B 80 degrees from it
  l["S"] = l["N"] - 70 * Vec3(0, std::cos(7 * degree), std::sin(7 * degree));
  auto below = [&](double sn_angle, double length)
  {
    const double a = (180 + 7 + sn_angle) * degree;
    return Vec3(l["N"] + length * Vec3(0, std::cos(a), std::sin(a)));
  };
  l["A"] = below(82, 55);
  l["B"] = below(80, 95);
  l["Pg"] = below(81, 108);
  return l;
}

std::map<std::string, double> values(const Landmarks& landmarks)
{
  std::map<std::string, double> result;
  for (const CephalometricMeasure& m : cephalometry(landmarks))
    result[m.name] = m.value;
  return result;
}

TEST(Cephalometry, AnglesOfADrawnHead)
{
  auto v = values(drawn_head());
  EXPECT_NEAR(v.at("SNA"), 82, 1e-9);
  EXPECT_NEAR(v.at("SNB"), 80, 1e-9);
  EXPECT_NEAR(v.at("ANB"), 2, 1e-9);
  EXPECT_NEAR(v.at("SNPg"), 81, 1e-9);
  // N-Pg leans 2 degrees backwards from the vertical of the Frankfort horizontal
  EXPECT_NEAR(v.at("facial angle"), 88, 1e-9);
  EXPECT_NEAR(v.at("FH-PP"), 0, 1e-9);
  const double plane = std::atan2(30, 62) / degree;
  EXPECT_NEAR(v.at("FH-MP"), plane, 1e-9);
  EXPECT_NEAR(v.at("SN-MP"), plane + 7, 1e-9);
  EXPECT_NEAR(v.at("N-ANS"), std::hypot(2, 50), 1e-9);
  EXPECT_GT(v.at("convexity"), 0) << "A lies in front of N-Pg";
  // E line at the height of ls is 100 - 10 * 25 / 65
  EXPECT_NEAR(v.at("E line to ls"), (93 - (100 - 10 * 25.0 / 65)) * 65 / std::hypot(10, 65), 1e-9);
  EXPECT_EQ(v.count("Co-A"), 0U);
  EXPECT_EQ(v.count("nasolabial angle"), 0U);
}

TEST(Cephalometry, AMovedMaxillaChangesSnaAlone)
{
  const Landmarks rest = drawn_head();
  Landmarks moved = rest;
  moved["A"] += Vec3(0, 5, 0);
  auto before = values(rest), after = values(moved);
  EXPECT_GT(after.at("SNA"), before.at("SNA") + 4);
  EXPECT_NEAR(after.at("ANB") - before.at("ANB"), after.at("SNA") - before.at("SNA"), 1e-9);
  EXPECT_GT(after.at("convexity"), before.at("convexity"));
  EXPECT_EQ(after.at("SNB"), before.at("SNB"));
  moved["A"] -= Vec3(0, 20, 0);
  EXPECT_LT(values(moved).at("convexity"), 0);
}

TEST(Cephalometry, AnbNeedsNoSella)
{
  Landmarks l = drawn_head();
  l.erase("S");
  auto v = values(l);
  EXPECT_NEAR(v.at("ANB"), 2, 1e-9);
  EXPECT_EQ(v.count("SNA"), 0U);
  l["A"] -= Vec3(0, 20, 0);
  EXPECT_LT(values(l).at("ANB"), -5);
}

TEST(Cephalometry, TellsWhichLandmarksAreMissingForWhat)
{
  using Names = std::vector<std::string>;
  Landmarks every;
  for (const LandmarkDefinition& d : landmark_definitions())
    every[d.name] = Vec3::Zero();
  EXPECT_TRUE(left_out_measures(every).landmarks.empty());
  EXPECT_TRUE(left_out_measures(every).measures.empty());
  every.erase("S");
  every.erase("Co_L");
  const LeftOutMeasures some = left_out_measures(every);
  EXPECT_EQ(some.landmarks, (Names{"S", "Co_L"}));
  EXPECT_EQ(some.measures, (Names{"SNA", "SNB", "SNPg", "SN-MP", "gonial angle", "Co-A", "Co-Gn"}));
  every.erase("Or_R");
  const LeftOutMeasures all = left_out_measures(every);
  EXPECT_EQ(all.landmarks, (Names{"S", "Or_R", "Co_L"}));
  EXPECT_EQ(all.measures.size(), 20U) << "no mid-sagittal plane";
}

TEST(Cephalometry, DoesNotDependOnWhereTheHeadLies)
{
  Landmarks l = drawn_head();
  const auto rest = values(l);
  RigidMotion motion;
  motion.rotation = rotation_from({0.5, -0.7, 2});
  motion.translation = {10, 200, -30};
  for (auto& [name, point] : l)
    point = motion.apply(point);
  for (const auto& [name, value] : values(l))
    EXPECT_NEAR(value, rest.at(name), 1e-9) << name;
}

TEST(Cephalometry, EveryMeasureIsFiniteAndNeedsKnownLandmarks)
{
  Landmarks every;
  double k = 0;
  for (const LandmarkDefinition& d : landmark_definitions())
  {
    k += 1;
    every[d.name] = Vec3(10 * std::sin(7 * k), 50 * std::sin(3 * k), 50 * std::cos(5 * k));
  }
  const auto measures = cephalometry(every);
  EXPECT_EQ(measures.size(), 20U);
  for (const CephalometricMeasure& m : measures)
    EXPECT_TRUE(std::isfinite(m.value)) << m.name;
  every["S"] = every["N"];
  EXPECT_LT(cephalometry(every).size(), measures.size()) << "an angle at a point that is its leg";
  EXPECT_TRUE(cephalometry(Landmarks{}).empty());
}

TEST(PatientFrame, FrankfortHorizontalIsLevel)
{
  Landmarks l = drawn_head();
  RigidMotion tilt;
  tilt.rotation = rotation_from({0.2, 0.1, -0.3});
  tilt.translation = {5, 6, 7};
  for (auto& [name, point] : l)
    point = tilt.apply(point);
  const auto frame = patient_frame(l);
  ASSERT_TRUE(frame);
  EXPECT_NEAR((frame->right - tilt.rotation.col(0)).norm(), 0, 1e-12);
  EXPECT_NEAR((frame->anterior - tilt.rotation.col(1)).norm(), 0, 1e-12);
  EXPECT_NEAR((frame->superior - tilt.rotation.col(2)).norm(), 0, 1e-12);
  EXPECT_NEAR((frame->point(l["Or_R"]) - Vec3(32, -14, -24)).norm(), 0, 1e-12);
  l.erase("Po_L");
  EXPECT_FALSE(patient_frame(l));
  EXPECT_EQ(missing_for_patient_frame(l), std::vector<std::string>{"Po_L"});
}

} // namespace
} // namespace f2b
