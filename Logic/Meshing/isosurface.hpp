#pragma once

#include "Core/geometry/scalar_grid.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>

/// Which closed surface bounds the inside of a sampled signed distance? Positions in mm, RAS.
namespace f2b
{

struct SurfaceOptions
{
  double decimation_error_mm = 0.0; ///< how far decimation may go from the surface; 0: none
  int smoothing_iterations = 15;    ///< of a windowed sinc filter; 0 for none
  double smoothing_pass_band = 0.1; ///< lower is smoother, in (0, 2)
  bool largest_component = false;   ///< drop all other pieces and inner cavities
};

/// The surface on which `grid` takes the value `level`, closed where the inside (below the level)
/// meets the walls of the grid's box. Triangles face outwards; point normals included.
///
/// Decimation keeps the surface closed and manifold, with its components and handles.
vtkSmartPointer<vtkPolyData> watertight_isosurface(const ScalarGrid& grid, double level = 0.0,
                                                   const SurfaceOptions& options = {});

/// The same surface with point normals.
vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* surface);

struct SurfaceCheck
{
  std::size_t open_edges = 0;         ///< of one triangle
  std::size_t non_manifold_edges = 0; ///< of more than two triangles, or of two that disagree
  std::size_t components = 0;
  double area_mm2 = 0.0;
  double volume_mm3 = 0.0; ///< positive if the triangles face outwards
  bool watertight() const { return open_edges == 0 && non_manifold_edges == 0; }
};

SurfaceCheck check_surface(vtkPolyData* surface);

} // namespace f2b
