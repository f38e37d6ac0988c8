#include "Case/report_parts.hpp"

namespace f2b
{

ReportColumn report_column(const std::string& key, const Texts& texts, const std::string& unit)
{
  return {key, texts("column." + key), unit};
}

ReportTable report_table(const std::string& id, const std::string& caption,
                         const std::vector<ReportHead>& columns, const Texts& texts)
{
  ReportTable table;
  table.id = id;
  table.caption = caption;
  for (const ReportHead& column : columns)
    table.columns.push_back(report_column(column.key, texts, column.unit));
  return table;
}

std::vector<std::string> methods_of(const nlohmann::json& plan)
{
  std::vector<std::string> methods;
  for (const char* method : {"rigid-fit", "virtual-force"})
    if (plan.at("methods").contains(method))
      methods.emplace_back(method);
  return methods;
}

std::string word(const std::string& english, const Texts& texts)
{
  const std::string key = "word." + english;
  return texts.has(key) ? texts(key) : english;
}

std::string joined(const nlohmann::json& words, const char* between)
{
  std::string text;
  for (const nlohmann::json& one : words)
    text += (text.empty() ? "" : between) + one.get<std::string>();
  return text;
}

} // namespace f2b
