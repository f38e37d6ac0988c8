#include "vtkFaceToBoneCurveRepresentation.h"

#include <Core/sculpting/surface_path.hpp>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkFaceToBoneCurveRepresentation);

struct vtkFaceToBoneCurveRepresentation::Surface
{
  explicit Surface(f2b::TriangleMesh m)
      : mesh(std::move(m)), links(mesh.points.size(), mesh.triangles), tree(mesh)
  {
  }
  f2b::TriangleMesh mesh;
  f2b::SurfaceLinks links;
  f2b::SurfaceTree tree;
};

struct vtkFaceToBoneCurveRepresentation::State
{
  std::vector<f2b::SurfacePlace> places;
  std::vector<std::vector<Point>> legs;
  bool closed;
};

namespace
{

using Point = std::array<double, 3>;

constexpr double nearPixels = 10;

f2b::SurfacePlace InTheAir(const Point& p)
{
  f2b::SurfacePlace place;
  place.point = f2b::Vec3(p.data());
  return place;
}

bool IsInTheAir(const f2b::SurfacePlace& place)
{
  return place.triangle < 0;
}

f2b::TriangleMesh ToMesh(vtkPolyData* surface)
{
  f2b::TriangleMesh mesh;
  for (vtkIdType v = 0; v < surface->GetNumberOfPoints(); ++v)
    mesh.points.emplace_back(surface->GetPoint(v));
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    surface->GetCellPoints(c, corners);
    if (corners->GetNumberOfIds() == 3)
      mesh.triangles.push_back({static_cast<int>(corners->GetId(0)),
                                static_cast<int>(corners->GetId(1)),
                                static_cast<int>(corners->GetId(2))});
  }
  return mesh;
}

} // namespace

vtkFaceToBoneCurveRepresentation::vtkFaceToBoneCurveRepresentation()
    : Line(vtkSmartPointer<vtkPolyData>::New()), Points(vtkSmartPointer<vtkPolyData>::New()),
      Chosen(vtkSmartPointer<vtkPolyData>::New())
{
  this->LineActor = this->AddActor(this->Line, {0.72, 0.05, 0.27}, 3.5);
  this->LineActor->GetProperty()->LightingOff();
  this->BallActor = this->MakeBalls(this->Points, this->Chosen);
}

vtkFaceToBoneCurveRepresentation::~vtkFaceToBoneCurveRepresentation() = default;

void vtkFaceToBoneCurveRepresentation::SetSurface(vtkPolyData* surface)
{
  this->Clear();
  this->Bone.reset();
  if (surface)
  {
    f2b::TriangleMesh mesh = ToMesh(surface);
    if (!mesh.triangles.empty())
      this->Bone = std::make_shared<const Surface>(std::move(mesh));
  }
  this->Modified();
}

void vtkFaceToBoneCurveRepresentation::ShareSurface(const vtkFaceToBoneCurveRepresentation& other)
{
  this->Clear();
  this->Bone = other.Bone;
  this->Modified();
}

void vtkFaceToBoneCurveRepresentation::SetFree(bool free)
{
  if (free == this->Free)
    return;
  this->Clear();
  this->Free = free;
}

void vtkFaceToBoneCurveRepresentation::SetColour(const Point& colour)
{
  this->LineActor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void vtkFaceToBoneCurveRepresentation::SetBall(const Point& colour)
{
  this->BallActor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  this->BallActor->GetProperty()->SetPointSize(19);
}

void vtkFaceToBoneCurveRepresentation::SetHandlesShown(bool shown)
{
  this->HandlesShown = shown;
  this->Highlighted = None;
  this->Draw();
}

std::optional<f2b::SurfacePlace> vtkFaceToBoneCurveRepresentation::PlaceAt(double x, double y)
{
  if (!this->Bone || !this->Renderer)
    return {};
  const Ray ray = this->GetRay(x, y);
  return this->Bone->tree.first_hit(f2b::Vec3(ray.Origin.data()), f2b::Vec3(ray.Direction.data()));
}

std::optional<f2b::SurfacePlace> vtkFaceToBoneCurveRepresentation::PlaceFor(int index, double x,
                                                                            double y)
{
  if (!this->Free)
    return this->PlaceAt(x, y);
  if (!this->Renderer)
    return {};
  return InTheAir(this->WorldAtDepthOf(this->GetControlPoint(index), x, y));
}

int vtkFaceToBoneCurveRepresentation::GetNumberOfControlPoints() const
{
  return static_cast<int>(this->Places.size());
}

auto vtkFaceToBoneCurveRepresentation::GetControlPoint(int index) const -> Point
{
  const f2b::Vec3& p = this->Places.at(static_cast<std::size_t>(index)).point;
  return {p.x(), p.y(), p.z()};
}

auto vtkFaceToBoneCurveRepresentation::GetControlPoints() const -> std::vector<Point>
{
  std::vector<Point> points;
  for (int i = 0; i < this->GetNumberOfControlPoints(); ++i)
    points.push_back(this->GetControlPoint(i));
  return points;
}

/// Points of a file need not lie on one piece of bone: where no way leads on, it goes straight.
void vtkFaceToBoneCurveRepresentation::SetControlPoints(const std::vector<Point>& points,
                                                        bool closed)
{
  this->Clear();
  for (const Point& p : points)
    this->Places.push_back(
        this->Free || !this->Bone ? InTheAir(p) : this->Bone->tree.nearest(f2b::Vec3(p.data())));
  this->Closed = closed && points.size() > 2;
  const std::size_t count = this->Places.size();
  for (std::size_t i = 0; i + (this->Closed ? 0 : 1) < count; ++i)
  {
    const f2b::SurfacePlace &from = this->Places[i], &to = this->Places[(i + 1) % count];
    std::vector<Point> leg = this->Leg(from, to);
    if (leg.empty())
      leg = this->Leg(InTheAir({from.point.x(), from.point.y(), from.point.z()}), to);
    this->Legs.push_back(std::move(leg));
  }
  this->Draw();
}

auto vtkFaceToBoneCurveRepresentation::Leg(const f2b::SurfacePlace& from,
                                           const f2b::SurfacePlace& to) const -> std::vector<Point>
{
  if (!this->Bone || IsInTheAir(from) || IsInTheAir(to))
    return {{from.point.x(), from.point.y(), from.point.z()},
            {to.point.x(), to.point.y(), to.point.z()}};
  std::vector<Point> points;
  for (const f2b::Vec3& p : f2b::surface_path(this->Bone->mesh, this->Bone->links, this->Bone->tree,
                                              from, to, SpacingMm))
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

auto vtkFaceToBoneCurveRepresentation::GetCurve() const -> std::vector<Point>
{
  std::vector<Point> curve;
  for (const auto& leg : this->Legs)
    curve.insert(curve.end(), leg.begin(), leg.end() - 1);
  if (!this->Closed && !this->Places.empty())
    curve.push_back(this->GetControlPoint(this->GetNumberOfControlPoints() - 1));
  return curve;
}

double vtkFaceToBoneCurveRepresentation::GetLength() const
{
  double length = 0;
  for (const auto& leg : this->Legs)
    for (std::size_t i = 1; i < leg.size(); ++i)
      length += (f2b::Vec3(leg[i].data()) - f2b::Vec3(leg[i - 1].data())).norm();
  return length;
}

bool vtkFaceToBoneCurveRepresentation::AddControlPoint(const f2b::SurfacePlace& place)
{
  if (this->Closed)
    return false;
  if (!this->Places.empty())
  {
    std::vector<Point> leg = this->Leg(this->Places.back(), place);
    if (leg.empty())
      return false;
    this->Legs.push_back(std::move(leg));
  }
  this->Places.push_back(place);
  this->Draw();
  return true;
}

bool vtkFaceToBoneCurveRepresentation::MoveControlPoint(int index, const f2b::SurfacePlace& place)
{
  const auto i = static_cast<std::size_t>(index), count = this->Places.size();
  const bool has_before = i > 0 || this->Closed, has_after = i + 1 < count || this->Closed;
  std::vector<Point> before, after;
  if (has_before)
    before = this->Leg(this->Places[(i + count - 1) % count], place);
  if (has_after)
    after = this->Leg(place, this->Places[(i + 1) % count]);
  if ((has_before && before.empty()) || (has_after && after.empty()))
    return false;
  this->Places[i] = place;
  if (has_before)
    this->Legs[(i + count - 1) % count] = std::move(before);
  if (has_after)
    this->Legs[i] = std::move(after);
  this->Draw();
  return true;
}

void vtkFaceToBoneCurveRepresentation::RemoveLastControlPoint()
{
  this->Open();
  if (!this->Legs.empty())
    this->Legs.pop_back();
  if (!this->Places.empty())
    this->Places.pop_back();
  this->Highlighted = None;
  this->Draw();
}

bool vtkFaceToBoneCurveRepresentation::Close()
{
  if (this->Closed || this->Places.size() < 3)
    return false;
  std::vector<Point> leg = this->Leg(this->Places.back(), this->Places.front());
  if (leg.empty())
    return false;
  this->Legs.push_back(std::move(leg));
  this->Closed = true;
  this->Draw();
  return true;
}

void vtkFaceToBoneCurveRepresentation::Open()
{
  if (!this->Closed)
    return;
  this->Legs.pop_back();
  this->Closed = false;
  this->Draw();
}

void vtkFaceToBoneCurveRepresentation::Clear()
{
  this->Places.clear();
  this->Legs.clear();
  this->Closed = false;
  this->Highlighted = None;
  this->Draw();
}

void vtkFaceToBoneCurveRepresentation::Shift(const Point& by)
{
  std::vector<Point> points = this->GetControlPoints();
  for (Point& p : points)
    for (std::size_t k = 0; k < 3; ++k)
      p[k] += by[k];
  this->SetControlPoints(points, this->Closed);
}

auto vtkFaceToBoneCurveRepresentation::Remember() const -> std::shared_ptr<const State>
{
  return std::make_shared<const State>(State{this->Places, this->Legs, this->Closed});
}

void vtkFaceToBoneCurveRepresentation::GoBack(const State& state)
{
  this->Places = state.places;
  this->Legs = state.legs;
  this->Closed = state.closed;
  this->Highlighted = None;
  this->Draw();
}

void vtkFaceToBoneCurveRepresentation::Draw()
{
  SetPolyline(this->Line, this->GetCurve(), this->Closed);
  std::vector<Point> points, chosen;
  for (int i = 0; this->HandlesShown && i < this->GetNumberOfControlPoints(); ++i)
    (i == this->Highlighted ? chosen : points).push_back(this->GetControlPoint(i));
  SetPoints(this->Points, points);
  SetPoints(this->Chosen, chosen);
  this->Modified();
}

/// Points behind the bone cannot be seen, and not be taken hold of.
int vtkFaceToBoneCurveRepresentation::ControlPointAt(double x, double y)
{
  constexpr double behind_mm = 3;
  int found = None;
  double nearest = nearPixels;
  for (int i = 0; this->HandlesShown && i < this->GetNumberOfControlPoints(); ++i)
  {
    const Point world = this->GetControlPoint(i), p = this->ToDisplay(world);
    const double away = std::hypot(p[0] - x, p[1] - y);
    if (away >= nearest)
      continue;
    if (this->Bone && !this->Free)
    {
      const Ray ray = this->GetRay(p[0], p[1]);
      const f2b::Vec3 origin(ray.Origin.data());
      const auto hit = this->Bone->tree.first_hit(origin, f2b::Vec3(ray.Direction.data()));
      if (hit && hit->distance < (f2b::Vec3(world.data()) - origin).norm() - behind_mm)
        continue;
    }
    nearest = away;
    found = i;
  }
  return found;
}

bool vtkFaceToBoneCurveRepresentation::LineAt(double x, double y)
{
  for (const auto& leg : this->Legs)
    for (std::size_t i = 1; i < leg.size(); ++i)
      if (PixelsFromPiece(this->ToDisplay(leg[i - 1]), this->ToDisplay(leg[i]), x, y) < nearPixels)
        return true;
  return false;
}

bool vtkFaceToBoneCurveRepresentation::HighlightOnly(int index)
{
  if (index == this->Highlighted)
    return false;
  this->Highlighted = index;
  this->Draw();
  return true;
}

void vtkFaceToBoneCurveRepresentation::ShowLength(double x, double y)
{
  if (this->Places.size() == 1 && !this->Name.empty())
    return this->SetReadout(this->Name, x, y);
  char text[80];
  std::snprintf(text, sizeof text, "%.1f mm%s", this->GetLength(), this->Closed ? ", closed" : "");
  this->SetReadout(text, x, y);
}

void vtkFaceToBoneCurveRepresentation::ShowName(double x, double y)
{
  this->SetReadout(this->Highlighted == None ? "" : this->Name, x, y);
}

void vtkFaceToBoneCurveRepresentation::ShowRefusal(double x, double y)
{
  this->SetReadout(this->Closed ? "the line is closed: Return takes it"
                                : "another bone: no line leads there from the last point",
                   x, y);
}

auto vtkFaceToBoneCurveRepresentation::GetInwards() const -> Point
{
  f2b::Vec3 sum = f2b::Vec3::Zero();
  for (const f2b::SurfacePlace& place : this->Places)
    if (this->Bone && !IsInTheAir(place))
    {
      const auto& t = this->Bone->mesh.triangles[static_cast<std::size_t>(place.triangle)];
      const auto corner = [&](std::size_t k) -> const f2b::Vec3&
      { return this->Bone->mesh.points[static_cast<std::size_t>(t[k])]; };
      const f2b::Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
      if (normal.norm() > 0)
        sum -= normal.normalized();
    }
  if (sum.norm() < 1e-3)
    return {0, -1, 0};
  sum.normalize();
  return {sum.x(), sum.y(), sum.z()};
}

auto vtkFaceToBoneCurveRepresentation::NearestOnBone(const Point& point) const -> Point
{
  if (!this->Bone)
    return point;
  const f2b::Vec3 p = this->Bone->tree.nearest(f2b::Vec3(point.data())).point;
  return {p.x(), p.y(), p.z()};
}

void vtkFaceToBoneCurveRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ControlPoints: " << this->Places.size() << "\n"
     << indent << "Closed: " << this->Closed << "\n";
}
