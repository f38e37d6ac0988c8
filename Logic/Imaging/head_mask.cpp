#include "Imaging/head_mask.hpp"

#include "Core/error.hpp"
#include "Imaging/signed_distance.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

BinaryMask above(const ScalarGrid& hu, double threshold)
{
  return mask_where(lattice_of(hu), [&](std::size_t s) { return hu.values[s] > threshold; });
}

BinaryMask intersection(const BinaryMask& a, const BinaryMask& b)
{
  return mask_where(a.lattice, [&](std::size_t s) { return a.values[s] && b.values[s]; });
}

BinaryMask difference(const BinaryMask& a, const BinaryMask& b)
{
  return mask_where(a.lattice, [&](std::size_t s) { return a.values[s] && !b.values[s]; });
}

Box bounds_of(const BinaryMask& mask)
{
  Box box;
  box.min = mask.lattice.last();
  box.max = mask.lattice.origin;
  for (int k = 0; k < mask.lattice.size.z(); ++k)
    for (int j = 0; j < mask.lattice.size.y(); ++j)
      for (int i = 0; i < mask.lattice.size.x(); ++i)
        if (mask.values[mask.lattice.index(i, j, k)])
        {
          box.min = box.min.cwiseMin(mask.lattice.position(i, j, k));
          box.max = box.max.cwiseMax(mask.lattice.position(i, j, k));
        }
  return box;
}

/// Thin parts of the head that the opening took away: ears, but not cloth or the holder's rim.
BinaryMask appendages(const BinaryMask& thin, const HeadMaskOptions& options)
{
  const Components parts = components_of(thin);
  const double sample_ml = std::pow(thin.lattice.spacing, 3) / 1000.0;
  return mask_where(thin.lattice,
                    [&](std::size_t s)
                    {
                      const int part = parts.label[s] - 1;
                      return part >= 0 && !parts.touches_wall[part] &&
                             static_cast<double>(parts.size[part]) * sample_ml <=
                                 options.largest_appendage_ml;
                    });
}

/// Soft tissue and bone that hang together with the largest bone of the CT, the skull.
BinaryMask solid_head(const ScalarGrid& hu, const HeadMaskOptions& options)
{
  const BinaryMask solid = above(hu, options.skin_threshold_hu);
  const BinaryMask skull = largest_component(above(hu, options.bone_threshold_hu));
  const BinaryMask eroded = erode(solid, options.opening_mm);
  const BinaryMask core = reconstruct(intersection(skull, eroded), eroded);
  const BinaryMask near_core =
      intersection(solid, dilate(core, options.opening_mm + 1.0 + 0.5 * hu.spacing));
  const BinaryMask body = reconstruct(core, near_core);
  const BinaryMask thin = appendages(difference(solid, body), options);
  const BinaryMask whole =
      mask_where(body.lattice, [&](std::size_t s) { return body.values[s] || thin.values[s]; });
  return reconstruct(body, whole);
}

/// The samples from which the air around the head can be reached, of those outside the dilated
/// head. The airway opens at the lower end of the CT, so that a part must also be large to be
/// outside.
BinaryMask outer_part(const BinaryMask& free_space)
{
  const Components parts = components_of(free_space);
  const int largest = parts.largest();
  const std::size_t enough = largest < 0 ? 0 : parts.size[largest] / 30;
  return mask_where(free_space.lattice,
                    [&](std::size_t s)
                    {
                      const int part = parts.label[s] - 1;
                      return part >= 0 && parts.touches_wall[part] && parts.size[part] >= enough;
                    });
}

BinaryMask outside_of(const ScalarGrid& distance, double radius)
{
  return mask_where(lattice_of(distance),
                    [&](std::size_t s) { return distance.values[s] > radius; });
}

/// The inside of the cranium: closed at a radius that shuts the foramen magnum, which the bone
/// closing leaves open.
BinaryMask cranial_cavity(const ScalarGrid& bone_distance, const BinaryMask& outer_air,
                          double closing_mm)
{
  const double foramen_radius = 20.0;
  const BinaryMask wide = outside_of(bone_distance, foramen_radius);
  const BinaryMask reached = reconstruct(intersection(outer_air, wide), wide);
  const Components parts = components_of(difference(wide, reached));
  const int largest = parts.largest() + 1;
  const BinaryMask core = mask_where(wide.lattice, [&](std::size_t s)
                                     { return largest > 0 && parts.label[s] == largest; });
  return dilate(core, foramen_radius - closing_mm + 2.0 * bone_distance.spacing);
}

Lattice cropped(const Lattice& lattice, const Box& box, double margin)
{
  Lattice result = lattice;
  for (int a = 0; a < 3; ++a)
  {
    const double first = (box.min[a] - margin - lattice.origin[a]) / lattice.spacing;
    const double last = (box.max[a] + margin - lattice.origin[a]) / lattice.spacing;
    const int from = std::max(0, static_cast<int>(std::floor(first)));
    const int to = std::min(lattice.size[a] - 1, static_cast<int>(std::ceil(last)));
    result.origin[a] = lattice.origin[a] + from * lattice.spacing;
    result.size[a] = to - from + 1;
  }
  return result;
}

template <class Values>
Values cropped_values(const Values& values, const Lattice& from, const Lattice& to)
{
  Values result(to.count());
  const Eigen::Vector3i shift =
      ((to.origin - from.origin) / from.spacing).array().round().cast<int>();
  for (int k = 0; k < to.size.z(); ++k)
    for (int j = 0; j < to.size.y(); ++j)
      std::copy_n(values.begin() + from.index(shift.x(), j + shift.y(), k + shift.z()), to.size.x(),
                  result.begin() + to.index(0, j, k));
  return result;
}

} // namespace

HeadMask find_head(const ScalarGrid& whole_hu, const HeadMaskOptions& options)
{
  const BinaryMask whole = solid_head(whole_hu, options);
  if (whole.count() == 0)
    throw Error("head",
                "no connected soft tissue around bone at " +
                    std::to_string(static_cast<int>(options.skin_threshold_hu)) + " HU",
                "check the skin threshold and that the CT shows a head");
  const Lattice all = lattice_of(whole_hu);
  const Lattice lattice = cropped(all, bounds_of(whole), 30.0);
  BinaryMask solid(lattice);
  solid.values = cropped_values(whole.values, all, lattice);
  ScalarGrid hu = grid_on(lattice, 0.0F);
  hu.values = cropped_values(whole_hu.values, all, lattice);

  ScalarGrid level = hu;
  for (std::size_t s = 0; s < level.values.size(); ++s)
  {
    const float f = static_cast<float>(options.skin_threshold_hu) - hu.values[s];
    level.values[s] = solid.values[s] ? std::min(f, -1.0F) : std::max(f, 300.0F);
  }
  ScalarGrid head = signed_distance(level);

  const BinaryMask outer_air = outer_part(outside_of(head, options.head_closing_mm));
  const BinaryMask bone = intersection(above(hu, options.bone_threshold_hu), solid);
  const ScalarGrid bone_distance = distance_to(bone);
  // Thin walls of sinuses are lost on a coarse lattice: a wider closing makes up for them.
  const double closing_mm = options.bone_closing_mm + 1.5 * lattice.spacing;
  const BinaryMask free_space = outside_of(bone_distance, closing_mm);
  const BinaryMask open_space =
      difference(free_space, cranial_cavity(bone_distance, outer_air, closing_mm));
  BinaryMask outside_bone = reconstruct(intersection(outer_air, open_space), open_space);
  return {std::move(head), outer_air, std::move(outside_bone), bone};
}

} // namespace f2b
