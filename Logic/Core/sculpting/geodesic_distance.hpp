#pragma once

#include "Core/sculpting/surface_links.hpp"
#include "Core/sculpting/surface_tree.hpp"

/// Which vertices are near a place if one walks along the surface, and how near?
namespace f2b
{

struct NearVertex
{
  int vertex;
  double distance; ///< along the surface [mm]
};

/// Distances along a surface from one place of it, as far as a limit.
///
/// A front runs outwards from vertex to vertex; within a triangle it is the circle about the source
/// laid into the triangle's plane, so flat surfaces are exact but for obtuse triangles. Reference:
/// R. Kimmel and J. Sethian, PNAS 95 (1998) 8431, with the circular front of
/// M. Novotni and R. Klein, WSCG (2002).
class GeodesicDistance
{
public:
  /// \param links  outlive this object
  explicit GeodesicDistance(const SurfaceLinks& links);

  /// Vertices within the limit, the nearest first. The result lives until the next call.
  const std::vector<NearVertex>& from(const std::vector<Vec3>& points, const SurfacePlace& source,
                                      double limit_mm);

private:
  enum class State : char
  {
    Far,
    Front,
    Final,
  };
  void offer(int vertex, double distance);
  void spread(const std::vector<Vec3>& points, int vertex);

  const SurfaceLinks& m_links;
  double m_limit_mm = 0;
  std::vector<double> m_distance;
  std::vector<State> m_state;
  std::vector<int> m_touched;
  std::vector<NearVertex> m_front; ///< a heap; a vertex may be in it more than once
  std::vector<NearVertex> m_reached;
};

} // namespace f2b
