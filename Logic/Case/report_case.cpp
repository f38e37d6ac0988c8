#include "Bridge/json_file.hpp"
#include "Case/case_pictures.hpp"
#include "Case/case_texts.hpp"
#include "Case/report_facts.hpp"
#include "Case/report_results.hpp"
#include "Case/table_files.hpp"
#include "Case/verbs.hpp"
#include "Case/viewer_sources.hpp"
#include "Core/error.hpp"
#include "Rendering/atomic_file.hpp"
#include "Rendering/html_report.hpp"
#include "Rendering/pdf_report.hpp"
#include "Rendering/plan_pictures.hpp"

#include <future>

namespace f2b
{
namespace
{

using nlohmann::json;

/// Texts with one key and a number at its end: "limitation.1", "limitation.2", ...
std::vector<std::string> numbered(const std::string& key, const Texts& texts)
{
  std::vector<std::string> list;
  for (int i = 1; texts.has(key + std::to_string(i)); ++i)
    list.push_back(texts(key + std::to_string(i)));
  return list;
}

ReportSection picture_section(const std::vector<WrittenPicture>& pictures, const Texts& texts)
{
  ReportSection section;
  section.heading = texts("section.pictures");
  for (const WrittenPicture& p : pictures)
    section.pictures.push_back(
        {texts("picture." + p.name + ".title"), texts("picture." + p.name + ".caption"), p.path});
  return section;
}

std::vector<std::string> warnings_of(const CaseFolder& folder, const json& plan)
{
  auto list = plan.at("warnings").get<std::vector<std::string>>();
  if (folder.has("predict.json"))
    for (const json& warning : read_json(folder.file("predict.json")).at("warnings"))
      list.push_back("predict: " + warning.get<std::string>());
  return list;
}

json plan_of(const CaseFolder& folder)
{
  const Path file = folder.require("plan.json", "plan");
  json plan = read_json(file);
  if (!plan.is_object() || plan.value("schema", json()) != "facetobone-plan/1")
    throw Error(file.string(), "it is no plan of the form facetobone-plan/1",
                "run 'facetobone plan' on this folder again");
  return plan;
}

/// One run of the verb.
class Reporting
{
public:
  Reporting(CaseSession& session, const ReportOptions& options)
      : m_session(session), m_options(options), m_folder(session.folder),
        m_texts(case_texts(options.texts)), m_plan(plan_of(m_folder)), m_change(session.folder),
        m_scene(case_pictures(m_folder, {true, true}))
  {
  }

  void draw();
  void write();

private:
  void compose(std::vector<std::string> warnings);
  void write_tables() const;
  std::string write_print(const ReportDocument& document) const;

  CaseSession& m_session;
  const ReportOptions& m_options;
  const CaseFolder& m_folder;
  Texts m_texts;
  json m_plan;
  CaseChange m_change;
  PlanScene m_scene;
  std::vector<WrittenPicture> m_pictures;
  ReportDocument m_document;
};

void Reporting::draw()
{
  m_session.progress("drawing pictures", 0.1);
  const Path folder = m_change.file("pictures/x").parent_path();
  m_pictures = write_pictures(m_scene, report_pictures(m_scene), folder, m_texts);
}

void Reporting::compose(std::vector<std::string> warnings)
{
  m_document = {};
  m_document.language = m_texts("language");
  m_document.title = m_texts("title");
  m_document.case_line = m_texts("case-line", {{"name", m_session.settings.name}});
  m_document.disclaimer = m_texts("disclaimer");
  m_document.disclaimer_detail = m_texts("disclaimer.detail");
  auto& sections = m_document.sections;
  if (!warnings.empty())
  {
    sections.emplace_back();
    sections.back().heading = m_texts("section.warnings");
    sections.back().points = std::move(warnings);
    sections.back().kind = ReportSection::Kind::Warning;
  }
  ReportSection limitations;
  limitations.heading = m_texts("section.limitations");
  limitations.points = numbered("limitation.", m_texts);
  limitations.kind = ReportSection::Kind::Box;
  sections.push_back(movement_section(m_plan, m_texts));
  sections.push_back(reach_section(m_plan, m_texts));
  sections.push_back(limitations);
  sections.push_back(picture_section(m_pictures, m_texts));
  sections.back().holds_viewer = true;
  sections.push_back(error_section(m_plan, m_texts));
  sections.push_back(cephalometry_section(m_plan, m_texts));
  sections.push_back(cut_section(m_plan, m_texts));
  if (m_folder.has("suggest.json"))
    sections.push_back(suggestion_section(read_json(m_folder.file("suggest.json")), m_texts));
  sections.push_back(case_section(m_session, m_options.identity, m_texts));
  sections.push_back(frame_section(m_folder, m_plan, m_texts));
  sections.push_back(osteotomy_section(m_folder, m_texts));
  sections.push_back(model_section(m_session, m_plan, m_texts));
  sections.push_back(timing_section(m_plan, m_texts));
  sections.push_back(provenance_section(m_session, m_plan, m_texts));
}

void Reporting::write_tables() const
{
  json tables = json::array();
  for (const ReportSection& section : m_document.sections)
    for (const ReportTable& table : section.tables)
    {
      tables.push_back(to_json(table));
      write_file_atomically(m_change.file("tables/" + table.id + ".csv"), csv_of(table));
    }
  write_json(m_change.file("report.json"),
             {{"schema", "facetobone-report/1"},
              {"name", m_session.settings.name},
              {"disclaimer", m_texts("disclaimer")},
              {"cephalometry", cephalometry_of(m_plan).at("measures")},
              {"tables", tables}});
}

/// The PDF, from the same document; why there is none, if so.
std::string Reporting::write_print(const ReportDocument& document) const
{
  const Path print = m_change.file(".print.html");
  write_file_atomically(print, html_report(document));
  const PdfResult pdf = write_pdf(print, m_change.file("report.pdf"));
  std::filesystem::remove(print);
  return pdf.reason;
}

void Reporting::write()
{
  m_session.progress("writing the report", 0.7);
  std::vector<std::string> warnings = warnings_of(m_folder, m_plan);
  compose(warnings);
  write_tables();
  std::future<std::string> print = std::async(std::launch::async, [this, document = m_document]
                                              { return write_print(document); });
  const std::optional<ViewerParts> viewer = case_viewer(m_scene, m_texts);
  if (const std::string no_pdf = print.get(); !no_pdf.empty())
  {
    warnings.push_back(no_pdf);
    compose(warnings);
  }
  write_file_atomically(m_change.file("report.html"), html_report(m_document, viewer));
  m_change.commit("report");
}

} // namespace

void report_case(CaseSession& session, const ReportOptions& options)
{
  try
  {
    Reporting reporting(session, options);
    reporting.draw();
    reporting.write();
  }
  catch (const json::exception& fault)
  {
    throw Error(session.folder.path().string(),
                std::string("a .json file in it is not what a step writes (") + fault.what() + ")",
                "run the steps on this folder again, from 'segment'");
  }
  session.progress("reported", 1);
}

} // namespace f2b
