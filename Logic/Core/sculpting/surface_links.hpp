#pragma once

#include "Core/geometry/vectors.hpp"

/// Which triangles meet at a vertex, and which vertices does it share an edge with?
namespace f2b
{

/// A run of indices; as long as the SurfaceLinks that it belongs to.
struct IndexRun
{
  const int* first;
  const int* last;
  const int* begin() const { return first; }
  const int* end() const { return last; }
};

/// Neighbourhoods of a triangulated surface whose triangles do not change.
class SurfaceLinks
{
public:
  /// \param triangles  outlive this object
  SurfaceLinks(std::size_t vertices, const std::vector<Triangle>& triangles);

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  std::size_t vertex_count() const { return m_triangle_start.size() - 1; }
  IndexRun triangles_of(int vertex) const { return run(m_triangle_start, m_triangle, vertex); }
  /// Each once, in ascending order.
  IndexRun neighbours_of(int vertex) const { return run(m_vertex_start, m_vertex, vertex); }

private:
  static IndexRun run(const std::vector<int>& start, const std::vector<int>& items, int vertex)
  {
    const auto v = static_cast<std::size_t>(vertex);
    return {items.data() + start[v], items.data() + start[v + 1]};
  }

  const std::vector<Triangle>& m_triangles;
  std::vector<int> m_triangle_start, m_triangle;
  std::vector<int> m_vertex_start, m_vertex;
};

} // namespace f2b
