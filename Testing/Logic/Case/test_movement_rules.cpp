#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/markups.hpp>
#include <Bridge/transform_file.hpp>
#include <Case/movement_rules.hpp>

namespace f2b
{
namespace
{

using nlohmann::json;
using test::expect_error;

constexpr double degree = 3.14159265358979323846 / 180;

/// A case with two cuts, of which the second one's fragment has rules.
struct Rules : ::testing::Test
{
  Rules()
  {
    write_landmarks(folder / "points.mrk.json", {{"Co_R", {50, 0, 0}},
                                                 {"Co_L", {-50, 0, 0}},
                                                 {"U1", {0, 80, -40}},
                                                 {"U6_R", {25, 50, -40}},
                                                 {"U6_L", {-25, 50, -40}}});
    mesh.fragments = {"maxilla", "mandible"};
  }
  FragmentRules read(const json& movement)
  {
    json document = {
        {"schema", "facetobone-case/1"},
        {"ct", "ct.nrrd"},
        {"landmarks", (folder / "points.mrk.json").string()},
        {"osteotomies",
         {{{"fragment", "maxilla"}, {"template", "le-fort-1"}},
          {{"fragment", "mandible"}, {"template", "genioplasty"}, {"movement", movement}}}},
        {"target", {{"mesh", "edited.vtp"}}}};
    CaseSession session(folder / "case", document, folder / "case.json");
    std::filesystem::copy_file(folder / "points.mrk.json",
                               session.folder.file("landmarks.mrk.json"),
                               std::filesystem::copy_options::overwrite_existing);
    return movement_rules(session, mesh).at(1);
  }
  void refused(const json& movement, const std::vector<std::string>& parts)
  {
    SCOPED_TRACE(movement.dump());
    expect_error([&] { read(movement); }, parts);
  }

  test::TemporaryFolder folder;
  MixedMesh mesh;
};

TEST_F(Rules, AreFreeWhereTheCaseSaysNothing)
{
  const FragmentRules rules = read(json::object());
  for (const CoordinateRule& rule : rules.coordinates)
  {
    EXPECT_FALSE(rule.is_locked);
    EXPECT_EQ(rule.least, -CoordinateRule::unlimited);
    EXPECT_EQ(rule.sd, CoordinateRule::unlimited);
  }
  EXPECT_FALSE(rules.hinge || rules.bite);
}

TEST_F(Rules, HaveAnglesInDegreesAndShiftsInMillimetres)
{
  const FragmentRules rules =
      read({{"locked", {"yaw"}},
            {"bounds", {{"pitch", {-5, 10}}, {"superior", {0, 4}}}},
            {"prior", {{"roll", {{"expected", 2}, {"sd", 1}}}, {"right", {{"sd", 0.5}}}}}});
  EXPECT_TRUE(rules.coordinates[2].is_locked);
  EXPECT_DOUBLE_EQ(rules.coordinates[0].least, -5 * degree);
  EXPECT_DOUBLE_EQ(rules.coordinates[0].most, 10 * degree);
  EXPECT_DOUBLE_EQ(rules.coordinates[5].most, 4);
  EXPECT_DOUBLE_EQ(rules.coordinates[1].expected, 2 * degree);
  EXPECT_DOUBLE_EQ(rules.coordinates[1].sd, 1 * degree);
  EXPECT_DOUBLE_EQ(rules.coordinates[3].sd, 0.5);
  EXPECT_EQ(rules.coordinates[3].expected, 0);
}

TEST_F(Rules, KnowAHingeByLandmarksOrPoints)
{
  const FragmentRules rules =
      read({{"hinge", {{"axis", {"Co_L", json::array({50, 0, 0})}}, {"bounds_deg", {-2, 8}}}}});
  ASSERT_TRUE(rules.hinge);
  EXPECT_LT((rules.hinge->direction - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((rules.hinge->point - Vec3(-50, 0, 0)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(rules.hinge->angle.most, 8 * degree);
}

TEST_F(Rules, KnowABiteByPointsOrBySplint)
{
  const RigidMotion truth{rotation_from({0.1, -0.05, 0.02}), {1, -2, 3}, {4, 5, 6}};
  const Landmarks from = read_landmarks(folder / "points.mrk.json");
  Landmarks to;
  for (const auto& [label, p] : from)
    to[label] = truth.apply(p);
  write_landmarks(folder / "to.mrk.json", to);
  write_transform(folder / "splint.tfm", truth.matrix());
  const std::vector<json> bites = {
      {{"with", "maxilla"},
       {"points",
        {{"from", (folder / "points.mrk.json").string()},
         {"to", (folder / "to.mrk.json").string()}}}},
      {{"with", "maxilla"}, {"splint", (folder / "splint.tfm").string()}, {"tolerance_mm", 0.5}}};
  for (const json& bite : bites)
  {
    const FragmentRules rules = read({{"bite", bite}});
    ASSERT_TRUE(rules.bite);
    EXPECT_EQ(rules.bite->leader, 0);
    const Vec3 p(7, -8, 9);
    EXPECT_LT((rules.bite->splint.apply(p) - truth.apply(p)).norm(), 1e-6);
  }
  const FragmentRules tolerant = read({{"bite", bites[1]}});
  ASSERT_EQ(tolerant.bite->points.size(), 3u); // the teeth
  EXPECT_LT((tolerant.bite->points[0] - Vec3(0, 80, -40)).norm(), 1e-9);
  EXPECT_EQ(read({{"bite", json::object()}}).bite->leader, BiteRelation::bone_that_stays);
}

TEST_F(Rules, AreRefusedWhereTheyCannotBeMeant)
{
  const std::string where = "'/osteotomies/1/movement'";
  refused({{"locked", {"pitch"}}, {"bounds", {{"pitch", {0, 1}}}}}, {where, "pitch"});
  refused({{"hinge", {{"axis", {"Co_R", "Co_R"}}}}}, {where, "one place"});
  refused({{"hinge", {{"axis", {"Co_R", "Condyle"}}}}}, {where, "'Condyle'"});
  refused({{"hinge", {{"axis", {"Co_R", "Co_L"}}}}, {"locked", {"pitch"}}}, {where, "hinge"});
  refused({{"bite", {{"with", "chin"}}}}, {where, "'chin'"});
  refused({{"bite", {{"splint", "none.tfm"}}}}, {"none.tfm"});
  refused({{"locked", {"sideways"}}}, {"/osteotomies/1/movement/locked/0", "pitch"});
  refused({{"bound", json::object()}}, {"/osteotomies/1/movement/bound", "bounds"});
  write_landmarks(folder / "line.mrk.json",
                  {{"a", {0, 0, 0}}, {"b", {10, 0, 0}}, {"c", {20, 0, 0}}});
  const std::string line = (folder / "line.mrk.json").string();
  refused({{"bite", {{"points", {{"from", line}, {"to", line}}}}}}, {"line.mrk.json", "triangle"});
  Mat4 scaling = Mat4::Identity();
  scaling(0, 0) = 2;
  write_transform(folder / "scaling.tfm", scaling);
  refused({{"bite", {{"splint", (folder / "scaling.tfm").string()}}}}, {"scaling.tfm", "rigid"});
}

} // namespace
} // namespace f2b
