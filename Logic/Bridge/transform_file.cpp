#include "Bridge/transform_file.hpp"

#include "Bridge/itk_with_eigen.hpp"

#include "Core/error.hpp"

#include <itkAffineTransform.h>
#include <itkHDF5TransformIOFactory.h>
#include <itkTransformFileReader.h>
#include <itkTransformFileWriter.h>
#include <itkTxtTransformIOFactory.h>
#include <itk_H5Cpp.h>

#include <fstream>
#include <iterator>
#include <mutex>

namespace f2b
{
namespace
{

using Affine = itk::AffineTransform<double, 3>;

void register_formats()
{
  static std::once_flag once;
  std::call_once(once,
                 []
                 {
                   itk::TxtTransformIOFactory::RegisterOneFactory();
                   itk::HDF5TransformIOFactory::RegisterOneFactory();
                   H5::Exception::dontPrint(); // its errors come as exceptions too
                 });
}

Mat4 lps_ras_flip()
{
  return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal();
}

[[noreturn]] void refuse(const std::filesystem::path& path)
{
  throw Error(path.string(), "it cannot be read as a transform", "give a whole .tfm or .h5 file");
}

/// ITK takes a text that ends too early for an identity.
void require_whole_text(const std::filesystem::path& path)
{
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.find("\nFixedParameters:") == std::string::npos || text.back() != '\n')
    refuse(path);
}

} // namespace

void write_transform(const std::filesystem::path& path, const Mat4& rest_to_planned_ras)
{
  register_formats();
  const Mat4 m = lps_ras_flip() * rest_to_planned_ras.inverse() * lps_ras_flip();
  auto transform = Affine::New();
  Affine::MatrixType matrix;
  Affine::OutputVectorType offset;
  for (unsigned r = 0; r < 3; ++r)
  {
    for (unsigned c = 0; c < 3; ++c)
      matrix(r, c) = m(r, c);
    offset[r] = m(r, 3);
  }
  transform->SetMatrix(matrix);
  transform->SetOffset(offset);
  try
  {
    auto writer = itk::TransformFileWriterTemplate<double>::New();
    writer->SetFileName(path.string());
    writer->SetInput(transform);
    writer->Update();
  }
  catch (const std::exception&)
  {
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
  }
}

Mat4 read_transform(const std::filesystem::path& path)
{
  register_formats();
  if (path.extension() != ".h5")
    require_whole_text(path);
  auto reader = itk::TransformFileReaderTemplate<double>::New();
  reader->SetFileName(path.string());
  try
  {
    reader->Update();
  }
  catch (const std::exception&)
  {
    refuse(path);
  }
  catch (const H5::Exception&)
  {
    refuse(path);
  }
  const auto* base = reader->GetTransformList()->empty()
                         ? nullptr
                         : dynamic_cast<itk::MatrixOffsetTransformBase<double, 3, 3>*>(
                               reader->GetTransformList()->front().GetPointer());
  if (!base)
    throw Error(path.string(), "it holds no linear transform in 3D",
                "give an affine or rigid transform");
  Mat4 m = Mat4::Identity();
  for (unsigned r = 0; r < 3; ++r)
  {
    for (unsigned c = 0; c < 3; ++c)
      m(r, c) = base->GetMatrix()(r, c);
    m(r, 3) = base->GetOffset()[r];
  }
  return (lps_ras_flip() * m * lps_ras_flip()).inverse();
}

} // namespace f2b
