#include "temporary_folder.hpp"

#include <Core/error.hpp>
#include <Rendering/html_report.hpp>
#include <Rendering/html_text.hpp>
#include <Rendering/texts.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <regex>
#include <set>

namespace
{

using namespace f2b;
using test::TemporaryFolder;

const std::string tiny_png("\x89PNG\r\n\x1a\n rest", 13);
const std::string hostile =
    "<script>alert('x')</script> & \"O'Neil\" \xf0\x9f\x99\x82 \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d";

ReportDocument make_document(const std::filesystem::path& folder)
{
  std::ofstream(folder / "p.png", std::ios::binary) << tiny_png;
  ReportDocument document;
  document.title = "Plan";
  document.case_line = hostile;
  document.disclaimer = "Research software, not a medical device.";
  ReportTable movement;
  movement.id = "movement";
  movement.caption = "Movement & <more>";
  movement.columns = {
      {"fragment", "Region", ""}, {"amount", "Displacement", "mm"}, {"direction", "Direction", ""}};
  movement.rows = {
      {"Mid<face>", ReportValue(11.0, 2), "Forward"},
      {"chin", ReportValue(-0.001, 2), "None"},
      {"jaw", ReportValue(std::numeric_limits<double>::quiet_NaN(), 2), ReportValue()}};
  ReportSection section;
  section.heading = "Movement";
  section.paragraphs = {"before & after"};
  section.points = {"a < b"};
  section.tables = {movement};
  section.pictures = {{"Frontal", "before & after", folder / "p.png"}};
  section.note = "a note";
  section.holds_viewer = true;
  ReportSection limits;
  limits.heading = "Limitations";
  limits.points = {"0.5 mm"};
  limits.kind = ReportSection::Kind::Box;
  document.sections = {section, limits};
  return document;
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
  ReportDocument m_document = make_document(m_folder.path());
  std::string m_html = html_report(m_document);
};

TEST_F(HtmlReport, HasEveryPart)
{
  for (const char* part : {"not a medical device", "Movement", "before &amp; after", "a &lt; b",
                           "a note", "Displacement [mm]", "Limitations", "class=\"box\"", "0.5 mm"})
    EXPECT_TRUE(contains(m_html, part)) << part;
}

TEST_F(HtmlReport, NumbersHaveTheirDecimalsAndNoMinusBeforeZero)
{
  EXPECT_TRUE(contains(m_html, "<td class=\"number\"><bdi>11.00</bdi></td>"));
  EXPECT_TRUE(contains(m_html, "<td class=\"number\"><bdi>0.00</bdi></td>"));
  EXPECT_TRUE(contains(m_html, "<td class=\"number\"><bdi>-</bdi></td>")) << "not known";
  EXPECT_FALSE(contains(m_html, "-0.00"));
}

TEST_F(HtmlReport, ShowsHostileTextAsTextOfItsOwnDirection)
{
  EXPECT_FALSE(contains(m_html, "<script"));
  EXPECT_TRUE(contains(m_html, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;O"));
  EXPECT_TRUE(contains(m_html, "\xf0\x9f\x99\x82"));
  EXPECT_TRUE(contains(m_html, "<bdi>Mid&lt;face&gt;</bdi>"));
  EXPECT_TRUE(contains(m_html, "aria-label=\"Movement &amp; &lt;more&gt;\""));
}

TEST_F(HtmlReport, NeedsNothingElseAndForbidsIt)
{
  EXPECT_TRUE(contains(m_html, "src=\"data:image/png;base64," + base64(tiny_png) + "\""));
  EXPECT_TRUE(contains(m_html, "default-src 'none'"));
  for (const char* part : {"http:", "https:", "file:", "href=", "url(", "@import", "//"})
    EXPECT_FALSE(contains(std::regex_replace(m_html, std::regex("base64,[^\"]*"), ""), part))
        << part;
}

TEST_F(HtmlReport, EveryPictureHasItsAlternativeText)
{
  EXPECT_TRUE(contains(m_html, "alt=\"Frontal. before &amp; after\""));
}

TEST_F(HtmlReport, IsWellNested)
{
  expect_well_nested(m_html);
  expect_well_nested(html_report(ReportDocument{}));
}

TEST_F(HtmlReport, ScriptsOfTheViewerCannotBeEndedByTheirText)
{
  const ViewerParts viewer{"<canvas></canvas>", "lib('</script>')", "run('<!--')",
                           "{\"name\":\"</script><script>alert(1)</script>\"}"};
  const std::string html = html_report(m_document, viewer);
  EXPECT_TRUE(contains(html, "<canvas></canvas>"));
  EXPECT_TRUE(contains(html, "lib('<\\/script>')"));
  EXPECT_TRUE(contains(html, "run('<\\!--')"));
  const std::regex closing("</script>");
  EXPECT_EQ(std::distance(std::sregex_iterator(html.begin(), html.end(), closing), {}), 3);
}

TEST_F(HtmlReport, MissingPictureIsNamed)
{
  m_document.sections[0].pictures[0].png = m_folder.path() / "none.png";
  try
  {
    html_report(m_document);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_TRUE(contains(error.what(), "none.png"));
  }
}

TEST(HtmlText, Base64KnowsEveryRemainder)
{
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(TextsOfPictures, PlacesAreFilledOnceAndUnknownKeysAreNamed)
{
  const Texts texts(Texts::Table{{"a", "{x} of {y}, {z}"}});
  EXPECT_EQ(texts("a", {{"x", "{y}"}, {"y", "2"}}), "{y} of 2, {z}");
  EXPECT_THROW(texts("b"), Error);
}

} // namespace
