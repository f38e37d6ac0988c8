#include "temporary_folder.hpp"
#include "texts_of_program.hpp"
#include "toy_plan.hpp"

#include <Core/error.hpp>
#include <Rendering/offscreen_display.hpp>
#include <Rendering/plan_pictures.hpp>

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <set>

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

const View frontal = *view_named("frontal"), profile = *view_named("profile-right");
const std::vector<View> around{frontal, profile, *view_named("three-quarter-right")};

Image draw(const PlanScene& scene, const std::vector<Subject>& show, const std::vector<View>& views,
           PixelSize panel, Background background = Background::Light)
{
  PictureDefinition definition{"test", show, views, {}, background, 0, {}};
  definition.size = {panel.width * panel_count(definition), panel.height};
  return draw_picture(scene, definition, test::texts_of_program());
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
  const Image image = draw(m_scene, {Subject::FaceBefore}, {frontal}, {1200, 1000});
  EXPECT_EQ(width(image), 1200);
  EXPECT_EQ(height(image), 1000);
  EXPECT_GT(share_drawn(image), 0.2);
  EXPECT_LT(share_drawn(image), 0.9);
}

TEST_F(PlanPicturesOf100mm, NothingIsCutOffInAnyView)
{
  for (const View& view : named_views())
  {
    EXPECT_TRUE(has_clean_border(draw(m_scene, {Subject::FaceTarget}, {view}, small)));
    EXPECT_TRUE(has_clean_border(draw(m_scene, {Subject::FragmentsAfter}, {view}, small)));
  }
}

TEST_F(PlanPicturesOf100mm, StatesDifferAndPicturesRepeatBitForBit)
{
  const Image before = draw(m_scene, {Subject::FaceBefore}, {profile}, small);
  const Image target = draw(m_scene, {Subject::FaceTarget}, {profile}, small);
  const Image again = draw(m_scene, {Subject::FaceBefore}, {profile}, small);
  EXPECT_GT(differing(before, target), 300);
  EXPECT_EQ(differing(before, again), 0);
}

TEST(ViewAxesOf, FrontalHasThePatientsRightOnTheLeftAndTheRightProfileTheNoseOnTheRight)
{
  EXPECT_NEAR(view_axes(frontal).right[0], -1, 1e-12);
  EXPECT_NEAR(view_axes(frontal).towards_viewer[1], 1, 1e-12);
  EXPECT_NEAR(view_axes(profile).right[1], 1, 1e-12);
  EXPECT_NEAR(view_axes(profile).towards_viewer[0], 1, 1e-12);
  EXPECT_NEAR(view_axes(*view_named("profile-left")).right[1], -1, 1e-12);
  EXPECT_NEAR(view_axes(*view_named("top")).towards_viewer[2], 1, 1e-12);
  EXPECT_LT(view_axes(*view_named("submental")).towards_viewer[2], -0.8);
  EXPECT_FALSE(view_named("sideways").has_value());
}

TEST_F(PlanPicturesOf100mm, DistanceMapIsBlueBehindAndRedInFront)
{
  const Image image = draw(m_scene, {Subject::DistanceMap}, around, {400, 500});
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

TEST_F(PlanPicturesOf100mm, BarHasAllColoursOfItsMapAndDarkNumbers)
{
  const Image image = draw(m_scene, {Subject::DistanceMap}, around, {700, 740});
  std::set<int> bar, ink;
  for (int x = 700; x < 1400; ++x)
    for (int y = 5; y < 110; ++y)
    {
      const Pixel p = pixel(image, x, y);
      if (p.is_blue() || p.is_red())
        bar.insert(p.red * 65536 + p.green * 256 + p.blue);
      if (p.red < 60 && p.green < 60 && p.blue < 70)
        ink.insert(x);
    }
  EXPECT_GT(bar.size(), 100u);
  EXPECT_GT(ink.size(), 40u) << "ticks and numbers";
}

TEST_F(PlanPicturesOf100mm, ContourLinesAreDrawnWhereTheyAreCrossed)
{
  PlanPictures plan = toy_plan(100);
  vtkDataArray* distance = plan.predicted->GetPointData()->GetArray(signed_distance_array);
  const auto dark = [&](double slope)
  {
    for (vtkIdType i = 0; i < plan.predicted->GetNumberOfPoints(); ++i)
      distance->SetTuple1(i, slope * plan.predicted->GetPoint(i)[2]);
    const Image image = draw(PlanScene(plan), {Subject::DistanceMap}, {frontal}, {400, 500});
    return count(image, [](const Pixel& p, int x, int y)
                 { return x > 120 && x < 280 && y > 150 && y < 340 && p.red < 50 && p.blue < 50; });
  };
  EXPECT_GT(dark(0.1), dark(0.001) + 100);
}

TEST_F(PlanPicturesOf100mm, DistanceMapShowsUnknownValuesInGrey)
{
  PlanPictures plan = toy_plan(100);
  vtkDataArray* distance = plan.predicted->GetPointData()->GetArray(signed_distance_array);
  distance->FillComponent(0, std::numeric_limits<double>::quiet_NaN());
  const Image image = draw(PlanScene(plan), {Subject::DistanceMap}, around, small);
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
  EXPECT_EQ(no_value_patch(draw(m_scene, {Subject::DistanceMap}, around, size)), 0);
  EXPECT_GT(no_value_patch(draw(partly, {Subject::DistanceMap}, around, size)), 60);
  EXPECT_GT(no_value_patch(draw(partly, {Subject::FacePredicted}, {frontal}, size)), 60);
  EXPECT_EQ(no_value_patch(draw(partly, {Subject::FaceBefore}, {frontal}, size)), 0);
  EXPECT_EQ(no_value_patch(draw(m_scene, {Subject::FacePredicted}, {frontal}, size)), 0);
}

TEST_F(PlanPicturesOf100mm, SkinThatWasNotComputedIsGreyInThePrediction)
{
  const PlanScene partly(partly_computed_plan());
  const auto grey = [](const Pixel& p, int, int y)
  { return y > 100 && std::abs(p.red - p.blue) < 6 && p.red < 200 && p.red > 60; };
  const Image before = draw(partly, {Subject::FaceBefore}, {frontal}, {400, 500});
  const Image predicted = draw(partly, {Subject::FacePredicted}, {frontal}, {400, 500});
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
  const Image image = draw(PlanScene(plan), {Subject::Reachability}, around, {400, 500});
  // the patient's right is on the left of the frontal panel
  EXPECT_LT(pixel(image, 140, 260).green, pixel(image, 260, 260).green - 60);
  EXPECT_EQ(no_value_patch(image), 0);
}

TEST_F(PlanPicturesOf100mm, RegionsHaveTheirColoursAndNoOthersBetweenThem)
{
  PlanPictures plan = toy_plan(100);
  add_array(plan.skin, region_array, [](double r) { return r > 0 ? 5 : 9; });
  const Image image = draw(PlanScene(plan), {Subject::Regions}, around, {400, 500});
  const Pixel right = pixel(image, 140, 260), left = pixel(image, 260, 260);
  EXPECT_GT(right.green, right.red + 10) << "cheek";
  EXPECT_GT(left.red, left.green + 10) << "chin";
  const auto blue = [](const Pixel& p, int x, int y)
  { return x < 400 && y > 120 && y < 380 && p.blue > p.red + 20 && p.blue > p.green + 20; };
  EXPECT_EQ(count(image, blue), 0) << "the lips' values lie between the two";
}

TEST_F(PlanPicturesOf100mm, TargetRegionIsMarkedWhereTheFaceMoves)
{
  const Image image = draw(m_scene, {Subject::TargetDisplacement}, around, small);
  EXPECT_EQ(width(image), 900);
  const Pixel face = pixel(image, 150, 125);
  const Pixel forehead = pixel(image, 150, 178);
  EXPECT_LT(face.green, forehead.green - 40);
}

TEST_F(PlanPicturesOf100mm, BonesShowTheFragmentMoved)
{
  const Image image =
      draw(m_scene, {Subject::FragmentsBefore, Subject::FragmentsAfter}, {profile}, small);
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
  const Image image = draw(m_scene, {Subject::FaceOverSkull}, around, small);
  EXPECT_GT(share_drawn(image), 0.1);
  EXPECT_GT(count(image, [](const Pixel& p, int, int) { return p.blue > p.red + 25; }), 100)
      << "the fragment's colour is seen through the skin";
}

TEST(PlanPicturesOfASmallHead, FillTheFrameAsWell)
{
  unsetenv("DISPLAY");
  const OffscreenDisplay display;
  const Image large = draw(PlanScene(toy_plan(100)), {Subject::FaceBefore}, {frontal}, small);
  const Image little = draw(PlanScene(toy_plan(25)), {Subject::FaceBefore}, {frontal}, small);
  EXPECT_NEAR(share_drawn(little), share_drawn(large), 0.02);
}

// The report's pictures at a size that draws quickly.
std::vector<WrittenPicture> write_small(const PlanPictures& plan,
                                        const std::filesystem::path& folder)
{
  const PlanScene scene(plan);
  std::vector<PictureDefinition> definitions = report_pictures(scene);
  for (PictureDefinition& definition : definitions)
    definition.size = {480, 200};
  return write_pictures(scene, definitions, folder, test::texts_of_program());
}

std::string names_of(const std::vector<WrittenPicture>& pictures)
{
  std::string text;
  for (const WrittenPicture& picture : pictures)
    text += picture.name + " ";
  return text;
}

TEST(WritePictures, WritesEveryPictureWithItsTextsAndLeavesNoDisplay)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  const auto written = write_small(toy_plan(100), folder.path());
  EXPECT_EQ(names_of(written), "faces_frontal faces_profile_right faces_three_quarter_right "
                               "target_displacement distance_map fragments_frontal "
                               "fragments_profile_right fragments_three_quarter_right "
                               "face_over_skull ");
  EXPECT_EQ(folder.file_count(), written.size());
  for (const WrittenPicture& picture : written)
  {
    vtkNew<vtkPNGReader> reader;
    ASSERT_TRUE(reader->CanReadFile(picture.path.c_str())) << picture.path;
    for (const char* part : {".title", ".caption"})
      EXPECT_TRUE(test::texts_of_program().has("picture." + picture.name + part)) << picture.name;
  }
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST(WritePictures, AddsReachabilityAndRegionsWhereTheyAreKnown)
{
  PlanPictures plan = toy_plan(100);
  const auto names = [&]
  {
    std::string text;
    for (const PictureDefinition& definition : report_pictures(PlanScene(plan)))
      text += definition.name + " ";
    return text;
  };
  add_array(plan.predicted, unreachable_array, [](double) { return 1; });
  add_array(plan.skin, region_array, [](double) { return 0; });
  EXPECT_NE(names().find("reachability "), std::string::npos);
  EXPECT_EQ(names().find("regions "), std::string::npos) << "nothing is known of them";
  add_array(plan.skin, region_array, [](double) { return 4; });
  EXPECT_NE(names().find("regions "), std::string::npos);
}

TEST(WritePictures, LeavesOutWhatThereIsNot)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  PlanPictures plan = toy_plan(100);
  plan.target = nullptr;
  plan.predicted = nullptr;
  plan.cut_planes = nullptr;
  plan.fragments.clear();
  EXPECT_EQ(write_small(plan, folder.path()).size(), 7u);
}

TEST(WritePictures, UnwritableFolderIsNamed)
{
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  try
  {
    write_small(toy_plan(100), folder.path() / "none");
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find((folder.path() / "none").string()), std::string::npos);
  }
}

TEST_F(PlanPicturesOf100mm, WhatTheCaseLacksIsNamedBeforeAnythingIsWritten)
{
  const TemporaryFolder folder;
  const PictureDefinition good{"good", {Subject::FaceBefore}, {frontal}, small, {}, 0, {}};
  PictureDefinition bad = good;
  bad.show = {Subject::CtAxial};
  try
  {
    write_pictures(m_scene, {good, bad}, folder.path(), test::texts_of_program());
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("'ct-axial': the case has no CT"), std::string::npos);
  }
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST_F(PlanPicturesOf100mm, TransparentBackgroundKeepsTheFaceAndItsColours)
{
  const Image light = draw(m_scene, {Subject::FaceBefore}, {frontal}, small, Background::White);
  const Image clear =
      draw(m_scene, {Subject::FaceBefore}, {frontal}, small, Background::Transparent);
  ASSERT_EQ(clear->GetNumberOfScalarComponents(), 4);
  const auto* corner = static_cast<const unsigned char*>(clear->GetScalarPointer(0, 0, 0));
  const auto* nose = static_cast<const unsigned char*>(clear->GetScalarPointer(150, 125, 0));
  EXPECT_EQ(corner[3], 0);
  EXPECT_EQ(nose[3], 255);
  EXPECT_EQ(nose[0], pixel(light, 150, 125).red);
}

TEST_F(PlanPicturesOf100mm, DarkBackgroundHasLightLetters)
{
  const Image image = draw(m_scene, {Subject::FaceBefore}, {frontal}, {400, 400}, Background::Dark);
  EXPECT_LT(pixel(image, 1, 1).red, 40);
  EXPECT_GT(count(image, [](const Pixel& p, int x, int y)
                  { return x < 250 && y > 370 && p.red > 200 && p.blue > 200; }),
            20);
}

TEST_F(PlanPicturesOf100mm, StatedDensityIsInTheFile)
{
  const TemporaryFolder folder;
  PictureDefinition definition{"dense", {Subject::FaceBefore}, {frontal}, small, {}, 300, {}};
  write_pictures(m_scene, {definition}, folder.path(), test::texts_of_program());
  const std::string bytes = test::read_text(folder.path() / "dense.png");
  const std::size_t at = bytes.find("pHYs");
  ASSERT_EQ(at, 37u);
  EXPECT_EQ(bytes.substr(at + 4, 4), std::string("\0\0\x2e\x23", 4)); // 11811 a metre
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder.path() / "dense.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], small.width);
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
