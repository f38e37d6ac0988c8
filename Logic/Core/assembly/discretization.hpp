#pragma once

#include "Core/mesh/mixed_mesh.hpp"
#include "Core/mesh/skin_map.hpp"
#include "Core/mesh/smooth_skin.hpp"

#include <memory>

/// Which vectors describe a deformed mesh, and how do they give its skin?
namespace f2b
{

/// Shape functions of the prisms.
enum class SkinElement
{
  Linear, ///< eq. 4
  Smooth, ///< eq. 5-6: a face with a continuous tangent plane (smooth_skin.hpp)
};

/// How the elements feel a change of volume.
enum class Dilatation
{
  PerPoint, ///< at every quadrature point: the plain element, which locks near incompressibility
  Averaged, ///< as the mean of a prism, or of a patch of tetrahedra (mean_dilatation.hpp)
};

struct ElementScheme
{
  SkinElement skin = SkinElement::Linear;
  Dilatation dilatation = Dilatation::PerPoint;
  int patch_tets = 5; ///< size of a patch for averaged dilatation (test_locking.cpp on the choice)
};

/// The paper's model: a face that is smooth, and no locking.
inline constexpr ElementScheme mixed_elements = {SkinElement::Smooth, Dilatation::Averaged};

/// A point of the skin as a combination of the first control vectors of one prism's element.
struct SkinWeights
{
  static constexpr int most = 9;

  int prism = -1; ///< -1: no finite-element skin is near
  int count = 0;
  std::array<int, most> control{};
  std::array<double, most> weight{};
};

/// A mesh with the shape functions of its elements.
///
/// A state of it is one control vector per degree of freedom in R^3 [mm, RAS]: the position of
/// every mesh node, in the mesh's order, then with smooth skin two slope vectors per node of the
/// face that has them, in the order of `SmoothSkin::tangents`. The mesh outlives the discretization.
class Discretization
{
public:
  explicit Discretization(const MixedMesh& mesh, ElementScheme scheme = {});

  const MixedMesh& mesh() const { return m_mesh; }
  ElementScheme scheme() const { return m_scheme; }
  /// Control vectors at rest.
  const std::vector<Vec3>& rest() const { return m_rest; }
  std::size_t control_count() const { return m_rest.size(); }

  /// The slopes of the face, or null: the skin is linear.
  const SmoothSkin* smooth_skin() const { return m_smooth.get(); }

  /// The node that a control vector belongs to.
  int node_of(std::size_t control) const;

  /// Flags of nodes carried over to the control vectors that belong to them: a held node of the
  /// face is clamped.
  std::vector<char> control_flags(const std::vector<char>& node_flags) const;
  SkinWeights skin_weights(const SkinPlace& place) const;
  /// The state in which a smooth map f carries the rest position along: nodes at f(X), slopes
  /// J(X) times their rest value. An affine map is exact in every element.
  template <class Map, class Derivative>
  std::vector<Vec3> mapped_rest(const Map& f, const Derivative& J) const;

private:
  const MixedMesh& m_mesh;
  ElementScheme m_scheme;
  std::shared_ptr<const SmoothSkin> m_smooth;
  std::vector<Vec3> m_rest;
};

template <class Map, class Derivative>
std::vector<Vec3> Discretization::mapped_rest(const Map& f, const Derivative& J) const
{
  std::vector<Vec3> x = m_rest;
  const std::size_t nodes = m_mesh.X.size();
  for (std::size_t c = 0; c < x.size(); ++c)
  {
    if (c < nodes)
      x[c] = f(m_rest[c]);
    else
      x[c] = J(m_mesh.X[static_cast<std::size_t>(node_of(c))]) * m_rest[c];
  }
  return x;
}

/// The reference skin's place in a discretization, one per reference-skin vertex.
struct SkinInterpolation
{
  SkinInterpolation(const Discretization& tissue, const SkinMap& map);

  /// Displacement of every reference-skin vertex [mm]; zero where no finite-element skin is near.
  /// \param change  of every control vector from rest, or any other variation of them
  std::vector<Vec3> of_change(const std::vector<Vec3>& change) const;
  /// The same for a state, given by its control vectors.
  std::vector<Vec3> displacement(const std::vector<Vec3>& x) const;

  std::vector<SkinWeights> vertices;

private:
  std::vector<Vec3> m_rest;
};

} // namespace f2b
