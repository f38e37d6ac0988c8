#include "expect_error.hpp"

#include "Logic/Core/flat_sheet.hpp"

#include <Core/sculpting/sculpting_session.hpp>

#include <algorithm>
#include <random>

namespace f2b
{
namespace
{

const Vec3 into_the_picture(0, -1, 0);

constexpr std::array all_kinds{BrushKind::Grab,   BrushKind::ElasticGrab, BrushKind::Draw,
                               BrushKind::Smooth, BrushKind::Flatten,     BrushKind::Erase,
                               BrushKind::Mask,   BrushKind::Unmask};

/// A nose on a face of 80 x 80 mm.
TriangleMesh face()
{
  return testing::make_sheet(
      80, 80, [](double r, double s) { return 15 * std::exp(-(r * r + s * s) / 150); });
}

Brush brush_of(BrushKind kind, double radius = 12)
{
  Brush brush;
  brush.kind = kind;
  brush.radius_mm = radius;
  return brush;
}

void stroke(SculptingSession& session, const Brush& brush, const Vec3& from, const Vec3& to)
{
  const auto place = [&](const Vec3& p) { return session.skin().tree().nearest(p); };
  session.begin_stroke(brush, place(from), into_the_picture);
  for (int k = 1; k <= 4; ++k)
  {
    const Vec3 at = from + k / 4.0 * (to - from);
    if (brush.drags())
      session.drag(at - from);
    else
      session.dab(place(at));
  }
  session.end_stroke();
}

/// Every bit of what sculpting changes and of what follows from it.
std::string bits(const SculptingSession& session)
{
  std::string all;
  auto append = [&](const void* data, std::size_t bytes)
  { all.append(static_cast<const char*>(data), bytes); };
  const SculptedSkin& skin = session.skin();
  for (const auto* field : {&skin.displacement(), &skin.points(), &skin.normals()})
    append(field->data(), field->size() * sizeof(Vec3));
  append(skin.mask().data(), skin.mask().size() * sizeof(double));
  return all;
}

int vertex_at(int column, int row)
{
  return row * 81 + column;
}

TEST(SculptingSession, GrabMovesTheMiddleByTheDragAndNothingBeyondTheRadius)
{
  for (const BrushKind kind : {BrushKind::Grab, BrushKind::ElasticGrab})
  {
    SculptingSession session(testing::make_sheet(80, 80));
    const Brush brush = brush_of(kind, 10);
    const Vec3 drag(1, 5, -2);
    stroke(session, brush, Vec3::Zero(), drag);
    EXPECT_LT((session.skin().displacement()[vertex_at(40, 40)] - drag).norm(), 1e-9);
    for (std::size_t v = 0; v < session.skin().size(); ++v)
    {
      if (session.skin().rest()[v].norm() > 1.02 * brush.reach_mm())
      {
        EXPECT_EQ(session.skin().displacement()[v], Vec3::Zero());
      }
    }
  }
}

TEST(SculptingSession, GrabDependsOnWhereItEndsNotOnTheWay)
{
  SculptingSession direct(face()), wandering(face());
  const Brush brush = brush_of(BrushKind::ElasticGrab);
  const SurfacePlace nose = direct.skin().tree().nearest({0, 15, 0});
  direct.begin_stroke(brush, nose, into_the_picture);
  direct.drag({0, 4, 1});
  direct.end_stroke();
  wandering.begin_stroke(brush, nose, into_the_picture);
  for (const Vec3& drag : {Vec3(9, 0, 0), Vec3(0, -20, 3), Vec3(0, 4, 1)})
    wandering.drag(drag);
  wandering.end_stroke();
  EXPECT_EQ(bits(direct), bits(wandering));
}

TEST(SculptingSession, ElasticGrabHasNoCrease)
{
  // largest second difference of the displacement along a row, per mm of drag
  auto crease = [](BrushKind kind, Falloff curve)
  {
    SculptingSession session(testing::make_sheet(80, 80));
    Brush brush = brush_of(kind, 10);
    brush.curve = curve;
    stroke(session, brush, Vec3::Zero(), {0, 4, 0});
    double most = 0;
    for (int i = 1; i < 80; ++i)
    {
      const auto& u = session.skin().displacement();
      const double bend =
          u[vertex_at(i - 1, 40)].y() - 2 * u[vertex_at(i, 40)].y() + u[vertex_at(i + 1, 40)].y();
      if (std::abs(i - 40) > 8)
        most = std::max(most, std::abs(bend) / 4);
    }
    return most;
  };
  EXPECT_LT(crease(BrushKind::ElasticGrab, Falloff::Smooth),
            0.2 * crease(BrushKind::Grab, Falloff::Linear));
}

TEST(SculptingSession, DrawBuildsUpAndInvertedCarves)
{
  SculptingSession session(testing::make_sheet(80, 80));
  Brush brush = brush_of(BrushKind::Draw, 10);
  brush.strength = 0.5;
  session.begin_stroke(brush, session.skin().tree().nearest(Vec3::Zero()), into_the_picture);
  session.end_stroke();
  EXPECT_NEAR(session.skin().displacement()[vertex_at(40, 40)].y(), 0.5, 1e-6);
  brush.inverted = true;
  session.begin_stroke(brush, session.skin().tree().nearest(Vec3::Zero()), into_the_picture);
  session.end_stroke();
  EXPECT_NEAR(session.skin().displacement()[vertex_at(40, 40)].y(), 0, 1e-5);
}

TEST(SculptingSession, SmoothLessensARoughDisplacement)
{
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Vec3> rough(81 * 81);
  for (Vec3& d : rough)
    d = {0, noise(random), 0};
  SculptingSession session(face(), rough);
  stroke(session, brush_of(BrushKind::Smooth, 20), {-3, 12, 0}, {3, 12, 0});
  double before = 0, after = 0;
  for (int j = 36; j < 45; ++j)
    for (int i = 36; i < 45; ++i)
    {
      before += rough[vertex_at(i, j)].squaredNorm();
      after += session.skin().displacement()[vertex_at(i, j)].squaredNorm();
    }
  EXPECT_LT(after, 0.1 * before);
}

TEST(SculptingSession, SmoothLeavesThePatientsOwnNose)
{
  SculptingSession session(face());
  stroke(session, brush_of(BrushKind::Smooth, 20), {-3, 12, 0}, {3, 12, 0});
  EXPECT_EQ(session.skin().points(), session.skin().rest());
  EXPECT_FALSE(session.history().can_undo());
}

TEST(SculptingSession, FlattenLowersTheNose)
{
  SculptingSession session(face());
  stroke(session, brush_of(BrushKind::Flatten, 15), {0, 15, 0}, {0, 15, 0.5});
  EXPECT_LT(session.skin().points()[vertex_at(40, 40)].y(), 13);
  EXPECT_GT(session.skin().points()[vertex_at(50, 40)].y(),
            session.skin().rest()[vertex_at(50, 40)].y());
}

TEST(SculptingSession, EraseGoesBackToExactlyZero)
{
  SculptingSession session(face());
  stroke(session, brush_of(BrushKind::Grab), {0, 15, 0}, {2, 19, 1});
  Brush eraser = brush_of(BrushKind::Erase, 30);
  for (int k = 0; k < 12; ++k)
    stroke(session, eraser, {0, 12, 0}, {1, 12, 0});
  for (const Vec3& d : session.skin().displacement())
    EXPECT_EQ(d, Vec3::Zero());
}

TEST(SculptingSession, MaskedVerticesMoveExactlyZeroUnderEveryBrush)
{
  std::vector<Vec3> start(81 * 81);
  for (std::size_t v = 0; v < start.size(); ++v)
    start[v] = {0, 0.3 * std::sin(0.1 * static_cast<double>(v)), 0};
  for (const BrushKind kind : all_kinds)
  {
    if (brush_of(kind).masks())
      continue;
    SculptingSession session(face(), start);
    Brush mask = brush_of(BrushKind::Mask, 10);
    mask.curve = Falloff::Constant;
    stroke(session, mask, {6, 10, 0}, {6, 10, 1});
    const std::vector<double> masked = session.skin().mask();
    ASSERT_GT(std::count(masked.begin(), masked.end(), 1.0), 100);
    stroke(session, brush_of(kind, 15), {0, 15, 0}, {3, 18, 2});
    int moved = 0;
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      const bool still = session.skin().displacement()[v] == start[v];
      EXPECT_TRUE(still || masked[v] < 1) << name_of(kind) << " moved vertex " << v;
      moved += !still;
    }
    EXPECT_GT(moved, 100) << name_of(kind);
  }
}

TEST(SculptingSession, SymmetricStrokesKeepASymmetricFaceSymmetric)
{
  for (const BrushKind kind : all_kinds)
    for (const double side : {0.0, 4.0, 25.0})
    {
      SculptingSession session(face());
      Brush brush = brush_of(kind);
      brush.symmetry = SymmetryPlane{};
      Brush first = brush_of(BrushKind::Draw, 40);
      first.symmetry = SymmetryPlane{};
      stroke(session, first, {0, 15, 0}, {0, 15, 0.1});
      stroke(session, brush, {side, 10, 1}, {side + 2, 14, 4});
      for (int j = 0; j <= 80; ++j)
        for (int i = 0; i <= 40; ++i)
        {
          const SkinVertex a = session.skin().vertex(vertex_at(i, j)),
                           b = session.skin().vertex(vertex_at(80 - i, j));
          ASSERT_LT((a.displacement - SymmetryPlane{}.mirrored_vector(b.displacement)).norm(), 1e-9)
              << name_of(kind) << " at " << side;
          ASSERT_NEAR(a.mask, b.mask, 1e-9);
        }
    }
}

TEST(SculptingSession, SymmetricGrabInProfileTakesTheMiddleAlong)
{
  SculptingSession session(face());
  Brush brush = brush_of(BrushKind::ElasticGrab, 15);
  brush.symmetry = SymmetryPlane{};
  session.begin_stroke(brush, session.skin().tree().nearest({2, 14, 0}), {-1, 0, 0});
  session.drag({0, 4, 0});
  session.end_stroke();
  EXPECT_GT(session.skin().displacement()[vertex_at(40, 40)].y(), 3);
}

TEST(SculptingSession, SymmetricGrabOnTheMidlineIsNotDoubled)
{
  SculptingSession session(face());
  Brush brush = brush_of(BrushKind::Grab);
  brush.symmetry = SymmetryPlane{};
  stroke(session, brush, {0, 15, 0}, {0, 19, 0});
  EXPECT_LT((session.skin().displacement()[vertex_at(40, 40)] - Vec3(0, 4, 0)).norm(), 1e-9);
}

/// 200 strokes of every kind with every option.
class RandomStrokes
{
public:
  void next(SculptingSession& session)
  {
    if (m_random() % 20 == 0)
    {
      const Vec3 p = m_across * Vec3(unit(), 0, unit()) + Vec3(0, 5, 0);
      session.begin_warp({p}, 10 + 20 * std::abs(unit()), "Landmark");
      session.drag_warp({p + 5 * Vec3(unit(), unit(), unit())});
      return session.end_stroke();
    }
    Brush brush = brush_of(all_kinds[m_random() % all_kinds.size()], 4 + 12 * std::abs(unit()));
    brush.strength = std::abs(unit());
    brush.curve = static_cast<Falloff>(m_random() % 5);
    brush.inverted = m_random() % 2;
    brush.front_faces_only = m_random() % 2;
    if (m_random() % 3 == 0)
      brush.depth_mm = 5;
    if (m_random() % 2)
      brush.symmetry = SymmetryPlane{};
    const Vec3 from(m_across * unit(), 5 + 5 * unit(), m_across * unit());
    stroke(session, brush, from, from + 5 * Vec3(unit(), unit(), unit()));
  }

private:
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }
  std::mt19937 m_random{7};
  double m_across = 35;
};

TEST(SculptingSession, UndoAndRedoAreExactToTheBitOver200Strokes)
{
  SculptingSession session(face());
  RandomStrokes strokes;
  std::vector<std::string> states{bits(session)};
  for (int k = 0; k < 200; ++k)
  {
    strokes.next(session);
    if (bits(session) != states.back())
      states.push_back(bits(session));
  }
  ASSERT_GT(states.size(), 150u);
  for (int round = 0; round < 2; ++round)
  {
    for (std::size_t k = states.size() - 1; k-- > 0;)
    {
      ASSERT_TRUE(session.undo());
      ASSERT_EQ(bits(session), states[k]) << k;
    }
    EXPECT_FALSE(session.undo());
    for (std::size_t k = 1; k < states.size(); ++k)
    {
      ASSERT_TRUE(session.redo());
      ASSERT_EQ(bits(session), states[k]) << k;
    }
    EXPECT_FALSE(session.redo());
  }
}

TEST(SculptingSession, ANewStrokeForgetsWhatWasUndone)
{
  SculptingSession session(face());
  stroke(session, brush_of(BrushKind::Grab), {0, 15, 0}, {0, 19, 0});
  stroke(session, brush_of(BrushKind::Draw), {9, 5, 0}, {9, 5, 3});
  EXPECT_EQ(session.history().undo_name(), "Draw");
  session.undo();
  EXPECT_EQ(session.history().redo_name(), "Draw");
  stroke(session, brush_of(BrushKind::Grab), {5, 9, 0}, {5, 14, 0});
  EXPECT_FALSE(session.redo());
}

TEST(SculptingSession, CancelledStrokeLeavesNothing)
{
  SculptingSession session(face());
  const std::string before = bits(session);
  session.begin_stroke(brush_of(BrushKind::Grab), session.skin().tree().nearest({0, 15, 0}),
                       into_the_picture);
  session.drag({0, 7, 0});
  session.cancel_stroke();
  EXPECT_EQ(bits(session), before);
  EXPECT_FALSE(session.history().can_undo());
}

TEST(SculptingSession, WarpTakesLandmarksToTheirPlaces)
{
  SculptingSession session(face());
  const Vec3 nose = session.skin().rest()[vertex_at(40, 40)];
  session.begin_warp({nose}, 25, "subnasale");
  session.drag_warp({nose + Vec3(3, 0, 0)});
  session.drag_warp({nose + Vec3(0, 4, 0)});
  session.end_stroke();
  EXPECT_LT((session.skin().displacement()[vertex_at(40, 40)] - Vec3(0, 4, 0)).norm(), 1e-12);
  EXPECT_EQ(session.skin().displacement()[vertex_at(0, 0)], Vec3::Zero());
  EXPECT_EQ(session.history().undo_name(), "subnasale");
}

TEST(SculptingSession, OldestStrokesAreForgottenWhenMemoryIsFull)
{
  StrokeHistory history(10);
  SculptedSkin skin(face(), {});
  for (int k = 0; k < 9; ++k)
    history.add({"s", {k}, {skin.vertex(k)}, {{Vec3(0, 1, 0), 0}}});
  int undone = 0;
  while (history.undo(skin))
    ++undone;
  EXPECT_EQ(undone, 5);
}

TEST(SculptingSession, UnfitDisplacementsAreRefused)
{
  std::vector<Vec3> bad(81 * 81, Vec3::Zero());
  bad[7].x() = std::nan("");
  test::expect_error([&] { SculptingSession(face(), bad); }, {"vertex 7", "not finite"});
  test::expect_error([&] { SculptingSession(face(), {Vec3::Zero()}); }, {"1 vectors", "6561"});
  test::expect_error([&] { SculptingSession(TriangleMesh{}); }, {"no triangles"});
  SculptingSession session(face());
  test::expect_error([&] { session.replace(bad, "Import"); }, {"not finite"});
  test::expect_error([&] { session.replace({}, "Import"); }, {"0 vectors"});
}

} // namespace
} // namespace f2b
