#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/material_file.hpp>

#include <nlohmann/json.hpp>

namespace f2b
{
namespace
{

using nlohmann::json;
using test::expect_error;
using test::TemporaryFolder;

json good_document()
{
  const json law = {
      {"law", "yeoh"}, {"c1", 0.02}, {"c2", 0.01}, {"c3", 0}, {"poisson_ratio", 0.45}};
  return {{"name", "own"},
          {"units", "MPa"},
          {"volumetric_law", "barrier"},
          {"tissues", {{"skin", law}, {"fat", law}, {"muscle", law}}}};
}

const IsochoricYeoh& yeoh_of(const MaterialSet& set, Tissue tissue)
{
  return std::get<Yeoh>(set.of(tissue)).isochoric;
}

TEST(MaterialFile, CarriedSetHoldsTheFittedValues)
{
  const MaterialSet set = read_materials("table1-stable");
  EXPECT_EQ(set.name, "table1-stable");
  EXPECT_NEAR(yeoh_of(set, Tissue::Skin).c1, 0.04796368459, 1e-12);
  EXPECT_NEAR(yeoh_of(set, Tissue::Fat).c2, 0.05365742555, 1e-12);
  EXPECT_NEAR(yeoh_of(set, Tissue::Muscle).c1, 0.02709435238, 1e-12);
  EXPECT_NEAR(poisson_ratio(set.of(Tissue::Muscle)), 0.30, 1e-12);
}

TEST(MaterialFile, UsersFileIsRead)
{
  const TemporaryFolder folder;
  const MaterialSet set = read_materials(folder.write("own.json", good_document().dump()));
  EXPECT_EQ(set.name, "own");
  EXPECT_EQ(yeoh_of(set, Tissue::Fat).c1, 0.02);
}

TEST(MaterialFile, EveryLawIsRead)
{
  const TemporaryFolder folder;
  json document = good_document();
  document["tissues"] = {
      {"skin", {{"law", "mooney-rivlin"}, {"c10", 0.18}, {"c01", -0.15}, {"poisson_ratio", 0.49}}},
      {"fat", {{"law", "neo-hookean"}, {"c10", 0.01}, {"poisson_ratio", 0.4}}},
      {"muscle", {{"law", "linear"}, {"youngs_modulus", 0.03}, {"poisson_ratio", 0.25}}}};
  const MaterialSet set = read_materials(folder.write("own.json", document.dump()));
  EXPECT_EQ(std::get<MooneyRivlin>(set.of(Tissue::Skin)).isochoric.c01, -0.15);
  EXPECT_EQ(std::get<NeoHookean>(set.of(Tissue::Fat)).isochoric.c10, 0.01);
  EXPECT_NEAR(poisson_ratio(set.of(Tissue::Fat)), 0.4, 1e-14);
  const auto& muscle = std::get<LinearElastic>(set.of(Tissue::Muscle));
  EXPECT_NEAR(muscle.shear_modulus, 0.012, 1e-16);
  EXPECT_NEAR(muscle.bulk_modulus, 0.02, 1e-16);
}

TEST(MaterialFile, UnitsAreConvertedOnce)
{
  const TemporaryFolder folder;
  for (const auto& [units, value] :
       {std::pair{"MPa", 0.02}, {"kPa", 20.}, {"Pa", 20000.}, {"gf/mm^2", 0.02 / 9.80665e-3}})
  {
    json document = good_document();
    document["units"] = units;
    document["tissues"]["fat"]["c1"] = value;
    // a tissue's own units stand against the file's
    document["tissues"]["skin"]["units"] = "MPa";
    const MaterialSet set = read_materials(folder.write("own.json", document.dump()));
    EXPECT_NEAR(yeoh_of(set, Tissue::Fat).c1, 0.02, 1e-16) << units;
    EXPECT_EQ(yeoh_of(set, Tissue::Skin).c1, 0.02) << units;
    EXPECT_NEAR(poisson_ratio(set.of(Tissue::Fat)), 0.45, 1e-14);
  }
}

TEST(MaterialFile, VolumetricLawIsTheNamedOne)
{
  const TemporaryFolder folder;
  for (const auto& [name, kind] : {std::pair{"quadratic", VolumetricLaw::Kind::Quadratic},
                                   {"log", VolumetricLaw::Kind::Logarithmic},
                                   {"barrier", VolumetricLaw::Kind::Barrier}})
  {
    json document = good_document();
    document["volumetric_law"] = name;
    const MaterialSet set = read_materials(folder.write("own.json", document.dump()));
    EXPECT_EQ(std::get<Yeoh>(set.of(Tissue::Muscle)).volumetric.kind, kind);
  }
}

TEST(MaterialFile, Table1IsLiteralAndLoads)
{
  const MaterialSet set = read_materials("table1");
  EXPECT_EQ(set.name, "table1");
  const auto& skin = std::get<MooneyRivlin>(set.of(Tissue::Skin)).isochoric;
  EXPECT_NEAR(skin.c10, 18.9834 * 9.80665e-3, 1e-15);
  EXPECT_NEAR(skin.c01, -15.4072 * 9.80665e-3, 1e-15);
  EXPECT_NEAR(1000 * shear_modulus(set.of(Tissue::Skin)), 70.14, 0.005);
  EXPECT_NEAR(1000 * shear_modulus(set.of(Tissue::Muscle)), 41.23, 0.005);
  EXPECT_NEAR(1000 * shear_modulus(set.of(Tissue::Fat)), 11.78, 0.005);
  EXPECT_NEAR(poisson_ratio(set.of(Tissue::Muscle)), 0.30, 1e-14);
}

TEST(MaterialFile, LiteratureSetIsAbout15KPaAtSmallStrain)
{
  const MaterialSet set = read_materials("nazari-2011");
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
  {
    EXPECT_NEAR(yeoh_of(set, tissue).c2, 1.175e-3, 1e-15);
    const double E = 2 * shear_modulus(set.of(tissue)) * (1 + poisson_ratio(set.of(tissue)));
    EXPECT_NEAR(E, 0.0149, 1e-9);
  }
}

TEST(MaterialFile, TissueEntryReadsBackAsTheSameLaw)
{
  const TemporaryFolder folder;
  const VolumetricLaw U{VolumetricLaw::Kind::Barrier, bulk_from(0.02, 0.45)};
  for (const Law& law :
       {Law(LinearElastic{0.01, bulk_from(0.01, 0.45)}), Law(NeoHookean{{0.01}, U}),
        Law(MooneyRivlin{{0.015, -0.005}, U}), Law(Yeoh{{0.01, 0.02, -0.03}, U})})
  {
    json document = good_document();
    document["tissues"]["fat"] = json::parse(tissue_entry(law).dump());
    const Law back = read_materials(folder.write("own.json", document.dump())).of(Tissue::Fat);
    ASSERT_EQ(back.index(), law.index());
    Mat3 F = Mat3::Identity();
    F(0, 1) = 0.3;
    F(2, 2) = 1.1;
    const auto stress = [&](const Law& one)
    { return std::visit([&](const auto& l) -> Mat3 { return l.stress(F); }, one); };
    EXPECT_LT((stress(back) - stress(law)).norm(), 1e-9 * stress(law).norm());
  }
}

TEST(MaterialFile, EveryBadKeyIsNamed)
{
  const TemporaryFolder folder;
  auto refused = [&](const char* pointer, const json& value, const std::vector<std::string>& parts)
  {
    json document = good_document();
    document[json::json_pointer(pointer)] = value;
    const auto file = folder.write("own.json", document.dump());
    std::vector<std::string> all = parts;
    all.push_back(file.string());
    expect_error([&] { read_materials(file); }, all);
  };
  refused("/units", "psi", {"units", "psi", "MPa, kPa, Pa, gf/mm^2"});
  refused("/units", 3, {"units", "MPa"});
  refused("/unit", "kPa", {"unit ", "not a known key", "did you mean 'units'?"});
  refused("/volumetric_law", "ln", {"volumetric_law", "ln", "quadratic, log, barrier"});
  refused("/tissues", json::array(), {"tissues/skin"});
  refused("/tissues/bone", 1, {"tissues/bone", "skin, fat, muscle"});
  refused("/tissues/fat", nullptr, {"tissues/fat"});
  refused("/tissues/fat/law", "ogden", {"tissues/fat/law", "ogden", "mooney-rivlin"});
  refused("/tissues/fat/law", 7, {"tissues/fat/law"});
  refused("/tissues/fat/units", "bar", {"tissues/fat/units", "bar"});
  refused("/tissues/fat/c10", 1, {"tissues/fat/c10", "did you mean 'c1'?"});
  refused("/tissues/skin/c1", "0.1", {"tissues/skin/c1", "\"0.1\""});
  refused("/tissues/skin/c1", nullptr, {"tissues/skin/c1", "null"}); // what a NaN becomes
  refused("/tissues/skin/c1", 0, {"tissues/skin", "c1 = 0", "c1 > 0"});
  refused("/tissues/skin/c1", -0.1, {"tissues/skin", "c1 = -0.1", "c1 > 0"});
  refused("/tissues/muscle/poisson_ratio", 0.5, {"tissues/muscle/poisson_ratio", "0.5"});
  refused("/tissues/muscle/poisson_ratio", -1, {"tissues/muscle/poisson_ratio", "-1"});
  refused("/tissues/fat",
          {{"law", "mooney-rivlin"}, {"c10", 0.1}, {"c01", -0.1}, {"poisson_ratio", 0.4}},
          {"tissues/fat", "c10 = 0.1, c01 = -0.1", "c10 + c01 > 0"});
  refused("/tissues/fat", {{"law", "linear"}, {"youngs_modulus", -1}, {"poisson_ratio", 0.4}},
          {"tissues/fat", "youngs_modulus = -1"});
}

TEST(MaterialFile, MissingKeysAndFilesAreNamed)
{
  const TemporaryFolder folder;
  for (const char* key : {"c1", "c2", "c3", "poisson_ratio", "law"})
  {
    json document = good_document();
    document["tissues"]["fat"].erase(key);
    const auto file = folder.write("own.json", document.dump());
    expect_error([&] { read_materials(file); },
                 {file.string(), std::string("tissues/fat/") + key, "missing"});
  }
  expect_error([] { read_materials("tabel1-stable"); },
               {"tabel1-stable", "no such", "nazari-2011, table1-stable, table1"});
  expect_error([&] { read_materials(folder.write("list.json", "[]")); },
               {"list.json", "array, not an object"});
  expect_error([&] { read_materials(folder.write("break.json", R"({"\nas": {}})")); },
               {"break.json", "\\nas is not a known key"});
  expect_error([&] { read_materials(folder.write("nan.json", R"({"units": NaN})")); },
               {"nan.json", "line 1"});
}

} // namespace
} // namespace f2b
