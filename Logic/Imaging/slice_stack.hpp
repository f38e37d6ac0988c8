#pragma once

#include "Imaging/ct_image.hpp"

#include <functional>
#include <string>
#include <vector>

/// Which rectangular lattice do slices fill that are uneven or shifted against one another?
namespace f2b
{

/// Where a slice lies along and beside the stack's normal [mm].
struct SlicePlace
{
  double position = 0;                     ///< along the normal
  double shift_across = 0, shift_down = 0; ///< of its first voxel against the first slice's
};

/// The lattice of the stack: evenly `step_mm` apart, wide enough for every slice.
struct StackLattice
{
  double step_mm = 1;
  std::size_t planes = 0;
  int before_across = 0, before_down = 0; ///< voxels added before the first slice's first one
  int columns = 0, rows = 0;
};

/// \param places  ascending positions
StackLattice stack_lattice(const std::vector<SlicePlace>& places, double step_mm, int columns,
                           int rows, double spacing_across, double spacing_down);

/// Fills `out` (columns x rows x planes) by linear interpolation within and between slices; -1024
/// where there is no slice. Slices are asked for in order, two are held at a time.
/// \param read  fills a slice's columns x rows voxels
void resample_stack(const std::vector<SlicePlace>& places, const StackLattice& lattice, int columns,
                    int rows, double spacing_across, double spacing_down,
                    const std::function<void(std::size_t, short*)>& read, short* out);

} // namespace f2b
