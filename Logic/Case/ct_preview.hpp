#pragma once

#include "Core/geometry/scalar_grid.hpp"
#include "Core/progress.hpp"
#include "Imaging/ct_reading.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

/// What does a CT look like before anything has been found in it?
namespace f2b
{

/// All of the CT, and surfaces of equal grey value: for the eye only, nothing is computed from them.
struct CtPreview
{
  ScalarGrid hu;                           ///< the whole CT, coarser where it would be very large
  vtkSmartPointer<vtkPolyData> skin, bone; ///< [mm, RAS]; with couch and metal as they are
  std::vector<std::string> notes;          ///< what reading it mended, a sentence each
};

/// Throws Error as read_ct does.
CtPreview preview_ct(const std::filesystem::path& path, const CtReading& reading,
                     const Progress& progress);

/// Whether a path is worth reading as a CT: a volume's name, a DICOM file, a folder with one.
bool may_be_ct(const std::filesystem::path& path);

} // namespace f2b
