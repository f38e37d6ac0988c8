#include "Bridge/grid_file.hpp"

#include "Bridge/itk_with_eigen.hpp"

#include "Core/error.hpp"

#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkImageFileWriter.h>
#include <itkNrrdImageIO.h>
#include <itkNrrdImageIOFactory.h>

#include <algorithm>
#include <mutex>
#include <type_traits>

namespace f2b
{
namespace
{

void register_nrrd()
{
  static std::once_flag once;
  std::call_once(once, [] { itk::NrrdImageIOFactory::RegisterOneFactory(); });
}

/// The grid's samples with the same order in memory: axes R and A are LPS axes turned round.
template <class Pixel, class Grid>
typename itk::Image<Pixel, 3>::Pointer to_image(const Grid& grid)
{
  auto image = itk::Image<Pixel, 3>::New();
  typename itk::Image<Pixel, 3>::SizeType size;
  typename itk::Image<Pixel, 3>::PointType origin;
  typename itk::Image<Pixel, 3>::SpacingType spacing;
  typename itk::Image<Pixel, 3>::DirectionType direction;
  direction.Fill(0);
  for (unsigned a = 0; a < 3; ++a)
  {
    const double sign = a < 2 ? -1 : 1;
    size[a] = static_cast<itk::SizeValueType>(grid.size[a]);
    origin[a] = sign * grid.origin[a];
    spacing[a] = grid.spacing;
    direction(a, a) = sign;
  }
  image->SetRegions(size);
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDirection(direction);
  image->Allocate();
  std::copy(grid.values.begin(), grid.values.end(), image->GetBufferPointer());
  return image;
}

template <class Pixel, class Grid>
void write(const std::filesystem::path& path, const Grid& grid)
{
  register_nrrd();
  auto writer = itk::ImageFileWriter<itk::Image<Pixel, 3>>::New();
  writer->SetFileName(path.string());
  writer->SetInput(to_image<Pixel>(grid));
  // labels shrink a hundredfold; distances hardly, at a high price in time
  writer->SetUseCompression(!std::is_same_v<Pixel, float>);
  try
  {
    writer->Update();
  }
  catch (const itk::ExceptionObject&)
  {
    throw Error(path.string(), "it cannot be written",
                "check the folder's permissions and free space");
  }
}

template <class Pixel, class Grid>
Grid read(const std::filesystem::path& path)
{
  register_nrrd();
  auto reader = itk::ImageFileReader<itk::Image<Pixel, 3>>::New();
  reader->SetFileName(path.string());
  reader->SetImageIO(itk::NrrdImageIO::New());
  try
  {
    reader->Update();
  }
  catch (const itk::ExceptionObject&)
  {
    throw Error(path.string(), "it cannot be read", "segment the case anew (facetobone segment)");
  }
  const auto* image = reader->GetOutput();
  Grid grid;
  grid.spacing = image->GetSpacing()[0];
  for (unsigned a = 0; a < 3; ++a)
  {
    const double sign = a < 2 ? -1 : 1;
    if (image->GetDirection()(a, a) != sign || image->GetSpacing()[a] != grid.spacing)
      throw Error(path.string(), "its axes are not those that FaceToBone writes",
                  "segment the case anew (facetobone segment)");
    grid.origin[a] = sign * image->GetOrigin()[a];
    grid.size[a] = static_cast<int>(image->GetLargestPossibleRegion().GetSize(a));
  }
  grid.values.assign(image->GetBufferPointer(), image->GetBufferPointer() + grid.count());
  return grid;
}

} // namespace

void write_grid(const std::filesystem::path& path, const ScalarGrid& grid)
{
  write<float>(path, grid);
}
void write_grid(const std::filesystem::path& path, const LabelGrid& grid)
{
  write<unsigned char>(path, grid);
}
ScalarGrid read_scalar_grid(const std::filesystem::path& path)
{
  return read<float, ScalarGrid>(path);
}
LabelGrid read_label_grid(const std::filesystem::path& path)
{
  return read<unsigned char, LabelGrid>(path);
}

} // namespace f2b
