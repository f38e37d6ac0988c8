#include <Core/error.hpp>
#include <Core/geometry/virtual_patient.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace
{

using f2b::Vec3;
using f2b::VirtualPatient;

const VirtualPatient& patient()
{
  static const VirtualPatient instance;
  return instance;
}

bool on_skin(const std::string& name)
{
  static const std::set<std::string> plain = {"prn", "cm", "sn", "ls", "li", "ch_R", "ch_L"};
  return plain.count(name) || name.find('\'') != std::string::npos;
}

std::map<std::string, Vec3> landmark_map(const VirtualPatient& who)
{
  std::map<std::string, Vec3> map;
  for (const auto& landmark : who.landmarks())
    map[landmark.name] = landmark.point_ras;
  return map;
}

void for_grid(const Vec3& lower, const Vec3& upper, double step,
              const std::function<void(const Vec3&)>& visit)
{
  for (double z = lower.z(); z <= upper.z(); z += step)
    for (double y = lower.y(); y <= upper.y(); y += step)
      for (double x = lower.x(); x <= upper.x(); x += step)
        visit({x, y, z});
}

Vec3 gradient(const std::function<double(const Vec3&)>& field, const Vec3& p)
{
  const double h = 1e-4;
  Vec3 g;
  for (int axis = 0; axis < 3; ++axis)
    g[axis] = (field(p + h * Vec3::Unit(axis)) - field(p - h * Vec3::Unit(axis))) / (2 * h);
  return g;
}

TEST(VirtualPatientTest, LandmarksLieOnTheirSurfaces)
{
  for (double retrusion : {0.0, 6.0, 10.0})
  {
    f2b::VirtualPatientOptions options;
    options.midface_retrusion_mm = retrusion;
    options.chin_deviation_mm = 3;
    const VirtualPatient who(options);
    for (const auto& landmark : who.landmarks())
    {
      if (landmark.name == "S") // the middle of a hollow
        continue;
      const double d =
          on_skin(landmark.name) ? who.skin(landmark.point_ras) : who.bone(landmark.point_ras);
      EXPECT_LT(std::abs(d), 1.5) << landmark.name << ", retrusion " << retrusion;
    }
  }
}

TEST(VirtualPatientTest, EveryPromisedLandmarkIsThere)
{
  const auto map = landmark_map(patient());
  for (const char* name : {"N",   "S",    "Or_R", "Or_L", "Po_R", "Po_L", "Zy_R",  "Zy_L", "ANS",
                           "PNS", "A",    "U1",   "U6_R", "U6_L", "L1",   "B",     "Pg",   "Me",
                           "Gn",  "Go_R", "Go_L", "Co_R", "Co_L", "prn",  "cm",    "sn",   "ls",
                           "li",  "Pg'",  "Me'",  "N'",   "ch_R", "ch_L", "Or'_R", "Or'_L"})
    EXPECT_EQ(map.count(name), 1U) << name;
  EXPECT_THROW(patient().landmark("nowhere"), f2b::Error);
}

TEST(VirtualPatientTest, HasTheSizeOfAnAdult)
{
  const auto at = landmark_map(patient());
  EXPECT_NEAR((at.at("N") - at.at("Me")).norm(), 119, 6);
  EXPECT_NEAR((at.at("Zy_R") - at.at("Zy_L")).norm(), 130, 4);
  EXPECT_NEAR((at.at("ANS") - at.at("PNS")).norm(), 52, 5);
  EXPECT_NEAR((at.at("Go_R") - at.at("Go_L")).norm(), 94, 8);
  EXPECT_NEAR(at.at("prn").y() - at.at("sn").y(), 17.5, 4);
  EXPECT_GT(at.at("U1").z(), at.at("L1").z() + 2) << "the bite is open";
}

TEST(VirtualPatientTest, SellaLiesInAFossaThatIsOpenAbove)
{
  const Vec3 sella = patient().landmark("S");
  const double clearance = patient().bone(sella);
  EXPECT_GT(clearance, 3);
  EXPECT_LT(clearance, 6);
  EXPECT_LT(patient().brain(sella + Vec3(0, 0, 12)), 0) << "the brain case is above it";
  for (double rise = 0; rise <= 12; rise += 0.5)
    EXPECT_GT(patient().bone(sella + Vec3(0, 0, rise)), 1) << rise;
  for (const Vec3& wall : {Vec3(0, -8, 0), Vec3(0, 8, 0), Vec3(0, 0, -8)})
    EXPECT_LT(patient().bone(sella + wall), 0) << wall.transpose();
  EXPECT_NEAR((patient().landmark("N") - sella).norm(), 70, 3);
}

TEST(VirtualPatientTest, RetrusionMovesTheMidfaceOnly)
{
  f2b::VirtualPatientOptions normal;
  normal.midface_retrusion_mm = 0;
  const auto before = landmark_map(VirtualPatient(normal)), after = landmark_map(patient());
  for (const char* name : {"ANS", "A", "U1", "U6_R", "prn"})
    EXPECT_NEAR(before.at(name).y() - after.at(name).y(), 6, 1.2) << name;
  EXPECT_LT((before.at("N") - after.at("N")).norm(), 1) << "the nasal bones begin there";
  for (const char* name : {"Po_R", "Pg", "Me", "Go_R", "Co_R", "Pg'", "Me'"})
    EXPECT_LT((before.at(name) - after.at(name)).norm(), 0.3) << name;
}

TEST(VirtualPatientTest, IsSymmetric)
{
  for_grid({3, -100, -130}, {90, 110, 110}, 11,
           [](const Vec3& p)
           {
             const Vec3 mirror(-p.x(), p.y(), p.z());
             const auto right = patient().distances(p), left = patient().distances(mirror);
             EXPECT_EQ(right.skin, left.skin);
             EXPECT_EQ(right.bone, left.bone);
             EXPECT_EQ(right.muscle, left.muscle);
             EXPECT_EQ(right.air, left.air);
           });
}

TEST(VirtualPatientTest, SoftTissueCoversTheBonesOfTheFace)
{
  for_grid({0, 10, -120}, {75, 100, 60}, 2.5,
           [](const Vec3& p)
           {
             const auto d = patient().distances(p);
             if (d.bone < 0)
             {
               EXPECT_LT(d.skin, -4) << p.transpose();
             }
           });
}

TEST(VirtualPatientTest, GradientsAreNearOneAtTheSurfaces)
{
  const std::function<double(const Vec3&)> fields[] = {
      [](const Vec3& p) { return patient().skin(p); },
      [](const Vec3& p) { return patient().bone(p); }};
  for (const auto& field : fields)
  {
    int near = 0, odd = 0;
    for_grid({1.3, -100, -125}, {90, 112, 105}, 4.1,
             [&](const Vec3& p)
             {
               if (std::abs(field(p)) > 1)
                 return;
               const double slope = gradient(field, p).norm();
               ++near;
               odd += slope < 0.3 || slope > 1.2;
             });
    EXPECT_GT(near, 500);
    EXPECT_LE(odd, near / 200); // creases, where the central difference straddles two shapes
  }
}

TEST(VirtualPatientTest, MandibleKeepsClearOfTheSkull)
{
  // Where the mandible's distance is d, any other bone must be at least the joint space away.
  for_grid({0, -14, -80}, {65, 90, -15}, 1.7,
           [](const Vec3& p)
           {
             const double jaw = patient().mandible(p);
             if (jaw > 0.3 && jaw < 1.9)
             {
               EXPECT_GT(patient().bone(p), 0) << p.transpose();
             }
           });
}

TEST(VirtualPatientTest, OcclusalPlaneRunsBetweenTheToothRows)
{
  const double level = 0.5 * (patient().landmark("U6_R").z() + patient().landmark("L1").z() + 1.0);
  for_grid({0, 20, level}, {36, 95, level}, 0.5,
           [](const Vec3& p) { EXPECT_GT(patient().bone(p), 0.4) << p.transpose(); });
}

TEST(VirtualPatientTest, RefusesOptionsOutOfRange)
{
  f2b::VirtualPatientOptions options;
  options.midface_retrusion_mm = 30;
  EXPECT_THROW(VirtualPatient{options}, f2b::Error);
  options.midface_retrusion_mm = std::nan("");
  EXPECT_THROW(VirtualPatient{options}, f2b::Error);
}

} // namespace
