#pragma once

#include <filesystem>

/// Does a volume file hold what its own header promises?
///
/// ITK 5.2 reads a truncated MetaImage or NIfTI file without complaint and takes zero or NaN
/// spacings of NRRD and NIfTI for 1 mm; these checks read the header's own text and count the
/// bytes.
namespace f2b
{

/// \throws Error  spacing that is not positive, or fewer bytes than the header says
void check_nrrd(const std::filesystem::path& path);
void check_meta_image(const std::filesystem::path& path);
void check_nifti(const std::filesystem::path& path);

} // namespace f2b
