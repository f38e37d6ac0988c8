#include <Core/geometry/face_regions.hpp>
#include <Core/geometry/rigid_motion.hpp>
#include <Core/geometry/virtual_patient.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

const VirtualPatient& patient()
{
  static const VirtualPatient instance;
  return instance;
}

Landmarks landmarks_of(const VirtualPatient& who)
{
  Landmarks landmarks;
  for (const NamedPoint& p : who.landmarks())
    landmarks[p.name] = p.point_ras;
  return landmarks;
}

FaceRegion region_at(const Vec3& point, const Landmarks& landmarks)
{
  return face_regions({point}, landmarks).at(0);
}

/// The skin in front of a place, looked for from outside along +A.
Vec3 skin_before(double right, double superior)
{
  Vec3 p(right, 140, superior);
  while (patient().skin(p) > 0.05)
    p.y() -= 0.5 * patient().skin(p);
  return p;
}

TEST(FaceRegions, SoftTissueLandmarksLieInTheirRegions)
{
  const Landmarks l = landmarks_of(patient());
  const std::pair<const char*, FaceRegion> expected[] = {{"prn", FaceRegion::Nose},
                                                         {"ls", FaceRegion::UpperLip},
                                                         {"li", FaceRegion::LowerLip},
                                                         {"Pg'", FaceRegion::Chin},
                                                         {"Me'", FaceRegion::Chin}};
  for (const auto& [name, region] : expected)
    EXPECT_EQ(name_of(region_at(l.at(name), l)), name_of(region)) << name;
}

TEST(FaceRegions, EveryPlaceOfTheFaceHasItsRegion)
{
  const Landmarks l = landmarks_of(patient());
  struct Place
  {
    double right, superior;
    const char* key;
  };
  for (const Place& p :
       {Place{0, 30, "forehead"}, Place{35, -10, "orbit_right"}, Place{-35, -10, "orbit_left"},
        Place{0, -20, "nose"}, Place{45, -45, "cheek_right"}, Place{-45, -45, "cheek_left"},
        Place{12, -62, "upper_lip"}, Place{-12, -80, "lower_lip"}, Place{5, -100, "chin"},
        Place{42, -90, "jaw_right"}, Place{-42, -90, "jaw_left"}})
    EXPECT_EQ(key_of(region_at(skin_before(p.right, p.superior), l)), p.key)
        << p.right << " " << p.superior;
  EXPECT_EQ(region_at({0, 30, -135}, l), FaceRegion::Neck);
  EXPECT_EQ(region_at({0, -90, 0}, l), FaceRegion::Other) << "back of the head";
  EXPECT_EQ(region_at({75, -15, -20}, l), FaceRegion::Other) << "ear";
}

TEST(FaceRegions, TurnAndMoveWithThePatient)
{
  const Landmarks rest = landmarks_of(patient());
  RigidMotion motion;
  motion.rotation = rotation_from({0.4, -0.3, 1.1});
  motion.translation = {100, -40, 7};
  Landmarks moved = rest;
  for (auto& [name, point] : moved)
    point = motion.apply(point);
  std::vector<Vec3> points, moved_points;
  for (double s = -125.3; s < 70; s += 7.1)
    for (double r = -70.2; r < 71; r += 7.3)
      points.push_back({r, 55 - 0.01 * r * r, s});
  for (const Vec3& p : points)
    moved_points.push_back(motion.apply(p));
  const std::vector<FaceRegion> regions = face_regions(points, rest);
  EXPECT_EQ(face_regions(moved_points, moved), regions);
  for (const FaceRegion region : all_face_regions())
    EXPECT_NE(std::count(regions.begin(), regions.end(), region), 0) << name_of(region);
}

TEST(FaceRegions, RightAndLeftMirrorEachOther)
{
  const Landmarks l = landmarks_of(patient());
  auto mirrored = [](FaceRegion region)
  {
    std::string key = key_of(region);
    if (const auto at = key.find("right"); at != std::string::npos)
      key.replace(at, 5, "left");
    return key;
  };
  for (double s = -120.3; s < 60; s += 4.1)
    for (double r = 0.7; r < 70; r += 4.3)
    {
      const Vec3 p(r, 60 - 0.01 * r * r, s);
      EXPECT_EQ(key_of(region_at({-r, p.y(), s}, l)), mirrored(region_at(p, l))) << r << " " << s;
    }
}

TEST(FaceRegions, ChinFollowsADeviatedMandible)
{
  VirtualPatientOptions options;
  options.chin_deviation_mm = 5;
  const VirtualPatient deviated(options);
  const Landmarks l = landmarks_of(deviated);
  const double middle = l.at("Pg'").x();
  EXPECT_GT(middle, 3);
  for (const double side : {-20.0, 20.0})
  {
    Vec3 p = l.at("Pg'") + Vec3(side, 0, 4);
    EXPECT_EQ(region_at(p, l), FaceRegion::Chin) << side;
    p.x() += side > 0 ? 8 : -8;
    EXPECT_NE(region_at(p, l), FaceRegion::Chin) << side;
  }
}

TEST(FaceRegions, WithoutSoftTissueLandmarksTheMouthIsFoundByTheTeeth)
{
  const Landmarks full = landmarks_of(patient());
  Landmarks hard = full;
  for (const char* name : {"sn", "ls", "li", "ch_R", "ch_L"})
    hard.erase(name);
  EXPECT_TRUE(missing_for_face_regions(hard).empty());
  EXPECT_EQ(region_at(full.at("ls"), hard), FaceRegion::UpperLip);
  EXPECT_EQ(region_at(full.at("li"), hard), FaceRegion::LowerLip);
  EXPECT_EQ(region_at(full.at("prn"), hard), FaceRegion::Nose);
}

TEST(FaceRegions, WithoutLandmarksAllIsOtherAndTheMissingOnesAreNamed)
{
  Landmarks l = landmarks_of(patient());
  const Vec3 nose = l.at("prn");
  l.erase("N");
  l.erase("Go_L");
  EXPECT_EQ(missing_for_face_regions(l), (std::vector<std::string>{"N", "Go_L"}));
  EXPECT_EQ(region_at(nose, l), FaceRegion::Other);
  EXPECT_EQ(missing_for_face_regions({}).size(), 14u);
}

TEST(FaceRegions, ValuesOfTheArrayAreTheEnumerators)
{
  for (const FaceRegion region : all_face_regions())
    EXPECT_EQ(face_region_of(static_cast<int>(region)), region);
  for (const double value : {-1.0, 13.0, 2.5, std::nan("")})
    EXPECT_FALSE(face_region_of(value).has_value()) << value;
}

} // namespace
} // namespace f2b
