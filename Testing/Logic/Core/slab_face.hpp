#pragma once

#include "Core/inverse/face_model.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

/// The smallest face that can be planned, and movements for it.
namespace f2b::testing
{

constexpr double degree = 3.14159265358979323846 / 180;

/// A slab as a face that is planned: its own skin is the reference skin.
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
                                             references(mesh)}
  {
  }
  Slab(const Slab&) = delete;
  Slab& operator=(const Slab&) = delete;

  SkinTarget target_of(const std::vector<RigidMotion>& motions) const
  {
    Prediction p = predict_face(face, motions, {}, no_progress);
    EXPECT_TRUE(p.summary.converged());
    return {p.skin_displacement, weights(), {}};
  }
  SkinTarget target_of(const RigidMotion& motion) const { return target_of(std::vector{motion}); }
  /// The same displacement everywhere.
  SkinTarget uniform_target(const Vec3& displacement, double weight = 1) const
  {
    const std::size_t n = skin.vertices.size();
    return {std::vector<Vec3>(n, displacement), std::vector<double>(n, weight), {}};
  }
  std::vector<double> weights() const { return std::vector<double>(skin.vertices.size(), 1.0); }
  /// Of the reference skin's vertices at rest.
  std::vector<Vec3> positions() const
  {
    std::vector<Vec3> places;
    for (const SkinWeights& w : skin.vertices)
    {
      Vec3 place = Vec3::Zero();
      for (std::size_t i = 0; i < std::size_t(w.count); ++i)
        place += w.weight[i] * tissue.rest()[std::size_t(w.control[i])];
      places.push_back(place);
    }
    return places;
  }

  MixedMesh mesh;
  MaterialSet materials;
  Discretization tissue;
  SkinInterpolation skin;
  FaceModel face;

private:
  /// The middle of each fragment's nodes where there are two, else the origin.
  static std::vector<Vec3> references(const MixedMesh& mesh)
  {
    std::vector<Vec3> middles(mesh.fragments.size(), Vec3::Zero());
    std::vector<int> nodes(mesh.fragments.size(), 0);
    for (std::size_t n = 0; mesh.fragments.size() > 1 && n < mesh.X.size(); ++n)
      if (mesh.node_boundary[n] == Boundary::Fragment)
      {
        const auto f = std::size_t(mesh.node_fragment[n]);
        middles[f] += (mesh.X[n] - middles[f]) / ++nodes[f];
      }
    return middles;
  }
};

/// Like the paper's Table 2, smaller, turned so that the slab's face is in front.
inline RigidMotion table_2_motion()
{
  RigidMotion m;
  m.translation = {2, -5, 3};
  m.rotation = rotation_from({5 * degree, 2.5 * degree, 0});
  return m;
}

/// Of two rotations [rad].
inline double angle_between(const Mat3& a, const Mat3& b)
{
  return Eigen::AngleAxisd(a.transpose() * b).angle();
}

} // namespace f2b::testing
