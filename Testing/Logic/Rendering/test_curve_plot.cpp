#include <Rendering/curve_plot.hpp>
#include <Rendering/offscreen_display.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

constexpr PixelSize size{800, 600};

struct Blob
{
  int pixels = 0;
  double x = 0, y = 0; ///< mean place, from the bottom left
};

/// The pixels that are nearly of a colour, between two columns.
Blob find(const Image& image, const Colour& colour, int from, int to)
{
  Blob blob;
  for (int y = 0; y < size.height; ++y)
    for (int x = from; x < to; ++x)
    {
      const auto* p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      bool same = true;
      for (std::size_t c = 0; c < 3; ++c)
        same = same && std::abs(p[c] - 255 * colour[c]) < 40;
      if (same)
      {
        ++blob.pixels;
        blob.x += x;
        blob.y += y;
      }
    }
  blob.x /= std::max(1, blob.pixels);
  blob.y /= std::max(1, blob.pixels);
  return blob;
}

TEST(CurvePlot, SeriesStandWhereTheirValuesAreOnAWhitePage)
{
  const Colour red{0.8, 0.1, 0.1}, blue{0.1, 0.1, 0.8}, green{0.1, 0.6, 0.1};
  CurvePlot plot{"three series", "x [mm]", "y [kPa]", {}};
  plot.series = {{"up", {1, 2}, {0, 100}, PlottedSeries::Style::Line, red},
                 {"flat", {1, 2}, {50, 50}, PlottedSeries::Style::DashedLine, blue},
                 {"marks", {1.5, 1.75, 2}, {10, 10, 10}, PlottedSeries::Style::Points, green}};
  const OffscreenDisplay display;
  const Image image = draw_plot(plot, size);
  ASSERT_EQ(image->GetDimensions()[0], size.width);
  ASSERT_EQ(image->GetDimensions()[1], size.height);
  EXPECT_GT(find(image, {1, 1, 1}, 0, size.width).pixels, size.width * size.height * 3 / 4);
  // right of the legend; a line is solid, a dashed one is not, marks are three
  const int middle = size.width / 2, right = size.width;
  const Blob up = find(image, red, middle, right), flat = find(image, blue, middle, right);
  const Blob marks = find(image, green, middle, right);
  EXPECT_GT(up.pixels, 300);
  EXPECT_GT(flat.pixels, 100);
  EXPECT_LT(flat.pixels, up.pixels);
  EXPECT_GT(marks.pixels, 60);
  EXPECT_GT(up.y, flat.y + 60);
  EXPECT_GT(flat.y, marks.y + 100);
  const Blob early = find(image, red, middle, middle + 100);
  const Blob late = find(image, red, right - 150, right - 50);
  EXPECT_GT(late.y, early.y + 100);
}

} // namespace
} // namespace f2b
