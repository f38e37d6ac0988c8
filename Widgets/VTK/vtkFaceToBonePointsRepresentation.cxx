#include "vtkFaceToBonePointsRepresentation.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkCellPicker.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

vtkStandardNewMacro(vtkFaceToBonePointsRepresentation);

namespace
{

void SetBalls(vtkPolyData* data, const std::vector<std::array<double, 3>>& points)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> cells;
  for (const auto& p : points)
  {
    cells->InsertNextCell(1);
    cells->InsertCellPoint(places->InsertNextPoint(p.data()));
  }
  data->Initialize();
  data->SetPoints(places);
  data->SetVerts(cells);
}

} // namespace

vtkFaceToBonePointsRepresentation::vtkFaceToBonePointsRepresentation()
    : Balls(vtkSmartPointer<vtkPolyData>::New()), Held(vtkSmartPointer<vtkPolyData>::New()),
      Line(vtkSmartPointer<vtkPolyData>::New()), Picker(vtkSmartPointer<vtkCellPicker>::New())
{
  this->LineActor = this->AddActor(this->Line, {0.45, 0.1, 0.5}, 2.5);
  this->BallActor = this->AddActor(this->Balls, {0.45, 0.1, 0.5});
  this->HeldActor = this->AddActor(this->Held, {0.95, 0.55, 0.1});
  this->BallActor->GetProperty()->SetPointSize(10);
  this->HeldActor->GetProperty()->SetPointSize(15);
  for (vtkActor* actor : {this->LineActor, this->BallActor, this->HeldActor})
  {
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->RenderPointsAsSpheresOn();
  }
  this->Picker->SetTolerance(0);
  this->Picker->PickFromListOn();
}

vtkFaceToBonePointsRepresentation::~vtkFaceToBonePointsRepresentation() = default;

void vtkFaceToBonePointsRepresentation::SetPoints(const std::vector<Point>& points,
                                                  const std::vector<std::string>& names)
{
  this->Points = points;
  this->Names = names;
  if (this->Highlighted >= static_cast<int>(points.size()))
    this->Highlighted = None;
  this->Draw();
}

void vtkFaceToBonePointsRepresentation::SetPoint(int index, const Point& point)
{
  this->Points.at(static_cast<std::size_t>(index)) = point;
  this->Draw();
}

void vtkFaceToBonePointsRepresentation::SetRuler(bool ruler)
{
  this->Ruler = ruler;
  this->Draw();
}

void vtkFaceToBonePointsRepresentation::SetColour(const Point& rgb)
{
  for (vtkActor* actor : {this->LineActor, this->BallActor})
    actor->GetProperty()->SetColor(rgb[0], rgb[1], rgb[2]);
}

void vtkFaceToBonePointsRepresentation::Highlight(int index)
{
  if (this->Highlighted == index)
    return;
  this->Highlighted = index;
  this->Draw();
}

std::string vtkFaceToBonePointsRepresentation::Measured(const std::vector<Point>& points)
{
  char text[32] = "";
  if (points.size() == 2)
    std::snprintf(text, sizeof text, "%.1f mm",
                  std::sqrt(vtkMath::Distance2BetweenPoints(points[0].data(), points[1].data())));
  if (points.size() == 3)
  {
    Point a{}, b{};
    vtkMath::Subtract(points[0].data(), points[1].data(), a.data());
    vtkMath::Subtract(points[2].data(), points[1].data(), b.data());
    std::snprintf(text, sizeof text, "%.1f deg",
                  vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(a.data(), b.data())));
  }
  return text;
}

vtkSmartPointer<vtkTextActor>
vtkFaceToBonePointsRepresentation::Label(const std::string& text) const
{
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput(text.c_str());
  vtkTextProperty* look = label->GetTextProperty();
  look->SetFontSize(14);
  look->SetColor(1, 1, 1);
  look->SetBackgroundColor(0.1, 0.12, 0.15);
  look->SetBackgroundOpacity(0.7);
  return label;
}

void vtkFaceToBonePointsRepresentation::Draw()
{
  std::vector<Point> held;
  if (this->Highlighted != None)
    held.push_back(this->Points.at(static_cast<std::size_t>(this->Highlighted)));
  SetBalls(this->Balls, this->Points);
  SetBalls(this->Held, held);
  SetPolyline(this->Line, this->Ruler ? this->Points : std::vector<Point>{}, false);
  this->Labels.clear();
  this->LabelPlaces.clear();
  for (std::size_t k = 0; k < this->Points.size() && k < this->Names.size(); ++k)
  {
    this->Labels.push_back(this->Label(this->Names[k]));
    this->LabelPlaces.push_back(this->Points[k]);
  }
  if (const std::string value = Measured(this->Points); this->Ruler && !value.empty())
  {
    const Point &a = this->Points[0], &b = this->Points[1];
    const bool angle = this->Points.size() == 3;
    this->Labels.push_back(this->Label(value));
    this->LabelPlaces.push_back(
        angle ? b : Point{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])});
  }
  this->Modified();
}

int vtkFaceToBonePointsRepresentation::PointAt(double x, double y)
{
  constexpr double reach = 10, behind = 8; // pixels; of two at one place the one in front counts
  int found = None;
  double nearest = reach + behind;
  for (std::size_t k = 0; k < this->Points.size(); ++k)
  {
    const Point at = this->ToDisplay(this->Points[k]);
    const double away = std::hypot(at[0] - x, at[1] - y);
    if (away < reach && away + behind * at[2] < nearest)
    {
      nearest = away + behind * at[2];
      found = static_cast<int>(k);
    }
  }
  return found;
}

auto vtkFaceToBonePointsRepresentation::SurfaceAt(double x, double y) -> std::optional<Point>
{
  this->Picker->InitializePickList();
  vtkActorCollection* actors = this->Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
    if (actor->GetVisibility() && actor->GetPickable() && actor->GetProperty()->GetOpacity() >= 0.5)
      this->Picker->AddPickList(actor);
  if (!this->Picker->Pick(x, y, 0, this->Renderer) || this->Picker->GetCellId() < 0)
    return {};
  Point place{};
  this->Picker->GetPickPosition(place.data());
  return place;
}

/// Labels stand beside their points in the picture, wherever the camera is; one that would lie on
/// another is left out: of those behind first, of the highlighted point last.
void vtkFaceToBonePointsRepresentation::BuildRepresentation()
{
  if (!this->Renderer)
    return;
  std::vector<std::size_t> order(this->Labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> depth;
  for (const Point& place : this->LabelPlaces)
    depth.push_back(this->ToDisplay(place)[2]);
  if (this->Highlighted >= 0 && static_cast<std::size_t>(this->Highlighted) < depth.size())
    depth[static_cast<std::size_t>(this->Highlighted)] = -1;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  const int* corner = this->Renderer->GetOrigin();
  std::vector<std::array<double, 4>> taken; // left, right, bottom, top
  for (const std::size_t k : order)
  {
    const Point at = this->ToDisplay(this->LabelPlaces[k]);
    double size[2] = {0, 0};
    this->Labels[k]->GetSize(this->Renderer, size);
    const double left = at[0] - corner[0] + 9, bottom = at[1] - corner[1] + 6;
    const std::array<double, 4> box{left, left + size[0], bottom, bottom + size[1]};
    const bool free =
        std::none_of(taken.begin(), taken.end(),
                     [&](const auto& t)
                     { return box[0] < t[1] && t[0] < box[1] && box[2] < t[3] && t[2] < box[3]; });
    this->Labels[k]->SetPosition(left, bottom);
    this->Labels[k]->SetVisibility(free);
    if (free)
      taken.push_back(box);
  }
}

void vtkFaceToBonePointsRepresentation::GetActors2D(vtkPropCollection* props)
{
  this->Superclass::GetActors2D(props);
  for (vtkTextActor* label : this->Labels)
    props->AddItem(label);
}

void vtkFaceToBonePointsRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (vtkTextActor* label : this->Labels)
    label->ReleaseGraphicsResources(window);
}

int vtkFaceToBonePointsRepresentation::RenderOverlay(vtkViewport* viewport)
{
  int drawn = this->Superclass::RenderOverlay(viewport);
  for (vtkTextActor* label : this->Labels)
    if (label->GetVisibility())
      drawn += label->RenderOverlay(viewport);
  return drawn;
}

int vtkFaceToBonePointsRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  int drawn = this->Superclass::RenderOpaqueGeometry(viewport);
  for (vtkTextActor* label : this->Labels)
    if (label->GetVisibility())
      drawn += label->RenderOpaqueGeometry(viewport);
  return drawn;
}

void vtkFaceToBonePointsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points: " << this->Points.size() << "\n";
}
