#include "temporary_folder.hpp"

#include "qFaceToBoneCut.h"
#include "qFaceToBoneCuts.h"

#include <Bridge/markups.hpp>
#include <Bridge/vtk_surface.hpp>
#include <Core/geometry/virtual_patient.hpp>

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using nlohmann::json;

/// The cuts of a case with the virtual patient's landmarks; no window, no step.
class Cuts : public ::testing::Test
{
protected:
  Cuts()
  {
    const VirtualPatient patient{VirtualPatientOptions{}};
    for (const NamedPoint& p : patient.landmarks())
      landmarks[p.name] = p.point_ras;
    file = (folder / "landmarks.mrk.json").string();
    write_landmarks(file, landmarks);
    load({{"osteotomies",
           {{{"fragment", "maxilla"},
             {"template", "le-fort-1"},
             {"movement", {{"locked", {"roll"}}, {"bounds", {{"anterior", {0, 6}}}}}}}}}});
  }
  void load(const json& document, const json& unfinished = {})
  {
    cuts.load(document, unfinished, file);
  }
  const qFaceToBoneCut& cut(std::size_t k) { return cuts.all().at(k); }
  /// What the case would be told, read back.
  json written()
  {
    return {{"osteotomies", cuts.osteotomies(folder.path().string())},
            {"protected", cuts.spared()}};
  }
  qFaceToBoneCutCurve line() const
  {
    qFaceToBoneCutCurve curve;
    curve.onBone = true;
    curve.handles = {{10, 60, 0}, {0, 64, 2}, {-10, 60, 0}};
    curve.line = resampled_curve(curve.handles, false, false, 1.5);
    curve.saw.direction = Vec3(0, -1, 0.2).normalized();
    curve.saw.depth_mm = 17;
    curve.overrun = 4;
    curve.settle();
    return curve;
  }

  test::TemporaryFolder folder;
  Landmarks landmarks;
  std::string file;
  qFaceToBoneCuts cuts;
};

TEST_F(Cuts, EveryTemplateCanBeAddedAndHasANameOfItsOwn)
{
  EXPECT_FALSE(cuts.isMoved());
  const QStringList names = qFaceToBoneCuts::templates();
  EXPECT_EQ(names.size(), 9);
  for (const QString& name : names)
  {
    while (cuts.count() >= qFaceToBoneCuts::MostCuts)
      cuts.remove(0);
    ASSERT_TRUE(cuts.addTemplate(name)) << cuts.error().toStdString();
    EXPECT_EQ(cuts.current(), cuts.count() - 1);
    EXPECT_EQ(cut(std::size_t(cuts.current())).problem, "");
    EXPECT_NE(qFaceToBoneCuts::titleOf(name), name);
  }
  ASSERT_TRUE(cuts.remove(0));
  ASSERT_TRUE(cuts.addTemplate("zygoma-left"));
  EXPECT_EQ(cut(7).fragment, "zygoma left 2");
  EXPECT_TRUE(cuts.isMoved());
  EXPECT_FALSE(cuts.addTemplate("bsso")); // there are eight
  EXPECT_FALSE(cuts.error().isEmpty());
}

TEST_F(Cuts, UndoAndRedoAreExact)
{
  std::vector<std::string> states;
  const auto state = [&] { return written().dump(); };
  states.push_back(state());
  const auto expect = [&](bool done)
  {
    ASSERT_TRUE(done) << cuts.error().toStdString();
    states.push_back(state());
    ASSERT_NE(states.back(), states[states.size() - 2]);
  };
  expect(cuts.addTemplate("genioplasty"));
  expect(cuts.addPlane({0, 60, -40}, false));
  expect(cuts.addPlane({0, 60, -30}, true));
  expect(cuts.addCurve(line(), {0, 60, -8}, false));
  expect(cuts.addCurve(line(), {}, true));
  expect(cuts.rename(0, "upper jaw"));
  cuts.setKerf(1, 0.6);
  expect(true);
  cuts.setDepth(3, 12);
  expect(true);
  cuts.setPoint(0, {1, 2, 3});
  expect(true);
  expect(cuts.removePart(0, 1));
  expect(cuts.setRule("chin", 0, {true, false, 0, 0}));
  expect(cuts.remove(1));
  for (std::size_t k = states.size() - 1; k > 0; --k)
  {
    ASSERT_TRUE(cuts.undo());
    EXPECT_EQ(state(), states[k - 1]) << k;
  }
  EXPECT_FALSE(cuts.undo());
  EXPECT_FALSE(cuts.isChanged());
  for (std::size_t k = 1; k < states.size(); ++k)
  {
    ASSERT_TRUE(cuts.redo());
    EXPECT_EQ(state(), states[k]) << k;
  }
  EXPECT_FALSE(cuts.redo());
}

TEST_F(Cuts, ADragIsOneStepOfUndoAndNoneIfTakenBack)
{
  const BoundedPlane before = cut(0).planes[0];
  BoundedPlane plane = before;
  cuts.beginDrag();
  for (int k = 1; k <= 20; ++k)
  {
    plane.center = before.center + Vec3(0, 0, 0.1 * k);
    cuts.setPlane(0, 0, plane);
    EXPECT_FALSE(cuts.undo()); // not while the hand is on it
  }
  cuts.endDrag();
  EXPECT_TRUE(cut(0).drawn);
  ASSERT_TRUE(cuts.undo());
  EXPECT_EQ(cut(0).planes[0].center, before.center);
  EXPECT_FALSE(cut(0).drawn);
  ASSERT_TRUE(cuts.addPlane({0, 60, -40}, false));
  const BoundedPlane added = cut(1).planes[0];
  plane = added;
  cuts.beginDrag();
  plane.half_u = 50;
  cuts.setPlane(1, 0, plane);
  cuts.setPlane(1, 0, added);
  cuts.endDrag();
  ASSERT_TRUE(cuts.undo());
  EXPECT_EQ(cuts.count(), 1);
}

TEST_F(Cuts, WhatIsWrittenIsReadBack)
{
  ASSERT_TRUE(cuts.addTemplate("zygoma-right")); // a free line and a plane
  qFaceToBoneCutCurve curve = cut(1).curves[0];
  curve.handles[1] += Vec3(2, 0, 1);
  curve.line = curve.handles;
  curve.settle();
  cuts.setCurve(1, 0, curve);
  ASSERT_TRUE(cuts.addCurve(line(), {3, 55, -6}, false));
  ASSERT_TRUE(cuts.rename(2, "chin"));
  EXPECT_EQ(cut(2).curves.at(0).saw.name, "chin line 1");
  const json document = written();
  load(document);
  ASSERT_EQ(cuts.count(), 3);
  EXPECT_FALSE(cut(0).drawn);
  EXPECT_EQ(cut(0).movement["locked"][0], "roll");
  EXPECT_EQ(cut(1).templateName, "zygoma-right");
  EXPECT_EQ(cut(1).planes.size(), 1u);
  ASSERT_EQ(cut(1).curves.size(), 1u);
  EXPECT_FALSE(cut(1).curves[0].onBone);
  ASSERT_EQ(cut(1).curves[0].handles.size(), curve.handles.size());
  for (std::size_t k = 0; k < curve.handles.size(); ++k)
    EXPECT_LT((cut(1).curves[0].handles[k] - curve.handles[k]).norm(), 1e-9);
  const qFaceToBoneCutCurve& drawn = cut(2).curves.at(0);
  EXPECT_EQ(drawn.saw.name, "chin line 1");
  EXPECT_TRUE(drawn.onBone);
  ASSERT_EQ(drawn.handles.size(), 3u); // not the points between
  EXPECT_LT((drawn.handles[1] - Vec3(0, 64, 2)).norm(), 1e-9);
  EXPECT_LT((drawn.saw.direction - line().saw.direction).norm(), 1e-9);
  EXPECT_EQ(drawn.saw.depth_mm, 17);
  EXPECT_NEAR(drawn.overrun, 4, 1e-9);
  EXPECT_LT((drawn.saw.points.front() - line().saw.points.front()).norm(), 0.3);
  EXPECT_LT((cut(2).point - Vec3(3, 55, -6)).norm(), 1e-9);
  EXPECT_FALSE(cuts.isMoved());
  load(document, written()); // once more through files
  EXPECT_FALSE(cuts.isMoved());
  EXPECT_FALSE(cuts.isChanged());
}

TEST_F(Cuts, OpenLinesRunOnPastTheirEndsAcrossTheSaw)
{
  ASSERT_TRUE(cuts.addCurve(line(), {3, 55, -6}, false));
  const SweptCurve& saw = cut(1).curves[0].saw;
  const Vec3 past = saw.points.front() - line().line.front();
  EXPECT_NEAR(past.norm(), 4, 1e-9);
  EXPECT_NEAR(past.dot(saw.direction), 0, 1e-9);
  EXPECT_GT(past.x(), 2); // the way it comes from
  cuts.setOverrun(1, 9);
  EXPECT_NEAR((saw.points.back() - line().line.back()).norm(), 9, 1e-9);
  cuts.setOverrun(1, 0);
  EXPECT_EQ(cut(1).curves[0].saw.points, cut(1).curves[0].line);
  EXPECT_NO_THROW(require_swept(cut(1).curves[0].saw, 1));
}

TEST_F(Cuts, UnfinishedOnesAreThereAgainAndCountAsMoved)
{
  const json before = written();
  ASSERT_TRUE(cuts.addTemplate("bsso"));
  const json unfinished = written();
  load(before, unfinished);
  EXPECT_EQ(cuts.count(), 2);
  EXPECT_TRUE(cuts.isMoved());
}

TEST_F(Cuts, NamesThatCannotBeAreRefused)
{
  ASSERT_TRUE(cuts.addTemplate("genioplasty"));
  for (const char* name : {"", "  ", "chin/left", "maxilla", "predicted", "-x",
                           "a name that is much longer than any table of the report can hold"})
  {
    EXPECT_FALSE(cuts.rename(1, name)) << name;
    EXPECT_FALSE(cuts.error().isEmpty());
    EXPECT_EQ(cut(1).fragment, "chin");
  }
  EXPECT_TRUE(cuts.rename(1, " lower chin "));
  EXPECT_EQ(cut(1).fragment, "lower chin");
  EXPECT_FALSE(cuts.rename(7, "none"));
}

TEST_F(Cuts, RulesAreReadKeptAndRefused)
{
  qFaceToBoneRules rules = cuts.rules("maxilla");
  EXPECT_TRUE(rules.isLocked(4));
  EXPECT_EQ(rules.within(4, 3, 45), 0);
  EXPECT_EQ(rules.within(1, 9, 40), 6);
  EXPECT_EQ(rules.within(1, -2, 40), 0);
  EXPECT_EQ(rules.within(0, 99, 40), 40);
  QSignalSpy told(&cuts, &qFaceToBoneCuts::rulesChanged);
  ASSERT_TRUE(cuts.setRule("maxilla", 1, {true, true, 0, 6})); // locked: no bounds any more
  ASSERT_TRUE(cuts.setRule("maxilla", 2, {false, true, -1, 4.5}));
  EXPECT_EQ(told.count(), 2);
  EXPECT_EQ(
      cut(0).movement,
      json::parse(R"({"locked": ["roll", "anterior"], "bounds": {"superior": [-1.0, 4.5]}})"));
  EXPECT_FALSE(cuts.setRule("maxilla", 2, {false, true, 3, 3}));
  EXPECT_FALSE(cuts.setRule("no such", 2, {true, false, 0, 0}));
  ASSERT_TRUE(cuts.setRule("maxilla", 4, {}));
  ASSERT_TRUE(cuts.setRule("maxilla", 1, {}));
  ASSERT_TRUE(cuts.setRule("maxilla", 2, {}));
  EXPECT_TRUE(cut(0).movement.is_null());
  EXPECT_FALSE(cuts.isMoved());
  EXPECT_TRUE(cuts.isChanged());
  load({{"osteotomies",
         {{{"fragment", "maxilla"},
           {"template", "le-fort-1"},
           {"movement", {{"hinge", {{"axis", {"Co_R", "Co_L"}}}}}}}}}});
  EXPECT_FALSE(cuts.rules("maxilla").restraint.isEmpty());
  EXPECT_TRUE(cuts.rules("maxilla").isLocked(0));
}

TEST_F(Cuts, NervesNearACutAreToldWithTheirDistance)
{
  PointMarkup nerve;
  nerve.type = "Curve";
  const BoundedPlane plane = cut(0).planes[0];
  for (const double u : {-10.0, 0.0, 10.0})
    nerve.points.push_back({"", plane.center + u * plane.u + 3.5 * plane.normal()});
  write_points(folder / "nerve_right.mrk.json", nerve);
  ASSERT_TRUE(cuts.addSpared(QString::fromStdString((folder / "nerve_right.mrk.json").string())))
      << cuts.error().toStdString();
  ASSERT_EQ(cuts.clearances().size(), 1u);
  EXPECT_EQ(cuts.clearances()[0].name, "nerve right");
  EXPECT_NEAR(cuts.clearances()[0].distance, 3, 1e-6); // from the kerf's wall
  EXPECT_FALSE(cuts.clearances()[0].near);
  EXPECT_NE(cuts.clearances()[0].words.indexOf("3.0 mm"), -1);
  EXPECT_TRUE(cuts.clearances()[0].surface);
  BoundedPlane nearer = plane;
  nearer.center += 2 * plane.normal();
  cuts.setPlane(0, 0, nearer);
  EXPECT_NEAR(cuts.clearances()[0].distance, 1, 1e-6);
  EXPECT_TRUE(cuts.clearances()[0].near);
  cuts.setMargin(0, 0.5);
  EXPECT_FALSE(cuts.clearances()[0].near);
  nearer.center += 1.4 * plane.normal();
  cuts.setPlane(0, 0, nearer);
  EXPECT_NE(cuts.clearances()[0].words.indexOf("through"), -1);
  const json document = written();
  load(document);
  EXPECT_EQ(cuts.clearances().size(), 1u);
  cuts.removeSpared(0);
  EXPECT_TRUE(cuts.clearances().empty());
  ASSERT_TRUE(cuts.undo());
  EXPECT_EQ(cuts.clearances().size(), 1u);
  EXPECT_FALSE(cuts.addSpared("/no/such/nerve.mrk.json"));
  folder.write("empty.vtp", "");
  EXPECT_FALSE(cuts.addSpared(QString::fromStdString((folder / "empty.vtp").string())));
}

TEST_F(Cuts, WithoutLandmarksATemplateSaysWhatIsMissing)
{
  cuts.load({{"osteotomies", {{{"template", "le-fort-1"}}}}}, {}, "");
  ASSERT_EQ(cuts.count(), 1);
  EXPECT_NE(cut(0).problem.find("landmark"), std::string::npos);
  EXPECT_FALSE(cuts.addTemplate("bsso"));
  EXPECT_NE(cuts.error().indexOf("landmark"), -1);
  EXPECT_TRUE(cuts.addPlane({0, 0, 0}, false));
}

} // namespace
} // namespace f2b
