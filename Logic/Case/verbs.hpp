#pragma once

#include "Case/case_session.hpp"

/// What can be done with a case? Each verb reads files of the case and writes its own, all or none.
///
/// Every verb throws Error in one line when it cannot; the case is then as it was.
namespace f2b
{

/// CT to distance maps, labels, the reference skin and the bone surface.
void segment_case(CaseSession& session);
/// Planes to fragments.
void cut_case(CaseSession& session);
/// Tissue to prisms on tetrahedra with their boundary parts.
void mesh_case(CaseSession& session);
/// The face that the patient should have, on the reference skin.
void target_case(CaseSession& session);
struct SuggestOptions
{
  std::optional<double> density; ///< of its own mesh; else the case's, but 0.3 at most
  bool confirm = false;          ///< also fits the best two fully
};
/// Ranks the osteotomy templates, alone and in pairs, by what they reach of the target;
/// suggest.json. Needs no cut and no mesh of the case.
void suggest_case(CaseSession& session, const SuggestOptions& options);
/// Movements of the fragments by both methods, and the faces that they give; plan.json.
void plan_case(CaseSession& session);
/// The face that stated movements give.
void predict_case(CaseSession& session);
struct ExportOptions
{
  std::string format = "calculix"; ///< calculix, febio or vtu
  Path file;                       ///< outside the case; empty: export.inp, .feb or .vtu in it
  bool split_prisms = false;       ///< each prism of the skin as three tetrahedra
  int increments = 10;             ///< of the movement, for calculix and febio
};
/// The forward problem of a movement, for other engines.
void export_case(CaseSession& session, const ExportOptions& options);
struct ScreenshotOptions
{
  std::vector<std::string> show{"face-before"}, views{"frontal"};
  Path output;               ///< a .png; a folder for `definition`, `turntable` and `morph`
  Path definition;           ///< many pictures: views.schema.json; then show and views do not count
  int width = 0, height = 0; ///< pixels; 0: 1200 x 1000 for each panel
  int dpi = 0;
  std::string background = "light";
  double fraction = 0.5; ///< of the way to the predicted face, for the subject morph
  std::optional<double> slice_mm;
  int turntable = 0, morph = 0; ///< frames of a film; not both
  Path texts;                   ///< a translation of Resources/texts/en.json
};
/// Pictures of a case as far as its steps have been done.
void screenshot_case(CaseSession& session, const ScreenshotOptions& options);
struct ReportOptions
{
  Path texts;            ///< a translation of Resources/texts/en.json
  bool identity = false; ///< also tell where the scan lies and the case's notes
};
/// Pictures, report.html, report.pdf, report.json, tables and surfaces for printing.
void report_case(CaseSession& session, const ReportOptions& options);
struct EvaluateOptions
{
  std::vector<int> experiments{1, 2, 3};
  Movements movements; ///< that really happened; none: Table 2's, of the first fragment
  double noise_sd_mm = 0.3, noise_correlation_mm = 5; ///< of the virtual patient's measured face
  unsigned long seed = 1;
  Path postoperative_ct;      ///< what really happened, in the virtual patient's place
  std::optional<Box> box_ras; ///< where the two CTs are registered; or by a mask
  Path mask;
  bool check_optimum = true; ///< Experiment 3 against an independent search, which takes longest
};
/// The paper's experiments on a meshed case: evaluation/ with tables (CSV, JSON, Markdown) and
/// colour maps.
void evaluate_case(CaseSession& session, const EvaluateOptions& options);

/// All of them into a folder; what the folder held before stays until everything is done.
void run_case(const nlohmann::json& document, const Path& source, const Path& folder,
              const Progress& progress, const CommitHook& hook = {});

struct SampleOptions
{
  double spacing_mm = 1.0;
  double noise_sd_hu = 12;
  double midface_retrusion_mm = 6;
  bool streaks = false;
  bool head_rest = false;
  unsigned long seed = 1;
};
/// Writes the virtual patient's CT, landmarks, true surfaces and case.json into a folder that is
/// empty or holds a sample.
void write_sample(const Path& folder, const SampleOptions& options, const Progress& progress);

} // namespace f2b
