#include "Case/plan_target.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/scan_surface.hpp"
#include "Core/error.hpp"
#include "Core/inverse/skin_error.hpp"

namespace f2b
{

PlanTarget::PlanTarget(const CaseSession& session, const LoadedFace& face)
    : m_rest(face.reference_skin.points)
{
  const auto surface = read_surface(session.folder.require("target.vtp", "target"));
  m_skin.displacement = point_vectors(surface, "displacement");
  m_skin.weight = point_scalars(surface, "weight");
  if (m_skin.weight.size() != m_rest.size())
    throw Error("target.vtp", "it does not belong to this reference skin",
                "run 'facetobone target' again");
  m_skin.registration_sd_mm = session.settings.target.registration_sd_mm;
  const TriangleMesh target = to_triangle_mesh(surface);
  m_normals = vertex_normals(target);
  if (read_json(session.folder.require("target.json", "target")).at("kind") == "scan")
  {
    const auto scan = std::make_shared<const ScanSurface>(
        read_surface(session.folder.require(target_scan_name, "target")));
    m_skin.nearest = nearest_on_scan(scan, m_rest);
  }
  require_overlap(face);
}

void PlanTarget::require_overlap(const LoadedFace& face) const
{
  for (std::size_t v = 0; v < m_rest.size(); ++v)
    if (m_skin.weight[v] > 0 && face.skin_area[v] > 0)
      return;
  throw Error("target", "no weighted part of it lies on the meshed face",
              "widen the target's mask (target.mask_mm) or the region of interest");
}

SkinTarget PlanTarget::for_vertices(const std::vector<Vec3>& skin_displacement) const
{
  SkinTarget target{m_skin.displacement, m_skin.weight, {}};
  if (!m_skin.nearest)
    return target;
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t v = 0; v < skin_displacement.size(); ++v)
    target.displacement[v] = m_skin.nearest(v, skin_displacement[v]).displacement;
  return target;
}

std::vector<double> PlanTarget::signed_distances(const std::vector<Vec3>& skin_displacement) const
{
  const SkinTarget target = for_vertices(skin_displacement);
  std::vector<Vec3> face = m_rest, wanted = m_rest;
  for (std::size_t v = 0; v < face.size(); ++v)
  {
    face[v] += skin_displacement[v];
    wanted[v] += target.displacement[v];
  }
  // the scan's triangles may face either way; those of the reference skin face outwards
  return f2b::signed_distances(face, wanted, m_normals);
}

} // namespace f2b
