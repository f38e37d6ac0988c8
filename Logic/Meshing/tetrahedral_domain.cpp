#include "Meshing/tetrahedral_domain.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <map>

namespace f2b
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
namespace parameters = CGAL::parameters;

/// Points of the domain's surface are located to this distance [mm].
constexpr double surface_tolerance = 1e-3;

Vec3 to_vec3(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

/// A size that varies in space, as CGAL's mesh criteria want it.
struct SizeField
{
  using FT = Kernel::FT;
  using Point_3 = Kernel::Point_3;
  using Index = Domain::Index;

  FT operator()(const Point_3& p, int, const Index&) const { return (*field)(to_vec3(p)); }

  const ScalarField* field;
};

/// Where the level changes sign between two points.
Vec3 zero_between(const ScalarField& level, Vec3 a, Vec3 b)
{
  const bool a_inside = level(a) < 0.0;
  while ((b - a).norm() > surface_tolerance)
  {
    const Vec3 middle = 0.5 * (a + b);
    ((level(middle) < 0.0) == a_inside ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

/// Surface points on a coarse lattice of lines along the three axes. CGAL's own start looks along
/// rays from the box's centre, which lies in the bone: it would find nothing.
std::vector<Vec3> seed_points(const TetrahedralDomain& domain)
{
  std::vector<Vec3> seeds;
  const double step = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (double pu = domain.lo[u]; pu < domain.hi[u]; pu += domain.seed_spacing)
      for (double pv = domain.lo[v]; pv < domain.hi[v]; pv += domain.seed_spacing)
      {
        Vec3 previous;
        previous[u] = pu;
        previous[v] = pv;
        previous[axis] = domain.lo[axis];
        bool was_inside = domain.level(previous) < 0.0;
        for (Vec3 p = previous; p[axis] < domain.hi[axis]; previous = p)
        {
          p[axis] += step;
          const bool inside = domain.level(p) < 0.0;
          if (inside != was_inside)
            seeds.push_back(zero_between(domain.level, previous, p));
          was_inside = inside;
        }
      }
  }
  return seeds;
}

/// Leaves out seeds that are nearer to an earlier one than the distance: they would force facets
/// far smaller than asked for.
std::vector<Vec3> thinned(const std::vector<Vec3>& seeds, double distance)
{
  std::vector<Vec3> kept;
  for (const Vec3& seed : seeds)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Vec3& other)
                     { return (other - seed).squaredNorm() < distance * distance; }))
      kept.push_back(seed);
  return kept;
}

void insert_seeds(Complex& complex, const Domain& cgal_domain, const std::vector<Vec3>& seeds)
{
  const Domain::Surface_patch_index surface(0, 1);
  for (const Vec3& seed : seeds)
  {
    const Kernel::Point_3 point(seed.x(), seed.y(), seed.z());
    const auto vertex = complex.triangulation().insert(Triangulation::Weighted_point(point));
    if (vertex == Complex::Vertex_handle())
      continue;
    complex.set_dimension(vertex, 2);
    complex.set_index(vertex, cgal_domain.index_from_surface_patch_index(surface));
  }
}

TetrahedralMesh extract(const Complex& complex)
{
  TetrahedralMesh mesh;
  std::map<std::size_t, int> index_of_stamp;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    Tet tet{};
    for (int i = 0; i < 4; ++i)
    {
      const auto vertex = cell->vertex(i);
      const int next = static_cast<int>(mesh.X.size());
      const auto [known, is_new] = index_of_stamp.emplace(vertex->time_stamp(), next);
      if (is_new)
        mesh.X.push_back(to_vec3(vertex->point().point()));
      tet[i] = known->second;
    }
    mesh.tets.push_back(tet);
  }
  return mesh;
}

} // namespace

TetrahedralMesh mesh_domain(const TetrahedralDomain& domain)
{
  const std::vector<Vec3> seeds = thinned(seed_points(domain), 0.5 * domain.seed_spacing);
  if (seeds.empty())
    return {};

  const CGAL::Bbox_3 box(domain.lo.x(), domain.lo.y(), domain.lo.z(), domain.hi.x(), domain.hi.y(),
                         domain.hi.z());
  const auto label = [&](const Kernel::Point_3& p)
  { return domain.level(to_vec3(p)) < 0.0 ? 1 : 0; };
  const double relative_error = surface_tolerance / (domain.hi - domain.lo).norm();
  const Domain cgal_domain(parameters::function = label, parameters::bounding_object = box,
                           parameters::relative_error_bound = relative_error);
  const Criteria criteria(parameters::facet_angle = domain.facet_angle_deg,
                          parameters::facet_size = SizeField{&domain.facet_size},
                          parameters::facet_distance = SizeField{&domain.facet_distance},
                          parameters::cell_radius_edge_ratio = domain.radius_edge_ratio,
                          parameters::cell_size = SizeField{&domain.cell_size});

  Complex complex;
  insert_seeds(complex, cgal_domain, seeds);
  CGAL::refine_mesh_3(complex, cgal_domain, criteria, parameters::no_perturb(),
                      parameters::no_exude(), parameters::manifold());
  // No time limit: a clock would make the mesh depend on the machine's load.
  CGAL::perturb_mesh_3(complex, cgal_domain, parameters::time_limit = 0,
                       parameters::sliver_bound = domain.sliver_bound_deg);
  return extract(complex);
}

} // namespace f2b
