// Markups in memory, and their files as Slicer 5.2 and 5.8 write them.
#include "scene_test.hpp"

#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLMarkupsClosedCurveNode.h>
#include <vtkMRMLMarkupsCurveNode.h>
#include <vtkMRMLMarkupsDisplayNode.h>
#include <vtkMRMLMarkupsFiducialNode.h>
#include <vtkMRMLMarkupsJsonStorageNode.h>
#include <vtkMRMLMarkupsPlaneNode.h>

#include <vtkMath.h>
#include <vtkTransform.h>

#include <cmath>

using namespace f2b::test;

namespace
{

const std::string schema =
    "{\"@schema\": "
    "\"https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
    "Resources/Schema/markups-schema-v1.0.3.json#\", \"markups\": [";

/// As Slicer 5.8 writes a list of points, with members that are not known here.
const std::string slicer_points = schema + R"({
    "type": "Fiducial",
    "coordinateSystem": "LPS",
    "coordinateUnits": ["mm", "UCUM", "millimeter"],
    "locked": true,
    "fixedNumberOfControlPoints": false,
    "labelFormat": "%N-%d",
    "lastUsedControlPointNumber": 7,
    "controlPoints": [
        {
            "id": "3",
            "label": "nasion",
            "description": "bridge of the nose",
            "associatedNodeID": "vtkMRMLScalarVolumeNode1",
            "position": [-1.5, -82.25, 12.125],
            "orientation": [-1.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 1.0],
            "selected": true,
            "locked": false,
            "visibility": false,
            "positionStatus": "defined",
            "confidence": 0.75
        },
        {
            "id": "7",
            "label": "gnathion",
            "description": "",
            "associatedNodeID": "",
            "position": "",
            "orientation": [-1.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 1.0],
            "selected": true,
            "locked": false,
            "visibility": true,
            "positionStatus": "undefined"
        }
    ],
    "measurements": [{"name": "length", "enabled": false, "value": 12.5, "units": "mm"}],
    "display": {
        "visibility": true,
        "opacity": 1.0,
        "color": [0.4, 1.0, 1.0],
        "sliceProjection": false,
        "snapMode": "toVisibleSurface"
    }
}]})";

template <class Node>
Node* read_text_as(vtkMRMLScene* scene, const TemporaryFolder& folder, const std::string& json)
{
  auto* node = add_node<Node>(scene, "markup");
  node->AddDefaultStorageNode();
  node->GetStorageNode()->SetFileName(folder.write("markup.mrk.json", json).c_str());
  return node->GetStorageNode()->ReadData(node) ? node : nullptr;
}

template <class Node>
Node* read_again(vtkMRMLScene* scene, vtkMRMLStorableNode* written)
{
  auto* node = add_node<Node>(scene, "again");
  node->AddDefaultStorageNode();
  node->GetStorageNode()->SetFileName(written->GetStorageNode()->GetFileName());
  return node->GetStorageNode()->ReadData(node) ? node : nullptr;
}

void expect_vector(const double* expected, const double* found, double tolerance = 1e-12)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(expected[i], found[i], tolerance) << i;
  }
}

} // namespace

// --- Points ------------------------------------------------------------------------------------

TEST(MarkupsTest, PointsAreAddedMovedAndRemoved)
{
  vtkNew<vtkMRMLScene> scene;
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene, "F");
  const EventCounter added(points, vtkMRMLMarkupsNode::PointAddedEvent);
  const EventCounter modified(points, vtkMRMLMarkupsNode::PointModifiedEvent);
  EXPECT_EQ(0, points->AddControlPoint(1.0, 2.0, 3.0));
  EXPECT_EQ(1, points->AddControlPoint(4.0, 5.0, 6.0, "chin"));
  EXPECT_EQ("F-1", points->GetNthControlPointLabel(0));
  EXPECT_EQ("chin", points->GetNthControlPointLabel(1));
  EXPECT_NE(points->GetNthControlPointID(0), points->GetNthControlPointID(1));
  EXPECT_EQ(2, added.count);
  const int before = modified.count;
  points->SetNthControlPointPosition(0, 7.0, 8.0, 9.0);
  EXPECT_EQ(before + 1, modified.count);
  EXPECT_EQ(8.0, points->GetNthControlPointPosition(0)[1]);
  points->RemoveNthControlPoint(0);
  EXPECT_EQ(1, points->GetNumberOfControlPoints());
  EXPECT_EQ("chin", points->GetNthControlPointLabel(0));
  const QuietVtk quiet;
  points->SetNthControlPointPosition(5, 0.0, 0.0, 0.0);
  points->RemoveNthControlPoint(-1);
  EXPECT_EQ(1, points->GetNumberOfControlPoints());
}

TEST(MarkupsTest, NumbersOfPointsAreKept)
{
  const QuietVtk quiet;
  vtkNew<vtkMRMLScene> scene;
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene);
  points->SetMaximumNumberOfControlPoints(1);
  EXPECT_EQ(0, points->AddControlPoint(1.0, 2.0, 3.0));
  EXPECT_EQ(-1, points->AddControlPoint(1.0, 2.0, 3.0));
  points->SetFixedNumberOfControlPoints(true);
  points->RemoveAllControlPoints();
  EXPECT_EQ(1, points->GetNumberOfControlPoints());
}

TEST(MarkupsTest, WorldGoesThroughTheParentTransform)
{
  vtkNew<vtkMRMLScene> scene;
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene);
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, 0.0, 0.0);
  transform->RotateZ(90.0);
  move->SetMatrixTransformToParent(transform->GetMatrix());
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene);
  points->SetAndObserveTransformNodeID(move->GetID());
  points->AddControlPointWorld(10.0, 5.0, 1.0);
  const double local[3] = {5.0, 0.0, 1.0};
  expect_vector(local, points->GetNthControlPointPosition(0));
  const double world[3] = {10.0, 5.0, 1.0};
  expect_vector(world, points->GetNthControlPointPositionWorld(0).GetData());
}

TEST(MarkupsTest, CopiesTakeAllPoints)
{
  vtkNew<vtkMRMLScene> scene;
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene, "F");
  points->AddControlPoint(1.0, 2.0, 3.0, "a");
  points->SetNthControlPointLocked(0, true);
  auto* copy = vtkMRMLMarkupsFiducialNode::SafeDownCast(scene->CopyNode(points));
  ASSERT_EQ(1, copy->GetNumberOfControlPoints());
  EXPECT_EQ("a", copy->GetNthControlPointLabel(0));
  EXPECT_TRUE(copy->GetNthControlPointLocked(0));
  copy->SetNthControlPointLabel(0, "b");
  EXPECT_EQ("a", points->GetNthControlPointLabel(0));
}

// --- Planes and curves -------------------------------------------------------------------------

TEST(MarkupsTest, APlaneHasOriginAndNormal)
{
  vtkNew<vtkMRMLScene> scene;
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene);
  const double origin[3] = {1.0, 2.0, 3.0};
  double normal[3] = {1.0, 2.0, -2.0};
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
  vtkMath::Normalize(normal);
  double found[3];
  plane->GetOrigin(found);
  expect_vector(origin, found);
  plane->GetNormal(found);
  expect_vector(normal, found);
  EXPECT_TRUE(plane->GetIsPlaneValid());
  ASSERT_EQ(1, plane->GetNumberOfControlPoints());
  expect_vector(origin, plane->GetNthControlPointPosition(0));
  plane->SetNthControlPointPosition(0, 4.0, 5.0, 6.0);
  plane->GetOrigin(found);
  const double moved[3] = {4.0, 5.0, 6.0};
  expect_vector(moved, found);
  plane->GetNormal(found);
  expect_vector(normal, found);
  plane->SetNormal(-normal[0], -normal[1], -normal[2]);
  plane->GetNormal(found);
  vtkMath::MultiplyScalar(normal, -1.0);
  expect_vector(normal, found);
}

TEST(MarkupsTest, APlaneInAMovedFrame)
{
  vtkNew<vtkMRMLScene> scene;
  auto* move = add_node<vtkMRMLLinearTransformNode>(scene);
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, 0.0, 0.0);
  transform->RotateX(90.0);
  move->SetMatrixTransformToParent(transform->GetMatrix());
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene);
  plane->SetAndObserveTransformNodeID(move->GetID());
  const double origin[3] = {10.0, 1.0, 2.0};
  const double normal[3] = {0.0, 0.0, 1.0};
  plane->SetOriginWorld(origin);
  plane->SetNormalWorld(normal);
  double found[3];
  plane->GetOriginWorld(found);
  expect_vector(origin, found);
  plane->GetNormalWorld(found);
  expect_vector(normal, found);
  plane->GetNormal(found);
  const double local[3] = {0.0, 1.0, 0.0};
  expect_vector(local, found);
}

TEST(MarkupsTest, ThreePointsOrAFitMakeAPlane)
{
  vtkNew<vtkMRMLScene> scene;
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene);
  plane->SetPlaneType(vtkMRMLMarkupsPlaneNode::PlaneType3Points);
  plane->AddControlPoint(0.0, 0.0, 5.0);
  plane->AddControlPoint(1.0, 0.0, 5.0);
  EXPECT_FALSE(plane->GetIsPlaneValid());
  plane->AddControlPoint(0.0, 1.0, 5.0);
  EXPECT_TRUE(plane->GetIsPlaneValid());
  double found[3];
  plane->GetNormal(found);
  const double up[3] = {0.0, 0.0, 1.0};
  expect_vector(up, found);

  auto* fit = add_node<vtkMRMLMarkupsPlaneNode>(scene);
  fit->SetPlaneType(vtkMRMLMarkupsPlaneNode::PlaneTypePlaneFit);
  for (int i = 0; i < 12; ++i)
  {
    const double x = std::cos(i * 0.5);
    const double y = std::sin(i * 0.5);
    fit->AddControlPoint(x, y, 0.5 * x);
  }
  EXPECT_TRUE(fit->GetIsPlaneValid());
  double expected[3] = {-0.5, 0.0, 1.0};
  vtkMath::Normalize(expected);
  fit->GetNormal(found);
  expect_vector(expected, found, 1e-9);
}

TEST(MarkupsTest, CurvesPassTheirControlPoints)
{
  vtkNew<vtkMRMLScene> scene;
  auto* open = add_node<vtkMRMLMarkupsCurveNode>(scene);
  auto* closed = add_node<vtkMRMLMarkupsClosedCurveNode>(scene);
  for (auto* curve : {open, static_cast<vtkMRMLMarkupsCurveNode*>(closed)})
  {
    curve->AddControlPoint(0.0, 0.0, 0.0);
    curve->AddControlPoint(10.0, 0.0, 0.0);
    curve->AddControlPoint(10.0, 10.0, 0.0);
  }
  EXPECT_FALSE(open->GetCurveClosed());
  EXPECT_TRUE(closed->GetCurveClosed());
  open->SetCurveTypeToLinear();
  EXPECT_NEAR(20.0, open->GetCurveLengthWorld(), 1e-9);
  closed->SetCurveTypeToLinear();
  EXPECT_NEAR(20.0 + std::sqrt(200.0), closed->GetCurveLengthWorld(), 1e-9);
  open->SetCurveTypeToCardinalSpline();
  EXPECT_GT(open->GetCurveLengthWorld(), 20.0);
}

// --- Files -------------------------------------------------------------------------------------

TEST(MarkupsFileTest, SlicersPointsAreRead)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* points = read_text_as<vtkMRMLMarkupsFiducialNode>(scene, folder, slicer_points);
  ASSERT_NE(nullptr, points);
  ASSERT_EQ(2, points->GetNumberOfControlPoints());
  const double nasion[3] = {1.5, 82.25, 12.125};
  expect_vector(nasion, points->GetNthControlPointPosition(0));
  EXPECT_EQ("nasion", points->GetNthControlPointLabel(0));
  EXPECT_EQ("3", points->GetNthControlPointID(0));
  EXPECT_EQ("bridge of the nose", points->GetNthControlPointDescription(0));
  EXPECT_FALSE(points->GetNthControlPointVisibility(0));
  EXPECT_EQ(vtkMRMLMarkupsNode::PositionDefined, points->GetNthControlPointPositionStatus(0));
  EXPECT_EQ(vtkMRMLMarkupsNode::PositionUndefined, points->GetNthControlPointPositionStatus(1));
  EXPECT_EQ(1, points->GetLocked());
  EXPECT_EQ(7, points->GetLastUsedControlPointNumber());
  EXPECT_EQ(1.0, points->GetNthControlPointOrientationMatrix(0)[0]);
}

TEST(MarkupsFileTest, MembersThatAreNotKnownStay)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* points = read_text_as<vtkMRMLMarkupsFiducialNode>(scene, folder, slicer_points);
  ASSERT_NE(nullptr, points);
  ASSERT_TRUE(save_data(points, folder / "same.mrk.json"));
  std::string text = read_text(folder / "same.mrk.json");
  for (const char* member :
       {"\"confidence\": 0.75", "\"UCUM\"", "\"snapMode\": \"toVisibleSurface\"", "\"value\": 12.5",
        "\"position\": \"\"", "markups-schema-v1.0.3"})
  {
    EXPECT_NE(std::string::npos, text.find(member)) << member;
  }
  points->SetNthControlPointPosition(1, 0.1, 0.2, 0.3);
  ASSERT_TRUE(save_data(points, folder / "moved.mrk.json"));
  text = read_text(folder / "moved.mrk.json");
  EXPECT_NE(std::string::npos, text.find("\"confidence\": 0.75"));
  EXPECT_EQ(std::string::npos, text.find("12.5")) << "measured on other points";
}

TEST(MarkupsFileTest, PointsKeepTheirDigits)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene, "F");
  const double position[3] = {1.0 / 3.0, -123.45678901234567, 1e-13};
  points->AddControlPoint(position[0], position[1], position[2], "Ü \"quoted\" \\ /");
  for (const int frame :
       {vtkMRMLStorageNode::CoordinateSystemLPS, vtkMRMLStorageNode::CoordinateSystemRAS})
  {
    points->AddDefaultStorageNode();
    vtkMRMLMarkupsJsonStorageNode::SafeDownCast(points->GetStorageNode())
        ->SetCoordinateSystem(frame);
    ASSERT_TRUE(save_data(points, folder / "F.mrk.json"));
    auto* back = read_again<vtkMRMLMarkupsFiducialNode>(scene, points);
    ASSERT_NE(nullptr, back);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(position[i], back->GetNthControlPointPosition(0)[i]);
    }
    EXPECT_EQ(points->GetNthControlPointLabel(0), back->GetNthControlPointLabel(0));
  }
}

TEST(MarkupsFileTest, PlanesComeBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* plane = add_node<vtkMRMLMarkupsPlaneNode>(scene, "cut");
  plane->SetOrigin(1.0, 2.0, 3.0);
  plane->SetNormal(0.6, 0.0, 0.8);
  plane->SetSizeMode(vtkMRMLMarkupsPlaneNode::SizeModeAbsolute);
  plane->SetSize(80.0, 60.0);
  ASSERT_TRUE(save_data(plane, folder / "cut.mrk.json"));
  auto* back = read_again<vtkMRMLMarkupsPlaneNode>(scene, plane);
  ASSERT_NE(nullptr, back);
  double expected[3][3];
  double found[3][3];
  plane->GetAxes(expected[0], expected[1], expected[2]);
  back->GetAxes(found[0], found[1], found[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    expect_vector(expected[axis], found[axis]);
  }
  plane->GetOrigin(expected[0]);
  back->GetOrigin(found[0]);
  expect_vector(expected[0], found[0]);
  EXPECT_EQ(80.0, back->GetSize()[0]);
  EXPECT_EQ(vtkMRMLMarkupsPlaneNode::SizeModeAbsolute, back->GetSizeMode());
}

TEST(MarkupsFileTest, SlicersPlaneIsRead)
{
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* plane = read_text_as<vtkMRMLMarkupsPlaneNode>(scene, folder, schema + R"({
    "type": "Plane", "coordinateSystem": "LPS", "coordinateUnits": "mm", "locked": false,
    "fixedNumberOfControlPoints": false, "labelFormat": "%N-%d", "lastUsedControlPointNumber": 1,
    "planeType": "pointNormal", "sizeMode": "auto", "autoScalingFactor": 1.0,
    "center": [-10.0, -20.0, 30.0], "normal": [-0.6, -0.0, 0.8],
    "objectToBase": [-1.0, -0.0, -0.0, -0.0, -0.0, -1.0, -0.0, -0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    "baseToNode": [-0.8, -0.0, -0.6, -10.0, -0.0, -1.0, -0.0, -20.0, -0.6, 0.0, 0.8, 30.0, 0.0, 0.0, 0.0, 1.0],
    "orientation": [-0.8, -0.0, -0.6, -0.0, -1.0, -0.0, -0.6, 0.0, 0.8],
    "size": [100.0, 100.0, 0.0], "planeBounds": [-50.0, 50.0, -50.0, 50.0],
    "controlPoints": [{"id": "1", "label": "P-1", "position": [-10.0, -20.0, 30.0],
      "orientation": [-1.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 1.0], "selected": true,
      "locked": false, "visibility": true, "positionStatus": "defined"}],
    "measurements": []}]})");
  ASSERT_NE(nullptr, plane);
  double found[3];
  plane->GetOrigin(found);
  const double origin[3] = {10.0, 20.0, 30.0};
  expect_vector(origin, found);
  plane->GetNormal(found);
  const double normal[3] = {0.6, 0.0, 0.8};
  expect_vector(normal, found);
}

TEST(MarkupsFileTest, ACurveOfTheSceneComesBack)
{
  const TemporaryFolder folder;
  {
    vtkNew<vtkMRMLScene> scene;
    auto* curve = add_node<vtkMRMLMarkupsClosedCurveNode>(scene, "cut");
    curve->CreateDefaultDisplayNodes();
    curve->SetCurveTypeToLinear();
    curve->AddControlPoint(1.0, 2.0, 3.0);
    curve->AddControlPoint(4.0, 5.0, 6.0);
    ASSERT_TRUE(save_data(curve, folder / "cut.mrk.json"));
    ASSERT_TRUE(save_scene(scene, folder / "case.mrml"));
  }
  vtkNew<vtkMRMLScene> scene;
  ASSERT_EQ("", load_scene(scene, folder / "case.mrml"));
  auto* curve = vtkMRMLMarkupsCurveNode::SafeDownCast(scene->GetFirstNodeByName("cut"));
  ASSERT_NE(nullptr, curve);
  EXPECT_STREQ("linear", curve->GetCurveTypeAsString(curve->GetCurveType()));
  EXPECT_EQ(2, curve->GetNumberOfControlPoints());
  EXPECT_NE(nullptr, curve->GetMarkupsDisplayNode());
}

class BadMarkupsTest : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BadMarkupsTest, IsAnErrorAndThePointsStay)
{
  const QuietVtk quiet;
  const TemporaryFolder folder;
  vtkNew<vtkMRMLScene> scene;
  auto* points = add_node<vtkMRMLMarkupsFiducialNode>(scene);
  points->AddControlPoint(1.0, 2.0, 3.0);
  points->AddDefaultStorageNode();
  points->GetStorageNode()->SetFileName(folder.write("bad.mrk.json", GetParam()).c_str());
  EXPECT_EQ(0, points->GetStorageNode()->ReadData(points));
  EXPECT_EQ(1, points->GetNumberOfControlPoints());
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadMarkupsTest,
    ::testing::Values(
        "", "nonsense", "[]", "{}", "{\"markups\": []}", "{\"markups\": [1]}",
        "{\"markups\": [{\"type\": \"Curve\"}]}", "{\"markups\": [{\"type\": 5}]}",
        "{\"markups\": [{\"type\": \"Fiducial\", \"coordinateSystem\": \"XYZ\"}]}",
        "{\"markups\": [{\"type\": \"Fiducial\", \"controlPoints\": [{\"position\": [1, 2]}]}]}",
        "{\"markups\": [{\"type\": \"Fiducial\", \"controlPoints\": [{\"position\": [1, 2, "
        "\"x\"]}]}]}",
        "{\"markups\": [{\"type\": \"Fiducial\", \"controlPoints\": [{\"position\": [1e999, 2, "
        "3]}]}]}",
        "{\"markups\": [{\"type\": \"Fiducial\", \"controlPoints\": [{\"positionStatus\": "
        "\"lost\"}]}]}"));
