#include "Imaging/unaltered_region.hpp"

#include "Core/error.hpp"
#include "Core/geometry/osteotomy.hpp"
#include "Imaging/head_mask.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace f2b
{
namespace
{

constexpr double vertex_to_base_mm = 95;

bool within(const Vec3& p, const Vec3& first, const Vec3& last)
{
  return (p.array() >= first.array()).all() && (p.array() <= last.array()).all();
}

/// Label at a point, no_bone beyond the labels' box.
unsigned char label_at(const LabelGrid& labels, const Vec3& p)
{
  const Vec3 last = labels.position(labels.size.x() - 1, labels.size.y() - 1, labels.size.z() - 1);
  return within(p, labels.origin, last) ? labels.nearest(p) : BonePartition::no_bone;
}

/// The samples of a lattice at whose position something holds.
template <class Holds>
BinaryMask mask_of_places(const Lattice& lattice, Holds holds)
{
  const auto nx = static_cast<std::size_t>(lattice.size.x()),
             ny = static_cast<std::size_t>(lattice.size.y());
  return mask_where(lattice,
                    [&](std::size_t s)
                    {
                      return holds(lattice.position(static_cast<int>(s % nx),
                                                    static_cast<int>(s / nx % ny),
                                                    static_cast<int>(s / (nx * ny))),
                                   s);
                    });
}

double millilitres(const BinaryMask& mask)
{
  return static_cast<double>(mask.count()) * std::pow(mask.lattice.spacing, 3) / 1000;
}

std::string rounded(double value)
{
  return std::to_string(std::lround(value));
}

/// Bone where `counts` holds, without what lies near a fragment.
template <class Counts>
BinaryMask bone_where(const WholeBone& whole, const LabelGrid& parts, double margin_mm,
                      Counts counts)
{
  const Lattice lattice = lattice_of(whole.bone);
  const ScalarGrid to_fragments =
      distance_to(mask_of_places(lattice, [&](const Vec3& p, std::size_t)
                                 { return label_at(parts, p) >= BonePartition::first_fragment; }));
  return mask_of_places(
      lattice, [&](const Vec3& p, std::size_t s)
      { return whole.bone.values[s] < 0 && to_fragments.values[s] > margin_mm && counts(p); });
}

/// Height of the vertex; throws where the CT does not show it.
double vertex_level(const WholeBone& whole)
{
  HeadMaskOptions options;
  options.bone_threshold_hu = whole.threshold_hu;
  const ScalarGrid head = find_head(whole.hu, options).head;
  const double top = lattice_of(whole.hu).last().z();
  double vertex = head.origin.z();
  for (int k = 0; k < head.size.z(); ++k)
    for (int j = 0; j < head.size.y(); ++j)
      for (int i = 0; i < head.size.x(); ++i)
        if (head.values[head.index(i, j, k)] < 0)
          vertex = std::max(vertex, head.position(i, j, k).z());
  if (vertex > top - 2 * whole.hu.spacing)
    throw Error("the pre-operative CT",
                "it ends below the vertex, so that the cranial base is not "
                "known",
                "give landmarks Or_R and Or_L, or a box or mask of bone that stays");
  return vertex;
}

BinaryMask given_bone(const BinaryMask& bone, const std::string& what, double shell_mm)
{
  constexpr double least_ml = 2;
  if (millilitres(bone) < least_ml)
    throw Error(
        what, "it holds only " + rounded(millilitres(bone)) + " ml of bone away from the fragments",
        "choose a part of the skull that the operation leaves alone");
  return dilate(bone, shell_mm);
}

std::string text(const Box& box)
{
  std::ostringstream out;
  out << "R " << box.min.x() << ".." << box.max.x() << ", A " << box.min.y() << ".." << box.max.y()
      << ", S " << box.min.z() << ".." << box.max.z() << " mm";
  return out.str();
}

} // namespace

BinaryMask unaltered_cranium(const WholeBone& preoperative, const LabelGrid& parts,
                             const UnalteredOptions& options)
{
  constexpr double least_ml = 20;
  const double level =
      options.base_level_s ? *options.base_level_s : vertex_level(preoperative) - vertex_to_base_mm;
  const BinaryMask bone = bone_where(preoperative, parts, options.margin_mm,
                                     [&](const Vec3& p) { return p.z() > level; });
  if (millilitres(bone) < least_ml)
    throw Error("the pre-operative CT",
                "only " + rounded(millilitres(bone)) + " ml of the cranium (above S " +
                    rounded(level) + " mm) lie in it, away from the fragments",
                "give a box or mask of bone that the operation leaves alone");
  return dilate(bone, options.shell_mm);
}

BinaryMask unaltered_box(const WholeBone& preoperative, const LabelGrid& parts, const Box& box_ras,
                         const UnalteredOptions& options)
{
  if (!((box_ras.max - box_ras.min).minCoeff() > 0))
    throw Error("the box for the registration", "it is empty: " + text(box_ras),
                "give min < max on every axis");
  const BinaryMask bone =
      bone_where(preoperative, parts, options.margin_mm,
                 [&](const Vec3& p) { return within(p, box_ras.min, box_ras.max); });
  return given_bone(bone, "the box for the registration (" + text(box_ras) + ")", options.shell_mm);
}

BinaryMask unaltered_mask(const WholeBone& preoperative, const LabelGrid& parts,
                          const LabelGrid& mask, const UnalteredOptions& options)
{
  const BinaryMask bone = bone_where(preoperative, parts, options.margin_mm,
                                     [&](const Vec3& p) { return label_at(mask, p) != 0; });
  return given_bone(bone, "the mask for the registration", options.shell_mm);
}

} // namespace f2b
