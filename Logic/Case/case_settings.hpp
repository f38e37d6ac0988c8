#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Imaging/ct_reading.hpp"
#include "Imaging/lattice.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What does CASE.json ask for? Keys, units and ranges: Resources/Schema/case.schema.json.
namespace f2b
{

using Path = std::filesystem::path;

/// A stated movement of one fragment; angles in degrees as people write them.
struct StatedMovement
{
  Vec3 translation = Vec3::Zero();  ///< right, anterior, superior [mm]
  Vec3 rotation_deg = Vec3::Zero(); ///< pitch, roll, yaw [degrees]

  RigidMotion about(const Vec3& reference_point) const;
};
using Movements = std::map<std::string, StatedMovement>;

/// A line drawn on bone and how it is sawn.
struct CurveSettings
{
  Path markup;
  std::optional<Vec3> direction; ///< across the bone's surface where absent
  double depth_mm = 20, lead_mm = 5;
  bool straight = false;
};

struct OsteotomySettings
{
  std::string fragment;
  std::string template_name;
  std::vector<Path> planes; ///< with curves: the cuts, instead of the template's
  std::vector<CurveSettings> curves;
  bool drawn() const { return !planes.empty() || !curves.empty(); }
  std::optional<Vec3> fragment_point;
  double kerf_mm = 1.0;
  nlohmann::json movement; ///< as written, paths absolute (movement_rules.hpp); null: free
};

/// A structure that the saw should spare.
struct ProtectedSettings
{
  std::string name;
  Path curve, mesh; ///< one of them
  double margin_mm = 2;
};

struct TargetSettings
{
  Path mesh; ///< one of mesh, scan, warp_from/warp_to, movements; none: no target yet
  Path scan;
  double scan_reach_mm = 30;
  Path warp_from, warp_to;
  double warp_radius_mm = 45;
  Movements movements;
  double mask_mm = 0;
  double registration_sd_mm = 0; ///< SkinTarget's

  /// How many of the kinds of target are given.
  int kinds() const
  {
    return !mesh.empty() + !scan.empty() + !warp_from.empty() + !movements.empty();
  }
};

/// The paper's own method.
struct VirtualForceSettings
{
  std::optional<double> stiffness_n_per_mm3 = 0.02; ///< without it: chosen for `residual_mm`
  double residual_mm = 0.5, rest_length_mm = 0;
  std::string load = "following"; ///< or dead
  std::vector<std::string> landmarks;
};

struct CaseSettings
{
  std::string name;
  Path ct, landmarks;
  CtReading reading;
  std::optional<double> skin_threshold_hu, bone_threshold_hu;
  std::optional<Box> region_ras;
  double spacing_mm = 1.0, head_closing_mm = 5, bone_closing_mm = 8;
  double surface_error_mm = 0; ///< of decimation; 0: none
  bool level_set = false;      ///< bone by it instead of the threshold
  Path seeds, labels;          ///< of the level set; edited by hand
  double skin_thickness_mm = 1.5;
  std::map<std::string, double> skin_thickness_by_region_mm; ///< by key_of(FaceRegion)
  std::vector<OsteotomySettings> osteotomies;
  std::vector<ProtectedSettings> protected_structures;
  TargetSettings target;
  std::string materials = "table1-stable";
  double mesh_density = 1, release_margin_mm = 5, contact_tolerance_mm = 2;
  std::optional<int> mesh_tetrahedra; ///< how many are wanted; density follows
  int threads = 0;
  int max_newton_iterations = 25, max_fit_iterations = 40;
  double step_tolerance_mm = 1e-8;
  VirtualForceSettings virtual_force;
  std::string predict_model = "nfm-em";
  Movements predict;
};

/// The case that a file states; where it is a CT, a case of that CT alone, without cuts and target.
nlohmann::json read_case(const Path& file);
/// Throw Error where a case has no cuts, or no target, and a step needs them.
void require_cuts(const CaseSettings& settings);
void require_target(const CaseSettings& settings);

/// Checks a document against the schema and what the schema cannot say.
/// \param source  its file, for messages and to resolve relative paths
/// Throws Error naming the file, the key, the value and what is allowed.
CaseSettings parse_settings(const nlohmann::json& document, const Path& source);

/// A fragment's name as part of a file name.
std::string file_part(std::string fragment);
/// Throws Error if files of two fragments, or of a fragment and the face, would have the same name.
void require_distinct_fragments(const std::vector<std::string>& names, const std::string& source);
/// Throws Error for a movement of what is no fragment.
void require_known_fragments(const Movements& movements, const std::vector<std::string>& fragments,
                             const std::string& source);

/// The document with its paths made absolute, to be kept in a case folder.
nlohmann::json with_absolute_paths(nlohmann::json document, const Path& source);

} // namespace f2b
