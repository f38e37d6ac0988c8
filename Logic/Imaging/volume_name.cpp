#include "Imaging/volume_name.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace f2b
{

VolumeFormat volume_format(const std::filesystem::path& path)
{
  static constexpr std::pair<const char*, VolumeFormat> endings[] = {
      {".nrrd", VolumeFormat::Nrrd},     {".nhdr", VolumeFormat::Nrrd},
      {".mha", VolumeFormat::MetaImage}, {".mhd", VolumeFormat::MetaImage},
      {".nii", VolumeFormat::Nifti},     {".nii.gz", VolumeFormat::Nifti},
      {".dcm", VolumeFormat::Dicom}};
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [ending, format] : endings)
  {
    const std::string end = ending;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
      return format;
  }
  return VolumeFormat::None;
}

} // namespace f2b
