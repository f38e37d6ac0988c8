#include "Case/ct_preview.hpp"

#include "Imaging/read_ct.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/volume_name.hpp"
#include "Meshing/isosurface.hpp"

#include <array>
#include <cmath>
#include <fstream>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

constexpr double skin_hu = -250, bone_hu = 250;
constexpr double most_slice_voxels = 3e7, most_surface_voxels = 4e6;

/// A lattice over the whole CT with no more samples than that.
Lattice whole_ct(const CtImage& ct, double finest_mm, double most)
{
  const Box box = extent_ras(ct);
  const double volume = (box.max - box.min).cwiseMax(1.0).prod();
  const double spacing = std::max(finest_mm, std::cbrt(volume / most));
  return lattice_over(box, spacing, anchor_ras(ct));
}

/// \param inside_above  [HU]
vtkSmartPointer<vtkPolyData> isosurface(ScalarGrid grid, double inside_above, bool largest)
{
  for (float& value : grid.values) // inside is below the level
    value = -value;
  SurfaceOptions options;
  options.largest_component = largest;
  return watertight_isosurface(grid, -inside_above, options);
}

bool is_dicom_file(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> magic{};
  file.seekg(128);
  file.read(magic.data(), magic.size());
  return file && std::string(magic.data(), magic.size()) == "DICM";
}

} // namespace

CtPreview preview_ct(const fs::path& path, const CtReading& reading, const Progress& progress)
{
  CtPreview preview;
  progress("reading the CT", 0);
  const CtImage::Pointer ct = read_ct(path, &preview.notes, reading);
  progress("making slices", 0.5);
  preview.hu = resample_ct(*ct, whole_ct(*ct, 1, most_slice_voxels));
  progress("making surfaces for the eye", 0.7);
  const ScalarGrid coarse = resample_ct(*ct, whole_ct(*ct, 2, most_surface_voxels));
  preview.skin = isosurface(coarse, skin_hu, true);
  progress("making surfaces for the eye", 0.85);
  preview.bone = isosurface(coarse, bone_hu, false);
  progress("read", 1);
  return preview;
}

bool may_be_ct(const fs::path& path)
{
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(path, ignored))
      if (entry.is_regular_file(ignored) && is_dicom_file(entry.path()))
        return true;
    return false;
  }
  return volume_format(path) != VolumeFormat::None || is_dicom_file(path);
}

} // namespace f2b
