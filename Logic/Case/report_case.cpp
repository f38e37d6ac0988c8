#include "Bridge/json_file.hpp"
#include "Case/case_pictures.hpp"
#include "Case/case_texts.hpp"
#include "Case/plan_findings.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Rendering/html_report.hpp"
#include "Rendering/plan_pictures.hpp"

#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::json;

std::string number(double value, int decimals)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

ReportFragment report_fragment(const json& f)
{
  const json& t = f.at("translation_mm");
  const json& r = f.at("rotation_deg");
  ReportFragment fragment;
  fragment.name = f.at("name").get<std::string>();
  fragment.reference_point_ras = vec3_from(f.at("reference_point_ras"));
  fragment.translation_ras_mm = {t.at("right").get<double>(), t.at("anterior").get<double>(),
                                 t.at("superior").get<double>()};
  fragment.rotation_deg = {r.at("pitch").get<double>(), r.at("roll").get<double>(),
                           r.at("yaw").get<double>()};
  return fragment;
}

ReportSkinError report_error(const json& e)
{
  ReportSkinError error;
  const std::pair<const char*, double*> fields[] = {{"mean", &error.mean},
                                                    {"sd", &error.sd},
                                                    {"variance", &error.variance},
                                                    {"median", &error.median},
                                                    {"p90", &error.p90},
                                                    {"p95", &error.p95},
                                                    {"max", &error.max},
                                                    {"under_1mm", &error.under_1mm},
                                                    {"under_2mm", &error.under_2mm},
                                                    {"signed_mean", &error.signed_mean}};
  for (const auto& [key, field] : fields)
    *field = e.at(key).get<double>();
  return error;
}

std::vector<ReportMethod> report_methods(const json& plan)
{
  const std::pair<const char*, const char*> known[] = {
      {"rigid-fit", "Six degrees of freedom per fragment, fitted to the target face under the "
                    "tissue's equilibrium. The default."},
      {"virtual-force",
       "The paper's method: the skin is pulled to the target and the bone's contact surface is "
       "registered. Biased towards too little movement, shown for comparison."}};
  std::vector<ReportMethod> methods;
  for (const auto& [name, note] : known)
  {
    const json& m = plan.at("methods").at(name);
    ReportMethod method;
    method.name = name;
    method.note = note;
    for (const json& fragment : m.at("fragments"))
      method.fragments.push_back(report_fragment(fragment));
    method.skin_error_mm = report_error(m.at("skin_error_mm"));
    if (m.contains("load_residual_mm"))
      method.load_residual_mm = m.at("load_residual_mm").at("mean").get<double>();
    methods.push_back(std::move(method));
  }
  return methods;
}

std::vector<ReportRegion> report_regions(const json& plan)
{
  const json& errors = plan.at("methods").at("rigid-fit").at("skin_error_mm").at("by_region");
  const json& reach = plan.at("reachability").at("regions");
  std::vector<ReportRegion> regions;
  for (const FaceRegion region : all_face_regions())
  {
    const std::string key = key_of(region);
    if (!errors.contains(key))
      continue;
    ReportRegion row;
    row.name = name_of(region);
    row.error_mean = errors.at(key).at("mean").get<double>();
    row.error_p90 = errors.at(key).at("p90").get<double>();
    if (reach.contains(key))
    {
      row.asked_p90 = reach.at(key).at("asked_mm").at("p90").get<double>();
      row.left_p90 = reach.at(key).at("left_mm").at("p90").get<double>();
    }
    regions.push_back(std::move(row));
  }
  return regions;
}

std::vector<ReportFact> facts_of(const std::vector<std::pair<std::string, std::string>>& rows)
{
  std::vector<ReportFact> facts;
  for (const auto& [key, value] : rows)
    facts.push_back({key, value});
  return facts;
}

std::vector<ReportFact> case_facts(const CaseSession& session, const json& plan)
{
  const json segment = read_json(session.folder.require("segment.json", "segment"));
  const json target = read_json(session.folder.require("target.json", "target"));
  const json cut = read_json(session.folder.require("cut.json", "cut"));
  std::string fragments;
  for (const json& f : cut.at("fragments"))
    fragments += (fragments.empty() ? "" : ", ") + f.at("name").get<std::string>() + " (" +
                 number(f.at("volume_mm3").get<double>() / 1000, 1) + " cm³)";
  return {{"CT", session.settings.ct.filename().string()},
          {"Skin threshold", number(segment.at("skin_threshold_hu"), 0) + " HU"},
          {"Bone threshold", number(segment.at("bone_threshold_hu"), 0) + " HU"},
          {"Fragments", fragments},
          {"Target", target.at("kind").get<std::string>() + ", moves the skin by up to " +
                         number(target.at("peak_displacement_mm"), 1) + " mm"},
          {"Materials", plan.at("materials").get<std::string>()}};
}

std::vector<ReportFact> mesh_facts(const json& mesh)
{
  const json& skin = mesh.at("skin_to_ct_mm");
  return {{"Prisms (skin)", std::to_string(mesh.at("prisms").get<int>())},
          {"Tetrahedra (fat, muscle)", std::to_string(mesh.at("tets").get<int>())},
          {"Nodes", std::to_string(mesh.at("nodes").get<int>())},
          {"Degrees of freedom", std::to_string(mesh.at("dofs").get<int>())},
          {"Smallest dihedral angle", number(mesh.at("min_dihedral_deg"), 1) + "°"},
          {"Smallest scaled Jacobian of a prism", number(mesh.at("min_prism_scaled_jacobian"), 2)},
          {"Mesh skin to CT skin", "95 % within " + number(skin.at("p95"), 2) + " mm, largest " +
                                       number(skin.at("max"), 2) + " mm"}};
}

std::string joined(const json& words, const char* between)
{
  std::string text;
  for (const json& word : words)
    text += (text.empty() ? "" : between) + word.get<std::string>();
  return text;
}

void add_suggestions(ReportContent& content, const json& suggested)
{
  for (const json& s : suggested.at("suggestions"))
  {
    ReportSuggestion line;
    line.cuts = joined(s.at("cuts"), " + ");
    line.reached = number(100 * s.at("reached").get<double>(), 0) + " %";
    line.rms_left = number(s.at("rms_left_mm"), 2) + " mm";
    for (const json& f : s.at("fragments"))
      line.movement += (line.movement.empty() ? "" : ". ") + f.at("name").get<std::string>() +
                       ": " + f.at("movement").get<std::string>();
    content.suggestions.push_back(std::move(line));
  }
  content.suggestions_note =
      "To first order about rest, of a target of " + number(suggested.at("target_rms_mm"), 2) +
      " mm RMS. One more cut must reach " +
      number(100 * suggested.at("criterion").at("cost_of_cut").get<double>(), 0) +
      " % more to rank higher.";
  for (const json& n : suggested.at("not_possible"))
    content.suggestions_note += " Not possible: " + joined(n.at("cuts"), " + ") + ".";
}

std::vector<std::string> warnings(const CaseSession& session, const json& plan)
{
  std::vector<std::string> list = plan.at("warnings").get<std::vector<std::string>>();
  const json segment = read_json(session.folder.require("segment.json", "segment"));
  for (const json& note : segment.at("notes"))
    list.push_back(note.get<std::string>());
  return list;
}

} // namespace

void report_case(CaseSession& session, const ReportOptions& options)
{
  const CaseFolder& folder = session.folder;
  const json plan = read_json(folder.require("plan.json", "plan"));
  session.progress("drawing pictures", 0.1);
  CaseChange change(session.folder);
  const Path picture_folder = change.file("pictures/x").parent_path();
  const Texts texts = case_texts(options.texts);
  const PlanScene scene(case_pictures(folder, {true, true}));
  ReportContent content;
  for (const WrittenPicture& p :
       write_pictures(scene, report_pictures(scene), picture_folder, texts))
    content.pictures.push_back(
        {texts("picture." + p.name + ".title"), texts("picture." + p.name + ".caption"), p.path});

  session.progress("writing the report", 0.9);
  content.title = "FaceToBone plan: " + session.settings.name;
  content.case_name = session.settings.name;
  content.frame_note = "Right, anterior and superior are the scanner's axes.";
  content.facts = case_facts(session, plan);
  content.methods = report_methods(plan);
  if (folder.has("suggest.json"))
    add_suggestions(content, read_json(folder.file("suggest.json")));
  content.reach = plan.at("reachability").at("sentences").get<std::vector<std::string>>();
  content.regions = report_regions(plan);
  content.cuts = facts_of(cut_rows(plan));
  content.bite = facts_of(bite_rows(plan));
  content.mesh_facts = mesh_facts(read_json(folder.require("mesh.json", "mesh")));
  for (const char* step : {"segment", "cut", "mesh", "target", "plan", "total"})
    content.timings.push_back({step, number(plan.at("timing_s").at(step), 1) + " s"});
  content.warnings = warnings(session, plan);
  write_html_report(change.file("report.html"), content);
  change.commit("report");
  session.progress("reported", 1);
}

} // namespace f2b
