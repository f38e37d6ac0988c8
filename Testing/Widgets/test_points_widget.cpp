#include "Widgets/tool_stage.hpp"

#include "vtkFaceToBonePointsWidget.h"

#include <vtkSphereSource.h>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;

vtkSmartPointer<vtkPolyData> ball()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(40);
  source->SetThetaResolution(200);
  source->SetPhiResolution(200);
  source->Update();
  return source->GetOutput();
}

/// A ball of 40 mm seen from in front.
class PointsStage : public ::testing::Test
{
protected:
  PointsStage() { stage.use(tool); }
  std::array<int, 2> at(double r, double s) { return stage.pixel(r, 0, s); }
  auto points() { return tool->GetPointsRepresentation()->GetPoints(); }
  static double radius(const std::array<double, 3>& p)
  {
    return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }
  void click(std::array<int, 2> where)
  {
    stage.press(where);
    stage.release(where);
  }

  testing::ToolStage stage{ball()};
  vtkNew<vtkFaceToBonePointsWidget> tool;
};

TEST_F(PointsStage, AsManyAsWantedArePlacedOnTheSurface)
{
  EventCounter placed(tool, vtkCommand::PlacePointEvent);
  click(at(0, 0));
  EXPECT_TRUE(points().empty());
  tool->SetWanted(2);
  click(at(48, 48)); // beside the ball
  EXPECT_TRUE(points().empty());
  click(at(0, 0));
  click(at(20, 10));
  click(at(-20, 10));
  ASSERT_EQ(points().size(), 2u);
  EXPECT_EQ(placed.count, 2);
  for (const auto& p : points())
  {
    EXPECT_NEAR(radius(p), 40, 0.05);
    EXPECT_GT(p[1], 0) << "the side that is seen";
  }
  EXPECT_NEAR(points()[1][0], 20, 0.3);
}

TEST_F(PointsStage, RulersTellDistanceAndAngle)
{
  using Rep = vtkFaceToBonePointsRepresentation;
  EXPECT_EQ(Rep::Measured({{0, 0, 0}, {3, 4, 12}}), "13.0 mm");
  EXPECT_EQ(Rep::Measured({{1, 0, 0}, {0, 0, 0}, {1, 1, 0}}), "45.0 deg");
  EXPECT_EQ(Rep::Measured({{0, 0, 0}}), "");
}

TEST_F(PointsStage, DraggedPointStaysOnTheSurface)
{
  tool->SetWanted(1);
  click(at(0, 0));
  EventCounter moved(tool, vtkCommand::InteractionEvent);
  stage.drag(at(0, 0), at(25, 0));
  EXPECT_GT(moved.count, 2);
  EXPECT_NEAR(radius(points()[0]), 40, 0.05);
  EXPECT_NEAR(points()[0][0], 25, 0.3);
}

TEST_F(PointsStage, HandleIsDraggedInThePlaneOfThePicture)
{
  tool->SetOnSurface(false);
  tool->GetPointsRepresentation()->SetPoints({{0, 40, 0}}, {"prn"});
  stage.drag(at(0, 0), at(10, 5));
  EXPECT_NEAR(tool->GetDragged()[0], 10, 0.3);
  EXPECT_NEAR(tool->GetDragged()[1], 0, 1e-6);
  EXPECT_NEAR(tool->GetDragged()[2], 5, 0.3);
}

TEST_F(PointsStage, OfTwoHandlesAtOnePlaceTheOneInFrontIsTaken)
{
  tool->SetOnSurface(false);
  tool->GetPointsRepresentation()->SetPoints({{0, -40, 0}, {0, 40, 0}}, {"behind", "in front"});
  stage.drag(at(0, 0), at(10, 0));
  EXPECT_EQ(tool->GetHeld(), 1);
}

TEST_F(PointsStage, EscapeTakesADragBack)
{
  tool->SetOnSurface(false);
  tool->GetPointsRepresentation()->SetPoints({{0, 40, 0}});
  EventCounter ends(tool, vtkCommand::EndInteractionEvent);
  stage.press(at(0, 0));
  stage.move(at(10, 0));
  EXPECT_EQ(tool->GetWidgetState(), int(vtkFaceToBonePointsWidget::Dragging));
  stage.key("Escape");
  EXPECT_EQ(points()[0], (std::array<double, 3>{0, 40, 0}));
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(tool->GetWidgetState(), int(vtkFaceToBonePointsWidget::Start));
}

TEST_F(PointsStage, UnfinishedPointsCanBeTakenBack)
{
  tool->SetWanted(3);
  click(at(0, 0));
  click(at(10, 0));
  stage.key("BackSpace");
  EXPECT_EQ(points().size(), 1u);
  click(at(10, 0));
  stage.key("Escape");
  EXPECT_TRUE(points().empty());
}

TEST_F(PointsStage, RandomEventsFindNothing)
{
  std::mt19937 random(5);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    if (k % 40 == 0)
    {
      tool->SetWanted(static_cast<int>(random() % 4));
      tool->SetOnSurface(random() % 2);
    }
    if (k % 90 == 0)
      tool->GetPointsRepresentation()->SetPoints({}); // the host takes them away
    stage.random_event(random);
    ASSERT_LE(points().size(), 3u);
    for (const auto& p : points())
      ASSERT_TRUE(std::isfinite(radius(p)));
  }
}

} // namespace
} // namespace f2b
