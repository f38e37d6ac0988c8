#include "Case/mesh_pictures.hpp"

#include "Bridge/mesh_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Core/mesh/boundary_facets.hpp"

#include <vtkCellData.h>
#include <vtkIntArray.h>

#include <algorithm>

namespace f2b
{
namespace
{

/// Where parts meet, a facet takes the one that holds it least: what is drawn as fixed is fixed.
Boundary part_of(const MixedMesh& mesh, const Triangle& facet)
{
  for (const Boundary part : {Boundary::Free, Boundary::Fragment, Boundary::FixedBone})
    if (std::any_of(facet.begin(), facet.end(),
                    [&](int n) { return mesh.node_boundary[static_cast<std::size_t>(n)] == part; }))
      return part;
  return Boundary::Crop;
}

Surface boundary_surface(const MixedMesh& mesh, const BoundaryFacets& facets)
{
  TriangleMesh triangles{mesh.X, {}};
  vtkNew<vtkIntArray> parts;
  parts->SetName(boundary_array);
  auto add = [&](const Triangle& triangle, Boundary part)
  {
    triangles.triangles.push_back(triangle);
    parts->InsertNextValue(static_cast<int>(part));
  };
  for (const Triangle& t : facets.skin)
    add(t, Boundary::Skin);
  for (const auto& side : facets.sides)
  {
    add({side[0], side[1], side[2]}, Boundary::Crop);
    add({side[0], side[2], side[3]}, Boundary::Crop);
  }
  for (const Triangle& t : facets.inner)
    add(t, part_of(mesh, t));
  Surface surface = to_polydata(triangles);
  surface->GetCellData()->AddArray(parts);
  return surface;
}

/// The triangles over nodes that all hang on one fragment, with only their own vertices.
TriangleMesh contact_mesh(const MixedMesh& mesh, const BoundaryFacets& facets, int fragment,
                          std::vector<int>& nodes)
{
  std::vector<int> place(mesh.X.size(), -1);
  TriangleMesh contact;
  for (const Triangle& t : facets.inner)
  {
    if (!std::all_of(t.begin(), t.end(),
                     [&](int n)
                     { return mesh.node_fragment[static_cast<std::size_t>(n)] == fragment; }))
      continue;
    Triangle own{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      int& at = place[static_cast<std::size_t>(t[i])];
      if (at < 0)
      {
        at = static_cast<int>(nodes.size());
        nodes.push_back(t[i]);
        contact.points.push_back(mesh.X[static_cast<std::size_t>(t[i])]);
      }
      own[i] = at;
    }
    contact.triangles.push_back(own);
  }
  return contact;
}

ContactPicture contact_picture(const TriangleMesh& rest, const std::vector<int>& nodes,
                               const std::vector<Vec3>& dragged, const std::vector<Vec3>& misfit)
{
  TriangleMesh pulled = rest;
  std::vector<double> length;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    pulled.points[i] += dragged[static_cast<std::size_t>(nodes[i])];
    length.push_back(misfit[static_cast<std::size_t>(nodes[i])].norm());
  }
  ContactPicture picture{to_polydata(rest), to_polydata(pulled)};
  add_point_array(picture.dragged, misfit_array, length);
  return picture;
}

} // namespace

void add_mesh_pictures(PlanPictures& pictures, const CaseFolder& folder)
{
  const MixedMesh mesh = read_mesh(folder.file("mesh.vtu"));
  const BoundaryFacets facets = boundary_facets(mesh);
  pictures.boundary = boundary_surface(mesh, facets);
  if (!folder.has("plan_virtual-force.vtu"))
    return;
  const Path plan = folder.file("plan_virtual-force.vtu");
  const std::vector<Vec3> dragged = read_node_vectors(plan, "dragged_displacement");
  const std::vector<Vec3> misfit = read_node_vectors(plan, "registration_misfit");
  if (dragged.size() != mesh.X.size() || misfit.size() != mesh.X.size())
    return; // of a plan that an older program made
  for (std::size_t f = 0; f < mesh.fragments.size(); ++f)
  {
    std::vector<int> nodes;
    const TriangleMesh contact = contact_mesh(mesh, facets, static_cast<int>(f), nodes);
    if (contact.triangles.empty())
    {
      pictures.contacts.clear(); // they are told by the fragments' order
      return;
    }
    pictures.contacts.push_back(contact_picture(contact, nodes, dragged, misfit));
  }
}

} // namespace f2b
