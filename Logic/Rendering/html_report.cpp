#include <Rendering/html_report.hpp>

#include <Rendering/html_text.hpp>
#include <Rendering/report_style.hpp>

namespace f2b
{

namespace
{

std::string element(const std::string& tag, const std::string& text)
{
  return "<" + tag + ">" + html_escaped(text) + "</" + tag + ">\n";
}

// A name may be written from right to left: it must not turn what stands around it.
std::string isolated(const std::string& text)
{
  return "<bdi>" + html_escaped(text) + "</bdi>";
}

bool is_numeric(const ReportTable& table, std::size_t column)
{
  for (const auto& row : table.rows)
  {
    if (column < row.size() && row[column].kind == ReportValue::Kind::Number)
    {
      return true;
    }
  }
  return false;
}

std::string table_head(const ReportTable& table)
{
  std::string html = "<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c)
  {
    const ReportColumn& column = table.columns[c];
    html += std::string("<th scope=\"col\"") + (is_numeric(table, c) ? " class=\"number\">" : ">") +
            html_escaped(column.title) +
            (column.unit.empty() ? "" : " [" + html_escaped(column.unit) + "]") + "</th>";
  }
  return html + "</tr></thead>";
}

std::string table_row(const ReportTable& table, const std::vector<ReportValue>& row)
{
  std::string html = "<tr>";
  for (std::size_t c = 0; c < row.size(); ++c)
  {
    const std::string text = isolated(row[c].shown());
    html += c == 0                 ? "<th scope=\"row\">" + text + "</th>"
            : is_numeric(table, c) ? "<td class=\"number\">" + text + "</td>"
                                   : "<td>" + text + "</td>";
  }
  return html + "</tr>\n";
}

std::string table_html(const ReportTable& table)
{
  constexpr std::size_t many_columns = 9;
  const bool has_head = !table.columns.empty() && !table.columns[0].title.empty();
  std::string html =
      "<div class=\"" + std::string(table.is_long ? "long" : "short") + "\">" +
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" +
      html_escaped(table.caption) + "\"><table class=\"" + (has_head ? "" : "facts ") +
      (table.columns.size() > many_columns ? "wide " : "") + (table.is_code ? "code " : "") + "\">";
  html += "<caption>" + html_escaped(table.caption) + "</caption>";
  html += (has_head ? table_head(table) : "") + "<tbody>\n";
  for (const auto& row : table.rows)
  {
    html += table_row(table, row);
  }
  html += "</tbody></table></div>\n";
  return html +
         (table.note.empty() ? "" : "<p class=\"note\">" + html_escaped(table.note) + "</p>\n") +
         "</div>\n";
}

std::string picture_html(const ReportPicture& picture)
{
  const std::string caption = html_escaped(picture.caption);
  const std::string title = html_escaped(picture.title);
  return "<figure><img src=\"" + png_data_uri(picture.png) + "\" alt=\"" + title +
         (caption.empty() ? "" : ". " + caption) + "\">\n<figcaption><strong>" + title +
         ".</strong> " + caption + "</figcaption></figure>\n";
}

std::string section_html(const ReportSection& section, const std::optional<ViewerParts>& viewer)
{
  const bool is_plain = section.kind == ReportSection::Kind::Plain;
  std::string html = is_plain                                   ? "<section>\n"
                     : section.kind == ReportSection::Kind::Box ? "<section class=\"box\">\n"
                                                                : "<section class=\"warning\">\n";
  html += element("h2", section.heading);
  if (section.holds_viewer && viewer)
  {
    html += viewer->html;
  }
  for (const std::string& paragraph : section.paragraphs)
  {
    html += element("p", paragraph);
  }
  if (!section.points.empty())
  {
    html += "<ul>\n";
    for (const std::string& point : section.points)
    {
      html += element("li", point);
    }
    html += "</ul>\n";
  }
  for (const ReportTable& table : section.tables)
  {
    html += table_html(table);
  }
  for (const ReportPicture& picture : section.pictures)
  {
    html += picture_html(picture);
  }
  html += section.note.empty() ? "" : "<p class=\"note\">" + html_escaped(section.note) + "</p>\n";
  return html + "</section>\n";
}

std::string head(const ReportDocument& document)
{
  return "<!DOCTYPE html>\n<html lang=\"" + html_escaped(document.language) +
         "\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html_escaped(document.title) + "</title>\n<style>" + report_style + "</style>\n</head>\n";
}

// A script's text ends at the first "</script" and may hold comments of HTML: neither occurs then.
std::string script_safe(std::string text)
{
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
  {
    text.replace(at, 2, "<\\/");
  }
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at + 4))
  {
    text.replace(at, 4, "<\\!--");
  }
  return text;
}

} // namespace

std::string html_report(const ReportDocument& document, const std::optional<ViewerParts>& viewer)
{
  std::string html = head(document) + "<body>\n<header>" + element("h1", document.title) +
                     "<p class=\"case\">" + isolated(document.case_line) +
                     "</p></header>\n<main>\n";
  html += "<p class=\"device\"><strong>" + html_escaped(document.disclaimer) + "</strong> " +
          html_escaped(document.disclaimer_detail) + "</p>\n";
  for (const ReportSection& section : document.sections)
  {
    html += section_html(section, viewer);
  }
  html += "</main>\n<footer>" + html_escaped(document.disclaimer) + "</footer>\n";
  if (viewer)
  {
    html += "<script type=\"application/json\" id=\"viewer-data\">" + script_safe(viewer->data) +
            "</script>\n<script>" + script_safe(viewer->library) + "</script>\n<script>" +
            script_safe(viewer->script) + "</script>\n";
  }
  return html + "</body>\n</html>\n";
}

} // namespace f2b
