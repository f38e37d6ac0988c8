#include "Imaging/read_ct.hpp"

#include "Core/error.hpp"
#include "Imaging/dicom_series.hpp"
#include "Imaging/grey_values.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/volume_header.hpp"
#include "Imaging/volume_name.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

/// The reader for a file's name, after the checks that ITK leaves out; null for other names.
itk::ImageIOBase::Pointer checked_reader(const fs::path& path)
{
  switch (volume_format(path))
  {
  case VolumeFormat::Nrrd:
    check_nrrd(path);
    return itk::NrrdImageIO::New().GetPointer();
  case VolumeFormat::MetaImage:
    check_meta_image(path);
    return itk::MetaImageIO::New().GetPointer();
  case VolumeFormat::Nifti:
    check_nifti(path);
    return itk::NiftiImageIO::New().GetPointer();
  case VolumeFormat::Dicom:
  case VolumeFormat::None:
    break;
  }
  return nullptr;
}

CtImage::Pointer read_volume(itk::ImageIOBase& io, const std::string& name)
{
  io.SetFileName(name);
  io.ReadImageInformation();
  require_hounsfield_type(io, name);
  if (io.GetNumberOfDimensions() != 3)
    throw Error(name, "has " + std::to_string(io.GetNumberOfDimensions()) + " dimensions",
                "give one CT volume of three dimensions");
  CtImage::SizeType size;
  CtImage::SpacingType spacing;
  CtImage::PointType origin;
  CtImage::DirectionType direction;
  for (unsigned a = 0; a < 3; ++a)
  {
    size[a] = io.GetDimensions(a);
    spacing[a] = io.GetSpacing(a);
    origin[a] = io.GetOrigin(a);
    for (unsigned row = 0; row < 3; ++row)
      direction(row, a) = io.GetDirection(a)[row];
  }
  const CtImage::Pointer ct = make_image(size, spacing, origin, direction, name);
  read_voxels(io, name, ct->GetBufferPointer());
  return ct;
}

CtImage::Pointer read_file(const fs::path& path)
{
  const itk::ImageIOBase::Pointer io = checked_reader(path);
  if (!io)
    throw Error(path.string(), "is not of a known image format",
                "give a DICOM folder, .nrrd, .nhdr, .mha, .mhd, .nii or .nii.gz file");
  const QuietStreams quiet;
  try
  {
    return read_volume(*io, path.string());
  }
  catch (const itk::ExceptionObject& error)
  {
    std::string reason = error.GetDescription();
    // Of the reader's stack of complaints the last one says what is wrong.
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == ' '))
      reason.pop_back();
    const std::size_t last = reason.rfind('\n');
    throw Error(path.string(),
                "cannot be read or is truncated: " +
                    first_line(last == std::string::npos ? reason : reason.substr(last + 1)),
                "copy or export the file again");
  }
}

/// A CT shows air around the head and bone in it.
void require_hounsfield_values(const CtImage& ct, const std::string& name)
{
  const short* voxels = ct.GetBufferPointer();
  const std::size_t count = ct.GetBufferedRegion().GetNumberOfPixels();
  const auto air = std::count_if(voxels, voxels + count, [](short v) { return v < -500; });
  const auto [lowest, highest] = std::minmax_element(voxels, voxels + count);
  if (static_cast<double>(air) >= 0.005 * static_cast<double>(count) && *highest > 200)
    return;
  throw Error(
      name,
      "does not look like a CT: values run from " + std::to_string(*lowest) + " to " +
          std::to_string(*highest) + ", " +
          (*highest > 200 ? "hardly any below -500 HU (air)" : "none above 200 HU (bone)"),
      "give a CT in Hounsfield units, not an MR or a rescaled image; for a cone-beam CT set "
      "\"grey_values\": \"cbct\" in the case");
}

} // namespace

fs::path dicom_folder_of(const fs::path& path)
{
  if (fs::is_directory(path))
    return path;
  if (volume_format(path) == VolumeFormat::Dicom || !path.has_extension())
    return fs::absolute(path).parent_path();
  return {};
}

CtImage::Pointer read_ct(const fs::path& path, std::vector<std::string>* notes,
                         const CtReading& reading)
{
  if (!fs::exists(path))
    throw Error(path.string(), "does not exist", "check the path of the CT");
  std::vector<std::string> ignored;
  std::vector<std::string>& told = notes ? *notes : ignored;
  CtImage::Pointer ct;
  if (const fs::path folder = dicom_folder_of(path); !folder.empty())
    ct = read_dicom_folder(folder, reading.series, told);
  else
    ct = read_file(path);
  if (reading.shifted_grey_values)
    told.push_back(to_hounsfield(*ct, path.string()));
  require_hounsfield_values(*ct, path.string());
  return ct;
}

} // namespace f2b
