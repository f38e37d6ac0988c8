#pragma once

#include "Imaging/lattice.hpp"

#include <cstdint>

/// Which samples of a lattice belong to a thing, how far is it, and which of its parts hang
/// together?
namespace f2b
{

struct BinaryMask
{
  Lattice lattice;
  std::vector<std::uint8_t> values; ///< 0 or 1

  explicit BinaryMask(const Lattice& on, std::uint8_t value = 0)
      : lattice(on), values(on.count(), value)
  {
  }
  std::size_t count() const;
};

/// The mask of the samples at which `inside(sample index)` holds.
template <class Predicate>
BinaryMask mask_where(const Lattice& lattice, Predicate inside)
{
  BinaryMask mask(lattice);
  const auto n = static_cast<std::ptrdiff_t>(mask.values.size());
#pragma omp parallel for
  for (std::ptrdiff_t s = 0; s < n; ++s)
    mask.values[s] = inside(static_cast<std::size_t>(s)) ? 1 : 0;
  return mask;
}

/// Euclidean distance of each sample to the nearest sample of the mask [mm]; 1e6 if it is empty.
ScalarGrid distance_to(const BinaryMask& mask);

/// Face-connected parts of a mask.
struct Components
{
  std::vector<int> label;         ///< per sample: 0 outside the mask, else 1 + number of the part
  std::vector<std::size_t> size;  ///< samples in each part
  std::vector<char> touches_wall; ///< does the part reach the lattice's boundary?

  int largest() const; ///< number of the largest part, -1 if there is none
};
Components components_of(const BinaryMask& mask);

/// The parts of `mask` that contain a sample of `seeds` (same lattice).
BinaryMask reconstruct(const BinaryMask& seeds, const BinaryMask& mask);

BinaryMask largest_component(const BinaryMask& mask);

/// Dilation and erosion with a ball of `radius` [mm]; closing = dilate, then erode.
BinaryMask dilate(const BinaryMask& mask, double radius);
BinaryMask erode(const BinaryMask& mask, double radius);

} // namespace f2b
