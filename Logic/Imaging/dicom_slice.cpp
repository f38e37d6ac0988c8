#include "Imaging/dicom_slice.hpp"

#include "Core/error.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <vector>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

std::string tag(const itk::ImageIOBase& io, const char* key)
{
  std::string value;
  itk::ExposeMetaData<std::string>(io.GetMetaDataDictionary(), key, value);
  while (!value.empty() && (value.back() == ' ' || value.back() == '\0'))
    value.pop_back();
  return value;
}

/// Fewer bytes than its pixels take, in a file whose pixels are not compressed.
void require_whole(const fs::path& file, const itk::ImageIOBase& io, const std::string& warnings)
{
  if (warnings.find("Incomplete Pixel Data") == std::string::npos)
    return;
  throw Error(file.string(),
              "is a truncated DICOM slice: " + std::to_string(fs::file_size(file)) + " bytes for " +
                  std::to_string(io.GetDimensions(0)) + " x " +
                  std::to_string(io.GetDimensions(1)) + " pixels",
              "copy the folder again");
}

} // namespace

bool is_dicom(const fs::path& file)
{
  const QuietStreams quiet;
  return itk::GDCMImageIO::New()->CanReadFile(file.c_str());
}

std::optional<DicomSlice> read_slice_header(const fs::path& file)
{
  const QuietStreams quiet;
  auto io = itk::GDCMImageIO::New();
  io->SetFileName(file.string());
  DicomSlice slice;
  slice.file = file;
  try
  {
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject&)
  {
    return std::nullopt;
  }
  require_whole(file, *io, quiet.text());
  slice.series = tag(*io, "0020|000e");
  slice.description = tag(*io, "0008|103e");
  slice.modality = tag(*io, "0008|0060");
  if (slice.modality == "CT")
    require_hounsfield_type(*io, file.string());
  slice.columns = io->GetDimensions(0);
  slice.rows = io->GetDimensions(1);
  slice.frames = io->GetNumberOfDimensions() > 2 ? io->GetDimensions(2) : 1;
  for (unsigned a = 0; a < 3 && a < io->GetNumberOfDimensions(); ++a)
  {
    slice.spacing[a] = io->GetSpacing(a);
    slice.origin[a] = io->GetOrigin(a);
    slice.across[a] = io->GetDirection(0)[a];
    slice.down[a] = io->GetDirection(1)[a];
  }
  // ITK puts 1 mm in the place of a spacing that is missing or nought.
  const std::string written = tag(*io, "0028|0030");
  double row_spacing = 0, column_spacing = 0;
  if (std::sscanf(written.c_str(), "%lf\\%lf", &row_spacing, &column_spacing) == 2)
  {
    slice.spacing[0] = column_spacing;
    slice.spacing[1] = row_spacing;
  }
  if (slice.frames == 1 && tag(*io, "0020|0032").empty())
    slice.series.clear();
  return slice;
}

void read_slice(const DicomSlice& slice, short* voxels)
{
  const QuietStreams quiet;
  auto io = itk::GDCMImageIO::New();
  io->SetFileName(slice.file.string());
  try
  {
    io->ReadImageInformation();
    read_voxels(*io, slice.file.string(), voxels);
  }
  catch (const itk::ExceptionObject& error)
  {
    throw Error(slice.file.string(), "cannot be read: " + first_line(error.GetDescription()),
                "copy the folder again");
  }
}

bool same_pixels(const DicomSlice& a, const DicomSlice& b)
{
  if (a.columns != b.columns || a.rows != b.rows)
    return false;
  std::vector<short> first(a.columns * a.rows), second(first.size());
  read_slice(a, first.data());
  read_slice(b, second.data());
  return first == second;
}

} // namespace f2b
