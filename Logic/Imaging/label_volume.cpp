#include "Imaging/label_volume.hpp"

#include "Core/error.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <itkImageFileReader.h>
#include <itkMetaDataObject.h>
#include <itkNrrdImageIO.h>

#include <cmath>

namespace f2b
{
namespace
{

using LabelImage = itk::Image<unsigned short, 3>;

std::string text_of(const itk::MetaDataDictionary& header, const std::string& key)
{
  std::string value;
  itk::ExposeMetaData<std::string>(header, key, value);
  return value;
}

void read_segments(const itk::MetaDataDictionary& header, LabelVolume& volume)
{
  for (int s = 0; s < 1000; ++s)
  {
    const std::string prefix = "Segment" + std::to_string(s) + "_";
    const std::string value = text_of(header, prefix + "LabelValue");
    if (value.empty() && text_of(header, prefix + "Name").empty())
      break;
    volume.is_segmentation = true;
    volume.segments[value.empty() ? s + 1 : std::atoi(value.c_str())] =
        text_of(header, prefix + "Name");
  }
}

void set_geometry(const LabelImage& image, LabelVolume& volume)
{
  const auto inverse = image.GetInverseDirection();
  for (unsigned a = 0; a < 3; ++a)
  {
    volume.size[a] = static_cast<int>(image.GetBufferedRegion().GetSize()[a]);
    volume.to_index[a][3] = 0;
    for (unsigned c = 0; c < 3; ++c)
    {
      volume.to_index[a][c] = inverse(a, c) / image.GetSpacing()[a];
      volume.to_index[a][3] -= volume.to_index[a][c] * image.GetOrigin()[c];
    }
  }
}

} // namespace

int LabelVolume::at_lps(double l, double p, double s) const
{
  std::size_t index = 0, stride = 1;
  for (int a = 0; a < 3; ++a)
  {
    const auto i = static_cast<long>(
        std::lround(to_index[a][0] * l + to_index[a][1] * p + to_index[a][2] * s + to_index[a][3]));
    if (i < 0 || i >= size[a])
      return -1;
    index += stride * static_cast<std::size_t>(i);
    stride *= static_cast<std::size_t>(size[a]);
  }
  return values[index];
}

LabelVolume read_label_volume(const std::filesystem::path& file)
{
  const QuietStreams quiet;
  auto io = itk::NrrdImageIO::New();
  auto reader = itk::ImageFileReader<LabelImage>::New();
  reader->SetImageIO(io);
  reader->SetFileName(file.string());
  try
  {
    io->SetFileName(file.string());
    io->ReadImageInformation();
    if (io->GetNumberOfDimensions() != 3 || io->GetNumberOfComponents() != 1)
      throw Error(file.string(), "its segments overlap (several layers) or it is no volume",
                  "export it from Slicer as one label map without overlaps");
    reader->Update();
  }
  catch (const itk::ExceptionObject& error)
  {
    throw Error(file.string(), "cannot be read: " + first_line(error.GetDescription()),
                "give a label map (.nrrd or .seg.nrrd)");
  }
  LabelVolume volume;
  const LabelImage& image = *reader->GetOutput();
  set_geometry(image, volume);
  const unsigned short* begin = image.GetBufferPointer();
  volume.values.assign(begin, begin + image.GetBufferedRegion().GetNumberOfPixels());
  read_segments(io->GetMetaDataDictionary(), volume);
  return volume;
}

} // namespace f2b
