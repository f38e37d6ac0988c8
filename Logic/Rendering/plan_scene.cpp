#include <Rendering/plan_scene.hpp>

#include <Core/error.hpp>

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <cmath>

namespace f2b
{

namespace
{

void check_surface(const Surface& surface, const std::string& name)
{
  const std::string remedy = "run the steps before 'report' again";
  if (!surface || surface->GetNumberOfPoints() == 0 || surface->GetNumberOfCells() == 0)
  {
    throw Error(name, "surface without points or faces", remedy);
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* x = surface->GetPoint(i);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      throw Error(name, "vertex " + std::to_string(i) + " is not finite", remedy);
    }
  }
}

void check_same_topology(const Surface& state, const Surface& skin, const std::string& name)
{
  const auto sizes = [](const Surface& s)
  {
    return std::to_string(s->GetNumberOfPoints()) + " vertices and " +
           std::to_string(s->GetNumberOfCells()) + " faces";
  };
  if (sizes(state) != sizes(skin))
  {
    throw Error(name, sizes(state) + ", the reference skin has " + sizes(skin),
                "use the exported reference skin without changing its topology");
  }
}

void check_array(const Surface& surface, const char* array_name, const std::string& name)
{
  const vtkDataArray* array = surface ? surface->GetPointData()->GetArray(array_name) : nullptr;
  if (array &&
      const_cast<vtkDataArray*>(array)->GetNumberOfTuples() != surface->GetNumberOfPoints())
  {
    throw Error(name, std::string("array ") + array_name + " has not one value per vertex",
                "run 'predict' again");
  }
}

void check(const PlanPictures& pictures)
{
  check_surface(pictures.skin, "skin");
  check_surface(pictures.uncut_bone, "uncut bone");
  for (const auto& [state, name] :
       {std::pair(pictures.target, "target face"), std::pair(pictures.predicted, "predicted face")})
  {
    if (state)
    {
      check_surface(state, name);
      check_same_topology(state, pictures.skin, name);
    }
  }
  check_array(pictures.skin, target_displacement_array, "skin");
  check_array(pictures.skin, region_array, "skin");
  check_array(pictures.predicted, signed_distance_array, "predicted face");
  check_array(pictures.predicted, unreachable_array, "predicted face");
  for (const FragmentPicture& fragment : pictures.fragments)
  {
    check_surface(fragment.rest, "fragment " + fragment.name);
    if (fragment.planned)
    {
      check_surface(fragment.planned, "fragment " + fragment.name + " as planned");
    }
  }
  for (const ContactPicture& contact : pictures.contacts)
  {
    check_surface(contact.rest, "contact surface");
    check_surface(contact.dragged, "dragged contact surface");
    check_array(contact.dragged, misfit_array, "dragged contact surface");
  }
}

} // namespace

// Smooth shading keeps the vertices: splitting would break the arrays' correspondence.
Surface with_normals(const Surface& surface)
{
  if (!surface)
  {
    return nullptr;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->ComputePointNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

PlanScene::PlanScene(const PlanPictures& pictures) : m_pictures(pictures)
{
  check(pictures);
  m_pictures.skin = with_normals(pictures.skin);
  m_pictures.target = with_normals(pictures.target);
  m_pictures.predicted = with_normals(pictures.predicted);
  m_pictures.uncut_bone = with_normals(pictures.uncut_bone);
  for (FragmentPicture& fragment : m_pictures.fragments)
  {
    fragment.rest = with_normals(fragment.rest);
    fragment.planned = with_normals(fragment.planned);
  }
  for (ContactPicture& contact : m_pictures.contacts)
  {
    contact.rest = with_normals(contact.rest);
    contact.dragged = with_normals(contact.dragged);
  }
}

bool PlanScene::has_distance() const
{
  return has_predicted() && m_pictures.predicted->GetPointData()->GetArray(signed_distance_array);
}

bool PlanScene::has_unreachable() const
{
  return has_predicted() && m_pictures.predicted->GetPointData()->GetArray(unreachable_array);
}

bool PlanScene::has_regions() const
{
  vtkDataArray* regions = m_pictures.skin->GetPointData()->GetArray(region_array);
  return regions && regions->GetRange()[1] > 0; // all 0: nothing is known of them
}

bool PlanScene::has_target_displacement() const
{
  return has_target() || m_pictures.skin->GetPointData()->GetArray(target_displacement_array);
}

bool PlanScene::has_intervals() const
{
  return std::any_of(m_pictures.fragments.begin(), m_pictures.fragments.end(),
                     [](const FragmentPicture& f) { return f.intervals.has_value(); });
}

bool PlanScene::has_plan() const
{
  return std::all_of(m_pictures.fragments.begin(), m_pictures.fragments.end(),
                     [](const FragmentPicture& f) { return f.planned != nullptr; });
}

std::vector<Surface> PlanScene::faces() const
{
  std::vector<Surface> surfaces{m_pictures.skin};
  for (const Surface& state : {m_pictures.target, m_pictures.predicted})
  {
    if (state)
    {
      surfaces.push_back(state);
    }
  }
  return surfaces;
}

std::vector<Surface> PlanScene::bones() const
{
  std::vector<Surface> surfaces{m_pictures.uncut_bone};
  for (const FragmentPicture& fragment : m_pictures.fragments)
  {
    surfaces.push_back(fragment.rest);
    if (fragment.planned)
    {
      surfaces.push_back(fragment.planned);
    }
  }
  if (m_pictures.cut_planes)
  {
    surfaces.push_back(m_pictures.cut_planes);
  }
  return surfaces;
}

} // namespace f2b
