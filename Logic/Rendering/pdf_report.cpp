#include <Rendering/pdf_report.hpp>

#include <Rendering/child_program.hpp>

#include <system_error>

namespace f2b
{

namespace
{

constexpr std::chrono::seconds limit{120};

} // namespace

PdfResult write_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf)
{
  const auto program = find_program("weasyprint");
  if (!program)
  {
    return {false, "report.pdf was not made: install the Debian package weasyprint and run "
                   "'report' again, or print report.html"};
  }
  const std::filesystem::path part = pdf.string() + ".part";
  const ChildResult done = run_program(*program, {"--quiet", html.string(), part.string()}, limit);
  std::error_code failed;
  if (done.exit_code == 0)
  {
    std::filesystem::rename(part, pdf, failed);
    if (!failed)
    {
      return {true, {}};
    }
  }
  std::filesystem::remove(part, failed);
  return {false, "report.pdf was not made: weasyprint " +
                     std::string(done.timed_out ? "took too long" : "failed") +
                     "; print report.html instead"};
}

} // namespace f2b
