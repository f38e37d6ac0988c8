#pragma once

#include <filesystem>

/// Which kind of image does a file's name promise?
namespace f2b
{

enum class VolumeFormat
{
  None,      ///< no image by its name
  Nrrd,      ///< .nrrd, .nhdr
  MetaImage, ///< .mha, .mhd
  Nifti,     ///< .nii, .nii.gz
  Dicom,     ///< .dcm; DICOM files often have no ending at all
};

/// By the name's ending, in capitals or not; the file need not exist.
VolumeFormat volume_format(const std::filesystem::path& path);

} // namespace f2b
