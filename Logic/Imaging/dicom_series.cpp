#include "Imaging/dicom_series.hpp"

#include "Core/error.hpp"
#include "Imaging/quiet_streams.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>
#include <itkVector.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

// ITK's vectors, not Core's: the readers' headers bring ITK's own copy of Eigen along, and two
// versions of Eigen do not get on in one translation unit.
using Vector = itk::Vector<double, 3>;

constexpr std::size_t fewest_slices = 16;

struct Slice
{
  fs::path file;
  std::string series, description, modality;
  itk::SizeValueType columns = 0, rows = 0, frames = 1;
  double spacing[3] = {0, 0, 0};
  Vector origin, across, down; ///< LPS [mm]; unit vectors along a row and down a column
  Vector normal() const { return itk::CrossProduct(across, down); }
  double position() const { return origin * normal(); }
};

using Series = std::vector<Slice>;

std::string tag(const itk::ImageIOBase& io, const char* key)
{
  std::string value;
  itk::ExposeMetaData<std::string>(io.GetMetaDataDictionary(), key, value);
  while (!value.empty() && (value.back() == ' ' || value.back() == '\0'))
    value.pop_back();
  return value;
}

std::string number(double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
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

Slice slice_of(const fs::path& file)
{
  const QuietStreams quiet;
  auto io = itk::GDCMImageIO::New();
  io->SetFileName(file.string());
  Slice slice;
  slice.file = file;
  try
  {
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject&)
  {
    return slice;
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

std::vector<fs::path> files_of(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw Error(folder.string(), "is an empty folder", "give a folder with the slices of one CT");
  return files;
}

/// A direction in whole per cents, so that rounding in the file does not part equal ones.
std::string rounded(const Vector& direction)
{
  std::ostringstream out;
  for (unsigned a = 0; a < 3; ++a)
    out << std::lround(100.0 * direction[a]) << '/';
  return out.str();
}

/// Slices by series; slices of another size or direction within a series count as a series too.
std::map<std::string, Series> series_of(const fs::path& folder)
{
  std::map<std::string, Series> found;
  for (const fs::path& file : files_of(folder))
  {
    if (!is_dicom(file))
      continue;
    Slice slice = slice_of(file);
    if (slice.series.empty())
      continue;
    std::ostringstream key;
    key << slice.series << ' ' << slice.columns << 'x' << slice.rows << ' ' << rounded(slice.across)
        << ' ' << rounded(slice.down);
    found[key.str()].push_back(std::move(slice));
  }
  if (found.empty())
    throw Error(folder.string(), "holds no DICOM images",
                "give a folder with the slices of one CT");
  return found;
}

std::string described(const Series& series)
{
  return "'" + series[0].description + "' (" + series[0].modality + ", " + series[0].series + ", " +
         std::to_string(series.size()) + " slices)";
}

bool is_volume(const Series& series)
{
  return series.size() >= fewest_slices || series[0].frames >= fewest_slices;
}

Series the_series(const fs::path& folder, std::vector<std::string>& notes)
{
  std::map<std::string, Series> found = series_of(folder);
  std::string list;
  std::size_t volumes = 0;
  for (const auto& [key, series] : found)
  {
    volumes += is_volume(series);
    list += (list.empty() ? "" : ", ") + described(series);
  }
  if (found.size() == 1)
    return std::move(found.begin()->second);
  if (volumes != 1)
    throw Error(folder.string(), "holds " + std::to_string(found.size()) + " DICOM series: " + list,
                "give a folder with one series");
  Series chosen;
  for (auto& [key, series] : found)
    if (is_volume(series))
      chosen = std::move(series);
    else
      notes.push_back("Left out a small DICOM series: " + described(series) + ".");
  return chosen;
}

/// The distance between neighbouring slices [mm].
double slice_spacing(const Series& sorted, const fs::path& folder)
{
  std::vector<double> steps;
  for (std::size_t s = 1; s < sorted.size(); ++s)
    steps.push_back(sorted[s].position() - sorted[s - 1].position());
  std::vector<double> ordered = steps;
  std::nth_element(ordered.begin(), ordered.begin() + ordered.size() / 2, ordered.end());
  const double usual = ordered[ordered.size() / 2];
  for (std::size_t s = 0; s < steps.size(); ++s)
  {
    const std::string between =
        sorted[s].file.filename().string() + " and " + sorted[s + 1].file.filename().string();
    if (steps[s] < 1e-3)
      throw Error(folder.string(), "has two slices at one position: " + between,
                  "keep one image of each slice");
    if (std::abs(steps[s] - usual) > 0.05 * usual)
      throw Error(folder.string(),
                  "slices are missing or not evenly spaced: " + number(steps[s]) + " mm between " +
                      between + ", elsewhere " + number(usual) + " mm",
                  "copy all slices of the series");
  }
  return (sorted.back().position() - sorted.front().position()) /
         static_cast<double>(sorted.size() - 1);
}

void require_no_tilt(const Series& sorted, const fs::path& folder)
{
  const Vector way = sorted.back().origin - sorted.front().origin;
  const Vector normal = sorted.front().normal();
  const Vector aside = way - normal * (way * normal);
  if (aside.GetNorm() > 0.01 * way.GetNorm())
    throw Error(folder.string(),
                "slices are shifted by " + number(aside.GetNorm()) + " mm in all (tilted gantry)",
                "resample the CT to a rectangular lattice");
}

void read_slice(const Slice& slice, short* voxels)
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

CtImage::Pointer stack(const Series& sorted, const fs::path& folder)
{
  const Slice& first = sorted.front();
  const bool several = sorted.size() > 1;
  CtImage::SpacingType spacing;
  spacing[0] = first.spacing[0];
  spacing[1] = first.spacing[1];
  spacing[2] = several ? slice_spacing(sorted, folder) : first.spacing[2];
  require_spacing(spacing.GetDataPointer(), folder.string());
  if (several)
    require_no_tilt(sorted, folder);
  const Vector normal = first.normal();
  CtImage::DirectionType direction;
  CtImage::PointType origin;
  for (unsigned a = 0; a < 3; ++a)
  {
    direction(a, 0) = first.across[a];
    direction(a, 1) = first.down[a];
    direction(a, 2) = normal[a];
    origin[a] = first.origin[a];
  }
  const CtImage::SizeType size{{first.columns, first.rows, several ? sorted.size() : first.frames}};
  const CtImage::Pointer ct = make_image(size, spacing, origin, direction, folder.string());
  for (std::size_t s = 0; s < sorted.size(); ++s)
    read_slice(sorted[s], ct->GetBufferPointer() + s * first.columns * first.rows);
  return ct;
}

} // namespace

bool is_dicom(const fs::path& file)
{
  const QuietStreams quiet;
  return itk::GDCMImageIO::New()->CanReadFile(file.c_str());
}

CtImage::Pointer read_dicom_folder(const fs::path& folder, std::vector<std::string>& notes)
{
  Series series = the_series(folder, notes);
  if (series[0].modality != "CT")
    throw Error(folder.string(), "DICOM modality is '" + series[0].modality + "'",
                "give a CT; other images do not hold Hounsfield units");
  std::sort(series.begin(), series.end(),
            [](const Slice& a, const Slice& b) { return a.position() < b.position(); });
  return stack(series, folder);
}

} // namespace f2b
