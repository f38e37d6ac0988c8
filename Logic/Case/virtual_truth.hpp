#pragma once

#include "Case/shell_of_case.hpp"

/// What would really happen to a case's patient, if the patient were not as the plan believes?
///
/// A virtual patient on the same CT: another mesh of tetrahedra only, another law, other
/// stiffnesses. It shares with the plan the CT, the segmentation and the cuts, and says so.
namespace f2b
{

struct TruthOptions
{
  double density = 1.5;           ///< elements per volume, relative to the case's own mesh
  double skin_thickness_mm = 1.3; ///< of the layer that has the skin's law
  bool is_neo_hookean = true;     ///< else the case's own laws
  std::array<double, tissue_count> stiffness{1.4, 0.7, 1.3}; ///< factors, by Tissue
  std::optional<double> poisson_ratio = 0.45; ///< of all tissues; none: the laws' own
};

/// The laws of the truth. Neo-Hookean ones have the shear modulus at rest of those they replace.
MaterialSet truth_materials(const MaterialSet& of_case, const TruthOptions& options);

/// The truth's mesh, cut as the case is: prisms split in three, dilatation averaged over patches so
/// that it does not lock.
class TruthMesh
{
public:
  /// Throws Error where the case is not cut, and as mesh_shell.
  TruthMesh(const CaseSession& session, const TruthOptions& options, const Progress& progress);
  TruthMesh(const TruthMesh&) = delete;
  TruthMesh& operator=(const TruthMesh&) = delete;

  /// \param face  the plan's: fragments are moved about its reference points, and skin counts where
  ///              both meshes have some
  FaceModel model(const MaterialSet& materials, const LoadedFace& face) const;
  std::size_t tets() const { return m_tets.tets.size(); }
  /// All tetrahedra; for a synthetic CT.
  const MixedMesh& mesh() const { return m_tets; }

private:
  MixedMesh m_prisms, m_tets;
  Discretization m_tissue, m_face; ///< of the tetrahedra; of the prisms, for their outer faces
  SkinMap m_map;
  SkinInterpolation m_interpolation;
};

/// How the truth differs from the plan, for a reader.
nlohmann::json mismatch_json(const TruthOptions& options, const TruthMesh& truth,
                             const LoadedFace& face, const MaterialSet& materials);

} // namespace f2b
