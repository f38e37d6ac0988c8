#include "temporary_folder.hpp"
#include "toy_plan.hpp"

#include <Core/error.hpp>
#include <Rendering/offscreen_display.hpp>
#include <Rendering/plan_pictures.hpp>
#include <Rendering/views.hpp>

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using namespace f2b;
using test::TemporaryFolder;

struct Pixel
{
  int red, green, blue;
  bool operator==(const Pixel& other) const
  {
    return red == other.red && green == other.green && blue == other.blue;
  }
  bool is_red() const { return red > green + 40 && red > blue + 40; }
  bool is_blue() const { return blue > red + 40 && blue > green + 20; }
};

Pixel pixel(const Image& image, int x, int y)
{
  const auto* p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return {p[0], p[1], p[2]};
}

int width(const Image& image)
{
  return image->GetDimensions()[0];
}
int height(const Image& image)
{
  return image->GetDimensions()[1];
}

template <class Condition>
int count(const Image& image, const Condition& condition)
{
  int number = 0;
  for (int y = 0; y < height(image); ++y)
  {
    for (int x = 0; x < width(image); ++x)
    {
      number += condition(pixel(image, x, y), x, y) ? 1 : 0;
    }
  }
  return number;
}

int differing(const Image& a, const Image& b)
{
  return count(a, [&b](const Pixel& p, int x, int y) { return !(p == pixel(b, x, y)); });
}

double share_drawn(const Image& image)
{
  const Pixel background = pixel(image, 0, 0);
  const int drawn = count(image, [&](const Pixel& p, int, int) { return !(p == background); });
  return static_cast<double>(drawn) / (width(image) * height(image));
}

bool has_clean_border(const Image& image)
{
  const Pixel background = pixel(image, 0, 0);
  const int w = width(image), h = height(image);
  return 0 == count(image, [&](const Pixel& p, int x, int y)
                    { return (x < 3 || y < 3 || x >= w - 3 || y >= h - 3) && !(p == background); });
}

// Small pictures: what is tested does not depend on the size.
constexpr PixelSize small{300, 250};

class PlanPicturesOf100mm : public testing::Test
{
protected:
  static void SetUpTestSuite() { unsetenv("DISPLAY"); }
  const OffscreenDisplay m_display;
  const PlanScene m_scene{toy_plan(100)};
};

TEST_F(PlanPicturesOf100mm, FaceHasTheAskedSizeAndIsNotBlank)
{
  const Image image = face_picture(m_scene, FaceState::Before, View::Frontal, {1200, 1000});
  EXPECT_EQ(width(image), 1200);
  EXPECT_EQ(height(image), 1000);
  EXPECT_GT(share_drawn(image), 0.2);
  EXPECT_LT(share_drawn(image), 0.9);
}

TEST_F(PlanPicturesOf100mm, NothingIsCutOffInAnyView)
{
  for (const View view : all_views)
  {
    EXPECT_TRUE(has_clean_border(face_picture(m_scene, FaceState::Target, view, small)));
    EXPECT_TRUE(has_clean_border(bones_picture(m_scene, BoneState::After, view, small)));
  }
}

TEST_F(PlanPicturesOf100mm, StatesDifferAndPicturesRepeatBitForBit)
{
  const Image before = face_picture(m_scene, FaceState::Before, View::Lateral, small);
  const Image target = face_picture(m_scene, FaceState::Target, View::Lateral, small);
  const Image again = face_picture(m_scene, FaceState::Before, View::Lateral, small);
  EXPECT_GT(differing(before, target), 300);
  EXPECT_EQ(differing(before, again), 0);
}

TEST(ViewAxesOf, FrontalHasThePatientsRightOnTheLeftAndLateralTheNoseOnTheRight)
{
  EXPECT_NEAR(view_axes(View::Frontal).right[0], -1, 1e-12);
  EXPECT_NEAR(view_axes(View::Frontal).towards_viewer[1], 1, 1e-12);
  EXPECT_NEAR(view_axes(View::Lateral).right[1], 1, 1e-12);
  EXPECT_NEAR(view_axes(View::Lateral).towards_viewer[0], 1, 1e-12);
  for (const View view : all_views)
  {
    EXPECT_GT(view_axes(view).up[2], 0.9);
  }
}

TEST_F(PlanPicturesOf100mm, DistanceMapIsBlueBehindAndRedInFront)
{
  const Image image = distance_map_picture(m_scene, {400, 500});
  EXPECT_EQ(width(image), 3 * 400);
  // Frontal panel: the patient's right, where the prediction lies behind, is on the left.
  const auto upper = [&](int y) { return y > height(image) / 4; };
  EXPECT_GT(count(image,
                  [&](const Pixel& p, int x, int y) { return upper(y) && x < 180 && p.is_blue(); }),
            500);
  EXPECT_GT(count(image, [&](const Pixel& p, int x, int y)
                  { return upper(y) && x > 220 && x < 400 && p.is_red(); }),
            500);
  EXPECT_EQ(
      count(image, [&](const Pixel& p, int x, int y) { return upper(y) && x < 180 && p.is_red(); }),
      0);
}

TEST_F(PlanPicturesOf100mm, DistanceMapShowsUnknownValuesInGrey)
{
  PlanPictures plan = toy_plan(100);
  vtkDataArray* distance = plan.predicted->GetPointData()->GetArray(signed_distance_array);
  distance->FillComponent(0, std::numeric_limits<double>::quiet_NaN());
  const Image image = distance_map_picture(PlanScene(plan), small);
  EXPECT_GT(share_drawn(image), 0.1);
  EXPECT_EQ(count(image, [&](const Pixel& p, int x, int) { return x < 300 && p.is_blue(); }), 0);
}

// The patch of a legend, drawn without light left of the face.
int no_value_patch(const Image& image)
{
  return count(image,
               [](const Pixel& p, int x, int) {
                 return x < 40 && p == Pixel{158, 158, 158};
               });
}

// The top of the toy's prediction as if it lay beyond the mesh.
PlanPictures partly_computed_plan()
{
  PlanPictures plan = toy_plan(100);
  vtkDataArray* distance = plan.predicted->GetPointData()->GetArray(signed_distance_array);
  for (vtkIdType i = 0; i < plan.predicted->GetNumberOfPoints(); ++i)
    if (plan.predicted->GetPoint(i)[2] > 20)
      distance->SetTuple1(i, std::numeric_limits<double>::quiet_NaN());
  return plan;
}

TEST_F(PlanPicturesOf100mm, SkinThatWasNotComputedIsInTheLegend)
{
  const PlanScene partly(partly_computed_plan());
  const PixelSize size{400, 500};
  EXPECT_EQ(no_value_patch(distance_map_picture(m_scene, size)), 0);
  EXPECT_GT(no_value_patch(distance_map_picture(partly, size)), 60);
  EXPECT_GT(no_value_patch(face_picture(partly, FaceState::Predicted, View::Frontal, size)), 60);
  EXPECT_EQ(no_value_patch(face_picture(partly, FaceState::Before, View::Frontal, size)), 0);
  EXPECT_EQ(no_value_patch(face_picture(m_scene, FaceState::Predicted, View::Frontal, size)), 0);
}

TEST_F(PlanPicturesOf100mm, SkinThatWasNotComputedIsGreyInThePrediction)
{
  const PlanScene partly(partly_computed_plan());
  const auto grey = [](const Pixel& p, int, int y)
  { return y > 100 && std::abs(p.red - p.blue) < 6 && p.red < 200 && p.red > 60; };
  const Image before = face_picture(partly, FaceState::Before, View::Frontal, {400, 500});
  const Image predicted = face_picture(partly, FaceState::Predicted, View::Frontal, {400, 500});
  EXPECT_GT(count(predicted, grey), count(before, grey) + 5000);
}

void add_array(const Surface& surface, const char* name, const std::function<double(double)>& of_x)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    array->InsertNextValue(of_x(surface->GetPoint(i)[0]));
  surface->GetPointData()->AddArray(array);
}

TEST_F(PlanPicturesOf100mm, ReachabilityIsDarkWhereMoreIsLeft)
{
  PlanPictures plan = toy_plan(100);
  add_array(plan.predicted, unreachable_array, [](double r) { return r > 0 ? 6.0 : 0.2; });
  const Image image = reachability_picture(PlanScene(plan), {400, 500});
  // the patient's right is on the left of the frontal panel
  EXPECT_LT(pixel(image, 140, 260).green, pixel(image, 260, 260).green - 60);
  EXPECT_EQ(no_value_patch(image), 0);
}

TEST_F(PlanPicturesOf100mm, RegionsHaveTheirColoursAndNoOthersBetweenThem)
{
  PlanPictures plan = toy_plan(100);
  add_array(plan.skin, region_array, [](double r) { return r > 0 ? 5 : 9; });
  const Image image = regions_picture(PlanScene(plan), {400, 500});
  const Pixel right = pixel(image, 140, 260), left = pixel(image, 260, 260);
  EXPECT_GT(right.green, right.red + 10) << "cheek";
  EXPECT_GT(left.red, left.green + 10) << "chin";
  const auto blue = [](const Pixel& p, int x, int y)
  { return x < 400 && y > 120 && y < 380 && p.blue > p.red + 20 && p.blue > p.green + 20; };
  EXPECT_EQ(count(image, blue), 0) << "the lips' values lie between the two";
}

TEST_F(PlanPicturesOf100mm, TargetRegionIsMarkedWhereTheFaceMoves)
{
  const Image image = target_region_picture(m_scene, small);
  EXPECT_EQ(width(image), 900);
  const Pixel face = pixel(image, 150, 125);
  const Pixel forehead = pixel(image, 150, 178);
  EXPECT_LT(face.green, forehead.green - 40);
}

TEST_F(PlanPicturesOf100mm, BonesShowTheFragmentMoved)
{
  const Image image = bones_comparison(m_scene, View::Lateral, small);
  EXPECT_EQ(width(image), 600);
  const auto blue_height = [&](int from, int to)
  {
    double sum = 0;
    const int number = count(image,
                             [&](const Pixel& p, int x, int y)
                             {
                               const bool counts = x >= from && x < to && y < 180 && p.is_blue();
                               sum += counts ? y : 0;
                               return counts;
                             });
    EXPECT_GT(number, 50);
    return sum / std::max(number, 1);
  };
  EXPECT_LT(blue_height(300, 600), blue_height(0, 300)) << "the fragment moves down";
}

TEST_F(PlanPicturesOf100mm, FaceOverBonesShowsBoth)
{
  const Image image = face_over_bones_picture(m_scene, small);
  EXPECT_GT(share_drawn(image), 0.1);
  EXPECT_GT(count(image, [](const Pixel& p, int, int) { return p.blue > p.red + 25; }), 100)
      << "the fragment's colour is seen through the skin";
}

TEST(PlanPicturesOfASmallHead, FillTheFrameAsWell)
{
  unsetenv("DISPLAY");
  const OffscreenDisplay display;
  const Image large =
      face_picture(PlanScene(toy_plan(100)), FaceState::Before, View::Frontal, small);
  const Image little =
      face_picture(PlanScene(toy_plan(25)), FaceState::Before, View::Frontal, small);
  EXPECT_NEAR(share_drawn(little), share_drawn(large), 0.02);
}

TEST(WritePlanPictures, WritesEveryPictureAndLeavesNoDisplay)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  PictureOptions options;
  options.single = {240, 200};
  options.panel = {160, 200};
  const auto written = write_plan_pictures(toy_plan(100), folder.path(), options);
  EXPECT_EQ(written.size(), 24u);
  EXPECT_EQ(folder.file_count(), written.size());
  for (const WrittenPicture& picture : written)
  {
    vtkNew<vtkPNGReader> reader;
    ASSERT_TRUE(reader->CanReadFile(picture.path.c_str())) << picture.path;
    EXPECT_EQ(picture.caption.empty(), !picture.belongs_in_report) << picture.name;
  }
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST(WritePlanPictures, AddsReachabilityAndRegionsWhereTheyAreKnown)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  PlanPictures plan = toy_plan(100);
  add_array(plan.predicted, unreachable_array, [](double) { return 1; });
  add_array(plan.skin, region_array, [](double) { return 0; });
  PictureOptions options;
  options.panel = {160, 200};
  options.singles = false;
  const auto names = [&]
  {
    std::string text;
    for (const WrittenPicture& picture : write_plan_pictures(plan, folder.path(), options))
      text += picture.name + " ";
    return text;
  };
  std::string drawn = names();
  EXPECT_NE(drawn.find("reachability "), std::string::npos);
  EXPECT_EQ(drawn.find("regions "), std::string::npos) << "nothing is known of them";
  add_array(plan.skin, region_array, [](double) { return 4; });
  drawn = names();
  EXPECT_NE(drawn.find("regions "), std::string::npos);
}

TEST(WritePlanPictures, LeavesOutWhatThereIsNot)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  PlanPictures plan = toy_plan(100);
  plan.target = nullptr;
  plan.predicted = nullptr;
  plan.cut_planes = nullptr;
  plan.fragments.clear();
  PictureOptions options;
  options.panel = {160, 200};
  options.singles = false;
  EXPECT_EQ(write_plan_pictures(plan, folder.path(), options).size(), 7u);
}

TEST(WritePlanPictures, UnwritableFolderIsNamed)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  try
  {
    write_plan_pictures(toy_plan(100), folder.path() / "none");
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find((folder.path() / "none").string()), std::string::npos);
  }
}

std::string error_of(const PlanPictures& plan)
{
  try
  {
    const PlanScene scene(plan);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

TEST(PlanSceneOf, RefusesUnfitSurfaces)
{
  EXPECT_EQ(error_of(toy_plan(100)), "");
  PlanPictures plan = toy_plan(100);
  plan.skin = nullptr;
  EXPECT_EQ(error_of(plan).rfind("skin:", 0), 0u);
  plan = toy_plan(100);
  plan.target = plan.uncut_bone;
  plan.target = Surface::New();
  EXPECT_EQ(error_of(plan).rfind("target face:", 0), 0u);
  plan = toy_plan(100);
  plan.predicted->GetPoints()->SetPoint(7, 0, std::nan(""), 0);
  EXPECT_NE(error_of(plan).find("vertex 7"), std::string::npos);
  plan = toy_plan(100);
  plan.target = plan.cut_planes;
  EXPECT_NE(error_of(plan).find("4 vertices"), std::string::npos);
}

} // namespace
