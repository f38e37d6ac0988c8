#pragma once

#include "Case/case_folder.hpp"
#include "Scene/scene_settings.hpp"

class vtkMRMLScene;

/// Which nodes show what a case folder holds?
namespace f2b
{

/// Brings a scene up to what a case's files say.
///
/// Nodes that are there already keep their ids and what a user changed on them (names, colours,
/// opacity); nodes of files that are no more are removed, so that no stale result is shown. Storage
/// nodes point at the case's own files.
/// \param nodes      of `scene`
/// \param read_data  else the nodes name their files, and whoever opens the scene reads them
void publish_case(const CaseOutlook& files, vtkMRMLScene* scene, const CaseNodes& nodes,
                  bool read_data);

/// The attribute of a published node that names its file in the case.
inline constexpr const char* published_file_attribute = "FaceToBone.File";
/// Which state of its file a node's data were read from; absent where they were not.
inline constexpr const char* published_time_attribute = "FaceToBone.FileTime";

} // namespace f2b
