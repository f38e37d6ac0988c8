#pragma once

#include <string>

/// What must be said besides a CT's path to read it?
namespace f2b
{

struct CtReading
{
  std::string series; ///< of a DICOM folder with several (dicom_series.hpp)
  /// The grey values are not Hounsfield units (cone-beam CT): shift and scale them so that air is
  /// -1000 and soft tissue 40 HU (grey_values.hpp).
  bool shifted_grey_values = false;
};

} // namespace f2b
