#include "Case/report_facts.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Bridge/material_file.hpp"
#include "Case/file_checksum.hpp"
#include "Case/library_versions.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Case/report_parts.hpp"

#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::json;

std::string number(double value, int decimals)
{
  return ReportValue(value, decimals).shown();
}

/// A table of two columns that needs no head.
ReportTable facts(const std::string& id, const Texts& texts)
{
  ReportTable table;
  table.id = id;
  table.caption = texts("table." + id);
  table.columns = {{"what", "", ""}, {"value", "", ""}};
  return table;
}

std::string joined_fragments(const json& cut)
{
  std::string text;
  for (const json& f : cut.at("fragments"))
    text += (text.empty() ? "" : ", ") + f.at("name").get<std::string>() + " (" +
            number(f.at("volume_mm3").get<double>() / 1000, 1) + " cm\u00b3)";
  return text;
}

std::string box_text(const json& box)
{
  std::string text;
  const char* letters[] = {"R", "A", "S"};
  for (std::size_t i = 0; i < 3; ++i)
    text += (i == 0 ? "" : ", ") + std::string(letters[i]) + " " +
            number(box.at("min").at(i).get<double>(), 0) + " - " +
            number(box.at("max").at(i).get<double>(), 0);
  return text + " mm";
}

std::vector<ReportValue> point_row(const std::string& name, const Vec3& p)
{
  return {name, ReportValue(p.x(), 1), ReportValue(p.y(), 1), ReportValue(p.z(), 1)};
}

/// A law as its file tells it: "c1 0.04796 MPa, c2 0.05163 MPa".
std::vector<ReportValue> law_row(Tissue tissue, const Law& law, const Texts& texts)
{
  const nlohmann::ordered_json entry = tissue_entry(law);
  std::string coefficients;
  for (const auto& [key, value] : entry.items())
    if (value.is_number() && key != "poisson_ratio")
    {
      char text[80];
      std::snprintf(text, sizeof text, "%s %.5g", key.c_str(), value.get<double>());
      coefficients += (coefficients.empty() ? "" : ", ") + std::string(text);
    }
  return {texts(std::string("tissue.") + name_of(tissue)), entry.at("law").get<std::string>(),
          coefficients, ReportValue(entry.at("poisson_ratio").get<double>(), 2)};
}

ReportTable laws(const CaseSettings& settings, const Texts& texts)
{
  const MaterialSet materials = read_materials(settings.materials);
  ReportTable table =
      report_table("materials", texts("table.materials", {{"name", materials.name}}),
                   {{"tissue"}, {"law"}, {"coefficients", "MPa"}, {"poisson_ratio"}}, texts);
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
    table.rows.push_back(law_row(tissue, materials.of(tissue), texts));
  return table;
}

ReportTable mesh_table(const json& plan, const json& mesh, const Texts& texts)
{
  ReportTable table = facts("mesh", texts);
  const json& m = plan.at("mesh");
  const std::tuple<const char*, int, const char*> rows[] = {{"prisms", 0, ""},
                                                            {"tets", 0, ""},
                                                            {"nodes", 0, ""},
                                                            {"dofs", 0, ""},
                                                            {"min_dihedral_deg", 1, "\u00b0"},
                                                            {"min_prism_scaled_jacobian", 2, ""}};
  for (const auto& [key, decimals, unit] : rows)
    table.rows.push_back(
        {texts(std::string("mesh.") + key), number(m.at(key).get<double>(), decimals) + unit});
  const json& skin = mesh.at("skin_to_ct_mm");
  table.rows.push_back(
      {texts("mesh.skin_to_ct"),
       texts("mesh.skin_to_ct.value", {{"p95", number(skin.at("p95").get<double>(), 2)},
                                       {"max", number(skin.at("max").get<double>(), 2)}})});
  return table;
}

ReportTable solver_table(const json& plan, const Texts& texts)
{
  ReportTable table = report_table("solver", texts("table.solver"),
                                   {{"method"},
                                    {"load_reached", "%"},
                                    {"load_steps"},
                                    {"newton_iterations"},
                                    {"factorizations"},
                                    {"cg_iterations"},
                                    {"stretch_max"},
                                    {"outside_stable", "%"}},
                                   texts);
  for (const std::string& method : methods_of(plan))
  {
    const json& m = plan.at("methods").at(method);
    const json& solve = m.at("equilibrium");
    double outside = 0;
    for (const auto& [tissue, told] : m.at("stability").items())
      outside = std::max(outside, told.value("share_outside", 0.0));
    table.rows.push_back({method, ReportValue(100 * solve.at("load_reached").get<double>(), 0),
                          ReportValue(solve.at("load_steps").get<double>(), 0),
                          ReportValue(solve.at("newton_iterations").get<double>(), 0),
                          ReportValue(solve.at("factorizations").get<double>(), 0),
                          ReportValue(solve.at("cg_iterations").get<double>(), 0),
                          ReportValue(m.at("tissue_stretch").at("max").get<double>(), 2),
                          ReportValue(100 * outside, 2)});
  }
  table.note = texts(
      "note.solver",
      {{"termination", plan.at("methods").at("rigid-fit").at("termination").get<std::string>()}});
  return table;
}

/// A note as a step wrote it, to stand between others.
std::string sentence(std::string note)
{
  if (!note.empty() && note.front() >= 'a' && note.front() <= 'z')
    note.front() = static_cast<char>(note.front() - 'a' + 'A');
  return note + (note.empty() || note.back() == '.' ? "" : ".");
}

/// Frankfort horizontal and mid-sagittal plane, in the scanner's axes.
ReportTable patient_axes(const json& frame, const Texts& texts)
{
  ReportTable table =
      report_table("patient_axes", texts("table.patient_axes"),
                   {{"patient_axis"}, {"right"}, {"anterior"}, {"superior"}}, texts);
  for (const auto& [key, decimals] :
       {std::pair{"right", 3}, {"anterior", 3}, {"superior", 3}, {"origin", 1}})
  {
    std::vector<ReportValue> row{texts(std::string("frame.") + key)};
    for (const json& x : frame.at(std::string(key) + "_ras"))
      row.emplace_back(x.get<double>(), decimals);
    table.rows.push_back(std::move(row));
  }
  table.note = texts("note.patient-frame");
  return table;
}

/// What computed the plan, and what it was computed from.
ReportTable versions(const CaseSession& session, const json& plan, const Texts& texts)
{
  ReportTable table = facts("versions", texts);
  const json reporting = library_versions();
  const json planning = plan.value("versions", reporting);
  for (const json& one : planning)
    table.rows.push_back({one.at(0).get<std::string>(), one.at(1).get<std::string>()});
  if (planning != reporting)
    table.rows.push_back({texts("version.report"), reporting.at(0).at(1).get<std::string>()});
  table.rows.push_back({texts("version.case"), session.document.at("schema").get<std::string>()});
  table.rows.push_back({texts("version.plan"), plan.at("schema").get<std::string>()});
  return table;
}

ReportTable input_table(const json& inputs, const Texts& texts)
{
  ReportTable table =
      report_table("inputs", texts("table.inputs"), {{"input"}, {"files"}, {"sha256"}}, texts);
  for (const json& input : inputs)
    table.rows.push_back({texts("input." + input.at("input").get<std::string>()),
                          ReportValue(input.at("files").get<double>(), 0),
                          input.at("sha256").get<std::string>()});
  table.note = texts("note.inputs");
  table.is_code = true;
  return table;
}

} // namespace

ReportSection case_section(const CaseSession& session, bool identity, const Texts& texts)
{
  const CaseFolder& folder = session.folder;
  const json segment = read_json(folder.require("segment.json", "segment"));
  const json target = read_json(folder.require("target.json", "target"));
  const json cut = read_json(folder.require("cut.json", "cut"));
  ReportTable table = facts("case", texts);
  auto add = [&](const char* key, const std::string& value) {
    table.rows.push_back({texts(std::string("case.") + key), value});
  };
  const bool is_folder = std::filesystem::is_directory(session.settings.ct);
  add("scan", is_folder ? texts("case.scan.dicom") : session.settings.ct.extension().string());
  if (identity)
  {
    add("path", session.settings.ct.string());
    add("notes", session.document.value("notes", std::string("-")));
  }
  add("spacing", number(session.settings.spacing_mm, 2) + " mm");
  add("skin_threshold", number(segment.at("skin_threshold_hu").get<double>(), 0) + " HU");
  add("bone_threshold", number(segment.at("bone_threshold_hu").get<double>(), 0) + " HU");
  add("region", box_text(segment.at("region_ras")));
  add("fragments", joined_fragments(cut));
  add("target", texts("case.target.value",
                      {{"kind", texts("target." + target.at("kind").get<std::string>())},
                       {"peak", number(target.at("peak_displacement_mm").get<double>(), 1)}}));
  add("release", number(session.settings.release_margin_mm, 1) + " mm");
  ReportSection section;
  section.heading = texts("section.case");
  section.tables.push_back(std::move(table));
  for (const json& note : segment.at("notes"))
    section.note += (section.note.empty() ? "" : " ") + sentence(note.get<std::string>());
  return section;
}

ReportSection frame_section(const CaseFolder& folder, const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.frame");
  section.paragraphs = {texts("note.frame")};
  const json frame = plan.value("patient_frame", json::object());
  if (frame.contains("origin_ras"))
    section.tables.push_back(patient_axes(frame, texts));
  else if (frame.contains("missing_landmarks"))
    section.paragraphs.push_back(
        texts("note.no-patient-frame", {{"landmarks", joined(frame.at("missing_landmarks"))}}));
  if (!folder.has("landmarks.mrk.json"))
    return section;
  ReportTable table =
      report_table("landmarks", texts("table.landmarks"),
                   {{"landmark"}, {"right", "mm"}, {"anterior", "mm"}, {"superior", "mm"}}, texts);
  for (const auto& [name, position] : read_landmarks(folder.file("landmarks.mrk.json")))
    table.rows.push_back(point_row(name, position));
  table.is_long = true;
  section.tables.push_back(std::move(table));
  return section;
}

ReportSection osteotomy_section(const CaseFolder& folder, const Texts& texts)
{
  ReportTable table = report_table("osteotomies", texts("table.osteotomies"),
                                   {{"fragment"},
                                    {"plane"},
                                    {"right", "mm"},
                                    {"anterior", "mm"},
                                    {"superior", "mm"},
                                    {"normal"},
                                    {"plane_size", "mm"},
                                    {"kerf", "mm"}},
                                   texts);
  for (const Osteotomy& o : placed_osteotomies(folder))
    for (const BoundedPlane& p : o.planes)
    {
      const Vec3 n = p.normal();
      table.rows.push_back({o.fragment, p.name, ReportValue(p.center.x(), 1),
                            ReportValue(p.center.y(), 1), ReportValue(p.center.z(), 1),
                            number(n.x(), 3) + ", " + number(n.y(), 3) + ", " + number(n.z(), 3),
                            number(2 * p.half_u, 0) + " x " + number(2 * p.half_v, 0),
                            ReportValue(o.kerf_mm, 1)});
    }
  ReportSection section;
  section.heading = texts("section.osteotomies");
  section.tables.push_back(std::move(table));
  return section;
}

ReportSection model_section(const CaseSession& session, const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.model");
  section.tables.push_back(
      mesh_table(plan, read_json(session.folder.require("mesh.json", "mesh")), texts));
  section.tables.push_back(laws(session.settings, texts));
  section.tables.push_back(solver_table(plan, texts));
  return section;
}

ReportSection timing_section(const json& plan, const Texts& texts)
{
  ReportTable table = facts("timings", texts);
  for (const char* step : {"segment", "cut", "mesh", "target", "rigid_fit", "intervals",
                           "virtual_force", "plan", "total"})
    if (plan.at("timing_s").contains(step))
      table.rows.push_back({texts(std::string("step.") + step),
                            number(plan.at("timing_s").at(step).get<double>(), 1) + " s"});
  table.rows.push_back(
      {texts("step.memory"), number(plan.at("peak_rss_mb").get<double>(), 0) + " MB"});
  ReportSection section;
  section.heading = texts("section.timings");
  section.tables.push_back(std::move(table));
  return section;
}

ReportSection provenance_section(const CaseSession& session, const json& plan, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.provenance");
  section.tables = {versions(session, plan, texts)};
  if (const json inputs = plan.value("inputs", json::array()); !inputs.empty())
    section.tables.push_back(input_table(inputs, texts));
  ReportTable checksums = facts("checksums", texts);
  checksums.is_code = true;
  for (const char* name : {"case.json", "ct.nrrd", "landmarks.mrk.json", "skin.vtp",
                           "cuts.mrk.json", "mesh.vtu", "target.vtp", "predicted_rigid-fit.vtp"})
    if (session.folder.has(name))
      checksums.rows.push_back({name, sha256_of(session.folder.file(name))});
  section.tables.push_back(std::move(checksums));
  return section;
}

} // namespace f2b
