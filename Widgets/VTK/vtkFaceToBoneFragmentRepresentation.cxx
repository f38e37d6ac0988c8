#include "vtkFaceToBoneFragmentRepresentation.h"

#include <Core/geometry/rigid_motion.hpp>
#include <Core/sculpting/line_of_sight.hpp>

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkFaceToBoneFragmentRepresentation);

namespace
{

using Point = std::array<double, 3>;

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double nearPixels = 9;

Point ToPoint(const f2b::Vec3& v)
{
  return {v.x(), v.y(), v.z()};
}

f2b::Vec3 ToVector(const Point& p)
{
  return {p[0], p[1], p[2]};
}

} // namespace

vtkFaceToBoneFragmentRepresentation::vtkFaceToBoneFragmentRepresentation()
{
  static const Point colours[] = {{0.80, 0.18, 0.15}, {0.10, 0.55, 0.20}, {0.12, 0.30, 0.80}};
  for (std::size_t k = 0; k < 6; ++k)
  {
    this->Lines[k] = vtkSmartPointer<vtkPolyData>::New();
    this->LineActors[k] = this->AddActor(this->Lines[k], colours[k % 3], k < 3 ? 5 : 3);
    this->LineActors[k]->GetProperty()->LightingOff();
  }
  this->Draw();
}

vtkFaceToBoneFragmentRepresentation::~vtkFaceToBoneFragmentRepresentation() = default;

void vtkFaceToBoneFragmentRepresentation::SetReferencePoint(const Point& point)
{
  this->ReferencePoint = point;
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneFragmentRepresentation::SetMovement(const Coordinates& movement)
{
  this->Movement = movement;
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneFragmentRepresentation::SetLocked(int coordinate, bool locked)
{
  this->Locked[Index(coordinate)] = locked;
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneFragmentRepresentation::SetLimits(int coordinate, double least, double most)
{
  this->Limits[Index(coordinate)] = {least, most};
}

double vtkFaceToBoneFragmentRepresentation::Within(int coordinate, double value) const
{
  const auto& [least, most] = this->Limits[Index(coordinate)];
  return std::max(least, std::min(most, value));
}

auto vtkFaceToBoneFragmentRepresentation::MovedPoint() const -> Point
{
  Point moved = this->ReferencePoint;
  for (std::size_t k = 0; k < 3; ++k)
    moved[k] += this->Movement[k];
  return moved;
}

/// Of a rotation: the axis that its angle turns about while the two outer ones stay.
auto vtkFaceToBoneFragmentRepresentation::Axis(int coordinate) const -> Point
{
  const double roll = degree * this->Movement[4], yaw = degree * this->Movement[5];
  switch (coordinate)
  {
  case 3:
    return ToPoint(f2b::rotation_from({0, roll, yaw}) * f2b::Vec3::UnitX());
  case 4:
    return ToPoint(f2b::rotation_from({0, 0, yaw}) * f2b::Vec3::UnitY());
  case 5:
    return {0, 0, 1};
  default:
  {
    Point axis{};
    axis[Index(coordinate)] = 1;
    return axis;
  }
  }
}

/// An arrow with its two barbs, or a ring.
auto vtkFaceToBoneFragmentRepresentation::Line(int coordinate) const -> std::vector<Point>
{
  const f2b::Vec3 centre = ToVector(this->MovedPoint()), axis = ToVector(this->Axis(coordinate));
  const f2b::Vec3 u = f2b::Vec3(axis.unitOrthogonal()), v = axis.cross(u);
  if (coordinate < 3)
  {
    const f2b::Vec3 tip = centre + this->Size * axis;
    const f2b::Vec3 back = tip - 0.15 * this->Size * axis;
    return {ToPoint(centre), ToPoint(tip), ToPoint(back + 0.06 * this->Size * u), ToPoint(tip),
            ToPoint(back - 0.06 * this->Size * u)};
  }
  std::vector<Point> ring;
  constexpr int pieces = 72;
  for (int k = 0; k <= pieces; ++k)
  {
    const double angle = 360 * degree * k / pieces;
    ring.push_back(
        ToPoint(centre + 0.8 * this->Size * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  return ring;
}

auto vtkFaceToBoneFragmentRepresentation::GripPosition(int coordinate) const -> Point
{
  // an eighth round, so that no two rings are held where they cross
  return this->Line(coordinate)[coordinate < 3 ? 1 : 9];
}

void vtkFaceToBoneFragmentRepresentation::Draw()
{
  for (int k = 0; k < 6; ++k)
  {
    const std::size_t i = Index(k);
    SetPolyline(this->Lines[i], this->Line(k), false);
    this->LineActors[i]->SetVisibility(!this->Locked[i]);
    const float width = i < 3 ? 5.f : 3.f;
    this->LineActors[i]->GetProperty()->SetLineWidth(this->Highlighted == k ? 2 * width : width);
  }
}

f2b::LineOfSight vtkFaceToBoneFragmentRepresentation::LineAt(double x, double y)
{
  const Ray ray = this->GetRay(x, y);
  return {ToVector(ray.Origin), ToVector(ray.Direction)};
}

int vtkFaceToBoneFragmentRepresentation::CoordinateAt(double x, double y)
{
  int found = None;
  double nearest = nearPixels;
  for (int k = 0; k < 6; ++k)
  {
    if (this->Locked[Index(k)])
      continue;
    const std::vector<Point> line = this->Line(k);
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      const double away =
          PixelsFromPiece(this->ToDisplay(line[i - 1]), this->ToDisplay(line[i]), x, y);
      if (away < nearest)
      {
        nearest = away;
        found = k;
      }
    }
  }
  return found;
}

bool vtkFaceToBoneFragmentRepresentation::HighlightOnly(int coordinate)
{
  if (coordinate == this->Highlighted)
    return false;
  this->Highlighted = coordinate;
  this->Draw();
  return true;
}

void vtkFaceToBoneFragmentRepresentation::ShowMovement(double x, double y)
{
  const Coordinates& m = this->Movement;
  char text[160];
  std::snprintf(text, sizeof text,
                "R %+.1f  A %+.1f  S %+.1f mm\npitch %+.1f  roll %+.1f  yaw %+.1f deg", m[0], m[1],
                m[2], m[3], m[4], m[5]);
  this->SetReadout(text, x, y);
}

void vtkFaceToBoneFragmentRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Movement:";
  for (const double value : this->Movement)
    os << " " << value;
  os << "\n";
}
