#pragma once

#include <Core/geometry/osteotomy_templates.hpp>
#include <Core/geometry/virtual_patient.hpp>
#include <Imaging/binary_mask.hpp>
#include <Imaging/postoperative_ct.hpp>
#include <Imaging/resample_ct.hpp>
#include <Imaging/segment_head.hpp>
#include <Imaging/synthetic_ct.hpp>

#include <cmath>

namespace f2b::test
{

/// The virtual patient on voxels of 2 mm with a Le Fort I osteotomy, and soft tissue on a lattice
/// of tetrahedra that follows the fragment less and less over 30 mm.
struct OperatedHead
{
  VirtualPatient patient;
  CtImage::Pointer before;
  HeadSegmentation head;
  BonePartition partition;
  RigidMotion motion;
  ScalarGrid hu;
  std::vector<std::array<int, 4>> tets;
  std::vector<Vec3> X, x;

  OperatedHead()
  {
    SyntheticCtOptions scan;
    scan.spacing_mm = Vec3::Constant(2);
    before = synthesize_ct(patient, scan);
    SegmentOptions options;
    options.spacing_mm = 1.5;
    options.region_ras = Box{Vec3(-76, -5, -112), Vec3(76, 122, 60)};
    head = segment_head(*before, options);
    Landmarks landmarks;
    for (const NamedPoint& point : patient.landmarks())
      landmarks[point.name] = point.point_ras;
    partition = cut_bone(head.bone, head.closed_bone,
                         {osteotomy_from_template("le-fort-1", "maxilla", landmarks, 1)});
    const double degree = std::acos(-1.0) / 180;
    motion.reference_point = patient.landmark("ANS");
    motion.translation = Vec3(1.5, 6, -3);
    motion.rotation = rotation_from({4 * degree, 2 * degree, -1 * degree});
    hu = resample_ct(*before, lattice_over(extent_ras(*before), 2, anchor_ras(*before)));
    fill_tissue();
  }

  CtImage::Pointer after(const PostoperativeCtOptions& options) const
  {
    const std::vector<RigidMotion> motions{motion};
    return synthesize_postoperative_ct({hu, head.bone, partition, motions, tets, X, x}, options);
  }

private:
  void fill_tissue()
  {
    constexpr double edge = 6, reach = 30;
    const Lattice bone = lattice_of(head.bone);
    const ScalarGrid far = distance_to(
        mask_where(bone, [&](std::size_t s)
                   { return partition.labels.values[s] == BonePartition::first_fragment; }));
    const Lattice nodes = lattice_over({Vec3(-72, 5, -108), Vec3(72, 118, 40)}, edge, Vec3::Zero());
    for (int k = 0; k < nodes.size.z(); ++k)
      for (int j = 0; j < nodes.size.y(); ++j)
        for (int i = 0; i < nodes.size.x(); ++i)
        {
          const Vec3 p = nodes.position(i, j, k);
          const double t = std::min(1.0, std::max(0.0, far.value(p) - 3) / reach);
          X.push_back(p);
          x.push_back(p + (1 - t * t * (3 - 2 * t)) * (motion.apply(p) - p));
          if (i + 1 < nodes.size.x() && j + 1 < nodes.size.y() && k + 1 < nodes.size.z() &&
              head.skin.value(p + Vec3::Constant(edge / 2)) < edge / 2)
            fill_cell(nodes, i, j, k);
        }
  }
  /// Six tetrahedra around the diagonal (Kuhn), a path from corner to corner for each order of axes.
  void fill_cell(const Lattice& nodes, int i, int j, int k)
  {
    const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& order : orders)
    {
      Eigen::Vector3i at(i, j, k);
      std::array<int, 4> tet{};
      for (std::size_t n = 0; n < 4; ++n)
      {
        tet[n] = static_cast<int>(nodes.index(at.x(), at.y(), at.z()));
        if (n < 3)
          ++at[order[n]];
      }
      tets.push_back(tet);
    }
  }
};

inline const OperatedHead& operated_head()
{
  static const OperatedHead head;
  return head;
}

} // namespace f2b::test
