#include "Meshing/shell_mesh.hpp"

#include "Core/error.hpp"
#include "Meshing/shell_sheet.hpp"
#include "Meshing/tetrahedral_domain.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace f2b
{

namespace
{

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Edge length of the skin's facets at density 1 [mm].
constexpr double edge_at_density_1 = 3.0;
/// Dihedral angle below which no node is moved for the sake of prisms [degrees].
constexpr double least_dihedral_deg = 10.0;

/// Prisms below this are reported one by one.
constexpr double least_scaled_jacobian = 0.1;

double edge_mm(const ShellMeshOptions& options)
{
  return edge_at_density_1 * std::cbrt(1.0 / options.density);
}

/// How far from a wall the rim of the skin may end: the sheet ends with whole facets.
double wall_band_mm(const ShellMeshOptions& options)
{
  return 1.5 * edge_mm(options);
}

/// Sizes at density 1 [mm]: those that gave about 11k prisms on 110k tetrahedra on a face.
TetrahedralDomain sized_domain(const ShellDomain& domain, const ShellMeshOptions& options)
{
  const double edge = edge_mm(options);
  // A wall is only there to be held: its facets and its sharp edges may be coarse.
  const auto on_wall = [&domain](const Vec3& p)
  { return domain.wall_level(p) > -0.5 && domain.skin(p) < -domain.zeta(p) - 2.0; };
  TetrahedralDomain result;
  result.level = [&domain](const Vec3& p) { return domain.level(p); };
  result.lo = domain.box().lo - Vec3::Constant(8.0);
  result.hi = domain.box().hi + Vec3::Constant(8.0);
  result.facet_size = [=](const Vec3& p) { return edge * (on_wall(p) ? 1.6 : 1.0); };
  result.facet_distance = [=, &domain](const Vec3& p)
  { return domain.wall_level(p) > -1.0 ? 0.4 * edge : 0.11 * edge; };
  result.cell_size = [=](const Vec3&) { return 1.08 * edge; };
  result.sliver_bound_deg = options.sliver_bound_deg;
  return result;
}

/// Prisms at the rim that are not good enough: the sheet may end before them.
std::vector<int> bad_rim_prisms(const ShellSheet& sheet, double required)
{
  std::vector<int> result;
  const std::vector<double> quality = prism_qualities(sheet.prisms);
  for (int t = 0; t < static_cast<int>(quality.size()); ++t)
  {
    const Triangle& n = sheet.prisms.triangles[t];
    if (quality[t] < required && (sheet.rim[n[0]] || sheet.rim[n[1]] || sheet.rim[n[2]]))
      result.push_back(t);
  }
  return result;
}

/// The sheet with its tops; facets at the rim that carry no good prism are given to the walls.
ShellSheet grown_sheet(TetrahedralMesh& tetrahedra, ShellFacets& facets, const ShellDomain& domain,
                       const ShellMeshOptions& options)
{
  const double snap = 0.6 * edge_mm(options);
  TetStars stars(tetrahedra);
  for (int pass = 0;; ++pass)
  {
    if (facets.skin.empty())
      throw Error("region of interest", "it holds no skin", "move it over the face");
    ShellSheet sheet = shell_sheet(stars, facets, domain, snap, least_dihedral_deg);
    place_tops(sheet.prisms, domain, options.prisms,
               [&](int node, const Vec3& p)
               { return stars.move(sheet.tet_node[node], p, least_dihedral_deg); });
    const std::vector<int> bad = bad_rim_prisms(sheet, options.prisms.required_jacobian);
    if (bad.empty() || pass == 8)
      return sheet;
    drop_from_sheet(facets, bad);
  }
}

MixedMesh assembled(const TetrahedralMesh& tetrahedra, const ShellSheet& sheet)
{
  MixedMesh mesh;
  mesh.X = tetrahedra.X;
  mesh.tets = tetrahedra.tets;
  const int first_top = mesh.node_count();
  mesh.X.insert(mesh.X.end(), sheet.prisms.top.begin(), sheet.prisms.top.end());
  for (const Triangle& n : sheet.prisms.triangles)
    mesh.prisms.push_back({first_top + n[0], first_top + n[1], first_top + n[2],
                           sheet.tet_node[n[0]], sheet.tet_node[n[1]], sheet.tet_node[n[2]]});
  mesh.node_fragment.assign(mesh.X.size(), -1);
  return mesh;
}

/// Is there bone within the tolerance at an inner node, or above it where the floor of the least
/// depth replaced bone that is nearer to the skin?
bool touches_bone(const Vec3& p, const ShellDomain& domain, double tolerance)
{
  const ScalarGrid& bone = domain.fields().bone;
  if (bone.value(p) <= tolerance)
    return true;
  const bool on_floor = domain.fields().closed_bone.value(p) < -0.5;
  const Vec3 outwards = domain.fields().skin.gradient(p).normalized();
  for (double height = 0.5; on_floor && height < -domain.skin(p); height += 0.5)
    if (bone.value(p + height * outwards) <= tolerance)
      return true;
  return false;
}

std::vector<Boundary> node_boundary(const TetrahedralMesh& tetrahedra, const ShellFacets& facets,
                                    const ShellSheet& sheet, const ShellDomain& domain,
                                    const ShellMeshOptions& options)
{
  constexpr double wall_tolerance = 0.05;
  std::vector<Boundary> result(tetrahedra.X.size(), Boundary::Interior);
  for (const Triangle& facet : facets.rest)
    for (const int node : facet)
    {
      const Vec3& p = tetrahedra.X[node];
      if (domain.wall_level(p) > -wall_tolerance)
        result[node] = Boundary::Crop;
      else
        result[node] = touches_bone(p, domain, options.contact_tolerance_mm) ? Boundary::FixedBone
                                                                             : Boundary::Free;
    }
  for (std::size_t i = 0; i < sheet.tet_node.size(); ++i)
  {
    const bool crop =
        sheet.rim[i] && domain.wall_level(sheet.prisms.bottom[i]) > -wall_band_mm(options);
    result[sheet.tet_node[i]] = crop ? Boundary::Crop : Boundary::Interior;
  }
  for (const int node : sheet.tet_node)
    result.push_back(result[node] == Boundary::Crop ? Boundary::Crop : Boundary::Skin);
  return result;
}

/// From samples that are not bone; muscle, the stiffer, where all are. Values below fat's are held
/// at fat's, so that filled airway counts as fat.
Tissue tissue_of(const std::array<Vec3, 4>& x, const ScalarGrid& hu, double fat_below_hu)
{
  constexpr double least_hu = -100.0, bone_hu = 200.0;
  const Vec3 centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  double sum = 0.0;
  int count = 0;
  const auto add = [&](const Vec3& p)
  {
    const double value = hu.value(p);
    if (value > bone_hu)
      return;
    sum += std::max(value, least_hu);
    ++count;
  };
  add(centre);
  for (const Vec3& corner : x)
    add(0.5 * (centre + corner));
  return count > 0 && sum / count < fat_below_hu ? Tissue::Fat : Tissue::Muscle;
}

void assign_tissue(MixedMesh& mesh, const ScalarGrid& hu, const ShellMeshOptions& options)
{
  for (const Tet& n : mesh.tets)
    mesh.tet_tissue.push_back(tissue_of({mesh.X[n[0]], mesh.X[n[1]], mesh.X[n[2]], mesh.X[n[3]]},
                                        hu, options.fat_below_hu));
}

void report_holes(ShellMeshReport& report, const MixedMesh& mesh, const ShellDomain& domain,
                  double wall_band)
{
  for (const auto& loop : boundary_loops(boundary_facets(mesh).skin))
  {
    double deepest = 0.0;
    Vec3 where = Vec3::Zero();
    for (const int node : loop)
      if (domain.wall_level(mesh.X[node]) < deepest)
      {
        deepest = domain.wall_level(mesh.X[node]);
        where = mesh.X[node];
      }
    if (deepest > -wall_band)
      continue;
    ++report.holes;
    report.remarks.push_back(
        {"hole in the skin, " + std::to_string(loop.size()) + " edges", where});
  }
}

void report_tops(ShellMeshReport& report, const MixedMesh& mesh, const ShellDomain& domain)
{
  for (int node = 0; node < mesh.node_count(); ++node)
    if (mesh.node_boundary[node] == Boundary::Skin && std::abs(domain.skin(mesh.X[node])) > 0.1)
    {
      ++report.tops_off_skin;
      report.remarks.push_back(
          {"top node off the skin by " + std::to_string(domain.skin(mesh.X[node])) + " mm",
           mesh.X[node]});
    }
}

void report_bad_prisms(ShellMeshReport& report, const MixedMesh& mesh, double required)
{
  for (int prism = 0; prism < report.prisms; ++prism)
  {
    const double scaled = min_scaled_jacobian(prism_corners(mesh, prism));
    if (scaled >= required)
      continue;
    ++report.bad_prisms;
    report.remarks.push_back(
        {"prism with scaled Jacobian " + std::to_string(scaled), mesh.X[mesh.prisms[prism][0]]});
  }
}

void report_left_out(ShellMeshReport& report)
{
  for (const LeftOut& place : report.fidelity.left_out)
    report.remarks.push_back(
        {"the CT's skin is " + std::to_string(place.distance) + " mm away from the mesh",
         place.place});
}

void report_topology(ShellMeshReport& report, const MixedMesh& mesh)
{
  const std::vector<int> nodes = non_manifold_nodes(tet_boundary(mesh.tets));
  report.non_manifold_nodes = static_cast<int>(nodes.size());
  for (const int node : nodes)
    report.remarks.push_back({"parts touch in a node or edge only", mesh.X[node]});
}

void measure(ShellMeshReport& report, const MixedMesh& mesh, const ShellDomain& domain,
             const ShellMeshOptions& options)
{
  report.prisms = static_cast<int>(mesh.prisms.size());
  report.tets = static_cast<int>(mesh.tets.size());
  report.nodes = mesh.node_count();
  report.quality = measure_quality(mesh);
  report.mesh_volume = report.quality.volume();
  report.label_volume = domain.label_volume();
  report.fidelity = skin_fidelity(mesh, domain, options.wall_margin_mm);
  report_bad_prisms(report, mesh, least_scaled_jacobian);
  report_left_out(report);
  report_topology(report, mesh);
  report_holes(report, mesh, domain, wall_band_mm(options));
  report_tops(report, mesh, domain);
}

} // namespace

ShellMesh build_shell_mesh(const ShellFields& fields, const ShellMeshOptions& options,
                           const Progress& progress)
{
  const auto start = Clock::now();
  const ShellDomain domain(fields, options.region, options.zeta, options.least_depth);
  progress("tetrahedra", 0.0);
  TetrahedralMesh tetrahedra = mesh_domain(sized_domain(domain, options));
  if (tetrahedra.tets.empty())
    throw Error("region of interest", "it holds no soft tissue between skin and bone",
                "move it over the face or mend the thresholds");
  ShellMesh result;
  ShellMeshReport& report = result.report;
  report.dropped_tets = keep_largest_component(tetrahedra);
  report.split_nodes = split_pinched_nodes(tetrahedra);
  report.mesh_seconds = seconds_since(start);

  progress("skin prisms", 0.6);
  const auto prism_start = Clock::now();
  ShellFacets facets = shell_facets(tetrahedra, domain, edge_mm(options));
  const ShellSheet sheet = grown_sheet(tetrahedra, facets, domain, options);
  report.stray_facets = facets.stray;
  report.prism_seconds = seconds_since(prism_start);

  MixedMesh& mesh = result.mesh;
  mesh = assembled(tetrahedra, sheet);
  mesh.node_boundary = node_boundary(tetrahedra, facets, sheet, domain, options);
  assign_tissue(mesh, fields.hu, options);

  progress("mesh quality", 0.8);
  measure(report, mesh, domain, options);
  report.total_seconds = seconds_since(start);
  progress("mesh quality", 1.0);
  return result;
}

} // namespace f2b
