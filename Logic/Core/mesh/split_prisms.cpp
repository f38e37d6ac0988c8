#include "Core/mesh/split_prisms.hpp"

#include "Core/error.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

/// The prism seen from its smallest node: that node is corner 0, on the first triangle. Turning it
/// upside down mirrors the order of the corners, so that the winding stays what it was.
std::array<int, 6> from_smallest(const std::array<int, 6>& prism)
{
  static constexpr std::size_t seen_from[6][6] = {{0, 1, 2, 3, 4, 5}, {1, 2, 0, 4, 5, 3},
                                                  {2, 0, 1, 5, 3, 4}, {3, 5, 4, 0, 2, 1},
                                                  {4, 3, 5, 1, 0, 2}, {5, 4, 3, 2, 1, 0}};
  const auto smallest = std::min_element(prism.begin(), prism.end()) - prism.begin();
  std::array<int, 6> turned{};
  for (std::size_t i = 0; i < 6; ++i)
    turned[i] = prism[seen_from[smallest][i]];
  return turned;
}

[[noreturn]] void refuse(const MixedMesh& mesh, const std::array<int, 6>& prism)
{
  const Vec3& at = mesh.X[static_cast<std::size_t>(prism[0])];
  throw Error("mesh",
              "the skin prism at RAS (" + std::to_string(at.x()) + ", " + std::to_string(at.y()) +
                  ", " + std::to_string(at.z()) +
                  ") is too warped to be split into three tetrahedra",
              "use the model nfm-em, or mesh at another density");
}

} // namespace

std::array<std::array<int, 4>, 3> split_prism(const std::array<int, 6>& prism)
{
  const auto [a, b, c, d, e, f] = from_smallest(prism);
  // both quads at `a` are cut from it; quad b, c, f, e is cut from its own smallest node
  if (std::min(b, f) < std::min(c, e))
    return {{{a, c, b, f}, {a, b, e, f}, {a, e, d, f}}};
  return {{{a, c, b, e}, {a, c, e, f}, {a, e, d, f}}};
}

MixedMesh split_prisms(const MixedMesh& mesh)
{
  MixedMesh split = mesh;
  split.prisms.clear();
  split.tets.reserve(mesh.tets.size() + 3 * mesh.prisms.size());
  for (const auto& prism : mesh.prisms)
    for (const auto& tet : split_prism(prism))
    {
      auto X = [&](std::size_t i) -> const Vec3&
      { return mesh.X[static_cast<std::size_t>(tet[i])]; };
      if (!(tet_volume6(X(0), X(1), X(2), X(3)) > 0))
        refuse(mesh, prism);
      split.tets.push_back(tet);
    }
  split.tet_tissue.resize(split.tets.size(), Tissue::Skin);
  return split;
}

} // namespace f2b
