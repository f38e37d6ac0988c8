#include "Meshing/isosurface.hpp"

#include "Meshing/edge_collapse.hpp"
#include "Meshing/self_crossings.hpp"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

/// A sample beyond the wall such that the surface crosses just outside the wall, whatever the
/// depth.
float beyond_wall(float inside)
{
  return 19.0F * std::abs(inside) + 1.0F;
}

/// The level minus the grid, with one layer of outside around it.
///
/// Where four samples of a face are inside and outside crosswise the tables of marching cubes part
/// those above the level. With the inside above, bone that meets at an edge of the lattice alone
/// stays apart, as it does when the bone is flooded through face neighbours.
vtkSmartPointer<vtkImageData> padded_image(const ScalarGrid& grid, double level)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int nx = grid.size.x() + 2, ny = grid.size.y() + 2, nz = grid.size.z() + 2;
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  const Vec3 origin = grid.position(-1, -1, -1);
  image->SetOrigin(origin.x(), origin.y(), origin.z());
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i, ++out)
      {
        const int gi = std::clamp(i - 1, 0, nx - 3), gj = std::clamp(j - 1, 0, ny - 3),
                  gk = std::clamp(k - 1, 0, nz - 3);
        float v = grid.values[grid.index(gi, gj, gk)] - static_cast<float>(level);
        // Triangles through a sample degenerate; a hair's breadth off they do not.
        if (std::abs(v) < 1e-3F)
          v = v < 0 ? -1e-3F : 1e-3F;
        const bool pad = gi != i - 1 || gj != j - 1 || gk != k - 1;
        *out = -(pad ? beyond_wall(v) : v);
      }
  return image;
}

Surface contour(const ScalarGrid& grid, double level)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(padded_image(grid, level));
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->ComputeGradientsOff();
  edges->Update();
  return edges->GetOutput();
}

Surface largest_piece(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataConnectivityFilter> filter;
  filter->SetInputData(surface);
  filter->SetExtractionModeToLargestRegion();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(filter->GetOutputPort());
  clean->PointMergingOff();
  clean->Update();
  return clean->GetOutput();
}

TriangleMesh mesh_of(vtkPolyData* surface)
{
  TriangleMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    surface->GetPoint(static_cast<vtkIdType>(p), mesh.points[p].data());
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface->GetNumberOfPolys(); ++t)
  {
    surface->GetPolys()->GetCellAtId(t, corners);
    mesh.triangles.push_back({static_cast<int>(corners->GetId(0)),
                              static_cast<int>(corners->GetId(1)),
                              static_cast<int>(corners->GetId(2))});
  }
  return mesh;
}

Surface surface_of(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  for (const Vec3& p : mesh.points)
    points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles)
  {
    const vtkIdType corners[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, corners);
  }
  auto surface = Surface::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

Surface smoothed(vtkPolyData* surface, const SurfaceOptions& options)
{
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetNumberOfIterations(options.smoothing_iterations);
  filter->SetPassBand(options.smoothing_pass_band);
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOn();
  filter->NormalizeCoordinatesOn();
  filter->Update();
  // thin walls may be smoothed through one another: there the surface stays as it was sampled
  TriangleMesh mesh = mesh_of(filter->GetOutput());
  yield_crossings(mesh, mesh_of(surface).points);
  return surface_of(mesh);
}

/// Not where large triangles would cross one another: such a surface stays as it was.
Surface decimated(vtkPolyData* surface, double error_mm)
{
  const TriangleMesh fewer = collapse_edges(mesh_of(surface), error_mm);
  return crossing_triangles(fewer).empty() ? surface_of(fewer) : Surface(surface);
}

Surface facing_outwards(vtkPolyData* surface)
{
  if (check_surface(surface).volume_mm3 >= 0.0)
    return surface;
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->ReverseCellsOn();
  reverse->Update();
  return reverse->GetOutput();
}

} // namespace

Surface with_normals(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->ComputePointNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

Surface watertight_isosurface(const ScalarGrid& grid, double level, const SurfaceOptions& options)
{
  Surface surface = contour(grid, level);
  if (surface->GetNumberOfPolys() == 0)
    return surface;
  if (options.largest_component)
    surface = largest_piece(surface);
  if (options.smoothing_iterations > 0)
    surface = smoothed(surface, options);
  if (options.decimation_error_mm > 0.0)
    surface = decimated(surface, options.decimation_error_mm);
  return with_normals(facing_outwards(surface));
}

} // namespace f2b
