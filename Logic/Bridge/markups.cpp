#include "Bridge/markups.hpp"

#include "Bridge/json_file.hpp"
#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;
using std::filesystem::path;

constexpr const char* schema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/"
                               "Loadable/Markups/Resources/Schema/"
                               "markups-schema-v1.0.3.json#";

/// Minus one on the axes that LPS counts the other way.
Vec3 flip_of(const json& markup, const path& file)
{
  const json stated = markup.value("coordinateSystem", json("LPS"));
  // early Slicer 5 wrote the number of an enumeration
  const std::string frame = stated.is_string() ? stated.get<std::string>() : stated.dump();
  if (frame == "LPS" || frame == "0")
    return {-1, -1, 1};
  if (frame == "RAS" || frame == "1")
    return {1, 1, 1};
  throw Error(file.string(), "coordinateSystem is '" + frame + "'", "use LPS or RAS");
}

Vec3 vector_from(const json& value, const path& file, const std::string& what)
{
  if (!value.is_array() || value.size() != 3)
    throw Error(file.string(), what + " is not three numbers", "save the markup again from Slicer");
  Vec3 v;
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (!value[a].is_number() || !std::isfinite(value[a].get<double>()))
      throw Error(file.string(), what + " has a coordinate that is not a finite number",
                  "place the point in Slicer and save again");
    v[static_cast<Eigen::Index>(a)] = value[a].get<double>();
  }
  return v;
}

json markups_of(const path& file)
{
  const json document = read_json(file);
  if (!document.is_object() || !document.contains("markups") || !document["markups"].is_array() ||
      document["markups"].empty())
    throw Error(file.string(), "it holds no markups", "give a Slicer markups file (.mrk.json)");
  return document["markups"];
}

std::vector<ControlPoint> control_points(const json& markup, const path& file)
{
  const Vec3 flip = flip_of(markup, file);
  std::vector<ControlPoint> points;
  for (const json& point : markup.value("controlPoints", json::array()))
  {
    const std::string label = point.value("label", "");
    if (point.value("positionStatus", "defined") != "defined" || !point.contains("position"))
      throw Error(file.string(), "point '" + label + "' has no position", "place it or delete it");
    points.push_back(
        {label, vector_from(point["position"], file, "point '" + label + "'").cwiseProduct(flip)});
  }
  return points;
}

json point_json(const ControlPoint& point, std::size_t index)
{
  const Vec3 p = point.position.cwiseProduct(Vec3(-1, -1, 1));
  return {{"id", std::to_string(index + 1)},
          {"label", point.label},
          {"description", ""},
          {"associatedNodeID", ""},
          {"position", {p.x(), p.y(), p.z()}},
          {"orientation", {-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0}},
          {"selected", true},
          {"locked", false},
          {"visibility", true},
          {"positionStatus", "defined"}};
}

json markup_json(const std::string& type, const std::vector<ControlPoint>& points)
{
  json markup = {{"type", type},
                 {"coordinateSystem", "LPS"},
                 {"coordinateUnits", "mm"},
                 {"locked", false},
                 {"fixedNumberOfControlPoints", false},
                 {"labelFormat", "%N-%d"},
                 {"lastUsedControlPointNumber", points.size()},
                 {"controlPoints", json::array()},
                 {"measurements", json::array()}};
  for (std::size_t i = 0; i < points.size(); ++i)
    markup["controlPoints"].push_back(point_json(points[i], i));
  return markup;
}

void require_point_type(const std::string& type, const path& file)
{
  for (const char* known : {"Fiducial", "Line", "Angle", "Curve", "ClosedCurve"})
    if (type == known)
      return;
  throw Error(file.string(), "its markup is a '" + type + "'",
              "give a Fiducial, Line, Angle, Curve or ClosedCurve");
}

/// Runs a decoder of a file; a field of the wrong type becomes an Error.
template <class Decoder>
auto decoded(const path& file, Decoder decoder)
{
  try
  {
    return decoder();
  }
  catch (const json::exception&)
  {
    throw Error(file.string(), "a markup has a field of the wrong type",
                "save it again from Slicer");
  }
}

} // namespace

std::vector<PointMarkup> read_point_markups(const path& file)
{
  const json markups = markups_of(file);
  return decoded(file,
                 [&]
                 {
                   std::vector<PointMarkup> all;
                   for (const json& markup : markups)
                   {
                     const std::string type = markup.value("type", "");
                     require_point_type(type, file);
                     all.push_back({type, control_points(markup, file)});
                   }
                   return all;
                 });
}

PointMarkup read_points(const path& file)
{
  const PointMarkup first = read_point_markups(file).front();
  if (first.points.empty())
    throw Error(file.string(), "it holds no points", "place them in Slicer and save again");
  return first;
}

void write_point_markups(const path& file, const std::vector<PointMarkup>& markups)
{
  json document = {{"@schema", schema}, {"markups", json::array()}};
  for (const PointMarkup& markup : markups)
    document["markups"].push_back(markup_json(markup.type, markup.points));
  write_json(file, document);
}

void write_points(const path& file, const PointMarkup& markup)
{
  write_point_markups(file, {markup});
}

Landmarks read_landmarks(const path& file)
{
  Landmarks landmarks;
  const PointMarkup first = read_point_markups(file).front();
  for (const ControlPoint& point : first.points)
    if (!landmarks.emplace(point.label, point.position).second)
      throw Error(file.string(), "the landmark '" + point.label + "' appears twice",
                  "remove one of them");
  return landmarks;
}

void write_landmarks(const path& file, const Landmarks& landmarks)
{
  PointMarkup markup;
  for (const auto& [label, position] : landmarks)
    markup.points.push_back({label, position});
  write_points(file, markup);
}

namespace
{

/// In-plane axes from what the file says of them: its orientation, or any pair around its normal.
void set_axes(BoundedPlane& plane, const json& markup, const path& file, const Vec3& flip)
{
  const json orientation = markup.value("orientation", json());
  if (orientation.is_array() && orientation.size() == 9)
  {
    // row-major, one axis a column
    for (int row = 0; row < 3; ++row)
    {
      plane.u[row] = flip[row] * orientation[static_cast<std::size_t>(3 * row)].get<double>();
      plane.v[row] = flip[row] * orientation[static_cast<std::size_t>(3 * row + 1)].get<double>();
    }
  }
  else
  {
    if (!markup.contains("normal"))
      throw Error(file.string(), "plane '" + plane.name + "' has neither orientation nor normal",
                  "save it again from Slicer 5 or newer");
    const Vec3 n =
        vector_from(markup["normal"], file, "normal of '" + plane.name + "'").cwiseProduct(flip);
    plane.u = n.unitOrthogonal();
    plane.v = n.cross(plane.u);
  }
  if (!(plane.u.norm() > 1e-6) || !(plane.normal().norm() > 1e-6))
    throw Error(file.string(), "plane '" + plane.name + "' has no direction",
                "place it again in Slicer");
  plane.u.normalize();
  plane.v = (plane.v - plane.u * plane.u.dot(plane.v)).normalized();
}

void set_extent(BoundedPlane& plane, const json& markup, const path& file)
{
  const json bounds = markup.value("planeBounds", json());
  if (bounds.is_array() && bounds.size() == 4 && bounds[1].get<double>() > bounds[0].get<double>())
  {
    double b[4];
    for (std::size_t i = 0; i < 4; ++i)
      b[i] = bounds[i].get<double>();
    plane.center += 0.5 * (b[0] + b[1]) * plane.u + 0.5 * (b[2] + b[3]) * plane.v;
    plane.half_u = 0.5 * (b[1] - b[0]);
    plane.half_v = 0.5 * (b[3] - b[2]);
  }
  else if (markup.contains("size"))
  {
    json size = markup["size"];
    if (size.is_array() && size.size() == 2)
      size.push_back(0.0);
    const Vec3 s = vector_from(size, file, "size of '" + plane.name + "'");
    plane.half_u = 0.5 * s.x();
    plane.half_v = 0.5 * s.y();
  }
  if (!(plane.half_u > 0) || !(plane.half_v > 0))
    throw Error(file.string(), "plane '" + plane.name + "' has no extent",
                "give it a size in Slicer");
}

BoundedPlane plane_from(const json& markup, const path& file)
{
  BoundedPlane plane;
  const std::string stem = file.stem().stem().string();
  plane.name = markup.value("name", "");
  const Vec3 flip = flip_of(markup, file);
  const std::vector<ControlPoint> points = control_points(markup, file);
  if (plane.name.empty())
    plane.name = points.empty() || points[0].label.empty() ? stem : points[0].label;
  if (markup.contains("center"))
    plane.center =
        vector_from(markup["center"], file, "center of '" + plane.name + "'").cwiseProduct(flip);
  else if (!points.empty())
    plane.center = points[0].position;
  else
    throw Error(file.string(), "plane '" + plane.name + "' has no center",
                "place it again in Slicer");
  set_axes(plane, markup, file, flip);
  set_extent(plane, markup, file);
  return plane;
}

/// A 4 x 4 matrix from plane to world, its rows in LPS, row-major.
json matrix_json(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin)
{
  json m = json::array();
  for (int row = 0; row < 4; ++row)
    for (const Vec3* column : {&x, &y, &z, &origin})
      m.push_back(row < 3 ? (*column)[row] * (row < 2 ? -1.0 : 1.0)
                          : (column == &origin ? 1.0 : 0.0));
  return m;
}

json plane_json(const BoundedPlane& plane)
{
  json markup = markup_json("Plane", {{plane.name, plane.center}});
  const Vec3 n = plane.normal(), c = plane.center.cwiseProduct(Vec3(-1, -1, 1));
  markup["name"] = plane.name;
  markup["fixedNumberOfControlPoints"] = true;
  markup["planeType"] = "pointNormal";
  markup["sizeMode"] = "absolute";
  markup["autoScalingFactor"] = 1.0;
  markup["center"] = {c.x(), c.y(), c.z()};
  markup["normal"] = {-n.x(), -n.y(), n.z()};
  markup["objectToBase"] = matrix_json(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::Zero());
  markup["baseToNode"] = matrix_json(plane.u, plane.v, n, plane.center);
  json orientation = json::array();
  for (int row = 0; row < 3; ++row)
    for (const Vec3& axis : {plane.u, plane.v, n})
      orientation.push_back(axis[row] * (row < 2 ? -1.0 : 1.0));
  markup["orientation"] = orientation;
  markup["size"] = {2 * plane.half_u, 2 * plane.half_v, 0.0};
  markup["planeBounds"] = {-plane.half_u, plane.half_u, -plane.half_v, plane.half_v};
  return markup;
}

} // namespace

std::vector<BoundedPlane> read_planes(const path& file)
{
  std::vector<BoundedPlane> planes;
  for (const json& markup : markups_of(file))
    planes.push_back(decoded(file,
                             [&]
                             {
                               const std::string type = markup.value("type", "");
                               if (type != "Plane")
                                 throw Error(file.string(), "it holds a '" + type + "' markup",
                                             "give Plane markups only");
                               return plane_from(markup, file);
                             }));
  return planes;
}

void write_planes(const path& file, const std::vector<BoundedPlane>& planes)
{
  json document = {{"@schema", schema}, {"markups", json::array()}};
  for (const BoundedPlane& plane : planes)
    document["markups"].push_back(plane_json(plane));
  write_json(file, document);
}

} // namespace f2b
