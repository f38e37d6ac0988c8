#pragma once

#include "Core/material/material_set.hpp"
#include "Core/material/stress_curve.hpp"

#include <string>

/// Where has the tissue been stretched further than its law is stable?
namespace f2b
{

/// The smallest eigenvalue of the Hessian of the deviatoric energy in principal stretches,
/// restricted to isochoric increments, divided by its value at rest, 2 mu: 1 at rest, not positive
/// outside the stable range.
///
/// With increments counted relative to the stretches, e_i = d lambda_i / lambda_i with
/// e_1 + e_2 + e_3 = 0, it is the quadratic form lambda_i lambda_j d2W/d lambda_i d lambda_j. It
/// decides whether a cube under dead loads without mean pressure resists every change of shape
/// along its axes (R. Hill, Arch. Mech. 19 (1967) 427 - on isotropic solids under all-round dead
/// load). The pressure, which the surroundings set, moves a test's own limit a little to either
/// side. 1 for the linear law, -infinity for inverted matter.
double stability_margin(const Law& law, const Mat3& F);

/// Where the margin is positive for incompressible matter under a loading.
DeformationRange guarded_range(const Law& law, Loading loading);

/// A place of the tissue in a deformed state.
struct MaterialPoint
{
  Tissue tissue;
  Mat3 F;
  Vec3 X;        ///< rest position [mm, RAS]
  double volume; ///< that the point stands for, at rest [mm^3]
};

/// How one tissue fares.
struct TissueStability
{
  long points = 0, points_outside = 0;
  double volume = 0, volume_outside = 0; ///< [mm^3]
  double worst_margin = 1;
  Vec3 worst_place = Vec3::Zero(); ///< rest position of the point with the worst margin [mm, RAS]

  double share_outside() const { return volume > 0 ? volume_outside / volume : 0; }
};

/// What the guard found in a deformed state, tissue by tissue.
class StabilityReport
{
public:
  explicit StabilityReport(const MaterialSet& materials) : m_materials(&materials) {}

  void add(const MaterialPoint& point);

  const TissueStability& of(Tissue tissue) const { return m_tissues[index(tissue)]; }
  bool all_inside() const;
  /// One sentence for each tissue with points outside: share, worst place and amount.
  std::vector<std::string> warnings() const;

private:
  static std::size_t index(Tissue tissue) { return static_cast<std::size_t>(tissue); }

  const MaterialSet* m_materials;
  std::array<TissueStability, tissue_count> m_tissues;
};

} // namespace f2b
