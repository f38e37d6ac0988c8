#include "vtkFaceToBonePlaneRepresentation.h"

#include <Core/geometry/osteotomy.hpp>
#include <Core/sculpting/line_of_sight.hpp>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkFaceToBonePlaneRepresentation);

namespace
{

using Point = std::array<double, 3>;
using Representation = vtkFaceToBonePlaneRepresentation;

constexpr double nearPixels = 11;
constexpr Representation::Handle balls[] = {Representation::Centre, Representation::Normal,
                                            Representation::EdgeU0, Representation::EdgeU1,
                                            Representation::EdgeV0, Representation::EdgeV1};

Point ToPoint(const f2b::Vec3& v)
{
  return {v.x(), v.y(), v.z()};
}

f2b::Vec3 Corner(const f2b::BoundedPlane& p, int i, double lift)
{
  const double u = i == 0 || i == 3 ? -1 : 1, v = i < 2 ? -1 : 1;
  return p.center + u * p.half_u * p.u + v * p.half_v * p.v + lift * p.normal();
}

/// A box of the kerf's thickness around the rectangle.
void DrawSlab(vtkPolyData* data, const f2b::BoundedPlane& plane, double kerf)
{
  const double half = std::max(0.05, 0.5 * kerf);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (const double lift : {-half, half})
    for (int i = 0; i < 4; ++i)
      points->InsertNextPoint(Corner(plane, i, lift).data());
  const vtkIdType faces[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                 {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const auto& face : faces)
    quads->InsertNextCell(4, face);
  data->Initialize();
  data->SetPoints(points);
  data->SetPolys(quads);
}

} // namespace

vtkFaceToBonePlaneRepresentation::vtkFaceToBonePlaneRepresentation()
    : Plane(std::make_unique<f2b::BoundedPlane>()), Slab(vtkSmartPointer<vtkPolyData>::New()),
      Outline(vtkSmartPointer<vtkPolyData>::New()), Balls(vtkSmartPointer<vtkPolyData>::New()),
      Chosen(vtkSmartPointer<vtkPolyData>::New()), Arrow(vtkSmartPointer<vtkPolyData>::New())
{
  const Point red{0.72, 0.05, 0.27};
  this->Coloured = {this->AddActor(this->Slab, red)->GetProperty(),
                    this->AddActor(this->Outline, red, 2.5)->GetProperty()};
  this->Coloured[0]->SetOpacity(0.3);
  this->Coloured[1]->LightingOff();
  this->AddActor(this->Arrow, {0.1, 0.1, 0.12}, 2.5)->GetProperty()->LightingOff();
  this->MakeBalls(this->Balls, this->Chosen);
  this->Draw();
}

vtkFaceToBonePlaneRepresentation::~vtkFaceToBonePlaneRepresentation() = default;

void vtkFaceToBonePlaneRepresentation::SetPlane(const f2b::BoundedPlane& plane)
{
  *this->Plane = plane;
  this->Draw();
  this->Modified();
}

void vtkFaceToBonePlaneRepresentation::SetKerf(double mm)
{
  this->Kerf = mm;
  this->Draw();
  this->Modified();
}

void vtkFaceToBonePlaneRepresentation::SetColour(const Point& colour)
{
  for (vtkProperty* look : this->Coloured)
    look->SetColor(colour[0], colour[1], colour[2]);
}

void vtkFaceToBonePlaneRepresentation::SetHandlesShown(bool shown)
{
  this->HandlesShown = shown;
  this->Highlighted = None;
  this->Coloured[0]->SetOpacity(shown ? 0.3 : 0.15);
  this->Draw();
}

auto vtkFaceToBonePlaneRepresentation::HandlePosition(Handle handle) const -> Point
{
  const f2b::BoundedPlane& p = *this->Plane;
  switch (handle)
  {
  case Normal:
    return ToPoint(p.center + 0.6 * std::min(p.half_u, p.half_v) * p.normal());
  case EdgeU0:
    return ToPoint(p.center - p.half_u * p.u);
  case EdgeU1:
    return ToPoint(p.center + p.half_u * p.u);
  case EdgeV0:
    return ToPoint(p.center - p.half_v * p.v);
  case EdgeV1:
    return ToPoint(p.center + p.half_v * p.v);
  default:
    return ToPoint(p.center);
  }
}

void vtkFaceToBonePlaneRepresentation::Draw()
{
  DrawSlab(this->Slab, *this->Plane, this->Kerf);
  std::vector<Point> corners, at;
  for (int i = 0; i < 4; ++i)
    corners.push_back(ToPoint(Corner(*this->Plane, i, 0)));
  SetPolyline(this->Outline, corners, true);
  if (this->HandlesShown)
  {
    for (const Handle handle : balls)
      at.push_back(this->HandlePosition(handle));
    SetPolyline(this->Arrow, {this->HandlePosition(Centre), this->HandlePosition(Normal)}, false);
  }
  else
    SetPolyline(this->Arrow, {}, false);
  SetPoints(this->Balls, at);
  at.clear();
  if (this->Highlighted > Face)
    at.push_back(this->HandlePosition(this->Highlighted));
  SetPoints(this->Chosen, at);
}

f2b::LineOfSight vtkFaceToBonePlaneRepresentation::LineAt(double x, double y)
{
  const Ray ray = this->GetRay(x, y);
  return {{ray.Origin[0], ray.Origin[1], ray.Origin[2]},
          {ray.Direction[0], ray.Direction[1], ray.Direction[2]}};
}

auto vtkFaceToBonePlaneRepresentation::HandleAt(double x, double y) -> Handle
{
  if (!this->HandlesShown)
    return None;
  Handle found = None;
  double nearest = nearPixels;
  for (const Handle handle : balls)
  {
    const Point p = this->ToDisplay(this->HandlePosition(handle));
    const double away = std::hypot(p[0] - x, p[1] - y);
    if (away < nearest)
    {
      nearest = away;
      found = handle;
    }
  }
  if (found != None)
    return found;
  const auto isNear = [&](const Point& a, const Point& b)
  { return PixelsFromPiece(this->ToDisplay(a), this->ToDisplay(b), x, y) < 0.7 * nearPixels; };
  for (int i = 0; i < 4; ++i)
    if (isNear(ToPoint(Corner(*this->Plane, i, 0)), ToPoint(Corner(*this->Plane, (i + 1) % 4, 0))))
      return Face;
  return isNear(this->HandlePosition(Centre), this->HandlePosition(Normal)) ? Face : None;
}

bool vtkFaceToBonePlaneRepresentation::HighlightOnly(Handle handle)
{
  if (handle == this->Highlighted)
    return false;
  this->Highlighted = handle;
  this->Draw();
  return true;
}

void vtkFaceToBonePlaneRepresentation::ShowSize(double x, double y)
{
  char text[120];
  std::snprintf(text, sizeof text, "%s%s%.1f x %.1f mm, kerf %.1f mm", this->Plane->name.c_str(),
                this->Plane->name.empty() ? "" : ": ", 2 * this->Plane->half_u,
                2 * this->Plane->half_v, this->Kerf);
  this->SetReadout(text, x, y);
}

void vtkFaceToBonePlaneRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kerf: " << this->Kerf << " mm\n";
}
