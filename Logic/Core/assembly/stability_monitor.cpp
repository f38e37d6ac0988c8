#include "Core/assembly/stability_monitor.hpp"

#include "Core/assembly/element_groups.hpp"

namespace f2b
{

StabilityReport examine_stability(const Discretization& tissue, const MaterialSet& materials,
                                  const std::vector<Vec3>& x)
{
  StabilityReport report(materials);
  visit_points(ElementGroups(tissue, materials), tissue.rest(), x,
               [&](Tissue kind, const Mat3& F, const Vec3& place, double volume) {
                 report.add({kind, F, place, volume});
               });
  return report;
}

} // namespace f2b
