#pragma once

#include "Imaging/ct_image.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Which CT volume do the DICOM slices of a folder make up?
namespace f2b
{

/// Reads the one series of at least 16 slices that the folder holds, or the named one.
///
/// Unevenly spaced and shifted slices (tilted gantry) are resampled to a rectangular lattice; a slice
/// that is there twice is taken once.
/// \param series_name  number in the list that an error gives, UID, or part of the description;
///                     empty: there must be one
/// \param notes  gets a sentence for whatever was mended or left out, such as a localiser
/// \throws Error  no DICOM, several series, another modality, missing slices, different slices at one
///                place, corrupt or truncated slices; with the files' names
CtImage::Pointer read_dicom_folder(const std::filesystem::path& folder,
                                   const std::string& series_name, std::vector<std::string>& notes);

} // namespace f2b
