#include "Core/mesh/split_prisms.hpp"
#include "Core/models/face_models.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

namespace f2b
{
namespace
{

using namespace testing;

constexpr double degree = 3.14159265358979323846 / 180;

/// Three tissues of Table 1's stiffness and compressibility.
MaterialSet face_tissues()
{
  auto law = [](double c1, double c2, double nu) {
    return Yeoh{{c1, c2, 0}, {VolumetricLaw::Kind::Barrier, bulk_from(2 * c1, nu)}};
  };
  MaterialSet set;
  set.name = "three tissues";
  set.laws = {law(0.048, 0.052, 0.49), law(0.019, 0.054, 0.49), law(0.027, 0.026, 0.30)};
  return set;
}

struct Slab
{
  explicit Slab(const SlabOptions& options = {8, 2, 80, 14, 1.5, 4, 0.5})
      : mesh(make_slab(options)), materials(face_tissues()), skin(corner_map(mesh))
  {
  }
  FaceModelResult predict(FaceModelKind model, double share = 1,
                          const FaceModelOptions& options = {}) const
  {
    RigidMotion motion;
    motion.translation = share * Vec3(2, -5, 3);
    motion.rotation = rotation_from({share * 5 * degree, share * 2.5 * degree, 0});
    return predict_with(model, {mesh, materials, {motion}}, skin, options, no_progress);
  }
  MixedMesh mesh;
  MaterialSet materials;
  SkinMap skin;
};

/// RMS of a - b relative to the largest of b.
double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]).squaredNorm();
    largest = std::max(largest, b[i].norm());
  }
  return std::sqrt(sum / double(a.size())) / largest;
}

std::vector<Vec3> displacement(const Slab& slab, const FaceModelResult& result)
{
  std::vector<Vec3> u = result.x;
  for (std::size_t n = 0; n < u.size(); ++n)
    u[n] -= slab.mesh.X[n];
  return u;
}

TEST(MassTensors, ForcesAreThoseOfTheLinearElasticModel)
{
  const Slab slab({4, 2, 40, 12, 1.5, 3, 0.4});
  const MixedMesh tets = split_prisms(slab.mesh);
  const MassTensors tensors(tets, slab.materials);
  MaterialSet linear;
  for (std::size_t t = 0; t < linear.laws.size(); ++t)
    linear.laws[t] =
        LinearElastic{shear_modulus(slab.materials.laws[t]), bulk_modulus(slab.materials.laws[t])};
  const Discretization tissue(tets);
  ElasticModel model(tissue, linear, std::vector<char>(tets.X.size(), 0));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shift(-1, 1);
  std::vector<Vec3> u(tets.X.size()), x = tets.X, f;
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    u[n] = Vec3(shift(generator), shift(generator), shift(generator));
    x[n] += u[n];
  }
  tensors.forces(u, f);
  const Eigen::VectorXd expected = model.forces(x);
  ASSERT_EQ(expected.size(), Eigen::Index(3 * f.size()));
  for (std::size_t n = 0; n < f.size(); ++n)
    EXPECT_LT((f[n] - expected.segment<3>(3 * Eigen::Index(n))).norm(), 1e-11 * expected.norm());
}

TEST(MassTensors, RigidTranslationCostsNothing)
{
  const Slab slab({4, 2, 40, 12, 1.5, 3, 0.4});
  const MixedMesh tets = split_prisms(slab.mesh);
  std::vector<Vec3> f;
  MassTensors(tets, slab.materials).forces(std::vector<Vec3>(tets.X.size(), Vec3(1, 2, 3)), f);
  for (const Vec3& force : f)
    EXPECT_LT(force.norm(), 1e-12);
}

TEST(FaceModels, MassTensorsComeToRestWhereTheLinearElementsAre)
{
  const Slab slab;
  const FaceModelResult lfem = slab.predict(FaceModelKind::Lfem);
  const FaceModelResult mtm = slab.predict(FaceModelKind::Mtm);
  ASSERT_TRUE(mtm.relaxation.converged);
  const double nodes = distance(displacement(slab, mtm), displacement(slab, lfem));
  const double skin = distance(mtm.skin_displacement, lfem.skin_displacement);
  std::printf("mtm against lfem: %.2e of the largest displacement (skin %.2e), %d steps of %.4f s, "
              "residual %.1e\n",
              nodes, skin, mtm.relaxation.steps, mtm.relaxation.time_step, mtm.relaxation.residual);
  EXPECT_LT(nodes, 1e-3);
  EXPECT_LT(skin, 1e-3);
}

TEST(FaceModels, RelaxationIsTheSameForEveryNumberOfThreads)
{
  const Slab slab;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const FaceModelResult alone = slab.predict(FaceModelKind::Mtm);
  omp_set_num_threads(3);
  const FaceModelResult three = slab.predict(FaceModelKind::Mtm);
  omp_set_num_threads(threads);
  EXPECT_EQ(alone.x, three.x);
  EXPECT_EQ(alone.relaxation.steps, three.relaxation.steps);
}

TEST(FaceModels, RelaxationSaysWhenItDidNotComeToRestAndCanBeStopped)
{
  const Slab slab;
  FaceModelOptions options;
  options.relaxation.max_steps = 40;
  const FaceModelResult cut_off = slab.predict(FaceModelKind::Mtm, 1, options);
  EXPECT_FALSE(cut_off.relaxation.converged);
  EXPECT_EQ(cut_off.relaxation.steps, 40);
  EXPECT_GT(cut_off.relaxation.residual, options.relaxation.tolerance);
  struct Stopped
  {
  };
  int told = 0;
  EXPECT_THROW(
      predict_with(
          FaceModelKind::Mtm,
          {slab.mesh, slab.materials, {RigidMotion{Mat3::Identity(), Vec3(1, 0, 0), Vec3::Zero()}}},
          slab.skin, {},
          [&](std::string_view, double fraction)
          {
            EXPECT_GE(fraction, 0);
            EXPECT_LE(fraction, 1);
            if (++told == 5)
              throw Stopped();
          }),
      Stopped);
}

TEST(FaceModels, AllAgreeOnASmallMovementUpToTheirElements)
{
  const Slab slab;
  const double small = 0.002;
  const FaceModelResult lfem = slab.predict(FaceModelKind::Lfem, small);
  const FaceModelResult nfem = slab.predict(FaceModelKind::Nfem, small);
  const FaceModelResult mixed = slab.predict(FaceModelKind::NfmEm, small);
  ASSERT_TRUE(nfem.equilibrium.converged());
  ASSERT_TRUE(mixed.equilibrium.converged());
  // the same elements and, at rest, the same law; what is left is of second order
  EXPECT_LT(distance(nfem.skin_displacement, lfem.skin_displacement), 1e-3);
  // other elements: no lock, a smooth face
  const double apart = distance(mixed.skin_displacement, nfem.skin_displacement);
  std::printf("nfm-em against nfem, small movement: %.3f\n", apart);
  EXPECT_GT(apart, 1e-3);
  EXPECT_LT(apart, 0.2);
}

TEST(FaceModels, NoMovementMovesNothing)
{
  const Slab slab;
  for (const FaceModelKind model :
       {FaceModelKind::Lfem, FaceModelKind::Mtm, FaceModelKind::Nfem, FaceModelKind::NfmEm})
  {
    const FaceModelResult result = slab.predict(model, 0);
    EXPECT_EQ(result.x.size(), slab.mesh.X.size()) << name_of(model);
    for (const Vec3& u : result.skin_displacement)
      EXPECT_LT(u.norm(), 1e-9) << name_of(model);
  }
}

TEST(FaceModels, NamesAreThoseOfTheCommandLine)
{
  for (const char* name : {"lfem", "mtm", "nfem", "nfm-em"})
  {
    ASSERT_TRUE(face_model_named(name)) << name;
    EXPECT_STREQ(name_of(*face_model_named(name)), name);
  }
  EXPECT_FALSE(face_model_named("nfmem"));
}

} // namespace
} // namespace f2b
