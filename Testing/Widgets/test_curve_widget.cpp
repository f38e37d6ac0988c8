#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBoneCurveRepresentation.h"
#include "vtkFaceToBoneCurveWidget.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/sculpting/surface_tree.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;

/// A ridged sheet of 80 x 80 mm under the pen.
class CurveStage : public ::testing::Test
{
protected:
  CurveStage()
      : bone(testing::make_sheet(80, 80, [](double r, double) { return 6 * std::cos(r / 8); })),
        shown(to_polydata(bone)), stage(shown), tree(bone)
  {
    look()->SetSurface(shown);
    stage.use(tool);
  }
  vtkFaceToBoneCurveRepresentation* look() { return tool->GetCurveRepresentation(); }
  std::array<int, 2> at(double r, double s) { return stage.pixel(r, 0, s); }
  void click(double r, double s)
  {
    stage.press(at(r, s));
    stage.release(at(r, s));
  }
  std::vector<std::array<int, 2>> points()
  {
    std::vector<std::array<int, 2>> pixels;
    for (const auto& p : look()->GetControlPoints())
      pixels.push_back(stage.pixel(p[0], p[1], p[2]));
    return pixels;
  }
  void expect_on_bone()
  {
    for (const auto& p : look()->GetCurve())
      ASSERT_LT(tree.nearest(Vec3(p.data())).distance, 1e-6);
  }

  TriangleMesh bone;
  vtkSmartPointer<vtkPolyData> shown;
  ToolStage stage;
  SurfaceTree tree;
  vtkNew<vtkFaceToBoneCurveWidget> tool;
};

TEST_F(CurveStage, PointByPointAlongTheSurface)
{
  click(-20, -10);
  click(0, -5);
  click(20, 12);
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 3);
  EXPECT_GT(look()->GetCurve().size(), 25u);
  EXPECT_GT(look()->GetLength(), 45); // over the ridges
  EXPECT_FALSE(look()->GetClosed());
  expect_on_bone();
  EXPECT_NEAR(look()->GetControlPoint(2)[0], 20, 0.3);
}

TEST_F(CurveStage, AClickOnTheFirstPointCloses)
{
  for (const auto& [r, s] : {std::pair(-20., -10.), {20., -10.}, {0., 25.}})
    click(r, s);
  const double open = look()->GetLength();
  click(-20, -10);
  EXPECT_TRUE(look()->GetClosed());
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 3);
  EXPECT_GT(look()->GetLength(), open + 30);
  click(30, 30); // nothing is added to a closed line
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 3);
  stage.key("BackSpace");
  EXPECT_FALSE(look()->GetClosed());
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 2);
}

TEST_F(CurveStage, PointsAreDraggedOnTheBone)
{
  click(-20, -10);
  click(0, -5);
  click(20, 12);
  stage.drag(at(0, -5), at(3, 22));
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 3);
  EXPECT_NEAR(look()->GetControlPoint(1)[2], 22, 0.3);
  expect_on_bone();
}

TEST_F(CurveStage, FreehandLeavesAPointEveryFewMillimetres)
{
  stage.press(at(-30, 0), false, true);
  for (int r = -30; r <= 30; ++r)
    stage.move(at(r, 5 * std::sin(r / 6.0)));
  stage.release(at(30, 0));
  EXPECT_GT(look()->GetNumberOfControlPoints(), 10);
  EXPECT_LT(look()->GetNumberOfControlPoints(), 30);
  expect_on_bone();
}

TEST_F(CurveStage, EscapeTakesBackWhatThePressBegan)
{
  click(-20, -10);
  click(0, -5);
  stage.press(at(20, 12));
  stage.key("Escape");
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 2);
  const auto before = look()->GetControlPoint(1);
  stage.press(at(0, -5));
  stage.move(at(9, 9));
  stage.key("Escape");
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(look()->GetControlPoint(1)[k], before[k], 1e-6);
  stage.press(at(10, 10), false, true);
  for (int r = 10; r < 35; ++r)
    stage.move(at(r, 10));
  stage.send(vtkCommand::RightButtonPressEvent, at(34, 10));
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 2);
}

TEST_F(CurveStage, ReturnFinishesALineOfTwoPointsOrMore)
{
  EventCounter finished(tool, vtkCommand::EndInteractionEvent);
  click(-20, -10);
  stage.key("Return");
  EXPECT_EQ(finished.count, 0);
  click(0, -5);
  stage.key("Return");
  EXPECT_EQ(finished.count, 1);
}

TEST_F(CurveStage, WithoutBoneNothingHappens)
{
  look()->SetSurface(nullptr);
  click(0, 0);
  stage.drag(at(0, 0), at(9, 9), false, true);
  stage.key("Delete");
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 0);
}

TEST_F(CurveStage, APointOfALineThatIsThereIsMovedAndNoneIsAdded)
{
  look()->SetControlPoints({{-20, 9, -10}, {0, 9, -5}, {20, 9, 12}}, false);
  expect_on_bone();
  tool->SetDrawing(false);
  EventCounter ends(tool, vtkCommand::EndInteractionEvent);
  click(10, 20);
  stage.key("BackSpace");
  stage.key("Return");
  EXPECT_EQ(look()->GetNumberOfControlPoints(), 3);
  EXPECT_EQ(ends.count, 0);
  stage.drag(at(0, -5), at(3, 22));
  EXPECT_NEAR(look()->GetControlPoint(1)[2], 22, 0.3);
  EXPECT_EQ(ends.count, 1);
}

TEST_F(CurveStage, FreeLineMovesInThePictureAsAWholeOrByItsPoints)
{
  look()->SetFree(true);
  look()->SetControlPoints({{-20, 30, -10}, {0, 30, -5}, {20, 30, 10}}, false);
  tool->SetDrawing(false);
  stage.drag(at(0, -5), at(3, 12));
  EXPECT_NEAR(look()->GetControlPoint(1)[0], 3, 0.3);
  EXPECT_NEAR(look()->GetControlPoint(1)[1], 30, 1e-3);
  EXPECT_NEAR(look()->GetControlPoint(1)[2], 12, 0.3);
  const auto before = look()->GetControlPoints();
  stage.drag(at(-8.5, 1), at(-8.5, 9)); // on the line between two points
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(look()->GetControlPoints()[i][2] - before[i][2], 8, 0.3);
  stage.press(at(3, 20));
  stage.move(at(30, 30));
  stage.key("Escape");
  EXPECT_NEAR(look()->GetControlPoint(1)[2], 20, 0.4);
}

TEST_F(CurveStage, LineWithoutHandlesIsOnlyLookedAt)
{
  look()->SetControlPoints({{-20, 9, -10}, {0, 9, -5}}, false);
  tool->SetDrawing(false);
  look()->SetHandlesShown(false);
  stage.drag(at(0, -5), at(3, 22));
  EXPECT_NEAR(look()->GetControlPoint(1)[2], -5, 0.3);
}

TEST_F(CurveStage, RandomEventsOnALineThatIsThereFindNothing)
{
  std::mt19937 random(22);
  tool->SetDrawing(false);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    if (k % 50 == 0 && tool->GetWidgetState() == 0)
    {
      look()->SetFree(k % 100 == 0);
      look()->SetControlPoints({{-20, 9, -10}, {0, 9, -5}, {20, 9, double(k % 11)}}, k % 150 == 0);
    }
    stage.random_event(random, points());
    ASSERT_EQ(look()->GetNumberOfControlPoints(), 3);
  }
}

TEST_F(CurveStage, RandomEventsFindNothing)
{
  std::mt19937 random(21);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    stage.random_event(random, points());
    if (look()->GetNumberOfControlPoints() > 12 && tool->GetWidgetState() == 0)
      look()->Clear();
  }
  expect_on_bone();
}

} // namespace
} // namespace f2b
