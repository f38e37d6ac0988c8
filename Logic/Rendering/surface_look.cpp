#include <Rendering/surface_look.hpp>

#include <Rendering/map_arrays.hpp>

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkContourFilter.h>
#include <vtkFeatureEdges.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

using Point = std::array<double, 3>;

vtkSmartPointer<vtkActor> add_surface(const Panel& panel, const Surface& surface,
                                      const Colour& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPhong();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetAmbient(0.12);
  property->SetDiffuse(0.89);
  panel.scene->AddActor(actor);
  return actor;
}

// Six times the volume under the faces, about the first vertex: its sign tells the orientation.
double oriented_volume(const Surface& surface)
{
  double volume = 0;
  Point origin{}, a{}, b{}, c{};
  surface->GetPoint(0, origin.data());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k)
    {
      surface->GetPoint(corners->GetId(0), a.data());
      surface->GetPoint(corners->GetId(k - 1), b.data());
      surface->GetPoint(corners->GetId(k), c.data());
      vtkMath::Subtract(a.data(), origin.data(), a.data());
      vtkMath::Subtract(b.data(), origin.data(), b.data());
      vtkMath::Subtract(c.data(), origin.data(), c.data());
      Point normal{};
      vtkMath::Cross(b.data(), c.data(), normal.data());
      volume += vtkMath::Dot(a.data(), normal.data());
    }
  }
  return volume;
}

// \param swell_mm  how much thicker and longer it is on every side
vtkSmartPointer<vtkActor> make_arrow(const Point& from, const Point& direction, double thickness_mm,
                                     double swell_mm)
{
  const double length = vtkMath::Norm(direction.data()) + 2 * swell_mm;
  vtkNew<vtkArrowSource> arrow; // along +x, one unit long: its parts are shares of the length
  arrow->SetShaftResolution(24);
  arrow->SetTipResolution(32);
  arrow->SetShaftRadius((0.5 * thickness_mm + swell_mm) / length);
  arrow->SetTipRadius((1.4 * thickness_mm + 1.5 * swell_mm) / length);
  arrow->SetTipLength(std::min(0.7, (3.4 * thickness_mm + 2 * swell_mm) / length));
  const Point x_axis{1, 0, 0};
  Point turn_axis{};
  vtkMath::Cross(x_axis.data(), direction.data(), turn_axis.data());
  if (vtkMath::Norm(turn_axis.data()) < 1e-9)
  {
    turn_axis = {0, 0, 1};
  }
  vtkNew<vtkTransform> placement;
  placement->Translate(from.data());
  placement->RotateWXYZ(
      vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(x_axis.data(), direction.data())),
      turn_axis.data());
  placement->Translate(-swell_mm, 0, 0);
  placement->Scale(length, length, length);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(arrow->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetUserTransform(placement);
  return actor;
}

// Of a translucent surface only the side towards the viewer is drawn: the far side would blur it.
void make_translucent(vtkActor* actor, const Surface& surface, double opacity)
{
  actor->GetProperty()->SetOpacity(opacity);
  if (oriented_volume(surface) >= 0)
  {
    actor->GetProperty()->BackfaceCullingOn();
  }
  else
  {
    actor->GetProperty()->FrontfaceCullingOn();
  }
}

void make_skin_gloss(vtkActor* actor)
{
  actor->GetProperty()->SetSpecular(0.12);
  actor->GetProperty()->SetSpecularPower(18);
}

vtkPolyDataMapper* colour_by(vtkActor* actor, const std::string& array)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array.c_str());
  return mapper;
}

vtkPolyDataMapper* add_mapped(const Panel& panel, const Surface& surface, const std::string& array,
                              vtkLookupTable* map)
{
  const auto actor = add_surface(panel, surface, {1, 1, 1});
  actor->GetProperty()->SetAmbient(0.32);
  actor->GetProperty()->SetDiffuse(0.62);
  vtkPolyDataMapper* mapper = colour_by(actor, array);
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(map);
  mapper->UseLookupTableScalarRangeOn();
  return mapper;
}

} // namespace

void add_skin(const Panel& panel, const Surface& surface, double opacity)
{
  const auto actor = add_surface(panel, surface, skin_colour);
  make_skin_gloss(actor);
  if (opacity < 1)
  {
    make_translucent(actor, surface, opacity);
  }
}

void add_bone(const Panel& panel, const Surface& surface, const Colour& colour)
{
  const auto actor = add_surface(panel, surface, colour);
  actor->GetProperty()->SetSpecular(0.18);
  actor->GetProperty()->SetSpecularPower(28);
}

void add_ghost(const Panel& panel, const Surface& surface)
{
  add_translucent(panel, surface, ghost_colour, ghost_opacity);
}

void add_translucent(const Panel& panel, const Surface& surface, const Colour& colour,
                     double opacity)
{
  make_translucent(add_surface(panel, surface, colour), surface, opacity);
}

void add_open_translucent(const Panel& panel, const Surface& surface, const Colour& colour,
                          double opacity)
{
  add_surface(panel, surface, colour)->GetProperty()->SetOpacity(opacity);
}

void add_skin_known_by(const Panel& panel, const Surface& surface, const std::string& array)
{
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("look");
  colours->SetNumberOfComponents(3);
  for (const double value : point_values(surface, array))
  {
    const Colour& c = std::isfinite(value) ? skin_colour : no_value_colour;
    colours->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
  }
  auto coloured = Surface::New();
  coloured->ShallowCopy(surface);
  coloured->GetPointData()->AddArray(colours);
  const auto actor = add_surface(panel, coloured, {1, 1, 1});
  make_skin_gloss(actor);
  colour_by(actor, "look")->SetColorModeToDirectScalars();
}

void add_map(const Panel& panel, const Surface& surface, const std::string& array,
             vtkLookupTable* map)
{
  // Values are interpolated, not colours: bands between vertices stay those of the bar.
  add_mapped(panel, surface, array, map)
      ->SetInterpolateScalarsBeforeMapping(!has_unknown_values(surface, array));
}

void add_categories(const Panel& panel, const Surface& surface, const std::string& array,
                    vtkLookupTable* map)
{
  add_mapped(panel, surface, array, map)->SetInterpolateScalarsBeforeMapping(false);
}

void add_cell_categories(const Panel& panel, const Surface& surface, const std::string& array,
                         vtkLookupTable* map)
{
  add_mapped(panel, surface, array, map)->SetScalarModeToUseCellFieldData();
}

void add_contour(const Panel& panel, const Surface& surface, const std::string& array, double value,
                 double width)
{
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(known_part(surface, array));
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  contour->SetValue(0, value);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -8);
  vtkNew<vtkActor> line;
  line->SetMapper(mapper);
  line->GetProperty()->SetColor(0.1, 0.1, 0.12);
  line->GetProperty()->SetLineWidth(static_cast<float>(width * panel.scale));
  line->GetProperty()->LightingOff();
  panel.scene->AddActor(line);
}

void add_outline(const Panel& panel, const Surface& lines, const Colour& colour, double width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width * panel.scale));
  actor->GetProperty()->LightingOff();
  panel.front->AddActor(actor);
}

void add_planes(const Panel& panel, const Surface& planes)
{
  const auto actor = add_surface(panel, planes, cut_colour);
  actor->GetProperty()->SetOpacity(0.22);
  actor->GetProperty()->LightingOff();
  // A plane seen edge-on inside bone would not be seen at all without its outline.
  vtkNew<vtkFeatureEdges> outline;
  outline->SetInputData(planes);
  outline->BoundaryEdgesOn();
  outline->FeatureEdgesOff();
  outline->ManifoldEdgesOff();
  outline->ColoringOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(outline->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> line;
  line->SetMapper(mapper);
  line->GetProperty()->SetColor(cut_colour[0], cut_colour[1], cut_colour[2]);
  line->GetProperty()->SetLineWidth(static_cast<float>(2 * panel.scale));
  line->GetProperty()->LightingOff();
  panel.front->AddActor(line);
}

void add_arrow(const Panel& panel, const Point& from, const Point& to, double thickness_mm)
{
  Point direction{};
  vtkMath::Subtract(to.data(), from.data(), direction.data());
  if (vtkMath::Norm(direction.data()) < 1e-6)
  {
    return;
  }
  // A light rim keeps the dark arrow visible on a dark fragment.
  const auto rim = make_arrow(from, direction, thickness_mm, 0.35 * thickness_mm);
  rim->GetProperty()->SetColor(1, 1, 1);
  rim->GetProperty()->LightingOff();
  rim->GetProperty()->FrontfaceCullingOn();
  panel.front->AddActor(rim);
  const auto arrow = make_arrow(from, direction, thickness_mm, 0);
  arrow->GetProperty()->SetColor(arrow_colour[0], arrow_colour[1], arrow_colour[2]);
  panel.front->AddActor(arrow);
}

} // namespace f2b
