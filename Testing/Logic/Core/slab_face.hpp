#pragma once

#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

/// A slab as a face to be planned: its own skin is the reference skin.
namespace f2b::testing
{

struct Slab
{
  explicit Slab(SlabOptions options = {8, 2, 80, 14, 1.5, 4, 0.5}, ElementScheme scheme = {})
      : Slab(make_slab(options), scheme)
  {
  }
  explicit Slab(MixedMesh slab_mesh, ElementScheme scheme = {})
      : mesh(std::move(slab_mesh)), materials(soft_material()), tissue(mesh, scheme),
        skin(tissue, corner_map(mesh)), face{tissue, materials, skin,
                                             std::vector<double>(skin.vertices.size(), 1.0),
                                             std::vector<Vec3>(mesh.fragments.size(), Vec3::Zero())}
  {
  }
  Slab(const Slab&) = delete;
  Slab& operator=(const Slab&) = delete;

  SkinTarget target_of(const std::vector<RigidMotion>& motions) const
  {
    Prediction p = predict_face(face, motions, {}, no_progress);
    EXPECT_TRUE(p.summary.converged());
    return {p.skin_displacement, std::vector<double>(skin.vertices.size(), 1.0)};
  }
  SkinTarget target_of(const RigidMotion& motion) const { return target_of(std::vector{motion}); }
  /// The same displacement everywhere.
  SkinTarget uniform_target(const Vec3& displacement, double weight = 1) const
  {
    const std::size_t n = skin.vertices.size();
    return {std::vector<Vec3>(n, displacement), std::vector<double>(n, weight)};
  }

  MixedMesh mesh;
  MaterialSet materials;
  Discretization tissue;
  SkinInterpolation skin;
  FaceModel face;
};

inline RigidMotion table_2_motion()
{
  constexpr double degree = 3.14159265358979323846 / 180;
  RigidMotion m;
  m.translation = {2, -5, 3};
  m.rotation = rotation_from({5 * degree, 2.5 * degree, 0});
  return m;
}

} // namespace f2b::testing
