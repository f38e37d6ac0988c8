#include <Rendering/html_report.hpp>

#include <Rendering/atomic_file.hpp>
#include <Rendering/html_text.hpp>
#include <Rendering/report_texts.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

namespace f2b
{

namespace
{

std::string fixed(double value, int decimals)
{
  if (!std::isfinite(value))
  {
    return "not known";
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  // A minus before nothing but zeros says something that is not so.
  const std::string plain = text.data();
  return plain.find_first_of("123456789") == std::string::npos && plain[0] == '-' ? plain.substr(1)
                                                                                  : plain;
}

std::string element(const std::string& tag, const std::string& text)
{
  return "<" + tag + ">" + html_escaped(text) + "</" + tag + ">\n";
}

std::string cell(const std::string& text)
{
  return "<td>" + html_escaped(text) + "</td>";
}

std::string number_cell(const std::string& text)
{
  return "<td class=\"number\">" + html_escaped(text) + "</td>";
}

std::string row_heading(const std::string& text)
{
  return "<th scope=\"row\">" + html_escaped(text) + "</th>";
}

std::string column_heading(const std::string& text, bool is_number = false)
{
  return std::string("<th scope=\"col\"") + (is_number ? " class=\"number\">" : ">") +
         html_escaped(text) + "</th>";
}

std::string fact_table(const std::string& heading, const std::vector<ReportFact>& facts)
{
  if (facts.empty())
  {
    return {};
  }
  std::string html = element("h2", heading) + "<table class=\"facts\"><tbody>\n";
  for (const ReportFact& fact : facts)
  {
    html += "<tr>" + row_heading(fact.key) + cell(fact.value) + "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string list(const std::string& css_class, const std::string& heading,
                 const std::vector<std::string>& items)
{
  std::string html =
      "<section class=\"" + css_class + "\"><h3>" + html_escaped(heading) + "</h3><ul>\n";
  for (const std::string& item : items)
  {
    html += element("li", item);
  }
  return html + "</ul></section>\n";
}

std::string point_text(const Vec3& p)
{
  return "(" + fixed(p[0], 1) + ", " + fixed(p[1], 1) + ", " + fixed(p[2], 1) + ") mm RAS";
}

std::string movement_rows(const ReportFragment& fragment)
{
  std::string html;
  for (const MovementRow& row :
       describe_movement(fragment.translation_ras_mm, fragment.rotation_deg))
  {
    html += "<tr>" + row_heading(fragment.name) + cell(row.axis) + number_cell(amount_text(row)) +
            cell(row.direction) + "</tr>\n";
  }
  return html;
}

std::string movement_table(const ReportMethod& method)
{
  std::string html =
      "<table><caption>The repositioning of the cut bones. Reference points at rest:";
  for (std::size_t i = 0; i < method.fragments.size(); ++i)
  {
    const ReportFragment& fragment = method.fragments[i];
    html += (i == 0 ? " " : "; ") + html_escaped(fragment.name) + " " +
            point_text(fragment.reference_point_ras);
  }
  html += ".</caption><thead><tr>" + column_heading("Region") +
          column_heading("Reference axis/point") + column_heading("Displacement", true) +
          column_heading("Direction") + "</tr></thead><tbody>\n";
  for (const ReportFragment& fragment : method.fragments)
  {
    html += movement_rows(fragment);
  }
  return html + "</tbody></table>\n";
}

std::string movements(const ReportContent& content)
{
  std::string html = element("h2", "Movement of the bones");
  for (const ReportMethod& method : content.methods)
  {
    html += "<section class=\"method\">" + element("h3", method.name);
    html += method.note.empty() ? "" : element("p", method.note);
    html += method.fragments.empty() ? element("p", "No fragment.") : movement_table(method);
    html += "</section>\n";
  }
  html += "<p class=\"note\">" + html_escaped(report_texts::convention) + " " +
          html_escaped(content.frame_note) + "</p>\n";
  return html;
}

struct ErrorRow
{
  const char* name;
  std::function<std::string(const ReportSkinError&)> value;
};

std::vector<ErrorRow> error_rows()
{
  const auto mm = [](double ReportSkinError::*member)
  { return [member](const ReportSkinError& e) { return fixed(e.*member, 2) + " mm"; }; };
  const auto share = [](double ReportSkinError::*member)
  { return [member](const ReportSkinError& e) { return fixed(100 * e.*member, 1) + " %"; }; };
  return {{"Mean", mm(&ReportSkinError::mean)},
          {"Standard deviation", mm(&ReportSkinError::sd)},
          {"Variance", [](const ReportSkinError& e) { return fixed(e.variance, 2) + " mm\u00b2"; }},
          {"Median", mm(&ReportSkinError::median)},
          {"90 % are below", mm(&ReportSkinError::p90)},
          {"95 % are below", mm(&ReportSkinError::p95)},
          {"Maximum", mm(&ReportSkinError::max)},
          {"Share under 1 mm", share(&ReportSkinError::under_1mm)},
          {"Share under 2 mm", share(&ReportSkinError::under_2mm)},
          {"Signed mean", mm(&ReportSkinError::signed_mean)}};
}

std::string error_row(const ErrorRow& row, const std::vector<ReportMethod>& methods)
{
  std::string html = "<tr>" + row_heading(row.name);
  for (const ReportMethod& method : methods)
  {
    html += number_cell(method.skin_error_mm ? row.value(*method.skin_error_mm) : "-");
  }
  return html + "</tr>\n";
}

std::string load_residual_row(const std::vector<ReportMethod>& methods)
{
  std::string html = "<tr>" + row_heading("Load residual");
  for (const ReportMethod& method : methods)
  {
    html += number_cell(method.load_residual_mm ? fixed(*method.load_residual_mm, 2) + " mm" : "-");
  }
  return html + "</tr>\n";
}

std::string skin_errors(const std::vector<ReportMethod>& methods)
{
  std::string html = element("h2", "What the face misses of the target") + "<table><thead><tr>" +
                     column_heading("Skin error");
  for (const ReportMethod& method : methods)
  {
    html += column_heading(method.name, true);
  }
  html += "</tr></thead><tbody>\n";
  for (const ErrorRow& row : error_rows())
  {
    html += error_row(row, methods);
  }
  html += load_residual_row(methods) + "</tbody></table>\n";
  return html + "<p class=\"note\">" + html_escaped(report_texts::error_definition) + "</p>\n";
}

std::string suggestions(const ReportContent& content)
{
  if (content.suggestions.empty())
  {
    return {};
  }
  std::string html = element("h2", "Which cuts reach this target") + "<table><thead><tr>" +
                     column_heading("Cuts") + column_heading("Reached", true) +
                     column_heading("RMS left", true) + column_heading("Movement") +
                     "</tr></thead><tbody>\n";
  for (const ReportSuggestion& s : content.suggestions)
  {
    html += "<tr>" + row_heading(s.cuts) + number_cell(s.reached) + number_cell(s.rms_left) +
            cell(s.movement) + "</tr>\n";
  }
  return html + "</tbody></table>\n<p class=\"note\">" + html_escaped(content.suggestions_note) +
         "</p>\n";
}

std::string region_row(const ReportRegion& region)
{
  const auto mm = [](const std::optional<double>& value)
  { return number_cell(value ? fixed(*value, 2) + " mm" : "-"); };
  return "<tr>" + row_heading(region.name) + mm(region.asked_p90) + mm(region.left_p90) +
         mm(region.error_mean) + mm(region.error_p90) + "</tr>\n";
}

std::string reach(const ReportContent& content)
{
  std::string html = element("h2", "What these cuts reach");
  for (const std::string& sentence : content.reach)
  {
    html += element("p", sentence);
  }
  if (content.regions.empty())
  {
    return html;
  }
  html += "<table><thead><tr>" + column_heading("Region") + column_heading("Asked for", true) +
          column_heading("Left", true) + column_heading("Skin error, mean", true) +
          column_heading("Skin error, 90 % are below", true) + "</tr></thead><tbody>\n";
  for (const ReportRegion& region : content.regions)
  {
    html += region_row(region);
  }
  return html + "</tbody></table>\n<p class=\"note\">" + html_escaped(report_texts::reach_note) +
         "</p>\n";
}

std::string pictures(const std::vector<ReportPicture>& all)
{
  std::string html = all.empty() ? "" : element("h2", "Pictures");
  for (const ReportPicture& picture : all)
  {
    const std::string caption = html_escaped(picture.caption);
    const std::string title = html_escaped(picture.title);
    html += "<figure><img src=\"" + png_data_uri(picture.png) + "\" alt=\"" + title +
            (caption.empty() ? "" : ". " + caption) + "\">\n<figcaption><strong>" + title +
            ".</strong> " + caption + "</figcaption></figure>\n";
  }
  return html;
}

std::string device_box()
{
  return "<p class=\"device\"><strong>" + html_escaped(report_texts::not_a_device) + "</strong> " +
         html_escaped(report_texts::not_a_device_detail) + "</p>\n";
}

std::string header(const ReportContent& content)
{
  return "<header>" + element("h1", content.title) + "<p class=\"case\">Case: <bdi>" +
         html_escaped(content.case_name) + "</bdi></p></header>\n";
}

} // namespace

std::string html_report(const ReportContent& content)
{
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += "<title>" + html_escaped(content.title + ": " + content.case_name) + "</title>\n";
  html += std::string("<style>") + report_texts::style + "</style>\n</head>\n<body>\n";
  html += header(content) + device_box() + "<main>\n";
  if (!content.warnings.empty())
  {
    html += list("warning", "Warnings", content.warnings);
  }
  html += content.methods.empty() ? "" : movements(content) + skin_errors(content.methods);
  html += content.reach.empty() ? "" : reach(content);
  html += fact_table("The cuts after the movement", content.cuts) +
          fact_table("The bite", content.bite);
  html += suggestions(content) + pictures(content.pictures);
  html += fact_table("The case", content.facts) + fact_table("The mesh", content.mesh_facts) +
          fact_table("Times", content.timings);
  html += list("box", "Limitations",
               {report_texts::limitations.begin(), report_texts::limitations.end()});
  html += "</main>\n<footer>" + html_escaped(report_texts::not_a_device) + "</footer>\n";
  return html + "</body>\n</html>\n";
}

void write_html_report(const std::filesystem::path& path, const ReportContent& content)
{
  write_file_atomically(path, html_report(content));
}

} // namespace f2b
