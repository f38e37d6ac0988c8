#pragma once

#include "Core/assembly/discretization.hpp"
#include "Core/assembly/stability_monitor.hpp"
#include "Core/models/damped_relaxation.hpp"
#include "Core/models/forward_problem.hpp"
#include "Core/solve/equilibrium.hpp"

#include <optional>
#include <string_view>

/// Which face do the four models of the paper's Table 3 predict for a movement of the bone?
namespace f2b
{

/// The first three work on the mesh's nodes with each prism split into three tetrahedra.
enum class FaceModelKind
{
  Lfem,  ///< linear elasticity on linear tetrahedra, one linear solve (Koch et al. 1996)
  Mtm,   ///< the same law as a mass-tensor model, relaxed explicitly (Cotin et al. 2000)
  Nfem,  ///< the tissues' own laws on plain linear tetrahedra
  NfmEm, ///< the tissues' own laws on the paper's mixed mesh: smooth prisms on tetrahedra, with
         ///< averaged dilatation
};

/// lfem, mtm, nfem, nfm-em.
const char* name_of(FaceModelKind model);
/// Nothing for a name that is none of these.
std::optional<FaceModelKind> face_model_named(std::string_view name);

struct FaceModelOptions
{
  EquilibriumOptions equilibrium; ///< of Nfem and NfmEm
  RelaxationOptions relaxation;   ///< of Mtm
};

struct FaceModelResult
{
  std::vector<Vec3> x;                      ///< positions of the mesh nodes [mm]
  std::vector<Vec3> skin_displacement;      ///< of the reference skin [mm]
  EquilibriumSummary equilibrium;           ///< of Mtm the effort only
  RelaxationSummary relaxation;             ///< of Mtm
  std::optional<StabilityReport> stability; ///< of Nfem and NfmEm, in the state that is returned
};

/// Predicts the face. Where Nfem or NfmEm cannot reach the movement, the summary says so and the
/// fields hold the last accepted state; a relaxation that did not come to rest says so too.
///
/// The reference skin follows its prism's face: by its smooth shape functions in NfmEm, linearly
/// in the others.
FaceModelResult predict_with(FaceModelKind model, const ForwardProblem& problem,
                             const SkinMap& skin, const FaceModelOptions& options,
                             const Progress& progress);

} // namespace f2b
