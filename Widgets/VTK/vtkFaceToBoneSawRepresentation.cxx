#include "vtkFaceToBoneSawRepresentation.h"

#include <Core/sculpting/line_of_sight.hpp>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <cmath>
#include <cstdio>

vtkStandardNewMacro(vtkFaceToBoneSawRepresentation);

namespace
{

using Point = std::array<double, 3>;

constexpr double nearPixels = 11;

Point Along(const Point& from, const Point& direction, double mm)
{
  return {from[0] + mm * direction[0], from[1] + mm * direction[1], from[2] + mm * direction[2]};
}

} // namespace

vtkFaceToBoneSawRepresentation::vtkFaceToBoneSawRepresentation()
    : Strip(vtkSmartPointer<vtkPolyData>::New()), Arrow(vtkSmartPointer<vtkPolyData>::New()),
      Balls(vtkSmartPointer<vtkPolyData>::New()), Chosen(vtkSmartPointer<vtkPolyData>::New())
{
  this->StripActor = this->AddActor(this->Strip, {0.72, 0.05, 0.27});
  this->StripActor->GetProperty()->SetOpacity(0.3);
  this->AddActor(this->Arrow, {0.1, 0.1, 0.12}, 2.5)->GetProperty()->LightingOff();
  this->MakeBalls(this->Balls, this->Chosen);
}

vtkFaceToBoneSawRepresentation::~vtkFaceToBoneSawRepresentation() = default;

void vtkFaceToBoneSawRepresentation::SetLine(const std::vector<Point>& points, bool closed)
{
  this->Points = points;
  this->Closed = closed;
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneSawRepresentation::SetDirection(const Point& direction)
{
  this->Direction = direction;
  vtkMath::Normalize(this->Direction.data());
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneSawRepresentation::SetReach(double leadMm, double depthMm)
{
  this->LeadMm = leadMm;
  this->DepthMm = depthMm;
  this->Draw();
  this->Modified();
}

void vtkFaceToBoneSawRepresentation::SetColour(const Point& colour)
{
  this->StripActor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void vtkFaceToBoneSawRepresentation::SetHandlesShown(bool shown)
{
  this->HandlesShown = shown;
  this->Highlighted = None;
  this->StripActor->GetProperty()->SetOpacity(shown ? 0.3 : 0.15);
  this->Draw();
}

auto vtkFaceToBoneSawRepresentation::GetMiddle() const -> Point
{
  double whole = 0;
  for (std::size_t i = 1; i < this->Points.size(); ++i)
    whole += std::sqrt(
        vtkMath::Distance2BetweenPoints(this->Points[i - 1].data(), this->Points[i].data()));
  double left = 0.5 * whole;
  for (std::size_t i = 1; i < this->Points.size(); ++i)
  {
    const Point &a = this->Points[i - 1], &b = this->Points[i];
    const double piece = std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
    if (piece >= left && piece > 0)
    {
      const double t = left / piece;
      return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
    }
    left -= piece;
  }
  return this->Points.empty() ? Point{} : this->Points.back();
}

auto vtkFaceToBoneSawRepresentation::HandlePosition(Handle handle) const -> Point
{
  const Point middle = this->GetMiddle();
  return handle == Depth ? Along(middle, this->Direction, this->DepthMm)
                         : Along(middle, this->Direction, -HandAwayMm);
}

void vtkFaceToBoneSawRepresentation::Draw()
{
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> quads;
  const auto count = static_cast<vtkIdType>(this->Points.size());
  for (const Point& p : this->Points)
  {
    corners->InsertNextPoint(Along(p, this->Direction, -this->LeadMm).data());
    corners->InsertNextPoint(Along(p, this->Direction, this->DepthMm).data());
  }
  for (vtkIdType i = 0; i + (this->Closed ? 0 : 1) < count; ++i)
  {
    const vtkIdType next = (i + 1) % count;
    const vtkIdType quad[] = {2 * i, 2 * next, 2 * next + 1, 2 * i + 1};
    quads->InsertNextCell(4, quad);
  }
  this->Strip->Initialize();
  this->Strip->SetPoints(corners);
  this->Strip->SetPolys(quads);
  const bool held = this->HandlesShown && count > 1;
  std::vector<Point> balls, chosen;
  if (held)
    balls = {this->HandlePosition(Hand), this->HandlePosition(Depth)};
  SetPolyline(this->Arrow, balls, false);
  SetPoints(this->Balls, balls);
  if (held && this->Highlighted != None)
    chosen = {this->HandlePosition(this->Highlighted)};
  SetPoints(this->Chosen, chosen);
}

f2b::LineOfSight vtkFaceToBoneSawRepresentation::LineAt(double x, double y)
{
  const Ray ray = this->GetRay(x, y);
  return {f2b::Vec3(ray.Origin.data()), f2b::Vec3(ray.Direction.data())};
}

auto vtkFaceToBoneSawRepresentation::HandleAt(double x, double y) -> Handle
{
  Handle found = None;
  double nearest = nearPixels;
  if (!this->HandlesShown || this->Points.size() < 2)
    return found;
  for (const Handle handle : {Hand, Depth})
  {
    const Point p = this->ToDisplay(this->HandlePosition(handle));
    const double away = std::hypot(p[0] - x, p[1] - y);
    if (away < nearest)
    {
      nearest = away;
      found = handle;
    }
  }
  return found;
}

bool vtkFaceToBoneSawRepresentation::HighlightOnly(Handle handle)
{
  if (handle == this->Highlighted)
    return false;
  this->Highlighted = handle;
  this->Draw();
  return true;
}

void vtkFaceToBoneSawRepresentation::ShowDepth(double x, double y)
{
  char text[80];
  std::snprintf(text, sizeof text, "saw: R %+.2f  A %+.2f  S %+.2f, %.1f mm deep",
                this->Direction[0], this->Direction[1], this->Direction[2], this->DepthMm);
  this->SetReadout(text, x, y);
}

void vtkFaceToBoneSawRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Depth: " << this->DepthMm << " mm\n";
}
