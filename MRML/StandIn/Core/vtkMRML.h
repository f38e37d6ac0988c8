#pragma once

/// Symbols of the library MRMLCore; in the stand-in it is static and exports nothing.
#include "vtkMRMLExport.h"

/// A version as one number that compares: 5.2.1 is 0x050201.
#define MRML_VERSION_CHECK(major, minor, patch) ((major << 16) | (minor << 8) | (patch))
