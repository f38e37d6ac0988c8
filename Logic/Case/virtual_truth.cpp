#include "Case/virtual_truth.hpp"

#include "Bridge/grid_file.hpp"
#include "Bridge/skin_mapping.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/material/law_variation.hpp"
#include "Core/mesh/contact.hpp"
#include "Core/mesh/split_prisms.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

Law law_of_truth(const Law& law, double stiffness, const TruthOptions& options)
{
  Law truth = law;
  if (options.is_neo_hookean)
  {
    const double mu = shear_modulus(law);
    truth = NeoHookean{{mu / 2}, {VolumetricLaw::Kind::Barrier, bulk_modulus(law)}};
  }
  if (options.poisson_ratio)
    truth = with_poisson_ratio(truth, *options.poisson_ratio);
  return stiffened(truth, stiffness);
}

/// Meshed finer, and cut where the case is.
MixedMesh cut_mesh(const CaseSession& session, const TruthOptions& options,
                   const Progress& progress)
{
  const ShellInputs inputs(session);
  MixedMesh mesh = mesh_shell(session, inputs, options.density * session.settings.mesh_density,
                              progress, options.skin_thickness_mm)
                       .mesh;
  const BonePartition partition =
      cut_bone(inputs.bone, inputs.closed_bone, placed_osteotomies(session.folder));
  assign_contacts(mesh, partition, session.settings.release_margin_mm);
  return mesh;
}

std::vector<Vec3> reference_skin_of(const CaseFolder& folder)
{
  return points_of(read_surface(folder.require("skin.vtp", "segment")));
}

} // namespace

MaterialSet truth_materials(const MaterialSet& of_case, const TruthOptions& options)
{
  MaterialSet truth{"truth", of_case.laws};
  for (std::size_t t = 0; t < truth.laws.size(); ++t)
    truth.laws[t] = law_of_truth(of_case.laws[t], options.stiffness[t], options);
  return truth;
}

TruthMesh::TruthMesh(const CaseSession& session, const TruthOptions& options,
                     const Progress& progress)
    : m_prisms(cut_mesh(session, options, progress)), m_tets(split_prisms(m_prisms)),
      m_tissue(m_tets, {SkinElement::Linear, Dilatation::Averaged}), m_face(m_prisms),
      m_map(map_skin(m_prisms, reference_skin_of(session.folder))), m_interpolation(m_face, m_map)
{
}

FaceModel TruthMesh::model(const MaterialSet& materials, const LoadedFace& face) const
{
  std::vector<double> area = face.skin_area;
  for (std::size_t v = 0; v < area.size(); ++v)
    if (m_interpolation.vertices[v].prism < 0)
      area[v] = 0;
  return {m_tissue, materials, m_interpolation, std::move(area), face.reference_points};
}

json mismatch_json(const TruthOptions& options, const TruthMesh& truth, const LoadedFace& face,
                   const MaterialSet& materials)
{
  json told = {{"mesh",
                {{"tetrahedra_of_truth", truth.tets()},
                 {"tetrahedra_of_plan", face.mesh.tets.size()},
                 {"prisms_of_plan", face.mesh.prisms.size()}}},
               {"law_of_truth", options.is_neo_hookean ? "neo-Hookean" : "as the plan's"},
               {"materials_of_plan", face.materials.name},
               {"skin_thickness_of_truth_mm", options.skin_thickness_mm},
               {"shares_with_the_plan", "CT, segmentation, cuts, released contact"}};
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
    told["tissue"][name_of(tissue)] = {
        {"shear_modulus_of_truth_kpa", 1000 * shear_modulus(materials.of(tissue))},
        {"shear_modulus_of_plan_kpa", 1000 * shear_modulus(face.materials.of(tissue))},
        {"poisson_ratio_of_truth", poisson_ratio(materials.of(tissue))},
        {"poisson_ratio_of_plan", poisson_ratio(face.materials.of(tissue))}};
  return told;
}

} // namespace f2b
