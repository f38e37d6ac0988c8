#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/markups.hpp>

#include <cmath>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

/// A fiducial file with the given frame and control points.
std::string fiducials(const std::string& frame, const std::string& points)
{
  return R"({"markups": [{"type": "Fiducial", )" + frame + R"("controlPoints": [)" + points +
         "]}]}";
}

std::string point(const std::string& label, const std::string& position)
{
  return R"({"label": ")" + label + R"(", "positionStatus": "defined", "position": [)" + position +
         "]}";
}

/// A plane as Slicer 5.6 writes it: 60 x 40 mm about L 10, P -20, S 30, with its x axis to the left
/// and its normal upwards.
const char* slicer_plane = R"({
  "@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
  "markups": [{
    "type": "Plane", "coordinateSystem": "LPS", "coordinateUnits": "mm", "locked": false,
    "fixedNumberOfControlPoints": true, "labelFormat": "%N-%d", "lastUsedControlPointNumber": 1,
    "planeType": "pointNormal", "sizeMode": "absolute", "autoScalingFactor": 1.0,
    "center": [10.0, -20.0, 30.0], "normal": [0.0, 0.0, 1.0],
    "objectToBase": [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    "baseToNode": [1.0, 0.0, 0.0, 10.0, 0.0, 1.0, 0.0, -20.0, 0.0, 0.0, 1.0, 30.0, 0.0, 0.0, 0.0, 1.0],
    "orientation": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
    "size": [60.0, 40.0, 0.0], "planeBounds": [-30.0, 30.0, -20.0, 20.0],
    "controlPoints": [{
      "id": "1", "label": "P-1", "description": "", "associatedNodeID": "",
      "position": [10.0, -20.0, 30.0], "orientation": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
      "selected": true, "locked": false, "visibility": true, "positionStatus": "defined"}],
    "measurements": [],
    "display": {"visibility": true, "opacity": 1.0}
  }]})";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Markups, FiducialsComeBackExactly)
{
  const TemporaryFolder folder;
  const Landmarks landmarks = {{"N", {0.1, 1.0 / 3, -2e-7}}, {"Or_R", {35.25, 80, 1e3}}};
  write_landmarks(folder / "l.mrk.json", landmarks);
  EXPECT_EQ(read_landmarks(folder / "l.mrk.json"), landmarks);
}

TEST(Markups, CurveKeepsTypeAndOrder)
{
  const TemporaryFolder folder;
  const PointMarkup curve{"ClosedCurve", {{"c", {1, 2, 3}}, {"a", {4, 5, 6}}, {"b", {7, 8, 9}}}};
  write_points(folder / "c.mrk.json", curve);
  const PointMarkup read = read_points(folder / "c.mrk.json");
  EXPECT_EQ(read.type, "ClosedCurve");
  ASSERT_EQ(read.points.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(read.points[i].label, curve.points[i].label);
    EXPECT_EQ(read.points[i].position, curve.points[i].position);
  }
}

TEST(Markups, FilesAreWrittenInLps)
{
  const TemporaryFolder folder;
  write_landmarks(folder / "l.mrk.json", {{"N", {1, 2, 3}}});
  const std::string text = test::read_text(folder / "l.mrk.json");
  EXPECT_NE(text.find(R"("coordinateSystem": "LPS")"), std::string::npos);
  EXPECT_NE(text.find("-1.0,\n            -2.0,\n            3.0"), std::string::npos) << text;
}

TEST(Markups, BothFramesAreRead)
{
  const TemporaryFolder folder;
  const std::string n = point("N", "1, 2, 3");
  for (const char* frame : {"", R"("coordinateSystem": "LPS", )", R"("coordinateSystem": 0, )"})
    EXPECT_EQ(read_landmarks(folder.write("l.json", fiducials(frame, n))).at("N"), Vec3(-1, -2, 3))
        << frame;
  for (const char* frame : {R"("coordinateSystem": "RAS", )", R"("coordinateSystem": "1", )"})
    EXPECT_EQ(read_landmarks(folder.write("r.json", fiducials(frame, n))).at("N"), Vec3(1, 2, 3))
        << frame;
  const auto odd = folder.write("odd.json", fiducials(R"("coordinateSystem": "XYZ", )", n));
  expect_error([&] { read_landmarks(odd); }, {odd.string(), "XYZ", "LPS or RAS"});
}

TEST(Markups, BadPointsAreNamed)
{
  const TemporaryFolder folder;
  auto refused = [&](const std::string& points, const std::vector<std::string>& parts)
  {
    const auto file = folder.write("bad.mrk.json", fiducials("", points));
    std::vector<std::string> all = parts;
    all.push_back(file.string());
    expect_error([&] { read_landmarks(file); }, all);
  };
  refused(point("N", "1, 2, null"), {"'N'", "not a finite number"});
  refused(point("N", "1, 2, \"NaN\""), {"'N'", "not a finite number"});
  refused(point("N", "1, 2"), {"'N'", "three numbers"});
  refused(point("N", "1, 2, NaN"), {"JSON", "line 1"});
  refused(point("N", "1, 2, 1e999"), {"too large"});
  refused(R"({"label": "N", "positionStatus": "undefined", "position": [0, 0, 0]})",
          {"'N'", "no position"});
  refused(R"({"label": "N"})", {"'N'", "no position"});
  refused(R"({"label": null, "position": [0, 0, 0]})", {"wrong type"});
  refused("17", {"wrong type"});
  refused(point("N", "1, 2, 3") + "," + point("N", "1, 2, 4"), {"'N'", "twice"});
  // a list of landmarks may be empty as yet, a line not
  const auto none = folder.write("none.mrk.json", fiducials("", ""));
  EXPECT_TRUE(read_landmarks(none).empty());
  expect_error([&] { read_points(none); }, {none.string(), "no points"});
}

TEST(Markups, OtherFilesAreRefused)
{
  const TemporaryFolder folder;
  for (const char* text :
       {"", "{", "[]", "{}", R"({"markups": []})", R"({"markups": 3})", R"({"markups": [3]})",
        R"({"markups": [{"type": "ROI"}]})", R"({"markups": [{"type": 4}]})"})
  {
    const auto file = folder.write("other.json", text);
    expect_error([&] { read_points(file); }, {file.string()});
    expect_error([&] { read_planes(file); }, {file.string()});
  }
  expect_error([&] { read_points(folder / "absent.json"); }, {"absent.json", "cannot be read"});
  expect_error([&] { read_points(folder.path()); }, {folder.path().string(), "cannot be read"});
}

TEST(Markups, PlanesComeBackWithTheirExtent)
{
  const TemporaryFolder folder;
  BoundedPlane tilted;
  tilted.name = "upper";
  tilted.center = {5, -3, 12};
  tilted.u = Vec3(1, 2, 0.5).normalized();
  tilted.v = tilted.u.unitOrthogonal();
  tilted.half_u = 40;
  tilted.half_v = 22.5;
  BoundedPlane other = tilted;
  other.name = "lower";
  other.center.z() = -7;
  write_planes(folder / "p.mrk.json", {tilted, other});
  const std::vector<BoundedPlane> read = read_planes(folder / "p.mrk.json");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, "upper");
  EXPECT_EQ(read[1].name, "lower");
  EXPECT_NEAR((read[0].center - tilted.center).norm(), 0, 1e-12);
  EXPECT_NEAR((read[0].u - tilted.u).norm(), 0, 1e-12);
  EXPECT_NEAR((read[0].v - tilted.v).norm(), 0, 1e-12);
  EXPECT_NEAR((read[1].normal() - tilted.normal()).norm(), 0, 1e-12);
  EXPECT_EQ(read[1].center.z(), -7);
  EXPECT_DOUBLE_EQ(read[0].half_u, 40);
  EXPECT_DOUBLE_EQ(read[0].half_v, 22.5);
}

TEST(Markups, SlicersOwnPlaneIsUnderstood)
{
  const TemporaryFolder folder;
  const BoundedPlane plane = read_planes(folder.write("cut.mrk.json", slicer_plane)).at(0);
  EXPECT_EQ(plane.name, "P-1");
  EXPECT_NEAR((plane.center - Vec3(-10, 20, 30)).norm(), 0, 1e-12);
  EXPECT_NEAR((plane.u - Vec3(-1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((plane.v - Vec3(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((plane.normal() - Vec3(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(plane.half_u, 30);
  EXPECT_DOUBLE_EQ(plane.half_v, 20);
}

TEST(Markups, OneSidedPlaneBoundsShiftTheRectangle)
{
  const TemporaryFolder folder;
  const std::string text =
      replaced(slicer_plane, "[-30.0, 30.0, -20.0, 20.0]", "[0.0, 60.0, -20.0, 20.0]");
  const BoundedPlane plane = read_planes(folder.write("cut.mrk.json", text)).at(0);
  EXPECT_NEAR((plane.center - Vec3(-40, 20, 30)).norm(), 0,
              1e-12); // 30 mm along its x axis, to the left
  EXPECT_DOUBLE_EQ(plane.half_u, 30);
}

TEST(Markups, PlaneWithNormalAloneIsUnderstood)
{
  const TemporaryFolder folder;
  const auto file =
      folder.write("palate.mrk.json", R"({"markups": [{"type": "Plane", "coordinateSystem": "RAS",
    "center": [1, 2, 3], "normal": [0, 0, 2], "size": [10, 20]}]})");
  const BoundedPlane plane = read_planes(file).at(0);
  EXPECT_EQ(plane.name, "palate");
  EXPECT_NEAR((plane.normal() - Vec3(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(plane.half_u, 5);
  EXPECT_DOUBLE_EQ(plane.half_v, 10);
}

TEST(Markups, BadPlanesAreNamed)
{
  const TemporaryFolder folder;
  auto refused = [&](const std::string& from, const std::string& to, const std::string& part)
  {
    const auto file = folder.write("bad.mrk.json", replaced(slicer_plane, from, to));
    expect_error([&] { read_planes(file); }, {file.string(), part});
  };
  refused(R"("type": "Plane")", R"("type": "Curve")", "'Curve'");
  refused(R"("center": [10.0)", R"("center": [null)", "not a finite number");
  refused(R"("orientation": [1.0)", R"("orientation": ["x")", "wrong type");
  refused(R"("orientation": [1.0, 0.0, 0.0, 0.0, 1.0)",
          R"("orientation": [0.0, 0.0, 0.0, 0.0, 1.0)", "no direction");
  refused(R"("orientation": [1.0, 0.0, 0.0, 0.0, 1.0)",
          R"("orientation": [1.0, 1.0, 0.0, 0.0, 0.0)", "no direction");
  refused(R"("size": [60.0, 40.0, 0.0], "planeBounds": [-30.0, 30.0, -20.0, 20.0])",
          R"("size": [60.0, 0.0, 0.0])", "no extent");
  refused(R"("planeBounds": [-30.0, 30.0, -20.0, 20.0])",
          R"("planeBounds": [-30.0, 30.0, 20.0, -20.0])", "no extent");
  const auto bare = folder.write("bare.json", R"({"markups": [{"type": "Plane"}]})");
  expect_error([&] { read_planes(bare); }, {bare.string(), "no center"});
  const auto level =
      folder.write("level.json", R"({"markups": [{"type": "Plane", "center": [0, 0, 0]}]})");
  expect_error([&] { read_planes(level); }, {level.string(), "neither orientation nor normal"});
  const auto zero = folder.write(
      "zero.json",
      R"({"markups": [{"type": "Plane", "center": [0, 0, 0], "normal": [0, 0, 0], "size": [1, 1]}]})");
  expect_error([&] { read_planes(zero); }, {zero.string(), "no direction"});
}

} // namespace
} // namespace f2b
