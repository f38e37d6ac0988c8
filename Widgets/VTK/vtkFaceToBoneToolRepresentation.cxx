#include "vtkFaceToBoneToolRepresentation.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double InFrontMm = 1000;

} // namespace

vtkFaceToBoneToolRepresentation::vtkFaceToBoneToolRepresentation()
    : Readout(vtkSmartPointer<vtkTextActor>::New())
{
  this->PickableOff();
  vtkTextProperty* text = this->Readout->GetTextProperty();
  text->SetFontSize(15);
  text->SetColor(1, 1, 1);
  text->SetBackgroundColor(0.1, 0.12, 0.15);
  text->SetBackgroundOpacity(0.75);
  this->Readout->VisibilityOff();
}

vtkFaceToBoneToolRepresentation::~vtkFaceToBoneToolRepresentation() = default;

vtkActor* vtkFaceToBoneToolRepresentation::AddActor(vtkPolyData* shown, const Point& colour,
                                                    double lineWidth)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shown);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -66000);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-66000);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
  this->Actors.push_back(actor);
  return actor;
}

void vtkFaceToBoneToolRepresentation::SetPolyline(vtkPolyData* data,
                                                  const std::vector<Point>& points, bool closed)
{
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> lines;
  for (const Point& p : points)
    corners->InsertNextPoint(p.data());
  if (points.size() > 1)
  {
    lines->InsertNextCell(static_cast<int>(points.size() + (closed ? 1 : 0)));
    for (std::size_t i = 0; i < points.size(); ++i)
      lines->InsertCellPoint(static_cast<vtkIdType>(i));
    if (closed)
      lines->InsertCellPoint(0);
  }
  data->Initialize();
  data->SetPoints(corners);
  data->SetLines(lines);
}

void vtkFaceToBoneToolRepresentation::SetPoints(vtkPolyData* data, const std::vector<Point>& at)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (const Point& p : at)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  data->Initialize();
  data->SetPoints(points);
  data->SetVerts(vertices);
}

double vtkFaceToBoneToolRepresentation::PixelsFromPiece(const Point& a, const Point& b, double x,
                                                        double y)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double squared = dx * dx + dy * dy;
  double t = squared > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / squared : 0;
  t = std::min(1.0, std::max(0.0, t));
  return std::hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}

vtkActor* vtkFaceToBoneToolRepresentation::MakeBalls(vtkPolyData* balls, vtkPolyData* chosen)
{
  vtkActor* actor = this->AddActor(balls, {0.1, 0.1, 0.12});
  vtkProperty* ball = actor->GetProperty();
  vtkProperty* other = this->AddActor(chosen, {1, 0.75, 0.1})->GetProperty();
  for (vtkProperty* look : {ball, other})
  {
    look->SetPointSize(look == ball ? 11.f : 15.f);
    look->RenderPointsAsSpheresOn();
    look->SetAmbient(0.4);
  }
  return actor;
}

auto vtkFaceToBoneToolRepresentation::GetRay(double x, double y) -> Ray
{
  Point ends[2];
  for (int k = 0; k < 2; ++k)
  {
    this->Renderer->SetDisplayPoint(x, y, k);
    this->Renderer->DisplayToWorld();
    const double* p = this->Renderer->GetWorldPoint();
    for (std::size_t i = 0; i < 3; ++i)
      ends[k][i] = p[i] / p[3];
  }
  Ray ray{ends[0], {}};
  vtkMath::Subtract(ends[1].data(), ends[0].data(), ray.Direction.data());
  vtkMath::Normalize(ray.Direction.data());
  if (this->Renderer->GetActiveCamera()->GetParallelProjection())
    for (std::size_t i = 0; i < 3; ++i) // tools may lie in front of all that is drawn
      ray.Origin[i] -= InFrontMm * ray.Direction[i];
  return ray;
}

auto vtkFaceToBoneToolRepresentation::ToDisplay(const Point& world) -> Point
{
  this->Renderer->SetWorldPoint(world[0], world[1], world[2], 1);
  this->Renderer->WorldToDisplay();
  const double* p = this->Renderer->GetDisplayPoint();
  return {p[0], p[1], p[2]};
}

auto vtkFaceToBoneToolRepresentation::WorldAtDepthOf(const Point& world, double x, double y)
    -> Point
{
  this->Renderer->SetDisplayPoint(x, y, this->ToDisplay(world)[2]);
  this->Renderer->DisplayToWorld();
  const double* p = this->Renderer->GetWorldPoint();
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

double vtkFaceToBoneToolRepresentation::MillimetresPerPixel(const Point& world)
{
  const Point at = this->ToDisplay(world);
  const Point beside = this->WorldAtDepthOf(world, at[0] + 1, at[1]);
  return std::sqrt(vtkMath::Distance2BetweenPoints(world.data(), beside.data()));
}

void vtkFaceToBoneToolRepresentation::SetReadout(const std::string& text, double x, double y)
{
  this->Readout->SetVisibility(!text.empty());
  this->Readout->SetInput(text.c_str());
  if (text.empty() || !this->Renderer)
    return;
  // beside the cursor, on its other side where the window ends
  double size[2] = {0, 0};
  this->Readout->GetSize(this->Renderer, size);
  const int* window = this->Renderer->GetSize();
  const double right = x + 18 + size[0] > window[0] ? x - 18 - size[0] : x + 18;
  const double up = y + 14 + size[1] > window[1] ? y - 14 - size[1] : y + 14;
  this->Readout->SetPosition(std::max(0.0, right), std::max(0.0, up));
}

std::string vtkFaceToBoneToolRepresentation::GetReadout() const
{
  return this->Readout->GetVisibility() ? this->Readout->GetInput() : "";
}

void vtkFaceToBoneToolRepresentation::GetActors(vtkPropCollection* props)
{
  for (vtkActor* actor : this->Actors)
    props->AddItem(actor);
}

void vtkFaceToBoneToolRepresentation::GetActors2D(vtkPropCollection* props)
{
  props->AddItem(this->Readout);
}

void vtkFaceToBoneToolRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkActor* actor : this->Actors)
    actor->ReleaseGraphicsResources(window);
  this->Readout->ReleaseGraphicsResources(window);
}

int vtkFaceToBoneToolRepresentation::RenderOverlay(vtkViewport* viewport)
{
  return this->Readout->GetVisibility() ? this->Readout->RenderOverlay(viewport) : 0;
}

int vtkFaceToBoneToolRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->BuildRepresentation();
  int drawn = 0;
  for (vtkActor* actor : this->Actors)
    if (actor->GetVisibility())
    {
      actor->SetPropertyKeys(this->GetPropertyKeys());
      drawn += actor->RenderOpaqueGeometry(viewport);
    }
  if (this->Readout->GetVisibility())
    drawn += this->Readout->RenderOpaqueGeometry(viewport);
  return drawn;
}

int vtkFaceToBoneToolRepresentation::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  int drawn = 0;
  for (vtkActor* actor : this->Actors)
    if (actor->GetVisibility())
    {
      actor->SetPropertyKeys(this->GetPropertyKeys()); // tell it that layers are peeled
      drawn += actor->RenderTranslucentPolygonalGeometry(viewport);
    }
  return drawn;
}

vtkTypeBool vtkFaceToBoneToolRepresentation::HasTranslucentPolygonalGeometry()
{
  for (vtkActor* actor : this->Actors)
    if (actor->GetVisibility() && actor->HasTranslucentPolygonalGeometry())
      return 1;
  return 0;
}

void vtkFaceToBoneToolRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actors: " << this->Actors.size() << "\n";
}
