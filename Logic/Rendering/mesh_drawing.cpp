#include <Rendering/subject_drawing.hpp>

#include <Rendering/map_arrays.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>

namespace f2b
{

namespace
{

constexpr int skin_part = 1; ///< Core's Boundary::Skin

// The facets that are skin, or all others; cell arrays go with them.
Surface facets(const Surface& boundary, bool of_skin)
{
  vtkDataArray* parts = boundary->GetCellData()->GetArray(boundary_array);
  auto chosen = Surface::New();
  chosen->SetPoints(boundary->GetPoints());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> values;
  values->SetName(boundary_array);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < boundary->GetNumberOfCells(); ++cell)
  {
    const double part = parts->GetTuple1(cell);
    if ((part == skin_part) == of_skin)
    {
      boundary->GetCellPoints(cell, corners);
      cells->InsertNextCell(corners);
      values->InsertNextValue(part);
    }
  }
  chosen->SetPolys(cells);
  chosen->GetCellData()->AddArray(values);
  return chosen;
}

SubjectDrawing boundary_parts(const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  const auto map = boundary_map();
  const std::array<const char*, 6> keys{
      "", "boundary.skin", "boundary.fixed", "boundary.fragment", "boundary.free", "boundary.crop"};
  for (std::size_t part = 1; part < keys.size(); ++part)
  {
    const double* c = map->GetTableValue(static_cast<vtkIdType>(part));
    drawing.legend.push_back(
        {texts(keys[part]), {c[0], c[1], c[2]}, part == skin_part ? 0.5 : 1.0});
  }
  const Surface inner = facets(scene.pictures().boundary, false);
  const Surface skin = facets(scene.pictures().boundary, true);
  drawing.framed = {scene.pictures().boundary};
  drawing.draw = [inner, skin, map](const Panel& panel, const ViewAxes&, double)
  {
    add_cell_categories(panel, inner, boundary_array, map);
    add_translucent(panel, skin, skin_colour, 0.25);
  };
  return drawing;
}

std::vector<Surface> contact_surfaces(const PlanScene& scene)
{
  std::vector<Surface> surfaces;
  for (const ContactPicture& contact : scene.pictures().contacts)
  {
    surfaces.push_back(contact.rest);
    surfaces.push_back(contact.dragged);
  }
  return surfaces;
}

SubjectDrawing contact_before_and_after(const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  drawing.legend = {{texts("legend.contact-rest"), ghost_colour, 0.6}};
  for (std::size_t f = 0; f < scene.pictures().contacts.size(); ++f)
  {
    drawing.legend.push_back(
        {texts("legend.contact-dragged", {{"fragment", scene.pictures().fragments.at(f).name}}),
         fragment_colour(f)});
  }
  drawing.draw = [&scene](const Panel& panel, const ViewAxes&, double)
  {
    for (std::size_t f = 0; f < scene.pictures().contacts.size(); ++f)
    {
      const ContactPicture& contact = scene.pictures().contacts[f];
      add_bone(panel, contact.dragged, fragment_colour(f));
      add_open_translucent(panel, contact.rest, ghost_colour, 0.45);
    }
  };
  return drawing;
}

SubjectDrawing contact_distance(const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  std::vector<double> all;
  for (const ContactPicture& contact : scene.pictures().contacts)
  {
    const std::vector<double> values = point_values(contact.dragged, misfit_array);
    all.insert(all.end(), values.begin(), values.end());
  }
  const auto map = sequential_map(nice_range(all, 1.0, 0.5));
  drawing.bar = ValueBar{map, texts("bar.contact-distance")};
  drawing.draw = [&scene, map](const Panel& panel, const ViewAxes&, double)
  {
    for (const ContactPicture& contact : scene.pictures().contacts)
    {
      add_map(panel, contact.dragged, misfit_array, map);
    }
  };
  return drawing;
}

} // namespace

SubjectDrawing mesh_drawing(Subject subject, const PlanScene& scene, const Texts& texts)
{
  SubjectDrawing drawing;
  if (subject == Subject::BoundaryParts)
  {
    drawing = boundary_parts(scene, texts);
  }
  else
  {
    drawing = subject == Subject::ContactSurfaces ? contact_before_and_after(scene, texts)
                                                  : contact_distance(scene, texts);
    drawing.framed = contact_surfaces(scene);
    drawing.legend_rows = 1 + scene.pictures().contacts.size();
  }
  drawing.title = texts("subject." + name_of(subject));
  return drawing;
}

} // namespace f2b
