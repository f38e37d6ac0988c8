#include "vtkFaceToBoneSculptRepresentation.h"

#include <Core/sculpting/sculpting_session.hpp>

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cstdio>

vtkStandardNewMacro(vtkFaceToBoneSculptRepresentation);

namespace
{

f2b::Vec3 ToVector(const std::array<double, 3>& p)
{
  return {p[0], p[1], p[2]};
}

/// A point array of a surface, made where it is absent.
vtkDataArray* ArrayOf(vtkPolyData* surface, const char* name, int components)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == count)
    return array;
  vtkNew<vtkDoubleArray> made;
  made->SetName(name);
  made->SetNumberOfComponents(components);
  made->SetNumberOfTuples(count);
  surface->GetPointData()->AddArray(made);
  return surface->GetPointData()->GetArray(name);
}

/// Gives an array all its values anew, as fast as its type allows: hosts may bring any.
void Fill(vtkDataArray* array, const double* values)
{
  const vtkIdType count = array->GetNumberOfValues();
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
    std::copy_n(values, count, doubles->GetPointer(0));
  else if (auto* floats = vtkFloatArray::FastDownCast(array))
    std::transform(values, values + count, floats->GetPointer(0),
                   [](double value) { return static_cast<float>(value); });
  else
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
      array->SetTuple(k, values + k * array->GetNumberOfComponents());
  array->Modified();
}

void SetNormals(vtkPolyData* surface, const std::vector<f2b::Vec3>& normals)
{
  vtkNew<vtkFloatArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(normals.size()));
  float* to = array->GetPointer(0);
  for (const f2b::Vec3& normal : normals)
    for (int k = 0; k < 3; ++k)
      *to++ = static_cast<float>(normal[k]);
  surface->GetPointData()->SetNormals(array);
}

} // namespace

vtkFaceToBoneSculptRepresentation::vtkFaceToBoneSculptRepresentation()
    : Circle(vtkSmartPointer<vtkPolyData>::New()), MirrorCircle(vtkSmartPointer<vtkPolyData>::New())
{
  this->CircleActor = this->AddActor(this->Circle, {0.05, 0.25, 0.65}, 2.5);
  this->MirrorActor = this->AddActor(this->MirrorCircle, {0.35, 0.5, 0.75}, 1.5);
  for (vtkActor* actor : {this->CircleActor, this->MirrorActor})
    actor->GetProperty()->LightingOff();
  this->HideBrush();
}

vtkFaceToBoneSculptRepresentation::~vtkFaceToBoneSculptRepresentation() = default;

void vtkFaceToBoneSculptRepresentation::SetSession(std::shared_ptr<f2b::SculptingSession> session,
                                                   vtkPolyData* shown)
{
  this->Session = std::move(session);
  this->Shown = shown;
  this->HideBrush();
  this->ShownRevision = -1;
  this->UpdateShown();
  this->Modified();
}

void vtkFaceToBoneSculptRepresentation::UpdateShown()
{
  if (!this->Session || !this->Shown || this->ShownRevision == this->Session->revision())
    return;
  this->ShownRevision = this->Session->revision();
  const f2b::SculptedSkin& skin = this->Session->skin();
  if (static_cast<std::size_t>(this->Shown->GetNumberOfPoints()) != skin.size())
  {
    vtkErrorMacro("the shown surface is not the session's");
    return;
  }
  std::vector<double> length(skin.size());
  for (std::size_t v = 0; v < skin.size(); ++v)
    length[v] = skin.displacement()[v].dot(skin.normals()[v]);
  vtkPoints* points = this->Shown->GetPoints();
  Fill(points->GetData(), skin.points().front().data());
  Fill(ArrayOf(this->Shown, DisplacementArray, 3), skin.displacement().front().data());
  Fill(ArrayOf(this->Shown, LengthArray, 1), length.data());
  Fill(ArrayOf(this->Shown, MaskArray, 1), skin.mask().data());
  SetNormals(this->Shown, skin.normals());
  points->Modified();
  this->Shown->Modified();
}

std::optional<f2b::SurfacePlace> vtkFaceToBoneSculptRepresentation::PlaceAt(double x, double y)
{
  if (!this->Session || !this->Renderer)
    return {};
  const Ray ray = this->GetRay(x, y);
  return this->Session->skin().tree().first_hit(ToVector(ray.Origin), ToVector(ray.Direction));
}

/// The tangent circle, each of its points moved to the nearest skin.
void vtkFaceToBoneSculptRepresentation::DrawCircle(vtkPolyData* data,
                                                   const f2b::SurfacePlace& place, double radius)
{
  constexpr int pieces = 64;
  constexpr double liftMm = 0.3;
  const f2b::SculptedSkin& skin = this->Session->skin();
  f2b::Vec3 normal = f2b::Vec3::Zero();
  const f2b::Triangle& t = skin.triangles()[static_cast<std::size_t>(place.triangle)];
  for (int k = 0; k < 3; ++k)
    normal +=
        place.weights[k] * skin.normals()[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
  const f2b::Vec3 u = normal.unitOrthogonal();
  const f2b::Vec3 v = normal.cross(u).normalized();
  std::vector<Point> points;
  for (int k = 0; k < pieces; ++k)
  {
    const double angle = 2 * 3.14159265358979323846 * k / pieces;
    const f2b::Vec3 around = place.point + radius * (std::cos(angle) * u + std::sin(angle) * v);
    const f2b::Vec3 p = skin.tree().nearest(around).point + liftMm * normal;
    points.push_back({p.x(), p.y(), p.z()});
  }
  SetPolyline(data, points, true);
}

void vtkFaceToBoneSculptRepresentation::ShowAt(const f2b::Brush& brush,
                                               const f2b::SurfacePlace& place, double x, double y)
{
  this->DrawCircle(this->Circle, place, brush.radius_mm);
  this->CircleActor->VisibilityOn();
  this->MirrorActor->SetVisibility(brush.symmetry.has_value());
  const f2b::SculptedSkin& skin = this->Session->skin();
  if (brush.symmetry)
    this->DrawCircle(this->MirrorCircle, skin.tree().nearest(brush.symmetry->mirrored(place.point)),
                     brush.radius_mm);
  const f2b::Vec3 moved = skin.displacement_at(place);
  char text[160];
  std::snprintf(text, sizeof text, "%.1f mm   (R %+.1f  A %+.1f  S %+.1f)\nradius %.0f mm, %.0f %%",
                moved.norm(), moved.x(), moved.y(), moved.z(), brush.radius_mm,
                100 * brush.strength);
  this->SetReadout(text, x, y);
}

void vtkFaceToBoneSculptRepresentation::ShowBrush(const f2b::Brush& brush, double x, double y)
{
  if (const auto place = this->PlaceAt(x, y))
    this->ShowAt(brush, *place, x, y);
  else
    this->HideBrush();
}

void vtkFaceToBoneSculptRepresentation::ShowHeldBrush(const f2b::Brush& brush, const Point& place,
                                                      double x, double y)
{
  if (this->Session)
    this->ShowAt(brush, this->Session->skin().tree().nearest(ToVector(place)), x, y);
}

void vtkFaceToBoneSculptRepresentation::HideBrush()
{
  this->CircleActor->VisibilityOff();
  this->MirrorActor->VisibilityOff();
  this->SetReadout("", 0, 0);
}

bool vtkFaceToBoneSculptRepresentation::IsBrushShown() const
{
  return this->CircleActor->GetVisibility() != 0;
}

void vtkFaceToBoneSculptRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Session: " << (this->Session ? "set" : "none") << "\n";
}
