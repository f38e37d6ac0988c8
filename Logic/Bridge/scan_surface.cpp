#include "Bridge/scan_surface.hpp"

#include "Bridge/vtk_surface.hpp"

#include <vtkCleanPolyData.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <map>

namespace f2b
{
ScanSurface::ScanSurface(vtkPolyData* surface)
{
  // files such as .stl keep the corners of each triangle apart
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(surface);
  merged->ConvertPolysToLinesOff();
  merged->Update();
  m_surface = merged->GetOutput();
  m_surface->BuildCells();
  m_mesh = to_triangle_mesh(m_surface);
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : m_mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  for (const Triangle& t : m_mesh.triangles)
  {
    std::array<char, 3> border{};
    for (std::size_t i = 0; i < 3; ++i)
      border[i] = uses[std::minmax(t[i], t[(i + 1) % 3])] < 2;
    m_border.push_back(border);
  }
  m_locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  m_locator->SetDataSet(m_surface);
  m_locator->BuildLocator();
}

ScanSurface::Foot ScanSurface::nearest(const Vec3& point) const
{
  thread_local vtkSmartPointer<vtkGenericCell> cell = vtkSmartPointer<vtkGenericCell>::New();
  Foot foot{};
  vtkIdType triangle = -1;
  int sub = 0;
  double squared = 0;
  m_locator->FindClosestPoint(point.data(), foot.point.data(), cell, triangle, sub, squared);
  const Triangle& corners = m_mesh.triangles[static_cast<std::size_t>(triangle)];
  std::array<Vec3, 3> x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = m_mesh.points[static_cast<std::size_t>(corners[i])];
  const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]);
  foot.normal = n.norm() > 0 ? Vec3(n.normalized()) : Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vec3 edge = x[(i + 1) % 3] - x[i];
    const double height = n.norm() / std::max(edge.norm(), 1e-300); // of the triangle over it
    const double above = edge.cross(foot.point - x[i]).norm() / std::max(edge.norm(), 1e-300);
    if (m_border[static_cast<std::size_t>(triangle)][i] &&
        above < 1e-6 * height)
      foot.is_on_border = true;
  }
  return foot;
}

std::function<NearestTarget(std::size_t, const Vec3&)>
nearest_on_scan(std::shared_ptr<const ScanSurface> scan, const std::vector<Vec3>& rest)
{
  return [scan = std::move(scan), rest](std::size_t v, const Vec3& displacement)
  {
    const ScanSurface::Foot foot = scan->nearest(rest[v] + displacement);
    return NearestTarget{foot.point - rest[v], foot.normal};
  };
}

SkinTarget target_on_scan(const std::shared_ptr<const ScanSurface>& scan,
                          const std::vector<Vec3>& rest, const std::vector<Vec3>& normals,
                          double reach_mm)
{
  SkinTarget target;
  target.displacement.resize(rest.size());
  target.weight.resize(rest.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t v = 0; v < rest.size(); ++v)
  {
    const ScanSurface::Foot foot = scan->nearest(rest[v]);
    target.displacement[v] = foot.point - rest[v];
    const bool counts = target.displacement[v].norm() < reach_mm && !foot.is_on_border &&
                        std::abs(foot.normal.dot(normals[v])) > 0.5;
    target.weight[v] = counts ? 1 : 0;
  }
  target.nearest = nearest_on_scan(scan, rest);
  return target;
}

} // namespace f2b
