#include "Core/sculpting/surface_links.hpp"

#include <algorithm>

namespace f2b
{

SurfaceLinks::SurfaceLinks(std::size_t vertices, const std::vector<Triangle>& triangles)
    : m_triangles(triangles), m_triangle_start(vertices + 1, 0)
{
  for (const Triangle& t : triangles)
    for (const int v : t)
      ++m_triangle_start[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 0; v < vertices; ++v)
    m_triangle_start[v + 1] += m_triangle_start[v];
  m_triangle.resize(3 * triangles.size());
  std::vector<int> next(m_triangle_start.begin(), m_triangle_start.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int v : triangles[t])
      m_triangle[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] =
          static_cast<int>(t);

  m_vertex_start.reserve(vertices + 1);
  m_vertex_start.push_back(0);
  std::vector<int> around;
  for (std::size_t v = 0; v < vertices; ++v)
  {
    around.clear();
    for (const int t : triangles_of(static_cast<int>(v)))
      for (const int other : triangles[static_cast<std::size_t>(t)])
        if (other != static_cast<int>(v))
          around.push_back(other);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    m_vertex.insert(m_vertex.end(), around.begin(), around.end());
    m_vertex_start.push_back(static_cast<int>(m_vertex.size()));
  }
}

} // namespace f2b
