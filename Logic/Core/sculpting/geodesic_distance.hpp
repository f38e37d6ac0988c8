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
  void join_front();
  void open_bucket();
  void spread(const std::vector<Vec3>& points, int vertex);

  /// A triangle at a vertex, by its other two corners. An edge belongs to the triangle that it is
  /// the first of; at a rim, or where triangles disagree about their orientation, to both.
  struct Opposite
  {
    int next, previous;
    bool has_edge_to_previous;
  };

  const SurfaceLinks& m_links;
  std::vector<std::size_t> m_ring_start;
  std::vector<Opposite> m_ring; ///< vertex by vertex
  double m_limit_mm = 0;
  std::vector<double> m_distance;
  std::vector<State> m_state;
  std::vector<int> m_touched;
  std::vector<int> m_offered; ///< since the front has advanced; more than once if ever less
  /// Vertices that are farther than the bucket at hand, by distance: only that one is a heap. A
  /// vertex may be there more than once.
  std::vector<std::vector<NearVertex>> m_buckets;
  std::size_t m_bucket = 0;
  std::vector<NearVertex> m_front; ///< the heap
  std::vector<NearVertex> m_reached;
};

} // namespace f2b
