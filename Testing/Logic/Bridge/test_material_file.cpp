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
  refused("/units", "kPa", {"units", "MPa"});
  refused("/units", 3, {"units", "MPa"});
  refused("/volumetric_law", "log", {"volumetric_law", "barrier"});
  refused("/tissues", json::array(), {"tissues/skin"});
  refused("/tissues/fat", nullptr, {"tissues/fat/law"});
  refused("/tissues/fat/law", "ogden", {"tissues/fat/law", "ogden"});
  refused("/tissues/fat/law", 7, {"tissues/fat/law"});
  refused("/tissues/skin/c1", "0.1", {"tissues/skin/c1", "\"0.1\""});
  refused("/tissues/skin/c1", 0, {"tissues/skin", "c1 > 0"});
  refused("/tissues/skin/c2", -0.1, {"tissues/skin", "c2 = -0.1"});
  refused("/tissues/muscle/c3", -1, {"tissues/muscle", "c3 = -1"});
  refused("/tissues/muscle/poisson_ratio", 0.5, {"tissues/muscle/poisson_ratio", "0.5"});
  refused("/tissues/muscle/poisson_ratio", -1, {"tissues/muscle/poisson_ratio", "-1"});
}

TEST(MaterialFile, MissingKeysAndFilesAreNamed)
{
  const TemporaryFolder folder;
  for (const char* key : {"c1", "c2", "c3", "poisson_ratio"})
  {
    json document = good_document();
    document["tissues"]["fat"].erase(key);
    const auto file = folder.write("own.json", document.dump());
    expect_error([&] { read_materials(file); },
                 {file.string(), std::string("tissues/fat/") + key, "missing"});
  }
  expect_error([] { read_materials("tabel1-stable"); },
               {"tabel1-stable", "no such", "table1-stable"});
  expect_error([&] { read_materials(folder.write("list.json", "[]")); }, {"list.json", "units"});
}

} // namespace
} // namespace f2b
