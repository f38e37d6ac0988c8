#include "Case/table_files.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

/// Quoted where it must be. A text that a spreadsheet would take for a formula is told as text.
std::string csv_field(const std::string& text)
{
  const bool is_formula = !text.empty() && std::string("=+-@").find(text[0]) != std::string::npos;
  const std::string safe = is_formula && text != "-" ? "'" + text : text;
  if (safe.find_first_of("\",\r\n") == std::string::npos)
    return safe;
  std::string quoted = "\"";
  for (const char c : safe)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_value(const ReportValue& value)
{
  return value.kind == ReportValue::Kind::Number ? json(value.number).dump()
         : value.kind == ReportValue::Kind::Text ? csv_field(value.text)
                                                 : "";
}

} // namespace

std::string csv_of(const ReportTable& table)
{
  std::string csv;
  for (const ReportColumn& column : table.columns)
    csv += (csv.empty() ? "" : ",") +
           csv_field(column.key + (column.unit.empty() ? "" : " [" + column.unit + "]"));
  csv += "\r\n";
  for (const auto& row : table.rows)
  {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += (c == 0 ? "" : ",") + csv_value(row[c]);
    csv += line + "\r\n";
  }
  return csv;
}

json to_json(const ReportTable& table)
{
  json columns = json::array(), rows = json::array();
  for (const ReportColumn& c : table.columns)
    columns.push_back({{"key", c.key}, {"title", c.title}, {"unit", c.unit}});
  for (const auto& row : table.rows)
  {
    json values = json::array();
    for (const ReportValue& v : row)
      values.push_back(v.kind == ReportValue::Kind::Number ? json(v.number)
                       : v.kind == ReportValue::Kind::Text ? json(v.text)
                                                           : json());
    rows.push_back(std::move(values));
  }
  return {{"id", table.id}, {"caption", table.caption}, {"columns", columns}, {"rows", rows}};
}

} // namespace f2b
