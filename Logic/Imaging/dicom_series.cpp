#include "Imaging/dicom_series.hpp"

#include "Core/error.hpp"
#include "Imaging/dicom_slice.hpp"
#include "Imaging/slice_stack.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

using Vector = DicomSlice::Vector;
constexpr std::size_t fewest_slices = 16;

using Slice = DicomSlice;
using Series = std::vector<Slice>;

std::string number(double value)
{
  std::ostringstream out;
  out << value;
  return out.str();
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
/// \param unreadable  gets the names of DICOM files that hold no image that can be read
std::map<std::string, Series> series_of(const fs::path& folder, std::string& unreadable)
{
  std::map<std::string, Series> found;
  for (const fs::path& file : files_of(folder))
  {
    if (!is_dicom(file))
      continue;
    std::optional<Slice> read = read_slice_header(file);
    if (!read)
      unreadable += (unreadable.empty() ? "" : ", ") + file.filename().string();
    if (!read || read->series.empty())
      continue;
    Slice& slice = *read;
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

/// The series that a user named: by its place in the list, its UID or a part of its description.
bool is_named(const Series& series, std::size_t place, const std::string& name)
{
  return name == std::to_string(place) || name == series[0].series ||
         (name.size() > 2 && series[0].description.find(name) != std::string::npos);
}

Series the_series(const fs::path& folder, const std::string& name, std::string& unreadable,
                  std::vector<std::string>& notes)
{
  std::map<std::string, Series> found = series_of(folder, unreadable);
  if (!unreadable.empty())
    notes.push_back("Left out DICOM files that hold no image that can be read: " + unreadable +
                    ".");
  std::string list;
  std::vector<std::map<std::string, Series>::iterator> wanted;
  std::size_t place = 0;
  for (auto entry = found.begin(); entry != found.end(); ++entry)
  {
    ++place;
    list += (list.empty() ? "" : ", ") + std::to_string(place) + ": " + described(entry->second);
    if (name.empty() ? is_volume(entry->second) : is_named(entry->second, place, name))
      wanted.push_back(entry);
  }
  if (name.empty() && found.size() == 1)
    return std::move(found.begin()->second);
  if (wanted.size() != 1)
    throw Error(folder.string(),
                "holds " + std::to_string(found.size()) + " DICOM series: " + list +
                    (name.empty() ? std::string()
                                  : "; " + std::to_string(wanted.size()) + " are '" + name + "'"),
                "name one of them with --series, or 'series' in the case, by number or UID");
  for (auto entry = found.begin(); entry != found.end(); ++entry)
    if (entry != wanted.front())
      notes.push_back((is_volume(entry->second) ? "Left out another DICOM series: "
                                                : "Left out a small DICOM series: ") +
                      described(entry->second) + ".");
  return std::move(wanted.front()->second);
}

std::vector<double> steps_of(const Series& sorted)
{
  std::vector<double> steps;
  for (std::size_t s = 1; s < sorted.size(); ++s)
    steps.push_back(sorted[s].position() - sorted[s - 1].position());
  return steps;
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

std::string between(const Series& sorted, std::size_t step)
{
  return sorted[step].file.filename().string() + " and " +
         sorted[step + 1].file.filename().string();
}

/// Slices that are missing: few gaps, each of about whole slices. Protocols of two slice distances
/// have many.
void require_all_slices(const Series& sorted, const std::vector<double>& steps, double usual,
                        const std::string& unreadable, const fs::path& folder)
{
  std::string gaps;
  std::size_t count = 0;
  for (std::size_t s = 0; s < steps.size(); ++s)
    if (steps[s] > 1.5 * usual)
    {
      ++count;
      if (count <= 5)
        gaps += (gaps.empty() ? "" : ", ") + number(steps[s]) + " mm between " + between(sorted, s);
    }
  constexpr double farthest_mm = 6; // a slice distance beyond which a face is not interpolated
  const double widest = *std::max_element(steps.begin(), steps.end());
  if (count == 0 || (count > steps.size() / 8 && widest <= farthest_mm))
    return;
  throw Error(folder.string(),
              "slices are missing: " + gaps + (count > 5 ? " and more" : "") + ", elsewhere " +
                  number(usual) + " mm" +
                  (unreadable.empty() ? "" : "; these files cannot be read: " + unreadable),
              "copy all slices of the series");
}

double shear_deg(const Series& sorted)
{
  const Vector way = sorted.back().origin - sorted.front().origin;
  const double along = way * sorted.front().normal();
  const Vector aside = way - sorted.front().normal() * along;
  return std::atan2(aside.GetNorm(), along) * 57.29577951308232;
}

/// What has to be mended before the slices are a lattice.
struct Mending
{
  double step_mm = 1; ///< of the lattice
  bool uneven = false, shifted = false;
};

Mending mending_of(const Series& sorted, const std::string& unreadable, const fs::path& folder,
                   std::vector<std::string>& notes)
{
  const std::vector<double> steps = steps_of(sorted);
  Mending mending;
  mending.step_mm = median(steps);
  require_all_slices(sorted, steps, mending.step_mm, unreadable, folder);
  const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
  mending.uneven = *most - *least > 0.02 * mending.step_mm;
  if (!mending.uneven)
    mending.step_mm = (sorted.back().position() - sorted.front().position()) /
                      static_cast<double>(sorted.size() - 1);
  else
    notes.push_back("Slices are unevenly spaced (" + number(*least) + " to " + number(*most) +
                    " mm, the widest between " +
                    between(sorted, static_cast<std::size_t>(most - steps.begin())) +
                    "): interpolated to " + number(mending.step_mm) + " mm.");
  const double tilt = shear_deg(sorted);
  if (tilt > 40)
    throw Error(folder.string(), "slices are shifted by " + number(tilt) + " degrees",
                "check that the series is whole and of one scan");
  mending.shifted = tilt > 0.5;
  if (mending.shifted)
    notes.push_back("Slices are shifted against one another by " + number(tilt) +
                    " degrees (tilted gantry): resampled to a rectangular lattice.");
  return mending;
}

/// Leaves one of slices at the same position that show the same; refuses those that do not.
void drop_repeats(Series& sorted, const fs::path& folder, std::vector<std::string>& notes)
{
  Series kept;
  std::string dropped;
  for (Slice& slice : sorted)
    if (kept.empty() || slice.position() - kept.back().position() > 1e-3)
      kept.push_back(std::move(slice));
    else if (same_pixels(kept.back(), slice))
      dropped += (dropped.empty() ? "" : ", ") + slice.file.filename().string();
    else
      throw Error(
          folder.string(),
          "has two different slices at one position: " + kept.back().file.filename().string() +
              " and " + slice.file.filename().string(),
          "keep one image of each slice");
  sorted = std::move(kept);
  if (!dropped.empty())
    notes.push_back("Left out repeated slices: " + dropped + ".");
}

CtImage::DirectionType direction_of(const Slice& slice)
{
  const Vector normal = slice.normal();
  CtImage::DirectionType direction;
  for (unsigned a = 0; a < 3; ++a)
  {
    direction(a, 0) = slice.across[a];
    direction(a, 1) = slice.down[a];
    direction(a, 2) = normal[a];
  }
  return direction;
}

/// Uneven or shifted slices on a lattice of their own.
CtImage::Pointer mended(const Series& sorted, const Mending& mending, CtImage::SpacingType spacing,
                        const fs::path& folder)
{
  const Slice& first = sorted.front();
  std::vector<SlicePlace> places;
  for (const Slice& slice : sorted)
  {
    const Vector aside = slice.origin - first.origin;
    places.push_back({slice.position(), aside * first.across, aside * first.down});
  }
  const int columns = static_cast<int>(first.columns), rows = static_cast<int>(first.rows);
  const StackLattice lattice =
      stack_lattice(places, mending.step_mm, columns, rows, spacing[0], spacing[1]);
  CtImage::PointType origin;
  for (unsigned a = 0; a < 3; ++a)
    origin[a] = first.origin[a] - lattice.before_across * spacing[0] * first.across[a] -
                lattice.before_down * spacing[1] * first.down[a];
  const CtImage::SizeType size{{static_cast<itk::SizeValueType>(lattice.columns),
                                static_cast<itk::SizeValueType>(lattice.rows), lattice.planes}};
  const CtImage::Pointer ct =
      make_image(size, spacing, origin, direction_of(first), folder.string());
  resample_stack(
      places, lattice, columns, rows, spacing[0], spacing[1],
      [&](std::size_t s, short* voxels) { read_slice(sorted[s], voxels); }, ct->GetBufferPointer());
  return ct;
}

CtImage::Pointer stack(const Series& sorted, const std::string& unreadable, const fs::path& folder,
                       std::vector<std::string>& notes)
{
  const Slice& first = sorted.front();
  const bool several = sorted.size() > 1;
  const Mending mending = several ? mending_of(sorted, unreadable, folder, notes) : Mending{};
  CtImage::SpacingType spacing;
  spacing[0] = first.spacing[0];
  spacing[1] = first.spacing[1];
  spacing[2] = several ? mending.step_mm : first.spacing[2];
  require_spacing(spacing.GetDataPointer(), folder.string());
  if (mending.uneven || mending.shifted)
    return mended(sorted, mending, spacing, folder);
  CtImage::PointType origin;
  for (unsigned a = 0; a < 3; ++a)
    origin[a] = first.origin[a];
  const CtImage::SizeType size{{first.columns, first.rows, several ? sorted.size() : first.frames}};
  const CtImage::Pointer ct =
      make_image(size, spacing, origin, direction_of(first), folder.string());
  for (std::size_t s = 0; s < sorted.size(); ++s)
    read_slice(sorted[s], ct->GetBufferPointer() + s * first.columns * first.rows);
  return ct;
}

} // namespace

CtImage::Pointer read_dicom_folder(const fs::path& folder, const std::string& series_name,
                                   std::vector<std::string>& notes)
{
  std::string unreadable;
  Series series = the_series(folder, series_name, unreadable, notes);
  if (series[0].modality != "CT")
    throw Error(folder.string(), "DICOM modality is '" + series[0].modality + "'",
                "give a CT; other images do not hold Hounsfield units");
  std::sort(series.begin(), series.end(),
            [](const Slice& a, const Slice& b) { return a.position() < b.position(); });
  drop_repeats(series, folder, notes);
  return stack(series, unreadable, folder, notes);
}

} // namespace f2b
