#pragma once

#include <Rendering/report_document.hpp>

#include <optional>
#include <string>

/// How does a document become one HTML file that needs nothing else and prints on A4 and Letter?
namespace f2b
{

/// The interactive page, ready to be put into the report.
struct ViewerParts
{
  std::string html;    ///< its element with controls; markup of ours
  std::string library; ///< the script that it rests on
  std::string script;  ///< its own script
  std::string data;    ///< JSON
};

/// The whole report as text. What it holds cannot load anything: its content security policy says so.
/// \throws f2b::Error naming a picture that cannot be read
std::string html_report(const ReportDocument& document,
                        const std::optional<ViewerParts>& viewer = {});

} // namespace f2b
