#pragma once

#include "vtkMRML.h"

#include <vtkObject.h>

#include <string>
#include <vector>

/// Zip files, through libarchive.
class VTK_MRML_EXPORT vtkArchive : public vtkObject
{
public:
  static vtkArchive* New();
  vtkTypeMacro(vtkArchive, vtkObject);
  /// Packs the folder; names in the archive begin with the folder's own. The file is replaced whole.
  static bool Zip(const char* zipFileName, const char* directoryToZip);
  /// Unpacks below the folder. False, and nothing outside of it touched, where a name is absolute or
  /// has "..", where an entry is neither file nor folder, or where the archive is damaged.
  static bool UnZip(const char* zipFileName, const char* destinationDirectory);
  static bool ListArchive(const char* archiveName, std::vector<std::string>& files);

protected:
  vtkArchive() = default;
  ~vtkArchive() override = default;
  vtkArchive(const vtkArchive&) = delete;
  void operator=(const vtkArchive&) = delete;
};
