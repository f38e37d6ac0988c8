#include "Meshing/isosurface.hpp"

#include <vtkCleanPolyData.h>
#include <vtkDecimatePro.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricDecimation.h>
#include <vtkReverseSense.h>
#include <vtkTriangleFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

/// A sample beyond the wall such that the surface crosses just outside the wall, whatever the depth.
float beyond_wall(float inside)
{
  return 19.0F * std::abs(inside) + 1.0F;
}

/// The grid minus the level, with one layer of outside around it.
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
        *out = pad ? beyond_wall(v) : v;
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
  return filter->GetOutput();
}

template <class Filter> Surface run(Filter& filter, vtkPolyData* surface, double reduction)
{
  filter.SetInputData(surface);
  filter.SetTargetReduction(reduction);
  filter.Update();
  return filter.GetOutput();
}

/// Quadric decimation where it keeps the surface closed, else one that minds the topology.
Surface decimated(vtkPolyData* surface, double target_edge)
{
  const SurfaceCheck before = check_surface(surface);
  const double wanted = before.area_mm2 / (std::sqrt(3.0) / 4.0 * target_edge * target_edge);
  const double reduction = 1.0 - wanted / static_cast<double>(surface->GetNumberOfPolys());
  if (reduction <= 0.0)
    return surface;
  auto keeps = [&](vtkPolyData* candidate)
  {
    const SurfaceCheck after = check_surface(candidate);
    return after.watertight() && after.components == before.components &&
           std::abs(after.volume_mm3 - before.volume_mm3) < 0.01 * std::abs(before.volume_mm3);
  };
  vtkNew<vtkQuadricDecimation> quadric;
  quadric->VolumePreservationOn();
  const Surface first = run(*quadric, surface, reduction);
  if (keeps(first))
    return first;
  vtkNew<vtkDecimatePro> careful;
  careful->PreserveTopologyOn();
  careful->SplittingOff();
  careful->BoundaryVertexDeletionOff();
  const Surface second = run(*careful, surface, reduction);
  return keeps(second) ? second : Surface(surface);
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

} // namespace

Surface watertight_isosurface(const ScalarGrid& grid, double level, const SurfaceOptions& options)
{
  Surface surface = contour(grid, level);
  if (surface->GetNumberOfPolys() == 0)
    return surface;
  if (options.largest_component)
    surface = largest_piece(surface);
  if (options.smoothing_iterations > 0)
    surface = smoothed(surface, options);
  if (options.target_edge_mm > 0.0)
    surface = decimated(surface, options.target_edge_mm);
  return with_normals(facing_outwards(surface));
}

} // namespace f2b
