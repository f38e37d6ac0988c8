#include "Case/cut_trials.hpp"

#include "Bridge/markups.hpp"
#include "Case/bone_part_surface.hpp"
#include "Core/error.hpp"
#include "Core/inverse/skin_sensitivity.hpp"
#include "Core/mesh/contact.hpp"

#include <numeric>

namespace f2b
{
namespace
{

/// Of a saw cut.
constexpr double kerf_mm = 1;

Landmarks landmarks_of(const CaseFolder& folder)
{
  if (!folder.has("landmarks.mrk.json"))
    throw Error(folder.path().string(), "it has no landmarks, which place the osteotomies",
                "give the case a file of Slicer fiducials (landmarks) and run 'facetobone segment' "
                "again");
  return read_landmarks(folder.file("landmarks.mrk.json"));
}

MixedMesh uncut_mesh(const CaseSession& session, const ShellInputs& inputs, double density,
                     const Progress& progress, double& seconds)
{
  const Stopwatch watch;
  MixedMesh mesh = mesh_shell(session, inputs, density, progress).mesh;
  seconds = watch.seconds();
  return mesh;
}

} // namespace

CutTrials::CutTrials(const CaseSession& session, double density, const Progress& progress)
    : m_release_margin_mm(session.settings.release_margin_mm), m_inputs(session),
      m_landmarks(landmarks_of(session.folder)),
      m_uncut(uncut_mesh(session, m_inputs, density, progress, m_seconds.mesh)),
      m_face(session, m_uncut)
{
}

BonePartition CutTrials::cut(const std::vector<std::string>& templates)
{
  const Stopwatch cutting;
  std::vector<Osteotomy> osteotomies;
  for (const std::string& name : templates)
    osteotomies.push_back(osteotomy_from_template(name, "", m_landmarks, kerf_mm));
  BonePartition partition = cut_bone(m_inputs.bone, m_inputs.closed_bone, osteotomies);
  m_face.reference_points.clear();
  for (std::size_t f = 0; f < osteotomies.size(); ++f)
  {
    const auto label = static_cast<unsigned char>(BonePartition::first_fragment + f);
    const auto surface = bone_part_surface(m_inputs.bone, partition, label);
    m_face.reference_points.push_back(area_centroid(to_triangle_mesh(surface)));
  }
  m_seconds.cut += cutting.seconds();

  const Stopwatch hanging;
  m_face.mesh.node_boundary = m_uncut.node_boundary;
  m_face.mesh.node_fragment = m_uncut.node_fragment;
  assign_contacts(m_face.mesh, partition, m_release_margin_mm);
  m_seconds.contact += hanging.seconds();
  return partition;
}

CutEffect CutTrials::effect_of(const std::vector<std::string>& templates)
{
  const BonePartition partition = cut(templates);
  const Stopwatch watch;
  const FaceModel model = m_face.model();
  ElasticModel elastic(model.tissue, model.materials,
                       held_controls(model.tissue, Held::BoneAndFragments));
  EquilibriumSolver solver(elastic, {});
  CutEffect effect;
  effect.cuts = templates;
  effect.fragments = m_face.mesh.fragments;
  effect.reference_points = m_face.reference_points;
  effect.bone_volume_mm3 = std::accumulate(partition.fragment_volume_mm3.begin(),
                                           partition.fragment_volume_mm3.end(), 0.0);
  // at rest the tissue is without stress: an equilibrium that needs no solve
  const MovementSpace space = movement_space(model, {});
  effect.columns =
      skin_columns(model, space, space.start(), model.tissue.rest(), solver, 1e-8);
  m_seconds.response += watch.seconds();
  return effect;
}

RigidFitResult CutTrials::fit(const std::vector<std::string>& templates, const SkinTarget& target,
                              const RigidFitOptions& options, const Progress& progress)
{
  cut(templates);
  return fit_fragments(m_face.model(), target, options, progress);
}

} // namespace f2b
