#pragma once

#include "vtkMRML.h"

#include <string>
#include <vector>

/// How are a scene's files replaced so that a kill at any moment leaves all of the old ones or all of
/// the new ones? The stand-in's own: each file is first written under another name beside its place;
/// a journal beside the scene file then says that all are whole; then they are renamed. Who reads the
/// scene finishes a journal first.
class VTK_MRML_EXPORT vtkMRMLSavedFiles
{
public:
  /// Name beside `path`, with its extension, to write to.
  static std::string Temporary(const std::string& path);

  /// Writes the content to a file that is then whole on the disk (not only in memory).
  static bool WriteWhole(const std::string& path, const std::string& content);

  /// Renames Temporary(path) to path; true on success.
  static bool Publish(const std::string& path);

  /// Publishes a scene file and the data files written before it, all or none.
  /// Data files outside of the scene's folder come first, each by itself.
  static bool PublishAll(const std::string& sceneFile, const std::vector<std::string>& dataFiles);

  /// Finishes what a killed PublishAll of this scene file had begun.
  static void Recover(const std::string& sceneFile);
};
