#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/stress_strain_file.hpp>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

TEST(StressStrainFile, EveryQuantityAndUnitBecomesStretchAndNominalMPa)
{
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> same[] = {
      {"stretch,nominal_stress_kPa", "1.25,50"},
      {"stretch,nominal_stress_MPa", "1.25,0.05"},
      {"strain;nominal_stress_Pa", "0.25;50000"},
      {"strain_percent\ttrue_stress_kPa", "25\t62.5"},
      {"stretch, true_stress_MPa", " 1.25 , .0625"},
      {"stretch,nominal_stress_gf/mm^2", "1.25,5.0985810648896406"}};
  for (const auto& [header, point] : same)
    for (const char* test : {"uniaxial", "equibiaxial"})
    {
      const auto file =
          folder.write("curve.csv", std::string("\xEF\xBB\xBF# skin, abdomen\r\n# test: ") + test +
                                        "\r\n\r\n" + header + "\r\n" + point + "\r\n# a remark\n");
      const StressCurve curve = read_stress_curve(file);
      EXPECT_EQ(curve.source, file.string());
      EXPECT_EQ(curve.loading,
                test == std::string("uniaxial") ? Loading::Uniaxial : Loading::Equibiaxial);
      ASSERT_EQ(curve.deformation.size(), 1u) << header;
      EXPECT_DOUBLE_EQ(curve.deformation[0], 1.25) << header;
      EXPECT_NEAR(curve.stress[0], 0.05, 1e-15) << header;
    }
}

TEST(StressStrainFile, ShearStressIsTheSameTrueAndNominal)
{
  const TemporaryFolder folder;
  for (const char* kind : {"true", "nominal"})
  {
    const StressCurve curve =
        read_stress_curve(folder.write("shear.csv", std::string("# test: simple-shear\nshear,") +
                                                        kind + "_stress_kPa\n-0.2,-3\n0.4,6\n"));
    EXPECT_EQ(curve.deformation, (std::vector<double>{-0.2, 0.4}));
    EXPECT_DOUBLE_EQ(curve.stress[1], 0.006);
    EXPECT_DOUBLE_EQ(curve.largest_stress(), 0.006);
  }
}

TEST(StressStrainFile, FaultsAreNamedByLine)
{
  const TemporaryFolder folder;
  const std::string head = "# test: uniaxial\nstretch,nominal_stress_kPa\n";
  const std::pair<std::string, std::vector<std::string>> faults[] = {
      {"", {"no points"}},
      {"stretch,nominal_stress_kPa\n1,0\n", {":1:", "states the test", "# test: uniaxial"}},
      {"# test: uniaxal\n", {":1:", "'uniaxal'", "did you mean 'uniaxial'"}},
      {"# test: torsion\n", {":1:", "'torsion'", "known tests"}},
      {head, {"no points"}},
      {head + "1.1;\n", {":3:", "''", "not a number"}},
      {head + "1.1,2,3\n", {":3:", "3 values"}},
      {head + "1,1;2,3\n", {":3:", "4 values", "decimal point"}},
      {head + "1.1,nan\n", {":3:", "'nan'"}},
      {head + "1.1,1e999\n", {":3:", "'1e999'"}},
      {head + "1.1,2\n0,0\n", {":4:", "stretch is 0"}},
      {head + "1.1,2\n# test: equibiaxial\n", {":4:", "before the header"}},
      {"# test: uniaxial\n1.0,0\n", {":2:", "first column is '1.0'", "stretch"}},
      {"# test: uniaxial\nstretch\n", {":2:", "1 columns"}},
      {"# test: uniaxial\nstrech,nominal_stress_kPa\n", {":2:", "did you mean 'stretch'"}},
      {"# test: uniaxial\nshear,nominal_stress_kPa\n", {":2:", "'shear'", "stretch"}},
      {"# test: simple-shear\nstretch,nominal_stress_kPa\n", {":2:", "'stretch'", "shear"}},
      {"# test: uniaxial\nstretch,stress\n", {":2:", "'stress'", "nominal_stress_kPa"}},
      {"# test: uniaxial\nstretch,nominal_stress_psi\n", {":2:", "'psi'", "kPa"}},
      {"# test: uniaxial\nstrain,nominal_stress_kPa\n-1,3\n", {":3:", "above -1"}}};
  for (const auto& [text, parts] : faults)
  {
    const auto file = folder.write("bad.csv", text);
    std::vector<std::string> all = parts;
    all.push_back("bad.csv");
    expect_error([&] { read_stress_curve(file); }, all);
  }
  expect_error([&] { read_stress_curve(folder / "absent.csv"); }, {"absent.csv", "cannot be read"});
  expect_error([&] { read_stress_curve(folder.path()); }, {"cannot be read"});
}

} // namespace
} // namespace f2b
