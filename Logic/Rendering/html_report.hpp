#pragma once

#include <Core/geometry/movement_words.hpp>
#include <Core/geometry/vectors.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What does a reader of a plan get? One HTML file that needs nothing else and prints on A4.
///
/// The caller computes every number; here they are only written down. All strings are UTF-8 text,
/// never markup. Frame RAS, mm, degrees.
namespace f2b
{

struct ReportFact
{
  std::string key;
  std::string value;
};

struct ReportFragment
{
  std::string name;
  Vec3 reference_point_ras = Vec3::Zero();
  Vec3 translation_ras_mm = Vec3::Zero(); ///< right, anterior, superior
  RotationDegrees rotation_deg;
};

/// Absolute skin errors [mm], area-weighted, and shares from 0 to 1 (design.md 6).
struct ReportSkinError
{
  double mean = 0, sd = 0, variance = 0, median = 0, p90 = 0, p95 = 0, max = 0;
  double under_1mm = 0, under_2mm = 0;
  double signed_mean = 0;
};

struct ReportMethod
{
  std::string name; ///< "rigid-fit", "virtual-force"
  std::string note; ///< one sentence under its heading; may be empty
  std::vector<ReportFragment> fragments;
  std::optional<ReportSkinError> skin_error_mm;
  std::optional<double> load_residual_mm; ///< virtual-force only
};

/// One line of the ranking of cuts: all of it as text.
struct ReportSuggestion
{
  std::string cuts;     ///< "le-fort-1 + genioplasty"
  std::string reached;  ///< "93 %"
  std::string rms_left; ///< "0.42 mm"
  std::string movement; ///< of every fragment, in words
};

/// One region of the face, rigid-fit [mm].
struct ReportRegion
{
  std::string name;
  double error_mean = 0, error_p90 = 0;      ///< of the predicted skin against the target
  std::optional<double> asked_p90, left_p90; ///< where the region has a target
};

struct ReportPicture
{
  std::string title;
  std::string caption; ///< also the alternative text
  std::filesystem::path png;
};

struct ReportContent
{
  std::string title = "FaceToBone plan";
  std::string case_name;
  std::string frame_note;        ///< which axes R, A, S are: scanner, or Frankfort and mid-sagittal
  std::vector<ReportFact> facts; ///< CT, cuts, target, materials, solver, versions
  std::vector<ReportMethod> methods;         ///< the default first
  std::vector<ReportSuggestion> suggestions; ///< best first; empty: none were asked for
  std::string suggestions_note;              ///< what decided, and what was not possible
  std::vector<std::string> reach;    ///< sentences on what these cuts reach
  std::vector<ReportRegion> regions;
  std::vector<ReportFact> cuts; ///< overlap and gap along each cut after the movement
  std::vector<ReportFact> bite; ///< before and after
  std::vector<ReportFact> mesh_facts;
  std::vector<ReportFact> timings;
  std::vector<std::string> warnings;
  std::vector<ReportPicture> pictures;
};

/// The whole report as text.
/// \throws f2b::Error naming a picture that cannot be read
std::string html_report(const ReportContent& content);

/// Writes it whole or not at all.
/// \throws f2b::Error naming `path` when it cannot be written
void write_html_report(const std::filesystem::path& path, const ReportContent& content);

} // namespace f2b
