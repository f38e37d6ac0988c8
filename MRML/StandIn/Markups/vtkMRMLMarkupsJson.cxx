#include "vtkMRMLMarkupsJson.h"

#include "vtkMRMLMarkupsDisplayNode.h"
#include "vtkMRMLMarkupsPlaneNode.h"

#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using Json = vtkMRMLMarkupsJson;

namespace
{

/// `count` finite numbers of a member; false where it is not there, or an empty text as Slicer writes
/// for no position.
bool ReadNumbers(const Json& object, const char* member, int count, double* values)
{
  const auto found = object.find(member);
  if (found == object.end() || (found->is_string() && found->get<std::string>().empty()))
  {
    return false;
  }
  if (!found->is_array() || found->size() != static_cast<std::size_t>(count))
  {
    throw std::runtime_error(std::string(member) + " is no list of " + std::to_string(count) +
                             " numbers");
  }
  for (int i = 0; i < count; ++i)
  {
    values[i] = found->at(i).get<double>();
    if (!std::isfinite(values[i]))
    {
      throw std::runtime_error(std::string(member) + " is not finite");
    }
  }
  return true;
}

template <class Value>
Value Read(const Json& object, const char* member, Value otherwise)
{
  const auto found = object.find(member);
  return found == object.end() || found->is_null() ? otherwise : found->template get<Value>();
}

/// RAS to LPS and back: the first two rows of a matrix of this many columns, or of a point.
void Flip(double* values, int columns)
{
  for (int i = 0; i < 2 * columns; ++i)
  {
    values[i] = values[i] == 0.0 ? 0.0 : -values[i];
  }
}

Json Numbers(const double* values, int count, int flippedColumns)
{
  std::vector<double> list(values, values + count);
  if (flippedColumns > 0)
  {
    Flip(list.data(), flippedColumns);
  }
  return Json(list);
}

// --- Control points ----------------------------------------------------------------------------

std::unique_ptr<vtkMRMLMarkupsNode::ControlPoint> PointFromJson(const Json& object, bool lps)
{
  auto point = std::make_unique<vtkMRMLMarkupsNode::ControlPoint>();
  point->ID = Read(object, "id", std::string());
  point->Label = Read(object, "label", std::string());
  point->Description = Read(object, "description", std::string());
  point->AssociatedNodeID = Read(object, "associatedNodeID", std::string());
  point->Selected = Read(object, "selected", true);
  point->Locked = Read(object, "locked", false);
  point->Visibility = Read(object, "visibility", true);
  const std::string status = Read(object, "positionStatus", std::string("defined"));
  point->PositionStatus = vtkMRMLMarkupsNode::GetPositionStatusFromString(status.c_str());
  if (point->PositionStatus < 0)
  {
    throw std::runtime_error("positionStatus is '" + status + "'");
  }
  if (!ReadNumbers(object, "position", 3, point->Position) &&
      point->PositionStatus == vtkMRMLMarkupsNode::PositionDefined)
  {
    point->PositionStatus = vtkMRMLMarkupsNode::PositionUndefined;
  }
  ReadNumbers(object, "orientation", 9, point->OrientationMatrix);
  if (lps)
  {
    Flip(point->Position, 1);
    if (object.contains("orientation"))
    {
      Flip(point->OrientationMatrix, 3);
    }
  }
  return point;
}

void PointToJson(const vtkMRMLMarkupsNode::ControlPoint& point, bool lps, Json& object)
{
  object["id"] = point.ID;
  object["label"] = point.Label;
  object["description"] = point.Description;
  object["associatedNodeID"] = point.AssociatedNodeID;
  object["position"] = point.PositionStatus == vtkMRMLMarkupsNode::PositionDefined
                           ? Numbers(point.Position, 3, lps ? 1 : 0)
                           : Json("");
  object["orientation"] = Numbers(point.OrientationMatrix, 9, lps ? 3 : 0);
  object["selected"] = point.Selected;
  object["locked"] = point.Locked;
  object["visibility"] = point.Visibility;
  object["positionStatus"] = vtkMRMLMarkupsNode::GetPositionStatusAsString(point.PositionStatus);
}

void PointsToJson(vtkMRMLMarkupsNode* node, bool lps, Json& markup)
{
  const Json before = markup.value("controlPoints", Json::array());
  Json points = Json::array();
  for (int n = 0; n < node->GetNumberOfControlPoints(); ++n)
  {
    const vtkMRMLMarkupsNode::ControlPoint& point = *node->GetNthControlPoint(n);
    const auto known =
        std::find_if(before.begin(), before.end(),
                     [&point](const Json& one) { return one.value("id", Json()) == point.ID; });
    Json object = known == before.end() ? Json::object() : *known;
    PointToJson(point, lps, object);
    points.push_back(std::move(object));
  }
  if (points != before && markup.contains("measurements"))
  {
    // They measured other points; Slicer measures again.
    for (Json& measurement : markup["measurements"])
    {
      measurement.erase("value");
      measurement.erase("controlPointValues");
    }
  }
  markup["controlPoints"] = std::move(points);
}

// --- Planes ------------------------------------------------------------------------------------

void PlaneFromJson(const Json& markup, bool lps, vtkMRMLMarkupsPlaneNode* plane)
{
  for (const auto& [member, matrix] :
       {std::make_pair("objectToBase", plane->GetObjectToBaseMatrix()),
        std::make_pair("baseToNode", plane->GetBaseToNodeMatrix())})
  {
    double values[16];
    if (ReadNumbers(markup, member, 16, values))
    {
      if (lps)
      {
        Flip(values, 4);
      }
      matrix->DeepCopy(values);
      if (matrix->Determinant() == 0.0)
      {
        matrix->Identity();
        throw std::runtime_error(std::string(member) + " is singular");
      }
    }
  }
  const std::string mode = Read(markup, "sizeMode", std::string("auto"));
  plane->SetSizeMode(vtkMRMLMarkupsPlaneNode::GetSizeModeFromString(mode.c_str()));
  plane->SetAutoSizeScalingFactor(
      Read(markup, "autoScalingFactor", plane->GetAutoSizeScalingFactor()));
  double size[3];
  if (ReadNumbers(markup, "size", 3, size))
  {
    plane->SetSize(size[0], size[1]);
  }
  double bounds[4];
  if (ReadNumbers(markup, "planeBounds", 4, bounds))
  {
    plane->SetPlaneBounds(bounds);
  }
}

void PlaneToJson(vtkMRMLMarkupsPlaneNode* plane, bool lps, Json& markup)
{
  markup["planeType"] = vtkMRMLMarkupsPlaneNode::GetPlaneTypeAsString(plane->GetPlaneType());
  markup["sizeMode"] = vtkMRMLMarkupsPlaneNode::GetSizeModeAsString(plane->GetSizeMode());
  markup["autoScalingFactor"] = plane->GetAutoSizeScalingFactor();
  double origin[3];
  plane->GetOrigin(origin);
  markup["center"] = Numbers(origin, 3, lps ? 1 : 0);
  double axes[3][3];
  plane->GetAxes(axes[0], axes[1], axes[2]);
  markup["normal"] = Numbers(axes[2], 3, lps ? 1 : 0);
  markup["objectToBase"] = Numbers(plane->GetObjectToBaseMatrix()->GetData(), 16, lps ? 4 : 0);
  markup["baseToNode"] = Numbers(plane->GetBaseToNodeMatrix()->GetData(), 16, lps ? 4 : 0);
  double orientation[9];
  for (int i = 0; i < 9; ++i)
  {
    orientation[i] = axes[i % 3][i / 3];
  }
  markup["orientation"] = Numbers(orientation, 9, lps ? 3 : 0);
  const double size[3] = {plane->GetSize()[0], plane->GetSize()[1], 0.0};
  markup["size"] = Numbers(size, 3, 0);
  markup["planeBounds"] = Numbers(plane->GetPlaneBounds(), 4, 0);
}

void DisplayToJson(vtkMRMLMarkupsDisplayNode* display, Json& object)
{
  object["visibility"] = display->GetVisibility() != 0;
  object["opacity"] = display->GetOpacity();
  object["color"] = Numbers(display->GetColor(), 3, 0);
  object["selectedColor"] = Numbers(display->GetSelectedColor(), 3, 0);
  object["activeColor"] = Numbers(display->GetActiveColor(), 3, 0);
  object["propertiesLabelVisibility"] = display->GetPropertiesLabelVisibility();
  object["pointLabelsVisibility"] = display->GetPointLabelsVisibility();
  object["textScale"] = display->GetTextScale();
  object["glyphType"] = vtkMRMLMarkupsDisplayNode::GetGlyphTypeAsString(display->GetGlyphType());
  object["glyphScale"] = display->GetGlyphScale();
  object["glyphSize"] = display->GetGlyphSize();
  object["useGlyphScale"] = display->GetUseGlyphScale();
  object["lineThickness"] = display->GetLineThickness();
  object["handlesInteractive"] = display->GetHandlesInteractive();
}

} // namespace

void vtkMRMLMarkupsFromJson(const Json& markup, bool& lps, vtkMRMLMarkupsNode* node)
{
  const std::string type = markup.at("type").get<std::string>();
  if (type != node->GetMarkupType())
  {
    throw std::runtime_error("it holds a " + type + ", not a " + node->GetMarkupType());
  }
  const std::string frame = Read(markup, "coordinateSystem", std::string("LPS"));
  // Slicer 4 wrote numbers.
  if (frame != "LPS" && frame != "1" && frame != "RAS" && frame != "0")
  {
    throw std::runtime_error("coordinateSystem is '" + frame + "'");
  }
  lps = frame == "LPS" || frame == "1";

  std::vector<std::unique_ptr<vtkMRMLMarkupsNode::ControlPoint>> points;
  for (const Json& object : markup.value("controlPoints", Json::array()))
  {
    points.push_back(PointFromJson(object, lps));
  }
  MRMLNodeModifyBlocker blocker(node);
  auto* plane = vtkMRMLMarkupsPlaneNode::SafeDownCast(node);
  node->SetFixedNumberOfControlPoints(false);
  node->RemoveAllControlPoints();
  if (plane)
  {
    // Files from before there were types hold three points.
    const std::string planeType = Read(markup, "planeType", std::string("threePoints"));
    plane->SetPlaneType(vtkMRMLMarkupsPlaneNode::GetPlaneTypeFromString(planeType.c_str()));
  }
  node->SetLocked(Read(markup, "locked", false));
  node->SetControlPointLabelFormat(Read(markup, "labelFormat", node->GetControlPointLabelFormat()));
  for (auto& point : points)
  {
    node->AddControlPoint(point.release(), false);
  }
  node->SetLastUsedControlPointNumber(
      Read(markup, "lastUsedControlPointNumber", node->GetLastUsedControlPointNumber()));
  if (plane)
  {
    PlaneFromJson(markup, lps, plane);
  }
  node->SetFixedNumberOfControlPoints(Read(markup, "fixedNumberOfControlPoints", false));
}

void vtkMRMLMarkupsToJson(vtkMRMLMarkupsNode* node, bool lps, Json& markup)
{
  markup["type"] = node->GetMarkupType();
  markup["coordinateSystem"] = lps ? "LPS" : "RAS";
  if (!markup.contains("coordinateUnits"))
  {
    markup["coordinateUnits"] = "mm";
  }
  markup["locked"] = node->GetLocked() != 0;
  markup["fixedNumberOfControlPoints"] = node->GetFixedNumberOfControlPoints();
  markup["labelFormat"] = node->GetControlPointLabelFormat();
  markup["lastUsedControlPointNumber"] = node->GetLastUsedControlPointNumber();
  if (auto* plane = vtkMRMLMarkupsPlaneNode::SafeDownCast(node))
  {
    PlaneToJson(plane, lps, markup);
  }
  PointsToJson(node, lps, markup);
  if (!markup.contains("measurements"))
  {
    markup["measurements"] = Json::array();
  }
  if (vtkMRMLMarkupsDisplayNode* display = node->GetMarkupsDisplayNode())
  {
    DisplayToJson(display, markup["display"]);
  }
}
