#pragma once

#include "Imaging/ct_image.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Which CT volume do the DICOM slices of a folder make up?
namespace f2b
{

/// Reads the one series of at least 16 slices that the folder holds.
/// \param notes  gets a sentence for each smaller series that was left out, such as a localiser
/// \throws Error  no DICOM, several series, another modality, missing or repeated slices, a
/// truncated
///                slice, a tilted gantry
CtImage::Pointer read_dicom_folder(const std::filesystem::path& folder,
                                   std::vector<std::string>& notes);

/// Is that file a DICOM image?
bool is_dicom(const std::filesystem::path& file);

} // namespace f2b
