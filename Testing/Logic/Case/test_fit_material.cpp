#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/json_file.hpp>
#include <Bridge/material_file.hpp>
#include <Bridge/resources.hpp>
#include <Case/fit_material.hpp>
#include <Case/fit_summary.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

namespace f2b
{
namespace
{

using nlohmann::json;
using test::expect_error;
using test::TemporaryFolder;

FitMaterialOptions table1_options(const TemporaryFolder& folder)
{
  FitMaterialOptions options;
  options.table1 = true;
  options.stable = true;
  options.folder = folder / "out";
  return options;
}

/// Every number of one document stands in the other, to a relative tolerance.
void expect_same_numbers(const json& expected, const json& found, const std::string& where)
{
  ASSERT_EQ(expected.is_structured(), found.is_structured()) << where;
  if (expected.is_object())
    for (const auto& [key, value] : expected.items())
    {
      ASSERT_TRUE(found.contains(key)) << where << "/" << key;
      expect_same_numbers(value, found[key], where + "/" + key);
    }
  else if (expected.is_number())
    EXPECT_NEAR(found.get<double>(), expected.get<double>(),
                1e-6 * std::abs(expected.get<double>()))
        << where;
  else
    EXPECT_EQ(found, expected) << where;
}

TEST(FitMaterial, MakesTheStableSetOfTable1ThatTheProgramCarries)
{
  const TemporaryFolder folder;
  const FitMaterialResult result = fit_material(table1_options(folder));
  ASSERT_EQ(result.files.size(), 2u);
  EXPECT_EQ(result.files[0].filename(), "table1-stable.json");
  const json made = read_json(result.files[0]);
  const json carried = json::parse(*carried_resource("materials/table1-stable.json"));
  expect_same_numbers(carried, made, "");
  EXPECT_EQ(made.size(), carried.size());
  EXPECT_EQ(carried["fit"]["command"], "facetobone fit-material --table1 --law yeoh --stable");
  EXPECT_NE(carried["fit"]["data"].get<std::string>().find("Table 1 curve"), std::string::npos);
  EXPECT_NO_THROW(read_materials(result.files[0]));
  EXPECT_GT(std::filesystem::file_size(result.files[1]), 5000u);
}

TEST(FitMaterial, Table1CurveIsTheDesigns)
{
  const StressCurve skin = table1_curve(Tissue::Skin);
  ASSERT_EQ(skin.deformation.size(), 61u);
  EXPECT_EQ(skin.deformation.front(), 1.0);
  EXPECT_DOUBLE_EQ(skin.deformation[20], 1.1);
  EXPECT_DOUBLE_EQ(skin.deformation.back(), 1.3);
  // 2 (c10 + c01 / s) (s - 1 / s^2)
  const double s = 1.3;
  EXPECT_NEAR(skin.stress.back(), 9.80665e-3 * 2 * (18.9834 - 15.4072 / s) * (s - 1 / (s * s)),
              1e-15);
}

TEST(FitMaterial, ATablesFitIsAnEntryForAMaterialFile)
{
  const TemporaryFolder folder;
  FitMaterialOptions options;
  // a neo-Hookean body of c10 = 10 kPa
  std::string table = "# test: uniaxial\nstretch,nominal_stress_kPa\n";
  for (const double s : {0.9, 1.0, 1.1, 1.2, 1.3})
    table += std::to_string(s) + "," + std::to_string(20 * (s - 1 / (s * s))) + "\n";
  options.data = folder.write("cheek.csv", table);
  options.law = "neo-hookean";
  options.poisson_ratio = 0.4;
  options.folder = folder / "out";
  const FitMaterialResult result = fit_material(options);
  EXPECT_EQ(result.files[0].filename(), "cheek-neo-hookean.json");
  const json entry = read_json(result.files[0]);
  // the file that it goes into may be in other units: the entry says its own
  const json document = {{"units", "kPa"},
                         {"volumetric_law", "log"},
                         {"tissues", {{"skin", entry}, {"fat", entry}, {"muscle", entry}}}};
  const MaterialSet set = read_materials(folder.write("own.json", document.dump()));
  EXPECT_NEAR(std::get<NeoHookean>(set.of(Tissue::Fat)).isochoric.c10, 0.010, 1e-8);
  EXPECT_NEAR(poisson_ratio(set.of(Tissue::Fat)), 0.4, 1e-12);
  const std::string words = fit_summary(result.fits[0]);
  for (const char* part :
       {"cheek.csv: uniaxial test, 5 points, stretch 0.9 to 1.3", "c10              10", "0.4;",
        "RMS residual", "stable at        every stretch"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " is not in\n" << words;
}

TEST(FitMaterial, AnUnstableFitSaysWhereItEnds)
{
  const TemporaryFolder folder;
  FitMaterialOptions options = table1_options(folder);
  options.stable = false;
  options.law = "mooney-rivlin";
  options.tissue = "fat";
  const FitMaterialResult result = fit_material(options);
  EXPECT_EQ(result.files[0].filename(), "table1-fat-mooney-rivlin.json");
  const auto& law = std::get<MooneyRivlin>(result.fits.at(0).fit.law).isochoric;
  EXPECT_NEAR(law.c01, -16.0127 * 9.80665e-3, 1e-9);
  const std::string words = fit_summary(result.fits[0]);
  for (const char* part :
       {"stable at stretch 0.9816 and above", "stable at stretch 1.0092 and below"})
    EXPECT_NE(words.find(part), std::string::npos) << words;
  EXPECT_NE(read_json(result.files[0])["fit"]["stable_range"].get<std::string>().find("0.9816"),
            std::string::npos);
}

TEST(FitMaterial, BadOptionsLeaveNothingBehind)
{
  const TemporaryFolder folder;
  FitMaterialOptions none;
  none.folder = folder / "out";
  expect_error([&] { fit_material(none); }, {"DATA.csv", "--table1"});
  FitMaterialOptions both = table1_options(folder);
  both.data = "a.csv";
  expect_error([&] { fit_material(both); }, {"either"});
  FitMaterialOptions tissue = table1_options(folder);
  tissue.tissue = "skn";
  expect_error([&] { fit_material(tissue); }, {"skn", "did you mean 'skin'?"});
  FitMaterialOptions law = table1_options(folder);
  law.law = "ogden";
  expect_error([&] { fit_material(law); }, {"ogden", "known laws: yeoh"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  FitMaterialOptions file = table1_options(folder);
  file.folder = folder.write("file", "");
  expect_error([&] { fit_material(file); }, {"file", "folder cannot be made"});
}

} // namespace
} // namespace f2b
