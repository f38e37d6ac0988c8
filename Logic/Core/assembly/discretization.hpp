#pragma once

#include "Core/mesh/mixed_mesh.hpp"
#include "Core/mesh/skin_map.hpp"

/// Which vectors describe a deformed mesh, and how do they give its skin?
namespace f2b
{

/// Shape functions of the prisms.
enum class SkinElement
{
  Linear, ///< eq. 4
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
  int patch_tets = 8; ///< size of a patch for averaged dilatation
};

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
/// every mesh node, in the mesh's order. The mesh outlives the discretization.
class Discretization
{
public:
  explicit Discretization(const MixedMesh& mesh, ElementScheme scheme = {});

  const MixedMesh& mesh() const { return m_mesh; }
  ElementScheme scheme() const { return m_scheme; }
  /// Control vectors at rest.
  const std::vector<Vec3>& rest() const { return m_rest; }
  std::size_t control_count() const { return m_rest.size(); }

  /// Flags of nodes carried over to the control vectors that belong to them.
  std::vector<char> control_flags(const std::vector<char>& node_flags) const;
  SkinWeights skin_weights(const SkinPlace& place) const;

private:
  const MixedMesh& m_mesh;
  ElementScheme m_scheme;
  std::vector<Vec3> m_rest;
};

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
