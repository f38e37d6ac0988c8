#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBoneFragmentRepresentation.h"
#include "vtkFaceToBoneFragmentWidget.h"

#include <Bridge/vtk_surface.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;

/// Seen from the front and a little from the patient's right and above.
class FragmentStage : public ::testing::Test
{
protected:
  FragmentStage() : stage(to_polydata(testing::make_sheet(4, 80)))
  {
    stage.renderer->GetActiveCamera()->SetPosition(200, 400, 150);
    look()->SetReferencePoint({5, 0, -3});
    stage.use(tool);
  }
  vtkFaceToBoneFragmentRepresentation* look() { return tool->GetFragmentRepresentation(); }
  std::array<int, 2> grip(int coordinate)
  {
    const auto p = look()->GripPosition(coordinate);
    return stage.pixel(p[0], p[1], p[2]);
  }
  std::array<int, 2> shifted(std::array<int, 2> p, int x, int y) { return {p[0] + x, p[1] + y}; }
  double value(int coordinate) { return look()->GetMovement()[std::size_t(coordinate)]; }

  ToolStage stage;
  vtkNew<vtkFaceToBoneFragmentWidget> tool;
};

TEST_F(FragmentStage, EachArrowAndRingMovesItsOwnCoordinate)
{
  for (int k = 0; k < 6; ++k)
  {
    look()->SetMovement({});
    const auto from = grip(k);
    ASSERT_EQ(look()->CoordinateAt(from[0], from[1]), k);
    stage.drag(from, shifted(from, 17, 23));
    for (int other = 0; other < 6; ++other)
      if (other == k)
      {
        EXPECT_GT(std::abs(value(k)), 0.1) << k;
      }
      else
      {
        EXPECT_EQ(value(other), 0) << k << " moved " << other;
      }
  }
}

TEST_F(FragmentStage, ArrowTipFollowsTheCursor)
{
  const auto from = grip(2);
  const auto to = stage.pixel(5, 0, -3 + 35 + 8); // 8 mm further up
  stage.drag(from, to);
  EXPECT_NEAR(value(2), 8, 0.4);
}

TEST_F(FragmentStage, RingsTurnRightHandedAboutTheirAxes)
{
  for (int k = 3; k < 6; ++k)
  {
    look()->SetMovement({0, 0, 0, 3, -4, 5});
    const double before = value(k);
    const auto grip_before = look()->GripPosition(k);
    const auto axis = look()->Axis(k), centre = look()->MovedPoint();
    const Vec3 a(axis.data()), c(centre.data()), g(grip_before.data());
    const Vec3 turned = c + Eigen::AngleAxisd(0.1, a) * (g - c);
    stage.drag(grip(k), stage.pixel(turned.x(), turned.y(), turned.z()));
    EXPECT_NEAR(value(k) - before, 0.1 * 180 / 3.14159265, 1.0) << k;
  }
}

TEST_F(FragmentStage, LockedCoordinatesCannotBeHeld)
{
  for (int k = 0; k < 6; ++k)
    look()->SetLocked(k, k != 1);
  for (int k = 0; k < 6; ++k)
    if (k != 1)
      stage.drag(grip(k), shifted(grip(k), 20, 20));
  for (int k = 0; k < 6; ++k)
    if (k != 1)
    {
      EXPECT_EQ(value(k), 0);
    }
}

TEST_F(FragmentStage, ControlMovesInHalvesAndLimitsHold)
{
  stage.press(grip(0));
  stage.send(vtkCommand::MouseMoveEvent, shifted(grip(0), -21, 3), true);
  EXPECT_EQ(2 * value(0), std::round(2 * value(0)));
  EXPECT_NE(value(0), 0);
  stage.move({-3000, 200});
  EXPECT_EQ(value(0), vtkFaceToBoneFragmentRepresentation::MostMm);
  stage.release({0, 0});
}

TEST_F(FragmentStage, ARulesLimitsHold)
{
  look()->SetLimits(2, -1, 3.3);
  stage.press(grip(2));
  stage.move(shifted(grip(2), 0, 120));
  EXPECT_EQ(value(2), 3.3);
  stage.send(vtkCommand::MouseMoveEvent, {200, -300}, true);
  EXPECT_EQ(value(2), -1);
  stage.release({0, 0});
}

TEST_F(FragmentStage, EscapeGoesBack)
{
  look()->SetMovement({1, 2, 3, 0, 0, 0});
  EventCounter changes(tool, vtkCommand::InteractionEvent);
  stage.press(grip(2));
  stage.move(shifted(grip(2), 0, 30));
  EXPECT_NE(value(2), 3);
  EXPECT_NE(look()->GetReadout(), "");
  stage.key("Escape");
  EXPECT_EQ(value(2), 3);
  EXPECT_EQ(changes.count, 2);
}

TEST_F(FragmentStage, RandomEventsFindNothing)
{
  std::mt19937 random(9);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    stage.random_event(random, {grip(0), grip(1), grip(2), grip(3), grip(4), grip(5)});
    for (int c = 0; c < 6; ++c)
      ASSERT_LE(std::abs(value(c)), 45);
    if (k % 40 == 0)
      look()->SetMovement({});
  }
}

} // namespace
} // namespace f2b
