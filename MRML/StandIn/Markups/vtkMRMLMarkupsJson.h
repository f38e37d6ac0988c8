#pragma once

#include <nlohmann/json.hpp>

class vtkMRMLMarkupsNode;

/// How does a markup go to JSON and back, by Slicer's schema? For the storage nodes only.
using vtkMRMLMarkupsJson = nlohmann::ordered_json;

/// Sets the node from the object. Throws std::exception where the object is not as the schema says.
/// \param lps  the frame of what it says itself, where it says one
void vtkMRMLMarkupsFromJson(const vtkMRMLMarkupsJson& markup, bool& lps, vtkMRMLMarkupsNode* node);

/// Puts the node into the object, over what it holds already; members that are not known stay.
void vtkMRMLMarkupsToJson(vtkMRMLMarkupsNode* node, bool lps, vtkMRMLMarkupsJson& markup);
