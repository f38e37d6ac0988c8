#include "Widgets/tool_stage.hpp"

#include "Logic/Core/flat_sheet.hpp"
#include "vtkFaceToBonePlaneRepresentation.h"
#include "vtkFaceToBonePlaneWidget.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/geometry/osteotomy.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

using testing::EventCounter;
using testing::ToolStage;
using Look = vtkFaceToBonePlaneRepresentation;

/// A cut seen obliquely: 60 x 40 mm, its normal up and a little to the front.
class PlaneStage : public ::testing::Test
{
protected:
  PlaneStage() : stage(to_polydata(testing::make_sheet(4, 80)))
  {
    plane.name = "level";
    plane.u = Vec3::UnitX();
    plane.v = Vec3(0, -std::sin(0.6), std::cos(0.6)).cross(Vec3::UnitX()).normalized();
    plane.half_u = 30;
    plane.half_v = 20;
    look()->SetPlane(plane);
    stage.use(tool);
  }
  Look* look() { return tool->GetPlaneRepresentation(); }
  const BoundedPlane& now() { return look()->GetPlane(); }
  std::array<int, 2> at(Look::Handle handle)
  {
    const auto p = look()->HandlePosition(handle);
    return stage.pixel(p[0], p[1], p[2]);
  }
  /// On an edge, between its ball and a corner.
  std::array<int, 2> outline()
  {
    const Vec3 p = now().center + 0.5 * now().half_u * now().u + now().half_v * now().v;
    return stage.pixel(p.x(), p.y(), p.z());
  }
  std::array<int, 2> shifted(std::array<int, 2> p, int x, int y) { return {p[0] + x, p[1] + y}; }
  void expect_orthonormal()
  {
    EXPECT_NEAR(now().u.norm(), 1, 1e-9);
    EXPECT_NEAR(now().v.norm(), 1, 1e-9);
    EXPECT_NEAR(now().u.dot(now().v), 0, 1e-9);
  }

  BoundedPlane plane;
  ToolStage stage;
  vtkNew<vtkFaceToBonePlaneWidget> tool;
};

TEST_F(PlaneStage, FindsTheHandleUnderTheCursor)
{
  for (const Look::Handle handle :
       {Look::Centre, Look::Normal, Look::EdgeU0, Look::EdgeU1, Look::EdgeV0, Look::EdgeV1})
  {
    const auto p = at(handle);
    EXPECT_EQ(look()->HandleAt(p[0] + 2, p[1] - 2), handle);
  }
  EXPECT_EQ(look()->HandleAt(outline()[0], outline()[1] + 3), Look::Face);
  const auto inside = shifted(at(Look::Centre), 50, 10);
  EXPECT_EQ(look()->HandleAt(inside[0], inside[1]), Look::None);
  EXPECT_EQ(look()->HandleAt(3, 3), Look::None);
}

TEST_F(PlaneStage, EdgeFollowsTheMouseAndTheOppositeOneStays)
{
  const auto opposite = look()->HandlePosition(Look::EdgeU0);
  stage.drag(at(Look::EdgeU1),
             shifted(at(Look::EdgeU1), -40, 0)); // 4 pixels a millimetre; R is left
  EXPECT_NEAR(2 * now().half_u, 70, 0.5);
  const auto after = look()->HandlePosition(Look::EdgeU0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(after[k], opposite[k], 1e-9);
  EXPECT_EQ(now().half_v, 20);
  stage.drag(at(Look::EdgeU1), {400, 200});
  EXPECT_NEAR(2 * now().half_u, vtkFaceToBonePlaneWidget::LeastSize, 1e-9);
}

TEST_F(PlaneStage, CentreMovesInThePicture)
{
  stage.drag(at(Look::Centre), shifted(at(Look::Centre), 20, 8));
  EXPECT_NEAR((now().center - plane.center - Vec3(-5, 0, 2)).norm(), 0, 1e-4);
  EXPECT_EQ(now().normal(), plane.normal());
}

TEST_F(PlaneStage, FaceMovesAlongTheNormalOnly)
{
  const auto from = outline();
  ASSERT_EQ(look()->HandleAt(from[0], from[1]), Look::Face);
  stage.drag(from, shifted(from, 0, 30));
  const Vec3 by = now().center - plane.center;
  EXPECT_GT(by.norm(), 3);
  EXPECT_NEAR(std::abs(by.dot(plane.normal())), by.norm(), 1e-9);
}

TEST_F(PlaneStage, NormalTiltsAboutTheMiddle)
{
  stage.drag(at(Look::Normal), shifted(at(Look::Normal), 30, 0));
  EXPECT_LT(now().normal().dot(plane.normal()), 0.95);
  EXPECT_EQ(now().center, plane.center);
  EXPECT_EQ(now().half_u, 30);
  expect_orthonormal();
}

TEST_F(PlaneStage, EscapeGoesBackAndTheSizeIsTold)
{
  EventCounter ends(tool, vtkCommand::EndInteractionEvent);
  stage.press(at(Look::EdgeU1));
  stage.move(shifted(at(Look::EdgeU1), -40, 0));
  EXPECT_EQ(look()->GetReadout(), "level: 70.0 x 40.0 mm, kerf 1.0 mm");
  stage.key("Escape");
  EXPECT_EQ(now().half_u, 30);
  EXPECT_EQ(look()->GetReadout(), "");
  EXPECT_EQ(ends.count, 1);
}

TEST_F(PlaneStage, RandomEventsFindNothing)
{
  std::mt19937 random(5);
  for (int k = 0; k < testing::random_event_count(); ++k)
  {
    stage.random_event(random, {at(Look::Centre), at(Look::Normal), at(Look::EdgeU0),
                                at(Look::EdgeU1), at(Look::EdgeV0), at(Look::EdgeV1)});
    if (k % 20 == 0)
      look()->SetPlane(plane); // else it soon is out of sight
    expect_orthonormal();
    ASSERT_TRUE(now().center.allFinite());
  }
}

} // namespace
} // namespace f2b
