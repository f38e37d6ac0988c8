#pragma once

#include "Bridge/vtk_surface.hpp"
#include "Case/case_folder.hpp"
#include "Case/case_settings.hpp"
#include "Core/assembly/stability_monitor.hpp"
#include "Core/geometry/osteotomy.hpp"
#include "Core/inverse/face_model.hpp"
#include "Core/progress.hpp"

#include <chrono>

/// What do the verbs share when they work on a case folder?
namespace f2b
{

/// An open case with its settings.
struct CaseSession
{
  CaseFolder folder;
  nlohmann::json document; ///< case.json, paths absolute
  CaseSettings settings;
  Progress progress;

  /// Opens a case that `segment` made; throws Error if there is none.
  static CaseSession open(const Path& folder, const Progress& progress = no_progress);
  /// Opens a folder for a new case.
  CaseSession(const Path& folder, const nlohmann::json& case_document, const Path& source,
              Progress progress = no_progress);
  /// Replaces the settings; what follows works with them and keeps them in the case.
  void change_settings(const nlohmann::json& case_document, const Path& source);
  /// Keeps the settings in a folder, as case.json of a case does.
  void write_settings(const Path& staging) const;

private:
  CaseSession(const Path& folder, Progress progress);
};

/// Throws Error if making the case in a folder would overwrite what it is to be made from.
void require_inputs_elsewhere(const CaseSettings& settings, const Path& folder);

/// Seconds since it was made.
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
  }

private:
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

nlohmann::json to_json(const Vec3& v);
Vec3 vec3_from(const nlohmann::json& value);
/// Reference skin, mesh and laws of a case, ready to be solved.
struct MeshedFace
{
  MeshedFace(const CaseSession& session, MixedMesh mesh);
  MeshedFace(const MeshedFace&) = delete;
  MeshedFace& operator=(const MeshedFace&) = delete;

  FaceModel model() const
  {
    return {tissue, materials, interpolation, skin_area, reference_points};
  }

  vtkSmartPointer<vtkPolyData> skin;
  TriangleMesh reference_skin;
  MixedMesh mesh; ///< its boundary parts may be changed, its geometry not
  MaterialSet materials;
  Discretization tissue;
  SkinMap map;
  SkinInterpolation interpolation;
  std::vector<double> skin_area; ///< 0 where a vertex has no finite-element skin near it
  std::vector<Vec3> reference_points;
};

/// The same as `cut` and `mesh` left it.
struct LoadedFace : MeshedFace
{
  explicit LoadedFace(const CaseSession& session);
};

EquilibriumOptions equilibrium_options(const CaseSettings& settings);
/// Motions in the order of the mesh's fragments; fragments that are not named stay at rest.
/// Throws Error for a name that is no fragment.
std::vector<RigidMotion> stated_motions(const Movements& movements, const LoadedFace& face,
                                        const std::string& source);
/// The movements that the case states for `predict`, or its plan's; throws Error if it has neither.
std::vector<RigidMotion> motions_to_predict(const CaseSession& session, const LoadedFace& face);
/// Writes a fragment's surface where a movement takes it.
void write_moved_fragment(const CaseFolder& folder, const std::string& fragment,
                          const RigidMotion& motion, const Path& file);
/// The reference skin moved by a displacement per vertex, with an array `displacement`.
vtkSmartPointer<vtkPolyData> displaced_skin(const LoadedFace& face,
                                            const std::vector<Vec3>& displacement);
/// Displacements of the mesh nodes in the state x [mm].
std::vector<Vec3> node_displacements(const MixedMesh& mesh, const std::vector<Vec3>& x);
/// What the guard found, tissue by tissue: share of the volume outside the law's stable range, the
/// worst place and its margin.
nlohmann::json to_json(const StabilityReport& stability);
/// How an equilibrium was reached, and what it cost without the seconds.
nlohmann::json to_json(const EquilibriumSummary& solve);
/// Where the time went [s].
nlohmann::json time_split(const SolveEffort& effort);
/// Throws Error (Numerical) with one sentence if a solve did not converge.
/// \param warnings  of the guard, which may say why
void require_converged(const EquilibriumSummary& summary, const std::string& what,
                       const std::vector<std::string>& warnings);

} // namespace f2b
