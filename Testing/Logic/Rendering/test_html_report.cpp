#include "temporary_folder.hpp"

#include <Core/error.hpp>
#include <Rendering/html_report.hpp>
#include <Rendering/html_text.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

namespace
{

using f2b::ReportContent;
using f2b::test::TemporaryFolder;

const std::string tiny_png("\x89PNG\r\n\x1a\n rest", 13);

ReportContent make_content(const std::filesystem::path& folder)
{
  std::ofstream(folder / "p.png", std::ios::binary) << tiny_png;
  f2b::ReportFragment fragment;
  fragment.name = "Mid<face>";
  fragment.translation_ras_mm = {2, 11, -5};
  fragment.rotation_deg = {5, 2.5, 0};
  f2b::ReportMethod fit{"rigid-fit", "The default.", {fragment}, {}, {}};
  f2b::ReportSkinError error;
  error.mean = 0.254;
  error.under_1mm = 0.987;
  error.signed_mean = -0.001;
  fit.skin_error_mm = error;
  f2b::ReportMethod force{"virtual-force", "", {fragment}, {}, 0.42};
  ReportContent content;
  content.case_name = "<script>alert('x')</script> & \"O'Neil\" \xf0\x9f\x99\x82";
  content.facts = {{"CT", "head <1>.nrrd"}};
  content.methods = {fit, force};
  content.suggestions = {{"le-fort-1 + <chin>", "93 %", "0.42 mm", "maxilla: 3.1 mm forward"}};
  content.suggestions_note = "A cut more must reach 5 % & more.";
  content.mesh_facts = {{"Prisms", "9812"}};
  content.timings = {{"Total", "81 s"}};
  content.warnings = {"overlap of 1.2 mm"};
  content.pictures = {{"Frontal", "before & after", folder / "p.png"}};
  return content;
}

TEST(HtmlReportText, TellsReachRegionsCutsAndBite)
{
  const TemporaryFolder folder;
  ReportContent content = make_content(folder.path());
  EXPECT_EQ(f2b::html_report(content).find("What these cuts reach"), std::string::npos);
  content.reach = {"The chin target (6.1 mm) is out of reach."};
  content.regions = {{"upper <lip>", 0.31, 0.64, 8.12, 0.44}, {"neck", 0.05, 0.1, {}, {}}};
  content.cuts = {{"chin - uncut bone", "gap 2.0 mm"}};
  content.bite = {{"Overjet", "8.3 mm before, 2.1 mm after"}};
  const std::string html = f2b::html_report(content);
  for (const char* part :
       {"What these cuts reach", "(6.1 mm) is out of reach.", "upper &lt;lip&gt;", "8.12 mm",
        "0.44 mm", "0.31 mm", "0.64 mm", "<td class=\"number\">-</td>",
        "The cuts after the movement", "gap 2.0 mm", "The bite", "8.3 mm before"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// Every tag that opens closes, in order.
void expect_well_nested(const std::string& html)
{
  const std::set<std::string> void_elements{"meta", "img"};
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-z][a-z0-9]*)[^>]*>");
  for (std::sregex_iterator it(html.begin(), html.end(), tag), end; it != end; ++it)
  {
    const std::string name = (*it)[2];
    if ((*it)[1].length() > 0)
    {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), name);
      open.pop_back();
    }
    else if (void_elements.count(name) == 0)
    {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
}

class HtmlReport : public testing::Test
{
protected:
  TemporaryFolder m_folder;
  ReportContent m_content = make_content(m_folder.path());
  std::string m_html = f2b::html_report(m_content);
};

TEST_F(HtmlReport, SaysWhatItIsNotAndWhereItsLimitsAre)
{
  for (const char* part : {"Research software, not a medical device", "0.5 mm", "0 to 3 mm",
                           "Lips and nose outside the cuts", "airway", "nerves", "synthetic truth"})
  {
    EXPECT_TRUE(contains(m_html, part)) << part;
  }
}

TEST_F(HtmlReport, HasEverySection)
{
  for (const char* part :
       {"Movement of the bones", "What the face misses of the target", "Pictures", "The case",
        "The mesh", "Times", "Which cuts reach this target", "le-fort-1 + &lt;chin&gt;",
        "maxilla: 3.1 mm forward", "5 % &amp; more", "Warnings", "Limitations", "overlap of 1.2 mm",
        "9812", "81 s"})
  {
    EXPECT_TRUE(contains(m_html, part)) << part;
  }
}

TEST_F(HtmlReport, PrintsTableTwoAndErrorsSideBySide)
{
  for (const char* part :
       {"11.00 mm</td><td>Forward", "5.00 mm</td><td>Downwards",
        "2.50\u00b0</td><td>Counter-clockwise", "2.00 mm</td><td>Right",
        "0.25 mm</td><td class=\"number\">-</td>", "98.7 %", "-</td><td class=\"number\">0.42 mm"})
  {
    EXPECT_TRUE(contains(m_html, part)) << part;
  }
  EXPECT_FALSE(contains(m_html, "-0.00"));
}

TEST_F(HtmlReport, ShowsHostileTextAsText)
{
  EXPECT_FALSE(contains(m_html, "<script"));
  EXPECT_TRUE(contains(m_html, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;O"));
  EXPECT_TRUE(contains(m_html, "\xf0\x9f\x99\x82"));
  EXPECT_TRUE(contains(m_html, "Mid&lt;face&gt;"));
}

TEST_F(HtmlReport, NeedsNothingElse)
{
  EXPECT_TRUE(contains(m_html, "src=\"data:image/png;base64," + f2b::base64(tiny_png) + "\""));
  for (const char* part : {"http", "file:", "href=", "url(", "@import", "//"})
  {
    EXPECT_FALSE(contains(std::regex_replace(m_html, std::regex("base64,[^\"]*"), ""), part))
        << part;
  }
}

TEST_F(HtmlReport, EveryPictureHasItsAlternativeText)
{
  EXPECT_TRUE(contains(m_html, "alt=\"Frontal. before &amp; after\""));
}

TEST_F(HtmlReport, IsWellNested)
{
  expect_well_nested(m_html);
}

TEST_F(HtmlReport, NeedsOnlyACase)
{
  expect_well_nested(f2b::html_report(ReportContent{}));
}

TEST_F(HtmlReport, WritesTheFile)
{
  f2b::write_html_report(m_folder.path() / "report.html", m_content);
  EXPECT_EQ(std::filesystem::file_size(m_folder.path() / "report.html"), m_html.size());
}

TEST_F(HtmlReport, MissingPictureIsNamed)
{
  m_content.pictures[0].png = m_folder.path() / "none.png";
  try
  {
    f2b::html_report(m_content);
    ADD_FAILURE();
  }
  catch (const f2b::Error& error)
  {
    EXPECT_TRUE(contains(error.what(), "none.png"));
  }
}

TEST(HtmlText, Base64KnowsEveryRemainder)
{
  EXPECT_EQ(f2b::base64(""), "");
  EXPECT_EQ(f2b::base64("f"), "Zg==");
  EXPECT_EQ(f2b::base64("fo"), "Zm8=");
  EXPECT_EQ(f2b::base64("foo"), "Zm9v");
  EXPECT_EQ(f2b::base64("foobar"), "Zm9vYmFy");
}

} // namespace
