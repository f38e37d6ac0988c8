#pragma once

#include "Core/geometry/osteotomy.hpp"

/// Between which neighbouring samples of a lattice does a saw pass?
namespace f2b
{

/// All planes and curves of some osteotomies on one lattice.
class LatticeCuts
{
public:
  /// A plane or a curve.
  struct Cut
  {
    std::size_t osteotomy = 0;
    std::string who; ///< as errors name it
    bool may_miss = false;
  };
  /// One passage of a cut between a sample and its next one along an axis.
  struct Passage
  {
    std::size_t sample = 0;
    int axis = 0;
    std::size_t cut = 0;
    Vec3 at = Vec3::Zero(); ///< where [mm, RAS]
  };

  LatticeCuts(const ScalarGrid& lattice, const std::vector<Osteotomy>& osteotomies);

  const std::vector<Cut>& cuts() const { return m_cuts; }
  /// Does a cut pass between this sample and the next one along an axis?
  bool between(std::size_t sample, int axis) const { return m_passed[sample] & (1 << axis); }
  /// Every passage, by sample and axis, in the order of the cuts.
  const std::vector<Passage>& passages() const { return m_passages; }
  /// The first of them there; only where `between`.
  const Passage& passage(std::size_t sample, int axis) const;

private:
  void add(const ScalarGrid& lattice, const BoundedPlane& plane, std::size_t cut);

  std::vector<Cut> m_cuts;
  std::vector<unsigned char> m_passed; ///< per sample, one bit an axis
  std::vector<Passage> m_passages;
};

} // namespace f2b
