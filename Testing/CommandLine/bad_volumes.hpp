#pragma once

#include <filesystem>
#include <string>

/// CTs that are none, made for the tests.
namespace f2b::test
{

struct Volume
{
  std::string type = "short"; ///< or uchar
  int size[3] = {40, 40, 40};
  std::string spacing[3] = {"5", "5", "5"}; ///< as written into the header
  int (*value)(int i, int j, int k) = nullptr;
};

/// Writes a raw .nrrd file.
void write_nrrd(const std::filesystem::path& file, const Volume& volume);
/// Writes the slices of a DICOM CT series.
void write_dicom_series(const std::filesystem::path& folder, const std::string& name,
                        const std::string& uid);

} // namespace f2b::test
