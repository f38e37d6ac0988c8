#include "Bridge/grid_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/case_session.hpp"
#include "Meshing/isosurface.hpp"
#include "Meshing/self_crossings.hpp"

#include <nlohmann/json.hpp>

#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

/// Are the surfaces of a cut case closed, without crossings, and where the CT has them?
///
/// `check_surfaces CASE` prints JSON. Crossings are counted by CGAL with exact predicates. Distances
/// are those of surface points to the isosurface of the case's CT at the threshold, left out where
/// segmentation changed what the threshold says (holder, streaks, shut mouth and nostrils), with the
/// share that is left out.

namespace
{

using namespace f2b;
using nlohmann::json;

json topology(const TriangleMesh& mesh)
{
  const SurfaceCheck check = check_surface(to_polydata(mesh));
  return {{"triangles", mesh.triangles.size()},
          {"open_edges", check.open_edges},
          {"non_manifold_edges", check.non_manifold_edges},
          {"crossing_triangles", crossing_triangles(mesh).size()},
          {"components", check.components},
          {"volume_mm3", check.volume_mm3}};
}

/// Samples where the threshold and the segmentation disagree on what is inside.
class Changed
{
public:
  Changed(const ScalarGrid& hu, double threshold, const ScalarGrid& distance)
      : m_hu(hu), m_threshold(threshold), m_distance(distance)
  {
  }
  bool near(const Vec3& p) const
  {
    const Eigen::Vector3i middle =
        ((p - m_hu.origin) / m_hu.spacing).array().round().matrix().cast<int>();
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
        {
          const Eigen::Vector3i v = middle + Eigen::Vector3i(i, j, k);
          // the walls of the lattice are no anatomy
          if ((v.array() < 0).any() || (v.array() >= m_hu.size.array()).any())
            return true;
          const std::size_t s = m_hu.index(v.x(), v.y(), v.z());
          if ((m_hu.values[s] > m_threshold) != (m_distance.values[s] < 0))
            return true;
        }
    return false;
  }

private:
  const ScalarGrid& m_hu;
  double m_threshold;
  const ScalarGrid& m_distance;
};

json distances(const TriangleMesh& mesh, const ScalarGrid& hu, double threshold,
               const ScalarGrid& distance)
{
  SurfaceOptions raw;
  raw.smoothing_iterations = 0;
  ScalarGrid negative = hu; // inside is below the level
  for (float& v : negative.values)
    v = -v;
  const auto isosurface = watertight_isosurface(negative, -threshold, raw);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(isosurface);
  locator->BuildLocator();
  const Changed changed(hu, threshold, distance);
  std::vector<double> found;
  for (const Vec3& p : mesh.points)
  {
    if (changed.near(p))
      continue;
    double closest[3], squared = 0;
    vtkIdType cell = 0;
    int sub = 0;
    locator->FindClosestPoint(p.data(), closest, cell, sub, squared);
    found.push_back(std::sqrt(squared));
  }
  if (found.empty())
    return {{"points", 0}};
  std::sort(found.begin(), found.end());
  double sum = 0;
  for (const double d : found)
    sum += d;
  auto at = [&](double share)
  { return found[static_cast<std::size_t>(share * static_cast<double>(found.size() - 1))]; };
  return {{"points", found.size()},
          {"left_out_share", 1 - double(found.size()) / double(mesh.points.size())},
          {"mean_mm", sum / double(found.size())},
          {"p95_mm", at(0.95)},
          {"p99_mm", at(0.99)},
          {"max_mm", found.back()}};
}

json check(const Path& folder)
{
  const CaseSession session = CaseSession::open(folder);
  json told;
  auto mesh = [&](const std::string& name)
  { return to_triangle_mesh(read_surface(folder / name)); };
  const json segment = json::parse(std::ifstream(folder / "segment.json"));
  const ScalarGrid hu = read_scalar_grid(folder / "ct.nrrd");
  for (const std::string name : {"skin", "bone"})
  {
    const TriangleMesh surface = mesh(name + ".vtp");
    told[name] = topology(surface);
    told[name]["to_ct"] = distances(surface, hu, segment.at(name + "_threshold_hu").get<double>(),
                                    read_scalar_grid(folder / (name + "_distance.nrrd")));
  }
  if (!session.folder.has("cut.json"))
    return told;
  told["uncut_bone"] = topology(mesh("uncut_bone.vtp"));
  const json cut = json::parse(std::ifstream(folder / "cut.json"));
  for (const json& fragment : cut.at("fragments"))
  {
    const auto name = fragment.at("name").get<std::string>();
    told["fragments"][name] = topology(mesh("fragment_" + file_part(name) + ".vtp"));
  }
  told["imbalance"] = cut.at("imbalance");
  return told;
}

} // namespace

int main(int count, char** arguments)
try
{
  if (count != 2)
  {
    std::cerr << "usage: check_surfaces CASE\n";
    return 2;
  }
  std::cout << check(arguments[1]).dump(2) << '\n';
}
catch (const std::exception& error)
{
  std::cerr << error.what() << '\n';
  return 1;
}
