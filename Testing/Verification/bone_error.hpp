#pragma once

#include "Case/case_session.hpp"
#include "Core/inverse/skin_error.hpp"

#include <cmath>

/// How far are fragments from where they should be?
namespace f2b::verification
{

/// The fragments' surfaces at rest.
class FragmentSurfaces
{
public:
  FragmentSurfaces(const CaseFolder& folder, const std::vector<std::string>& names)
  {
    for (const std::string& name : names)
    {
      const TriangleMesh mesh = to_triangle_mesh(
          read_surface(folder.require("fragment_" + file_part(name) + ".vtp", "cut")));
      m_points.push_back(mesh.points);
      m_areas.push_back(vertex_areas(mesh));
    }
  }

  /// Mean distance over all surfaces, by area [mm].
  double mean_mm(const std::vector<RigidMotion>& a, const std::vector<RigidMotion>& b) const
  {
    double sum = 0, total = 0;
    for (std::size_t f = 0; f < m_points.size(); ++f)
      for (std::size_t i = 0; i < m_points[f].size(); ++i)
      {
        const Vec3& p = m_points[f][i];
        sum += m_areas[f][i] * (a[f].apply(p) - b[f].apply(p)).norm();
        total += m_areas[f][i];
      }
    return sum / total;
  }

private:
  std::vector<std::vector<Vec3>> m_points;
  std::vector<std::vector<double>> m_areas;
};

} // namespace f2b::verification
