#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What does a reader of a plan get? Sections of text, tables and pictures, each told once: the HTML
/// report, the CSV tables and report.json are written from the same document.
///
/// All strings are UTF-8 text, never markup.
namespace f2b
{

/// A text, a number with the decimals that a person reads, or nothing.
struct ReportValue
{
  enum class Kind
  {
    None,
    Text,
    Number,
  };

  ReportValue() = default;
  ReportValue(std::string words) : kind(Kind::Text), text(std::move(words)) {}
  ReportValue(const char* words) : kind(Kind::Text), text(words) {}
  /// Not finite: nothing.
  ReportValue(double value, int shown_decimals);

  Kind kind = Kind::None;
  std::string text;
  double number = 0;
  int decimals = 0;

  /// As a person reads it; "-" for nothing, and no minus before nothing but zeros.
  std::string shown() const;
};

struct ReportColumn
{
  std::string key; ///< for CSV and JSON
  std::string title;
  std::string unit; ///< "mm", "°", "%"; shown behind the title
};

struct ReportTable
{
  std::string id; ///< for files: tables/ID.csv
  std::string caption;
  std::vector<ReportColumn> columns;
  std::vector<std::vector<ReportValue>> rows; ///< the first value of each heads it
  std::string note;
  bool is_long = false; ///< may break across pages, between rows
  bool is_code = false; ///< its texts are checksums: letters of one width
};

struct ReportPicture
{
  std::string title;
  std::string caption; ///< also the alternative text
  std::filesystem::path png;
};

struct ReportSection
{
  enum class Kind
  {
    Plain,
    Box,     ///< set apart: limitations
    Warning, ///< set apart, and seen
  };

  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<std::string> points; ///< a list
  std::vector<ReportTable> tables;
  std::vector<ReportPicture> pictures;
  std::string note;
  Kind kind = Kind::Plain;
  bool holds_viewer = false; ///< the interactive page, where there is one, comes first in it
};

struct ReportDocument
{
  std::string language = "en";
  std::string title;
  std::string case_line;         ///< under the title
  std::string disclaimer;        ///< "Research software, not a medical device."
  std::string disclaimer_detail; ///< what follows from it
  std::vector<ReportSection> sections;
};

} // namespace f2b
