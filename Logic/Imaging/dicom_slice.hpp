#pragma once

#include <itkVector.h>

#include <filesystem>
#include <optional>
#include <string>

/// What does one DICOM slice say of itself?
namespace f2b
{

struct DicomSlice
{
  // ITK's vectors, not Core's: the readers' headers bring ITK's own copy of Eigen along, and two
  // versions of Eigen do not get on in one translation unit.
  using Vector = itk::Vector<double, 3>;

  std::filesystem::path file;
  std::string series, description, modality;
  itk::SizeValueType columns = 0, rows = 0, frames = 1;
  double spacing[3] = {0, 0, 0};
  Vector origin, across, down; ///< LPS [mm]; unit vectors along a row and down a column
  Vector normal() const { return itk::CrossProduct(across, down); }
  double position() const { return origin * normal(); }
};

/// Is that file a DICOM image?
bool is_dicom(const std::filesystem::path& file);

/// Nothing where the file holds no image that can be read; an empty series where the image has no
/// place in space. Throws Error for a truncated slice and for voxels that are no Hounsfield units.
std::optional<DicomSlice> read_slice_header(const std::filesystem::path& file);

/// Fills columns x rows (x frames) voxels. Throws Error with the file's name.
void read_slice(const DicomSlice& slice, short* voxels);

/// Do two slices show the same?
bool same_pixels(const DicomSlice& a, const DicomSlice& b);

} // namespace f2b
