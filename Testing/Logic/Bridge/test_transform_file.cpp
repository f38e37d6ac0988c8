#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/itk_with_eigen.hpp>
#include <Bridge/transform_file.hpp>
#include <Core/geometry/rigid_motion.hpp>

#include <itkAffineTransform.h>
#include <itkHDF5TransformIOFactory.h>
#include <itkTransformFileReader.h>
#include <itkTxtTransformIOFactory.h>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

RigidMotion table_2()
{
  constexpr double degree = 3.14159265358979323846 / 180;
  return {rotation_from({5 * degree, 2.5 * degree, 0}), {2, 11, -5}, {1.5, 62, -31}};
}

Vec3 lps_ras(const Vec3& p)
{
  return {-p.x(), -p.y(), p.z()};
}

class TransformFile : public testing::TestWithParam<const char*>
{
};

TEST_P(TransformFile, ComesBackExactly)
{
  const TemporaryFolder folder;
  const auto file = folder / ("mid-face" + std::string(GetParam()));
  write_transform(file, table_2().matrix());
  EXPECT_LT((read_transform(file) - table_2().matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(TransformFile, ItkMapsPlannedPointsBackToRestInLps)
{
  const TemporaryFolder folder;
  const auto file = folder / ("mid-face" + std::string(GetParam()));
  write_transform(file, table_2().matrix());
  itk::TxtTransformIOFactory::RegisterOneFactory();
  itk::HDF5TransformIOFactory::RegisterOneFactory();
  auto reader = itk::TransformFileReaderTemplate<double>::New();
  reader->SetFileName(file.string());
  reader->Update();
  auto* transform =
      dynamic_cast<itk::Transform<double, 3, 3>*>(reader->GetTransformList()->front().GetPointer());
  ASSERT_TRUE(transform);
  for (const Vec3& rest : {Vec3(0, 0, 0), Vec3(30, 80, -40), Vec3(-12.5, 3, 7)})
  {
    const Vec3 planned_lps = lps_ras(table_2().apply(rest));
    const auto back = transform->TransformPoint(itk::Point<double, 3>(planned_lps.data()));
    EXPECT_LT((Vec3(back[0], back[1], back[2]) - lps_ras(rest)).norm(), 1e-10);
  }
}

TEST_P(TransformFile, DamagedFilesAreRefusedInOneLine)
{
  const TemporaryFolder folder;
  const std::string name = "damaged" + std::string(GetParam());
  write_transform(folder / name, table_2().matrix());
  const std::string whole = test::read_text(folder / name);
  for (const std::string& text :
       {std::string(), std::string("not a transform"), whole.substr(0, whole.size() / 3)})
  {
    folder.write(name, text);
    expect_error([&] { read_transform(folder / name); }, {name});
  }
  expect_error([&] { read_transform(folder / ("absent" + std::string(GetParam()))); }, {"absent"});
}

TEST_P(TransformFile, UnwritablePlaceIsRefused)
{
  expect_error([]
               { write_transform("/proc/facetobone" + std::string(GetParam()), Mat4::Identity()); },
               {"/proc/facetobone", "cannot be written"});
}

INSTANTIATE_TEST_SUITE_P(Formats, TransformFile, testing::Values(".tfm", ".h5"),
                         [](const auto& tested) { return std::string(tested.param).substr(1); });

TEST(TransformFileKinds, NonlinearTransformIsRefused)
{
  const TemporaryFolder folder;
  const auto file = folder.write("t.tfm", "#Insight Transform File V1.0\n#Transform 0\n"
                                          "Transform: TranslationTransform_double_3_3\n"
                                          "Parameters: 1 2 3\nFixedParameters: \n");
  expect_error([&] { read_transform(file); }, {file.string(), "linear"});
  expect_error([&] { read_transform(folder.write("t.txt", "1 0 0")); }, {"t.txt"});
}

} // namespace
} // namespace f2b
