#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBoneSculptRepresentation.h"
#include "vtkFaceToBoneSculptWidget.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <vtkPointData.h>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;

/// A nose on a face of 80 x 80 mm under the brush.
class SculptStage : public ::testing::Test
{
protected:
  SculptStage()
      : reference(testing::make_sheet(
            80, 80, [](double r, double s) { return 15 * std::exp(-(r * r + s * s) / 150); })),
        session(std::make_shared<SculptingSession>(reference)), shown(to_polydata(reference)),
        stage(shown)
  {
    tool->GetSculptRepresentation()->SetSession(session, shown);
    stage.use(tool);
    choose(BrushKind::Grab);
  }

  void choose(BrushKind kind, bool symmetric = false)
  {
    Brush brush;
    brush.kind = kind;
    brush.radius_mm = 12;
    if (symmetric)
      brush.symmetry = SymmetryPlane{};
    tool->SetBrush(brush);
  }
  double moved(double r, double s) const
  {
    return session->skin().displacement()[vertex(r, s)].norm();
  }
  static std::size_t vertex(double r, double s)
  {
    return static_cast<std::size_t>((40 + s) * 81 + 40 + r);
  }
  std::array<int, 2> at(double r, double s) { return stage.pixel(r, 0, s); }

  TriangleMesh reference;
  std::shared_ptr<SculptingSession> session;
  vtkSmartPointer<vtkPolyData> shown;
  ToolStage stage;
  vtkNew<vtkFaceToBoneSculptWidget> tool;
};

TEST_F(SculptStage, BrushIsShownOnTheSkinOnly)
{
  vtkFaceToBoneSculptRepresentation* look = tool->GetSculptRepresentation();
  stage.move(at(5, 5));
  EXPECT_TRUE(look->IsBrushShown());
  EXPECT_NE(look->GetReadout().find("radius 12 mm"), std::string::npos) << look->GetReadout();
  stage.move(at(47, 0));
  EXPECT_FALSE(look->IsBrushShown());
  EXPECT_EQ(look->GetReadout(), "");
}

TEST_F(SculptStage, EveryBrushActsWhereTheMouseIs)
{
  for (const BrushKind kind : {BrushKind::Grab, BrushKind::ElasticGrab, BrushKind::Draw,
                               BrushKind::Flatten, BrushKind::Smooth, BrushKind::Erase})
  {
    choose(BrushKind::Draw);
    stage.drag(at(-2, 0), at(4, 0)); // something to smooth and to erase
    const auto before = session->skin().displacement();
    choose(kind);
    stage.drag(at(0, 0), at(3, 3));
    EXPECT_NE(session->skin().displacement()[vertex(2, 1)], before[vertex(2, 1)]) << name_of(kind);
    EXPECT_EQ(session->skin().displacement()[vertex(-35, 30)], before[vertex(-35, 30)]);
  }
}

TEST_F(SculptStage, GrabFollowsTheMouseInTheViewPlane)
{
  stage.drag(at(0, 0), at(6, 4));
  const Vec3 d = session->skin().displacement()[vertex(0, 0)];
  EXPECT_NEAR(d.x(), 6, 0.4);
  EXPECT_NEAR(d.y(), 0, 1e-6);
  EXPECT_NEAR(d.z(), 4, 0.4);
}

TEST_F(SculptStage, ShownSurfaceFollowsWithItsArrays)
{
  EventCounter changes(tool, vtkCommand::InteractionEvent);
  stage.drag(at(0, 0), at(6, 4));
  EXPECT_EQ(changes.count, 5);
  const auto& points = session->skin().points();
  for (std::size_t v = 0; v < points.size(); v += 7)
    EXPECT_LT((Vec3(shown->GetPoint(vtkIdType(v))) - points[v]).norm(), 1e-5);
  vtkDataArray* d = shown->GetPointData()->GetArray("displacement");
  ASSERT_TRUE(d);
  EXPECT_EQ(d->GetComponent(vtkIdType(vertex(0, 0)), 0),
            session->skin().displacement()[vertex(0, 0)].x());
}

TEST_F(SculptStage, SymmetryMovesBothSides)
{
  choose(BrushKind::Draw, true);
  stage.drag(at(20, 0), at(20, 4));
  EXPECT_GT(moved(20, 1), 1);
  EXPECT_NEAR(moved(-20, 1), moved(20, 1), 1e-6);
  EXPECT_LT(moved(0, 0), 1e-9);
}

TEST_F(SculptStage, MaskedSkinMovesExactlyZero)
{
  choose(BrushKind::Mask);
  for (int k = 0; k < 10; ++k)
    stage.drag(at(3, -3), at(3, 3));
  const auto mask = session->skin().mask();
  ASSERT_EQ(mask[vertex(3, 0)], 1);
  choose(BrushKind::Grab);
  stage.drag(at(-14, 0), at(-14, 6));
  EXPECT_GT(moved(-14, 0), 3);
  for (std::size_t v = 0; v < mask.size(); ++v)
    if (mask[v] == 1)
    {
      ASSERT_EQ(session->skin().displacement()[v], Vec3::Zero());
    }
  choose(BrushKind::Mask);
  for (int k = 0; k < 10; ++k)
    stage.drag(at(3, -3), at(3, 3), true); // control unmasks
  EXPECT_EQ(session->skin().mask()[vertex(3, 0)], 0);
}

TEST_F(SculptStage, EscapeTakesTheStrokeBack)
{
  EventCounter ends(tool, vtkCommand::EndInteractionEvent);
  stage.press(at(0, 0));
  stage.move(at(9, 0));
  EXPECT_EQ(tool->GetWidgetState(), int(vtkFaceToBoneSculptWidget::Sculpting));
  EXPECT_GT(moved(0, 0), 3);
  stage.key("Escape");
  EXPECT_EQ(tool->GetWidgetState(), int(vtkFaceToBoneSculptWidget::Start));
  EXPECT_EQ(moved(0, 0), 0);
  EXPECT_FALSE(session->history().can_undo());
  EXPECT_EQ(ends.count, 1);
}

TEST_F(SculptStage, SwitchingOffInAStrokeTakesItBack)
{
  stage.press(at(0, 0));
  stage.move(at(9, 0));
  tool->SetEnabled(0);
  EXPECT_EQ(moved(0, 0), 0);
  stage.move(at(0, 9));
  EXPECT_EQ(moved(0, 0), 0);
}

TEST_F(SculptStage, BracketsAndWheelChangeRadiusAndStrengthWithinLimits)
{
  stage.key("bracketright");
  EXPECT_NEAR(tool->GetBrush().radius_mm, 12 * 1.15, 1e-9);
  stage.send(vtkCommand::MouseWheelBackwardEvent, at(0, 0), false, true);
  EXPECT_NEAR(tool->GetBrush().radius_mm, 12, 1e-9);
  stage.send(vtkCommand::MouseWheelBackwardEvent, at(0, 0), true, false);
  EXPECT_NEAR(tool->GetBrush().strength, 1 / 1.15, 1e-9);
  for (int k = 0; k < 100; ++k)
    stage.key("bracketleft");
  EXPECT_EQ(tool->GetBrush().radius_mm, Brush::least_radius_mm);
  for (int k = 0; k < 100; ++k)
    stage.key("braceright");
  EXPECT_EQ(tool->GetBrush().strength, 1);
}

TEST_F(SculptStage, APressBesideTheSkinIsTheCameras)
{
  EventCounter camera(stage.interactor, vtkCommand::LeftButtonPressEvent); // of lower priority
  stage.press(at(47, 0));
  EXPECT_EQ(camera.count, 1);
  stage.press(at(0, 0));
  EXPECT_EQ(camera.count, 1);
  stage.release(at(0, 0));
}

TEST_F(SculptStage, QuickStrokeHasNoGaps)
{
  choose(BrushKind::Draw);
  stage.press(at(-30, 20));
  stage.move(at(30, 20)); // in one event
  stage.release(at(30, 20));
  for (int r = -28; r <= 28; ++r)
    EXPECT_GT(moved(r, 20), 0.5) << r;
}

TEST_F(SculptStage, RandomEventsFindNothing)
{
  std::mt19937 random(11);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    if (k % 50 == 0)
      choose(static_cast<BrushKind>(random() % 8), random() % 2);
    stage.random_event(random);
    if (k % 97 == 0 && !session->in_stroke())
      session->undo();
  }
  tool->SetEnabled(0);
  while (session->undo())
    ;
  for (const Vec3& d : session->skin().displacement())
    ASSERT_EQ(d, Vec3::Zero());
}

} // namespace
} // namespace f2b
