#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// How does an evaluation read as tables?
namespace f2b
{

/// Cells as text; numbers that are not known are empty.
struct Table
{
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Of the experiments that evaluation.json holds: Table 3, Table 4, Experiment 3, each beside the
/// paper's figures [mm].
std::vector<std::pair<std::string, Table>> evaluation_tables(const nlohmann::json& evaluation);

/// Comma-separated values, RFC 4180.
std::string to_csv(const Table& table);
std::string to_markdown(const Table& table);

/// Everything a reader needs: what it was measured against, the tables, what stands out.
std::string evaluation_text(const nlohmann::json& evaluation);

} // namespace f2b
