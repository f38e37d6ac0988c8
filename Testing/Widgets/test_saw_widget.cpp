#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBoneSawRepresentation.h"
#include "vtkFaceToBoneSawWidget.h"

#include <Bridge/vtk_surface.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;
using Look = vtkFaceToBoneSawRepresentation;

/// A line from the patient's right to the left that is sawn backwards, seen from the front and above.
class SawStage : public ::testing::Test
{
protected:
  SawStage() : stage(to_polydata(testing::make_sheet(4, 80)))
  {
    stage.renderer->GetActiveCamera()->SetPosition(150, 300, 250);
    look()->SetLine({{20, 0, 0}, {0, 0, 6}, {-20, 0, 0}}, false);
    look()->SetDirection({0, -2, 0});
    look()->SetReach(5, 20);
    stage.use(tool);
  }
  Look* look() { return tool->GetSawRepresentation(); }
  std::array<int, 2> at(Look::Handle handle)
  {
    const auto p = look()->HandlePosition(handle);
    return stage.pixel(p[0], p[1], p[2]);
  }
  Vec3 direction() { return Vec3(look()->GetDirection().data()); }

  ToolStage stage;
  vtkNew<vtkFaceToBoneSawWidget> tool;
};

TEST_F(SawStage, HandIsInFrontOfTheMiddleAndTheDepthBehind)
{
  EXPECT_LT((Vec3(look()->GetMiddle().data()) - Vec3(0, 0, 6)).norm(), 1e-9);
  EXPECT_LT((Vec3(look()->HandlePosition(Look::Depth).data()) - Vec3(0, -20, 6)).norm(), 1e-9);
  EXPECT_LT((Vec3(look()->HandlePosition(Look::Hand).data()) - Vec3(0, Look::HandAwayMm, 6)).norm(),
            1e-9);
}

TEST_F(SawStage, HandTurnsTheSawAndTheDepthStays)
{
  const auto from = at(Look::Hand);
  stage.drag(from, {from[0] + 5, from[1] + 30}); // the hand up: the saw goes down
  EXPECT_LT(direction().z(), -0.2);
  EXPECT_NEAR(direction().norm(), 1, 1e-12);
  EXPECT_EQ(look()->GetDepth(), 20);
}

TEST_F(SawStage, DepthFollowsTheCursorWithinLimits)
{
  stage.drag(at(Look::Depth), stage.pixel(0, -33, 6));
  EXPECT_NEAR(look()->GetDepth(), 33, 0.6);
  EXPECT_LT((direction() - Vec3(0, -1, 0)).norm(), 1e-12);
  stage.drag(at(Look::Depth), stage.pixel(0, 30, 6));
  EXPECT_EQ(look()->GetDepth(), vtkFaceToBoneSawWidget::LeastDepth);
}

TEST_F(SawStage, EscapeGoesBackAndTheDepthIsTold)
{
  EventCounter ends(tool, vtkCommand::EndInteractionEvent);
  stage.press(at(Look::Depth));
  stage.move(stage.pixel(0, -30, 6));
  EXPECT_NE(look()->GetReadout().find("mm deep"), std::string::npos);
  stage.key("Escape");
  EXPECT_EQ(look()->GetDepth(), 20);
  EXPECT_EQ(look()->GetReadout(), "");
  EXPECT_EQ(ends.count, 1);
}

TEST_F(SawStage, WithoutHandlesItCannotBeHeld)
{
  look()->SetHandlesShown(false);
  stage.drag(at(Look::Depth), stage.pixel(0, -33, 6));
  EXPECT_EQ(look()->GetDepth(), 20);
}

TEST_F(SawStage, RandomEventsFindNothing)
{
  std::mt19937 random(31);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    stage.random_event(random, {at(Look::Hand), at(Look::Depth)});
    if (k % 60 == 0)
      look()->SetLine({{20, 0, 0}, {0, 0, 6}, {-20, 0, double(k % 7)}}, k % 120 == 0);
    ASSERT_NEAR(direction().norm(), 1, 1e-9);
    ASSERT_LE(look()->GetDepth(), vtkFaceToBoneSawWidget::MostDepth);
  }
}

} // namespace
} // namespace f2b
