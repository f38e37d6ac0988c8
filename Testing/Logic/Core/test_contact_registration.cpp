#include "Core/inverse/contact_registration.hpp"
#include "Logic/Core/finite_differences.hpp"
#include "Logic/Core/slab_face.hpp"
#include "expect_error.hpp"

namespace f2b
{
namespace
{

using namespace testing;
using test::expect_error;

RigidMotion some_motion()
{
  return {rotation_from({0.4, -0.2, 0.3}), {2, -5, 3}, {1, 2, 3}};
}

std::vector<Vec3> carried(const MixedMesh& mesh, const RigidMotion& motion)
{
  std::vector<Vec3> x;
  for (const Vec3& X : mesh.X)
    x.push_back(motion.apply(X));
  return x;
}

void expect_same(const RigidMotion& a, const RigidMotion& b)
{
  EXPECT_LT((a.rotation - b.rotation).norm(), 1e-12);
  EXPECT_LT((a.translation - b.translation).norm(), 1e-11);
}

/// Beside and above the bottom of the slab, where its contact surface is flat.
std::vector<ContactLandmark> four_landmarks()
{
  return {{"a", {-15, -12, 0.7}}, {"b", {14, -13, -2}}, {"c", {12, 16, 0}}, {"d", {-11, 3, 1.5}}};
}

TEST(ContactRegistration, IsExactForARigidMovementWithLandmarksOnAndOffTheSurface)
{
  const MixedMesh mesh = make_slab({8, 2, 80, 14, 1.5, 4, 0.5});
  const RigidMotion truth = some_motion();
  const ContactSurfaces surfaces(mesh, {truth.reference_point}, four_landmarks());
  const FragmentRegistration found = surfaces.register_to(carried(mesh, truth)).at(0);
  expect_same(found.surface.motion, truth);
  EXPECT_LT(found.surface.rms_mm, 1e-12);
  ASSERT_TRUE(found.landmarks);
  EXPECT_EQ(found.landmarks->points, 4);
  expect_same(found.landmarks->motion, truth);
  EXPECT_LT(found.landmarks->rms_mm, 1e-12);
  for (const Vec3& misfit : registration_misfit(mesh, {truth}, carried(mesh, truth)))
    EXPECT_LT(misfit.norm(), 1e-12);
}

TEST(ContactRegistration, LandmarksAloneDecideWhereTheyAreGiven)
{
  const MixedMesh mesh = make_slab({8, 2, 80, 14, 1.5, 4, 0.5});
  const RigidMotion truth = some_motion();
  // near three contact nodes, and all other tissue deformed
  const std::vector<ContactLandmark> landmarks = {
      {"a", {-10, -10, 0}}, {"b", {10, -10, 0}}, {"c", {10, 10, 0}}};
  std::vector<Vec3> x = shaken(carried(mesh, truth), 1, 3);
  for (std::size_t n = 0; n < x.size(); ++n)
    for (const ContactLandmark& landmark : landmarks)
      if ((mesh.X[n] - landmark.position).norm() < 1e-9)
        x[n] = truth.apply(mesh.X[n]);
  const ContactSurfaces surfaces(mesh, {truth.reference_point}, landmarks);
  const FragmentRegistration found = surfaces.register_to(x).at(0);
  expect_same(found.motion(), truth);
  EXPECT_GT(found.surface.rms_mm, 0.3);
  EXPECT_GT((found.surface.motion.translation - truth.translation).norm(), 0.01);
}

TEST(ContactRegistration, LandmarksGoToTheNearestFragment)
{
  MixedMesh mesh = make_slab({12, 1, 80, 8, 1.5, 0, 0.5});
  mesh.fragments = {"left", "right"};
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (mesh.node_boundary[n] == Boundary::Fragment)
      mesh.node_fragment[n] = mesh.X[n].x() > 0;
  const ContactSurfaces surfaces(mesh, {Vec3::Zero(), Vec3::Zero()},
                                 {{"a", {12, -12, 0}}, {"b", {13, 12, 0}}, {"c", {8, 0, 1}}});
  const auto found = surfaces.register_to(mesh.X);
  EXPECT_FALSE(found.at(0).landmarks);
  EXPECT_TRUE(found.at(1).landmarks);
  expect_same(found.at(0).motion(), {});
}

TEST(ContactRegistration, SaysWhatItCannotWorkWith)
{
  const MixedMesh mesh = make_slab({8, 2, 80, 14, 1.5, 4, 0.5});
  auto refused = [&](const MixedMesh& slab, const std::vector<ContactLandmark>& landmarks,
                     const std::vector<std::string>& parts)
  { expect_error([&] { ContactSurfaces(slab, {Vec3::Zero()}, landmarks); }, parts); };
  auto landmarks = four_landmarks();
  landmarks.resize(2);
  refused(mesh, landmarks, {"'block'", "three registration landmarks", "it has 2"});
  refused(mesh, {{"a", {-10, 0, 0}}, {"b", {0, 0, 0}}, {"c", {15, 0, 0.3}}},
          {"3 registration landmarks lie on one line"});
  landmarks = four_landmarks();
  landmarks.push_back({"far", {0, 0, -30}});
  refused(mesh, landmarks, {"landmark 'far'", "30.0 mm away", "fragment 'block'"});
  MixedMesh bare = mesh;
  for (auto& boundary : bare.node_boundary)
    boundary = boundary == Boundary::Fragment ? Boundary::Free : boundary;
  refused(bare, {}, {"'block'", "three soft-tissue contact nodes", "it has 0", "release margin"});
  refused(bare, four_landmarks(), {"landmark 'a'", "no fragment has soft-tissue contact"});
  MixedMesh line = mesh;
  for (std::size_t n = 0; n < line.X.size(); ++n)
    if (line.node_boundary[n] == Boundary::Fragment && std::abs(line.X[n].x()) > 1)
      line.node_boundary[n] = Boundary::Free;
  refused(line, {}, {"soft-tissue contact nodes lie on one line"});
}

} // namespace
} // namespace f2b
