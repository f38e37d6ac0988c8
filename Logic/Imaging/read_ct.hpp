#pragma once

#include "Imaging/ct_image.hpp"
#include "Imaging/ct_reading.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Which CT does a file or folder hold?
namespace f2b
{

/// Reads a DICOM folder, a NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd) or NIfTI (.nii, .nii.gz)
/// file.
///
/// Voxels are Hounsfield units, rounded to whole ones. A path to one DICOM file means its folder.
/// \param notes  gets what was left out or mended, a sentence each, if not null
/// \throws Error  whatever is wrong with it, in one line with the file's name, the value and a
/// remedy
CtImage::Pointer read_ct(const std::filesystem::path& path,
                         std::vector<std::string>* notes = nullptr, const CtReading& reading = {});

/// The folder whose DICOM files read_ct takes for this path; empty where it takes the file alone.
std::filesystem::path dicom_folder_of(const std::filesystem::path& path);

} // namespace f2b
