#include "Case/evaluation_tables.hpp"

#include <algorithm>
#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::json;
using Row = std::vector<std::string>;

std::string number(const json& value, int decimals = 3)
{
  if (!value.is_number())
    return "";
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", decimals, value.get<double>());
  return text;
}

std::string percent(const json& share)
{
  return number(100 * share.get<double>(), 1);
}

void append_error(Row& row, const json& error)
{
  for (const char* key : {"mean", "sd", "variance", "median", "p90", "p95", "max", "signed_mean"})
    row.push_back(number(error.at(key)));
  row.push_back(percent(error.at("under_1mm")));
  row.push_back(percent(error.at("under_2mm")));
}

const Row error_columns = {"mean", "sd",  "variance", "median",  "p90",
                           "p95",  "max", "signed",   "<1 mm %", "<2 mm %"};

void append_paper(Row& row, const json& paper)
{
  for (const char* key : {"mean", "variance", "max"})
    row.push_back(number(paper.at(key), 2));
}

const Row paper_columns = {"paper mean", "paper variance", "paper max"};

Row with_columns(Row first, const Row& then)
{
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

Table models_table(const json& experiment)
{
  Table table{"Experiment 1: predicted against actual face [mm] (paper Table 3)",
              with_columns(with_columns({"model", "skin"}, error_columns), paper_columns),
              {}};
  const std::pair<const char*, const char*> parts[] = {
      {"error_mm", "all"},
      {"cut_mm", "over the fragments"},
      {"outside_cut_mm", "elsewhere"},
      {"without_noise_mm", "all, noise of measuring left out"}};
  for (const auto& [key, part] : parts)
    for (const json& r : experiment.at("rows"))
    {
      if (!r.contains(key))
        continue;
      Row row = {r.at("model"), part};
      append_error(row, r.at(key));
      if (key == std::string("error_mm"))
        append_paper(row, r.at("paper_mm"));
      row.resize(table.columns.size());
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table bones_table(const json& experiment)
{
  Table table{"Experiment 2: bone where it is planned against where it went [mm] (paper Table 4)",
              with_columns(with_columns({"target", "method"}, error_columns), paper_columns),
              {}};
  for (const json& r : experiment.at("rows"))
    for (const auto& [method, found] : r.at("methods").items())
    {
      Row row = {r.at("name"), method};
      append_error(row, found.at("bone_error_mm"));
      append_paper(row, r.at("paper_mm"));
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table targets_table(const json& experiment)
{
  Table table{"Experiment 3: predicted against target face [mm] (paper Fig. 12: mean 0.75, p90 1.5 "
              "inside the cut)",
              with_columns(with_columns({"target", "plan", "skin"}, error_columns),
                           {"weighted RMS", "best RMS of an independent search"}),
              {}};
  auto add = [&](const json& r, const json& of, const char* plan)
  {
    for (const bool cut : {true, false})
    {
      Row row = {r.at("target"), plan, cut ? "over the fragments" : "all"};
      append_error(row, cut ? of.at("error_mm").at("cut") : of.at("error_mm"));
      if (!cut && of.contains("weighted_rms_mm"))
        row.push_back(number(of.at("weighted_rms_mm"), 4));
      if (!cut && of.contains("independent_search"))
        row.push_back(number(of.at("independent_search").at("weighted_rms_mm"), 4));
      row.resize(table.columns.size());
      table.rows.push_back(std::move(row));
    }
  };
  for (const json& r : experiment.at("rows"))
  {
    add(r, r, "rigid-fit");
    add(r, r.at("virtual_force"), "virtual-force");
    if (r.contains("with_genioplasty") && r.at("with_genioplasty").contains("error_mm"))
      add(r, r.at("with_genioplasty"), "rigid-fit, chin cut too");
  }
  return table;
}

std::string quoted(const std::string& cell)
{
  if (cell.find_first_of(",\"\n") == std::string::npos)
    return cell;
  std::string text = "\"";
  for (const char c : cell)
    text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string truth_text(const json& actual)
{
  std::string text = "Measured against a " + actual.at("kind").get<std::string>() +
                     " (correspondence: " + actual.at("correspondence").get<std::string>() + ").";
  if (!actual.contains("differs_from_plan"))
    return text + "\n";
  const json& d = actual.at("differs_from_plan");
  const json& noise = actual.at("skin_noise");
  text += " It is not as the plan believes: " +
          std::to_string(d.at("mesh").at("tetrahedra_of_truth").get<int>()) +
          " tetrahedra only, against " +
          std::to_string(d.at("mesh").at("prisms_of_plan").get<int>()) + " prisms and " +
          std::to_string(d.at("mesh").at("tetrahedra_of_plan").get<int>()) + " tetrahedra; law " +
          d.at("law_of_truth").get<std::string>() + " against " +
          d.at("materials_of_plan").get<std::string>() + "; skin " +
          number(d.at("skin_thickness_of_truth_mm"), 1) + " mm thick";
  for (const auto& [tissue, t] : d.at("tissue").items())
    text += "; " + tissue + " mu " + number(t.at("shear_modulus_of_truth_kpa"), 1) + " against " +
            number(t.at("shear_modulus_of_plan_kpa"), 1) + " kPa, nu " +
            number(t.at("poisson_ratio_of_truth"), 2) + " against " +
            number(t.at("poisson_ratio_of_plan"), 2);
  return text + "; measured skin with noise of " + number(noise.at("sd_mm_per_component"), 2) +
         " mm per component over " + number(noise.at("correlation_length_mm"), 0) +
         " mm. It shares with the plan: " + d.at("shares_with_the_plan").get<std::string>() + ".\n";
}

std::string findings_text(const json& evaluation)
{
  std::string text;
  if (evaluation.contains("experiment1"))
    text += "\nExperiment 1: the least mean error has " +
            evaluation.at("experiment1").at("verdict").at("least_mean_error").get<std::string>() +
            "; " + evaluation.at("experiment1").at("verdict").at("note").get<std::string>() + ".\n";
  if (evaluation.contains("experiment2"))
    for (const json& r : evaluation.at("experiment2").at("rows"))
      text += "Experiment 2, " + r.at("name").get<std::string>() + ": target is " +
              r.at("target").get<std::string>() + ".\n";
  if (evaluation.contains("experiment3"))
    for (const json& r : evaluation.at("experiment3").at("rows"))
    {
      const std::string name = "Experiment 3, target " + r.at("target").get<std::string>() + ": ";
      for (const json& sentence : r.at("sentences"))
        text += name + sentence.get<std::string>() + "\n";
      if (r.contains("with_genioplasty") && r.at("with_genioplasty").contains("chin") &&
          r.at("chin").is_object())
        text += name + "with the chin cut too, " +
                number(r.at("with_genioplasty").at("chin").at("left_p90_mm"), 2) +
                " mm are left at the chin instead of " + number(r.at("chin").at("left_p90_mm"), 2) +
                " mm.\n";
    }
  return text;
}

} // namespace

std::vector<std::pair<std::string, Table>> evaluation_tables(const json& evaluation)
{
  std::vector<std::pair<std::string, Table>> tables;
  if (evaluation.contains("experiment1"))
    tables.emplace_back("table3", models_table(evaluation.at("experiment1")));
  if (evaluation.contains("experiment2"))
    tables.emplace_back("table4", bones_table(evaluation.at("experiment2")));
  if (evaluation.contains("experiment3"))
    tables.emplace_back("experiment3", targets_table(evaluation.at("experiment3")));
  return tables;
}

std::string to_csv(const Table& table)
{
  std::string text;
  auto add = [&](const Row& row)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i ? "," : "") + quoted(row[i]);
    text += "\r\n";
  };
  add(table.columns);
  for (const Row& row : table.rows)
    add(row);
  return text;
}

std::string to_markdown(const Table& table)
{
  std::string text = "### " + table.title + "\n\n";
  auto add = [&](const Row& row)
  {
    text += "|";
    for (const std::string& cell : row)
      text += " " + cell + " |";
    text += "\n";
  };
  add(table.columns);
  add(Row(table.columns.size(), "---"));
  for (const Row& row : table.rows)
    add(row);
  return text + "\n";
}

std::string evaluation_text(const json& evaluation)
{
  std::string text = "# Evaluation of " + evaluation.at("name").get<std::string>() + "\n\n";
  if (evaluation.contains("actual"))
    text += truth_text(evaluation.at("actual")) + "\n";
  for (const auto& [name, table] : evaluation_tables(evaluation))
    text += to_markdown(table);
  return text + findings_text(evaluation) + "\nResearch software, not a medical device.\n";
}

} // namespace f2b
