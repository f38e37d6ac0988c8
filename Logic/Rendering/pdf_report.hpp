#pragma once

#include <filesystem>
#include <string>

/// How does the HTML report become a PDF? By Debian's weasyprint, which needs no display and no
/// network, embeds its fonts and numbers the pages.
namespace f2b
{

struct PdfResult
{
  bool written = false;
  std::string reason; ///< why not, in a sentence
};

/// \param html  a file that `html_report` made without a viewer; it stays
/// Writes the PDF whole or not at all. A machine without weasyprint is no error: see `reason`.
PdfResult write_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf);

} // namespace f2b
