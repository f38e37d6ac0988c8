#include "Bridge/json_file.hpp"
#include "Case/evaluation_tables.hpp"
#include "Case/fit_summary.hpp"
#include "Case/print_case.hpp"
#include "Case/verbs.hpp"
#include "CommandLine/case_client.hpp"
#include "CommandLine/plan_table.hpp"
#include "CommandLine/progress_bar.hpp"
#include "CommandLine/screenshot_arguments.hpp"
#include "CommandLine/stated_movement.hpp"
#include "CommandLine/suggestion_table.hpp"
#include "CommandLine/tidy_after_kill.hpp"
#include "Core/error.hpp"
#include "Scene/movement_text.hpp"

#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkSlicerFaceToBoneLogic.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>

namespace
{

using namespace f2b;

enum ExitCode
{
  ok = 0,
  any_other = 1,
  bad_input = 2,
  numerical_failure = 3,
};

struct Arguments
{
  std::string case_file, folder, series;
  bool quiet = false;
  std::string target_mesh, scan, warp_from, warp_to;
  double warp_radius_mm = 45;
  std::vector<std::string> movements;
  std::string model;
  SampleOptions sample;
  FitMaterialOptions fit;
  ExportOptions exported;
  SuggestOptions suggested;
  ScreenshotOptions screenshot;
  ReportOptions report;
  EvaluateOptions evaluated;
  std::vector<double> box_ras;
};

using Action = std::function<void(const Arguments&, const Progress&)>;

void print_plan(const Path& folder)
{
  std::cout << plan_table(read_json(folder / "plan.json"));
  if (std::filesystem::exists(folder / "report.html"))
    std::cout << "Report: "
              << std::filesystem::absolute(folder / "report.html").lexically_normal().string()
              << "\n";
}

void print_prediction(const Path& folder)
{
  const nlohmann::json told = read_json(folder / "predict.json");
  std::cout << "Predicted face (" << told.at("model").get<std::string>()
            << "): " << (folder / "predicted.vtp").string() << "\n";
  for (const nlohmann::json& warning : told.at("warnings"))
    std::cout << "Warning: " << warning.get<std::string>() << "\n";
}

using Plan = vtkMRMLFaceToBonePlanNode;
using Target = vtkMRMLFaceToBoneTargetNode;

/// The plan of a case file, with the DICOM series that the command line chooses.
Plan* begun(CaseClient& client, const Arguments& a)
{
  Plan* plan = client.begin(a.case_file, a.folder);
  if (!a.series.empty())
  {
    nlohmann::json other = nlohmann::json::parse(plan->GetOtherSettings(), nullptr, false);
    if (!other.is_object())
      other = nlohmann::json::object();
    other["series"] = a.series;
    plan->SetOtherSettings(other.dump());
  }
  return plan;
}

void run(const Arguments& a, const Progress& progress)
{
  CaseClient client(progress);
  client.require(client.logic()->Run(begun(client, a)));
}

void segment(const Arguments& a, const Progress& progress)
{
  CaseClient client(progress);
  client.require(client.logic()->Segment(begun(client, a)));
}

void cut(const Arguments& a, const Progress& progress)
{
  CaseClient client(progress);
  client.require(client.logic()->Cut(client.open(a.folder)));
  const nlohmann::json told = read_json(Path(a.folder) / "cut.json");
  for (const nlohmann::json& note : told.at("notes"))
    std::cout << note.get<std::string>() << "\n";
}

// Settings that the command line changes become part of the case; relative paths in them start
// from where the user stands.

/// A file as the command line names it: relative to where the program was started, where a plan's
/// own are relative to its folder.
std::string from_here(const std::string& file)
{
  return std::filesystem::absolute(file).string();
}

void target(const Arguments& a, const Progress& progress)
{
  const auto kinds =
      !a.warp_from.empty() + !a.scan.empty() + !a.target_mesh.empty() + !a.movements.empty();
  if (kinds > 1)
    throw Error("command line",
                "'/target' has " + std::to_string(kinds) + " of mesh, scan, warp and from_movement",
                "give exactly one of them");
  CaseClient client(progress);
  Plan* plan = client.open(a.folder);
  Target* target = plan->GetTargetNode();
  if (!a.warp_from.empty())
  {
    target->SetKind(Target::Warp);
    target->SetWarpFromFileName(from_here(a.warp_from));
    target->SetWarpToFileName(from_here(a.warp_to));
    target->SetWarpRadiusMm(a.warp_radius_mm);
  }
  if (!a.scan.empty())
  {
    target->SetKind(Target::Scan);
    target->SetScanFileName(from_here(a.scan));
  }
  if (!a.target_mesh.empty())
  {
    target->SetKind(Target::Mesh);
    target->SetMeshFileName(from_here(a.target_mesh));
  }
  if (!a.movements.empty())
  {
    target->SetKind(Target::Movement);
    target->RemoveMovements();
    for (const StatedArgument& m : movements_from_arguments(a.movements))
      target->SetMovement(m.fragment, m.coordinates.data());
  }
  client.require(client.logic()->Target(plan));
}

void state_movements(Plan* plan, const std::vector<std::string>& arguments)
{
  if (arguments.empty())
    return;
  plan->RemoveStatedMovements();
  for (const StatedArgument& m : movements_from_arguments(arguments))
    plan->SetStatedMovement(m.fragment, m.coordinates.data());
}

void predict(const Arguments& a, const Progress& progress)
{
  CaseClient client(progress);
  Plan* plan = client.open(a.folder);
  state_movements(plan, a.movements);
  if (!a.model.empty())
    plan->SetPredictModel(a.model);
  client.require(client.logic()->Predict(plan));
}

/// Leaves the case's own movement as it is: the deck states its own.
void export_deck(const Arguments& a, const Progress& progress)
{
  if (a.exported.format == "stl" || a.exported.format == "ply")
  {
    CaseSession session = CaseSession::open(a.folder, progress);
    return export_fragments(session, a.exported.format, a.exported.file);
  }
  CaseClient client(progress);
  if (a.exported.format == "mrb")
    return client.write_bundle(a.folder, a.exported.file);
  Plan* plan = client.open(a.folder);
  state_movements(plan, a.movements);
  client.require(client.logic()->Export(plan, a.exported.format, a.exported.file.string(),
                                        a.exported.split_prisms, a.exported.increments));
}

void add_screenshot(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb = app.add_subcommand("screenshot", "Draw one picture of a case, many, or a film");
  verb->add_option("CASE", a.folder, "Case folder, or a file in it such as case.mrml")->required();
  add_screenshot_options(*verb, a.screenshot);
  actions[verb] = [](const Arguments& args, const Progress& progress)
  {
    CaseSession session = CaseSession::open(folder_of_case(args.folder), progress);
    screenshot_case(session, args.screenshot);
  };
}

/// Adds a verb that reads and writes one case folder.
CLI::App* add_verb(CLI::App& app, Arguments& a, const char* name, const char* help)
{
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_option("DIR", a.folder, "Case folder")->required();
  return verb;
}

CLI::App* add_movements(CLI::App* verb, Arguments& a)
{
  verb->add_option(
      "--movement", a.movements,
      "Movement of a fragment, NAME:right,anterior,superior,pitch,roll,yaw in mm and degrees, "
      "such as 'mid-face:2,11,-5,5,2.5,0'; may be repeated");
  return verb;
}

CLI::App* add_case_verb(CLI::App& app, Arguments& a, const char* name, const char* help,
                        const char* what)
{
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_option("CASE", a.case_file, what)->required();
  verb->add_option("-o,--output", a.folder, "Case folder to write")->required();
  verb->add_option(
      "--series", a.series,
      "Of a DICOM folder with several: number in the list that the error gives, or UID");
  return verb;
}

/// Like CLI::Range, which lets "nan" through.
CLI::Validator within(double low, double high)
{
  std::ostringstream range;
  range << "from " << low << " to " << high;
  return CLI::Validator(
      [=, text = range.str()](std::string& word)
      {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(word, value) && value >= low && value <= high;
        return good ? std::string() : word + " is not a number " + text;
      },
      range.str());
}

void add_sample(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb = app.add_subcommand(
      "sample", "Make the virtual patient: CT, landmarks, true surfaces and case.json");
  verb->add_option("-o,--out", a.folder, "Folder to write")->required();
  verb->add_option("--spacing", a.sample.spacing_mm, "Voxel size [mm]")
      ->check(within(0.5, 3.0))
      ->capture_default_str();
  verb->add_option("--noise", a.sample.noise_sd_hu, "Standard deviation of the noise [HU]")
      ->check(within(0.0, 200.0))
      ->capture_default_str();
  verb->add_option("--retrusion", a.sample.midface_retrusion_mm,
                   "How far the mid-face lies behind [mm]")
      ->check(within(0.0, 10.0))
      ->capture_default_str();
  verb->add_option("--seed", a.sample.seed, "Seed of the noise")->capture_default_str();
  verb->add_flag("--streaks", a.sample.streaks, "Metal streaks from dental crowns");
  verb->add_flag("--head-rest", a.sample.head_rest, "A head rest behind the head");
  actions[verb] = [](const Arguments& args, const Progress& progress)
  { write_sample(args.folder, args.sample, progress); };
}

void fit(const Arguments& a, const Progress&)
{
  const FitMaterialResult result = fit_material(a.fit);
  for (const FittedCurve& curve : result.fits)
    std::cout << fit_summary(curve);
  std::cout << "Material: " << result.files[0].string() << "\nPlot: " << result.files[1].string()
            << "\n";
}

void add_fit_material(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb = app.add_subcommand(
      "fit-material", "Fit a tissue's law to a stress-strain table; writes material and plot");
  auto* data = verb->add_option("DATA", a.fit.data,
                                "Table with '# test: uniaxial' (equibiaxial, simple-shear) and a "
                                "header such as stretch,nominal_stress_kPa");
  auto* table1 = verb->add_option_function<std::string>(
      "--table1",
      [&a](const std::string& tissue)
      {
        a.fit.table1 = true;
        a.fit.tissue = tissue;
      },
      "Fit the curves of the paper's Table 1 instead: skin, fat, muscle, or all");
  table1->expected(0, 1)->excludes(data)->type_name("[TISSUE]");
  verb->add_option("--law", a.fit.law, "yeoh, neo-hookean or mooney-rivlin")->capture_default_str();
  verb->add_flag("--stable", a.fit.stable, "Keep every coefficient >= 0");
  verb->add_option("--poisson-ratio", a.fit.poisson_ratio,
                   "Of the material that is written [0.49, or Table 1's]; the fit is "
                   "incompressible")
      ->check(within(-0.99, 0.4999));
  verb->add_option("-o,--output", a.fit.folder, "Folder for the files")->capture_default_str();
  actions[verb] = fit;
}

void add_export(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb = add_movements(
      add_verb(app, a, "export",
               "Write a movement's forward problem for another engine, or fragments for printing"),
      a);
  verb->add_option(
          "--format", a.exported.format,
          "calculix (.inp), febio (.feb 4.0), vtu (mesh, tissues, boundary, movement), stl or "
          "ply (fragments at rest and planned), mrb (the scene with all data, for Slicer)")
      ->required()
      ->check(CLI::IsMember({"calculix", "febio", "vtu", "stl", "ply", "mrb"}));
  verb->add_option("-o,--output", a.exported.file,
                   "File to write, a folder for stl and ply; in DIR where absent");
  verb->add_flag("--split-prisms", a.exported.split_prisms,
                 "Tetrahedra only: three for each prism of the skin");
  verb->add_option("--increments", a.exported.increments, "Equal shares of the movement")
      ->check(within(1, 1000))
      ->capture_default_str();
  actions[verb] = export_deck;
}

void add_suggest(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb =
      add_verb(app, a, "suggest", "Rank the usual cuts by what they reach of the target");
  verb->add_flag("--confirm", a.suggested.confirm,
                 "Also plan the best two fully, not only to first order");
  verb->add_option("--density", a.suggested.density,
                   "Of the mesh it is computed on [the case's mesh.density, but 0.3 at most]")
      ->check(within(0.02, 8));
  actions[verb] = [](const Arguments& args, const Progress& progress)
  {
    CaseClient client(progress);
    Plan* plan = client.open(args.folder);
    plan->SetSuggestConfirm(args.suggested.confirm);
    plan->SetSuggestDensity(args.suggested.density.value_or(0));
    client.require(client.logic()->Suggest(plan));
  };
}

void add_report(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb =
      add_verb(app, a, "report", "Draw pictures; write report.html, .pdf, .json and tables");
  verb->add_option("--texts", a.report.texts, "A translation of Resources/texts/en.json");
  verb->add_flag("--identity", a.report.identity,
                 "Also tell the scan's folder and the case's notes, which may name the patient");
  actions[verb] = [](const Arguments& args, const Progress& progress)
  {
    CaseClient client(progress);
    Plan* plan = client.open(args.folder);
    plan->SetReportTextsFileName(args.report.texts.string());
    plan->SetReportIdentity(args.report.identity);
    client.require(client.logic()->Report(plan));
  };
}

void evaluate(const Arguments& a, const Progress& progress)
{
  CaseSession session = CaseSession::open(a.folder, progress);
  EvaluateOptions options = a.evaluated;
  if (!a.movements.empty())
  {
    nlohmann::json document = session.document;
    document.erase("predict");
    for (const StatedArgument& m : movements_from_arguments(a.movements))
      document["predict"][m.fragment] = to_movement_json(m.coordinates);
    options.movements = parse_settings(document, "command line").predict;
  }
  if (!a.box_ras.empty())
    options.box_ras =
        Box{{a.box_ras[0], a.box_ras[1], a.box_ras[2]}, {a.box_ras[3], a.box_ras[4], a.box_ras[5]}};
  evaluate_case(session, options);
}

void add_evaluate(CLI::App& app, Arguments& a, std::map<CLI::App*, Action>& actions)
{
  CLI::App* verb = add_movements(
      add_verb(
          app, a, "evaluate",
          "The paper's experiments on a meshed case: tables and colour maps in DIR/evaluation"),
      a);
  EvaluateOptions& options = a.evaluated;
  verb->add_option("--experiments", options.experiments, "Which of 1, 2, 3")
      ->delimiter(',')
      ->check(CLI::IsMember({1, 2, 3}))
      ->capture_default_str();
  verb->add_option("--postoperative", options.postoperative_ct,
                   "The patient's CT after the operation [a virtual patient takes its place]");
  verb->add_option("--box", a.box_ras,
                   "Where the two CTs are registered: least and greatest R, A, S [the cranium]")
      ->expected(6)
      ->delimiter(',');
  verb->add_option("--mask", options.mask,
                   "The same as labels (.nrrd) in the frame of the case's CT");
  verb->add_option("--noise", options.noise_sd_mm,
                   "Of the virtual patient's measured skin: standard deviation [mm]")
      ->check(within(0, 5))
      ->capture_default_str();
  verb->add_option("--noise-length", options.noise_correlation_mm, "Its correlation length [mm]")
      ->check(within(0, 50))
      ->capture_default_str();
  verb->add_option("--seed", options.seed, "Of the noise")->capture_default_str();
  verb->add_flag("!--no-search", options.check_optimum,
                 "Leave out the independent search beside Experiment 3, which takes longest");
  actions[verb] = evaluate;
}

Action on_case(bool (vtkSlicerFaceToBoneLogic::*step)(Plan*))
{
  return [step](const Arguments& a, const Progress& progress)
  {
    CaseClient client(progress);
    Plan* plan = client.open(a.folder);
    client.require((client.logic()->*step)(plan));
  };
}

std::map<CLI::App*, Action> add_verbs(CLI::App& app, Arguments& a)
{
  std::map<CLI::App*, Action> actions;
  add_sample(app, a, actions);
  actions[add_case_verb(app, a, "run", "Do everything: CT and target face in, plan and report out",
                        "Case file (JSON; Resources/Schema/case.schema.json)")] = run;
  actions[add_case_verb(app, a, "segment", "Find skin and bone in the CT; begins a case folder",
                        "Case file, or a CT: DICOM folder, .nrrd, .mha, .mhd, .nii")] = segment;
  actions[add_verb(app, a, "cut", "Cut the bone into fragments")] = cut;
  actions[add_verb(app, a, "mesh", "Mesh skin and soft tissue between face and bone")] =
      on_case(&vtkSlicerFaceToBoneLogic::Mesh);
  CLI::App* target_verb = add_movements(add_verb(app, a, "target", "Make the target face"), a);
  target_verb->add_option("--mesh", a.target_mesh,
                          "The exported skin.vtp after editing (.vtp, .ply, .obj)");
  target_verb->add_option("--scan", a.scan,
                          "A surface with any vertices, such as a face scan, in the CT's frame");
  auto* from = target_verb->add_option("--warp-from", a.warp_from, "Slicer fiducials on the face");
  auto* to = target_verb->add_option("--warp-to", a.warp_to, "Where they should go, same labels");
  from->needs(to);
  to->needs(from);
  target_verb->add_option("--warp-radius", a.warp_radius_mm, "No effect farther than this [mm]")
      ->capture_default_str();
  actions[target_verb] = target;
  add_suggest(app, a, actions);
  actions[add_verb(app, a, "plan", "Find the bone movements that give the target face")] =
      on_case(&vtkSlicerFaceToBoneLogic::Plan);
  CLI::App* predict_verb =
      add_movements(add_verb(app, a, "predict", "Predict the face that a bone movement gives"), a);
  predict_verb->add_option("--model", a.model,
                           "lfem, mtm, nfem or nfm-em (the mixed elements; default)");
  actions[predict_verb] = predict;
  add_export(app, a, actions);
  add_report(app, a, actions);
  add_screenshot(app, a, actions);
  add_evaluate(app, a, actions);
  add_fit_material(app, a, actions);
  return actions;
}

int report_failure(std::string text, int code)
{
  // one line, whatever a library says
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  std::cerr << "facetobone: " << text << "\n";
  return code;
}

/// What was wrong with the arguments, and where to look.
std::string usage_text(const CLI::App& app, const std::string& fault, const std::string& first_word)
{
  const auto verbs = app.get_subcommands();
  if (!verbs.empty())
    return fault + "; see facetobone " + verbs.front()->get_name() + " --help";
  const bool misspelt = !first_word.empty() && first_word[0] != '-';
  return (misspelt ? "'" + first_word + "' is no command" : fault) + "; see facetobone --help";
}

/// Every failure leaves here as one line and one exit code.
int perform(const std::string& verb, const Action& action, const Arguments& a)
{
  try
  {
    {
      ProgressBar bar(a.quiet);
      action(a, bar.callback());
    }
    if (verb == "run" || verb == "plan")
      print_plan(a.folder);
    if (verb == "suggest")
      std::cout << suggestion_table(read_json(Path(a.folder) / "suggest.json"));
    if (verb == "predict")
      print_prediction(a.folder);
    if (verb == "evaluate")
      std::cout << evaluation_text(read_json(Path(a.folder) / "evaluation/evaluation.json"));
    return ok;
  }
  catch (const StepFailure& failure)
  {
    return report_failure(failure.what(), failure.code());
  }
  catch (const Error& error)
  {
    return report_failure(error.what(),
                          error.kind() == ErrorKind::Numerical ? numerical_failure : bad_input);
  }
  catch (const nlohmann::json::exception& error)
  {
    return report_failure("a .json file of the case is not as this program writes it (" +
                              std::string(error.what()) + "); do the step that made it anew",
                          bad_input);
  }
  catch (const std::bad_alloc&)
  {
    return report_failure("memory ran out; use a lower mesh.density or a machine with more memory",
                          any_other);
  }
  catch (const std::exception& error)
  {
    return report_failure(error.what(), any_other);
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app(
      "FaceToBone plans cranio-maxillofacial surgery from the face backwards: give the face that "
      "the\n"
      "patient should have and the bone cuts, and it computes how each fragment must move.\n"
      "Research software, not a medical device.\n\n"
      "Try:  facetobone sample -o patient && facetobone run patient/case.json -o plan");
  app.set_version_flag("--version", std::string("facetobone ") + FACETOBONE_VERSION);
  app.require_subcommand(1);
  app.fallthrough(); // --quiet may stand after the verb
  app.get_formatter()->column_width(32);
  Arguments arguments;
  app.add_flag("-q,--quiet", arguments.quiet, "No progress bar");
  const std::map<CLI::App*, Action> actions = add_verbs(app, arguments);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return app.exit(error); // help or version
    return report_failure(usage_text(app, error.what(), argc > 1 ? argv[1] : ""), bad_input);
  }
  CLI::App* verb = app.get_subcommands().front();
  const TidyAfterKill tidy(arguments.folder);
  return perform(verb->get_name(), actions.at(verb), arguments);
}
