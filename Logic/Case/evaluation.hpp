#pragma once

#include "Case/actual_outcome.hpp"
#include "Case/face_regions.hpp"
#include "Core/inverse/rigid_fit.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Core/inverse/virtual_force.hpp"
#include "Rendering/map_panels.hpp"

/// What do the paper's three experiments share (section 3.2)?
namespace f2b
{

/// One run of the verb `evaluate`.
struct Evaluation
{
  Evaluation(CaseSession& session, const EvaluateOptions& options);

  CaseSession& session;
  const EvaluateOptions& options;
  LoadedFace face;
  SkinParts parts; ///< of the case's own cuts
  CaseChange change;

  /// A file that is to appear in the case's folder `evaluation`.
  Path file(const std::string& name) const { return change.file("evaluation/" + name); }
  RigidFitOptions fit_options() const;
};

/// What both methods make of one target.
struct TwoPlans
{
  RigidFitResult fit;
  VirtualForceResult dragged;
};
TwoPlans plan_by_both(const Evaluation& evaluation, const SkinTarget& target);

/// The reference skin in a state, with its distance from another one as point array; no value where
/// the area is zero.
vtkSmartPointer<vtkPolyData> skin_with_distance(const MeshedFace& face,
                                                const std::vector<Vec3>& displacement,
                                                std::vector<double> distance,
                                                const std::vector<double>& area);

/// "mean 0.62, variance 0.11, at most 2.31 mm".
std::string text_of(const SkinError& error);

/// Experiment 1: the four models' faces for the bone movement that really happened (Table 3,
/// Fig. 10). Leaves the mixed model's face for Experiment 2's S1.
nlohmann::json compare_models(const Evaluation& evaluation, const ActualOutcome& actual,
                              std::vector<Vec3>& mixed_face);
/// Experiment 2: the bone movement found back from that face (S1) and from the measured one (S2), by
/// both methods (Table 4, Fig. 11).
nlohmann::json compare_bones(const Evaluation& evaluation, const ActualOutcome& actual,
                             const std::vector<Vec3>& mixed_face);
/// Experiment 3: targets by recipe, planned and predicted (Fig. 12).
nlohmann::json reach_targets(const Evaluation& evaluation);

} // namespace f2b
