#include "Core/assembly/dilatation_patches.hpp"
#include "Logic/Core/benchmark_blocks.hpp"
#include "Logic/Core/finite_differences.hpp"
#include "Logic/Core/loaded_body.hpp"

#include <Eigen/Eigenvalues>

#include <numeric>
#include <set>

namespace f2b
{
namespace
{

using namespace testing;

MaterialSet neo_hookean(double shear_modulus, double poisson_ratio)
{
  MaterialSet set;
  set.laws.fill(
      NeoHookean{{shear_modulus / 2},
                 {VolumetricLaw::Kind::Quadratic, bulk_from(shear_modulus, poisson_ratio)}});
  return set;
}

constexpr ElementScheme plain{SkinElement::Linear, Dilatation::PerPoint};
constexpr ElementScheme averaged{SkinElement::Linear, Dilatation::Averaged};

/// Cook's membrane in plane strain: 48 long, 44 high where it is held, 16 where 100 N per mm of
/// depth pull up (R. D. Cook, J. Struct. Div. ASCE 100 (1974) 1851).
class Cook
{
public:
  explicit Cook(int n) : m_block{n, n, 1}, m_mesh(tet_block(m_block, Place{48.0 / n})) {}

  MixedMesh& mesh() { return m_mesh; }
  /// Upward movement of the upper free corner [mm], or NaN.
  double tip(ElementScheme scheme, double poisson_ratio = 0.499, double force = 100) const
  {
    const Discretization tissue(m_mesh, scheme);
    const MaterialSet materials = neo_hookean(80.1938, poisson_ratio);
    std::vector<char> held(m_mesh.X.size());
    std::transform(m_mesh.X.begin(), m_mesh.X.end(), held.begin(),
                   [](const Vec3& X) { return X.x() == 0; });
    ElasticModel model(tissue, materials, held);
    LoadedBody body(model);
    for (int node = 0; node < m_mesh.node_count(); ++node)
      body.hold(node, 2);
    const int n = m_block.nx;
    const double share = 0.5 * force * (48.0 / n) / n;
    for (int j = 0; j <= n; ++j)
      for (const int k : {0, 1})
        body.load(m_block.id(n, j, k), {0, j == 0 || j == n ? share / 2 : share, 0});
    std::vector<Vec3> x = m_mesh.X;
    EXPECT_GT(body.solve(x, 5), 0) << "Newton's method failed";
    EXPECT_GT(model.smallest_dilatation(x), 0);
    return x[std::size_t(m_block.id(n, n, 0))].y() - 60;
  }

private:
  struct Place
  {
    double depth;
    Vec3 operator()(double r, double s, double t) const
    {
      return {48 * r, 44 * r + s * (44 - 28 * r), depth * t};
    }
  };
  Block m_block;
  MixedMesh m_mesh;
};

/// Converged: CalculiX 2.20, same law, 8, 16 and 32 quadratic bricks (C3D20R) a side give 6.743,
/// 6.853 and 6.898 mm, which go to 6.93.
constexpr double cook_converged_mm = 6.93;

TEST(Locking, CooksMembraneOfTetrahedra)
{
  double plain_tip = 0, cured_tip = 0;
  for (const int n : {8, 16, 32})
  {
    const Cook cook(n);
    plain_tip = cook.tip(plain);
    cured_tip = cook.tip(averaged);
    std::printf("Cook's membrane, nu 0.499, %2d cells a side: plain %.3f mm, averaged %.3f mm of "
                "%.2f mm\n",
                n, plain_tip, cured_tip, cook_converged_mm);
  }
  EXPECT_NEAR(cured_tip, cook_converged_mm, 0.05 * cook_converged_mm);
  EXPECT_LT(plain_tip, 0.6 * cook_converged_mm);
}

/// End of a cantilever of one layer of prisms, 40 x 20 x 4 mm, under 0.05 N across it [mm].
double plate_tip(int n, ElementScheme scheme)
{
  const Block block{n, n / 2, 1};
  const MixedMesh mesh =
      prism_block(block, [](double r, double s, double t) { return Vec3(40 * r, 20 * s, 4 * t); });
  const Discretization tissue(mesh, scheme);
  const MaterialSet materials = neo_hookean(1, 0.499);
  std::vector<char> held(mesh.X.size());
  std::transform(mesh.X.begin(), mesh.X.end(), held.begin(),
                 [](const Vec3& X) { return X.x() == 0; });
  ElasticModel model(tissue, materials, tissue.control_flags(held));
  LoadedBody body(model);
  const double share = 0.05 / block.ny / 2;
  for (int j = 0; j <= block.ny; ++j)
    for (const int k : {0, 1})
      body.load(block.id(n, j, k), {0, 0, j == 0 || j == block.ny ? share / 2 : share});
  std::vector<Vec3> x = tissue.rest();
  EXPECT_GT(body.solve(x, 2), 0) << "Newton's method failed";
  return x[std::size_t(block.id(n, n / 4, 0))].z();
}

/// CalculiX 2.20, same law, 8 x 4 x 2, 16 x 8 x 2 and 16 x 8 x 4 quadratic bricks (C3D20R) give
/// 2.809, 2.944 and 2.951 mm.
TEST(Locking, OneLayerOfPrismsBends)
{
  constexpr double converged_mm = 2.95;
  constexpr ElementScheme smooth{SkinElement::Smooth, Dilatation::PerPoint};
  constexpr ElementScheme smooth_averaged{SkinElement::Smooth, Dilatation::Averaged};
  double of_plain = 0, cured = 0, cured_smooth = 0;
  for (const int n : {8, 16, 32})
  {
    of_plain = plate_tip(n, plain);
    cured = plate_tip(n, averaged);
    cured_smooth = plate_tip(n, smooth_averaged);
    std::printf("plate, nu 0.499, %2d cells long: linear face plain %.3f mm, averaged %.3f mm; "
                "smooth face plain %.3f mm, averaged %.3f mm; of %.2f mm\n",
                n, of_plain, cured, plate_tip(n, smooth), cured_smooth, converged_mm);
  }
  EXPECT_NEAR(cured, converged_mm, 0.05 * converged_mm);
  EXPECT_NEAR(cured_smooth, converged_mm, 0.05 * converged_mm);
  EXPECT_LT(of_plain, 0.6 * converged_mm);
}

TEST(Locking, TheCureChangesLittleWhereNothingLocks)
{
  const Cook cook(16);
  const double of_plain = cook.tip(plain, 0.42), of_cured = cook.tip(averaged, 0.42);
  const double fine = Cook(32).tip(plain, 0.42);
  std::printf(
      "Cook's membrane, nu 0.42: plain %.3f mm, averaged %.3f mm, plain and finer %.3f mm\n",
      of_plain, of_cured, fine);
  EXPECT_GT(of_cured, of_plain);
  EXPECT_LT(of_cured, 1.05 * fine);
}

TEST(Locking, TheResultHardlyDependsOnThePatches)
{
  Cook cook(16);
  const double tip = cook.tip(averaged);
  for (const int size : {4, 8, 12})
  {
    ElementScheme other = averaged;
    other.patch_tets = size;
    const double other_tip = cook.tip(other);
    std::printf("patches of about %2d tetrahedra: %.3f mm\n", size, other_tip);
    EXPECT_NEAR(other_tip, tip, 0.025 * tip);
  }
  // the order of the mesh says nothing
  std::mt19937 generator(5);
  std::shuffle(cook.mesh().tets.begin(), cook.mesh().tets.end(), generator);
  EXPECT_NEAR(cook.tip(averaged), tip, 1e-9 * tip);
}

TEST(Locking, LargeDeformationConverges)
{
  const double tip = Cook(8).tip(averaged, 0.499, 400);
  std::printf("Cook's membrane under four times the load: %.2f mm\n", tip);
  EXPECT_GT(tip, 12);
}

/// A free body has six motions without stiffness, and no others.
TEST(Locking, NoModeIsWithoutStiffness)
{
  const MixedMesh mesh =
      tet_block({3, 3, 3}, [](double r, double s, double t) { return Vec3(9 * r, 9 * s, 9 * t); });
  const MaterialSet materials = neo_hookean(0.02, 0.499);
  std::array<double, 2> seventh{};
  for (const ElementScheme scheme : {plain, averaged})
  {
    const Discretization tissue(mesh, scheme);
    ElasticModel model(tissue, materials, std::vector<char>(mesh.X.size(), 0));
    (void)model.linearize(mesh.X);
    Eigen::MatrixXd K(model.unknown_count(), model.unknown_count());
    for (Eigen::Index c = 0; c < K.cols(); ++c)
      K.col(c) = product(model.stiffness(), Eigen::VectorXd::Unit(K.cols(), c));
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    EXPECT_LT(std::abs(values[5]), 1e-12 * values[values.size() - 1]);
    seventh[scheme.dilatation == Dilatation::Averaged] = values[6];
  }
  std::printf("softest deformation: plain %.3e N/mm, averaged %.3e N/mm\n", seventh[0], seventh[1]);
  EXPECT_GT(seventh[1], 0.1 * seventh[0]);
}

TEST(DilatationPatches, CoverEveryTetrahedronOnceInConnectedPieces)
{
  const MixedMesh mesh =
      tet_block({9, 8, 7}, [](double r, double s, double t) { return Vec3(9 * r, 8 * s, 7 * t); });
  for (const int size : {4, 5, 8})
  {
    const DilatationPatches patches = make_dilatation_patches(mesh.tets, size);
    std::vector<int> members = patches.tets;
    std::sort(members.begin(), members.end());
    std::vector<int> all(mesh.tets.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(members, all);
    int largest = 0, smallest = size;
    for (int p = 0; p < patches.count(); ++p)
    {
      std::vector<Tet> tets;
      for (int i = patches.start[std::size_t(p)]; i < patches.start[std::size_t(p) + 1]; ++i)
        tets.push_back(mesh.tets[std::size_t(patches.tets[std::size_t(i)])]);
      for (const int component : tet_components(tets))
        EXPECT_EQ(component, 0);
      largest = std::max(largest, patches.size(p));
      smallest = std::min(smallest, patches.size(p));
    }
    std::printf("%d patches of %d to %d tetrahedra, %.2f in the mean\n", patches.count(), smallest,
                largest, double(mesh.tets.size()) / patches.count());
    EXPECT_GE(2 * smallest, size);
    EXPECT_LE(largest, 2 * size);
    EXPECT_GT(double(mesh.tets.size()) / patches.count(), 0.9 * size);
  }
}

TEST(DilatationPatches, APieceThatIsSmallStaysAlone)
{
  MixedMesh mesh = tet_block({2, 2, 2}, [](double r, double s, double t) { return Vec3(r, s, t); });
  const int first = mesh.node_count();
  mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  const DilatationPatches patches = make_dilatation_patches(mesh.tets, 8);
  std::multiset<int> sizes;
  for (int p = 0; p < patches.count(); ++p)
    sizes.insert(patches.size(p));
  EXPECT_EQ(sizes.count(1), 1u);
  EXPECT_GE(*std::next(sizes.begin()), 4);
}

} // namespace
} // namespace f2b
