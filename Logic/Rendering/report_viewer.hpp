#pragma once

#include <Rendering/html_report.hpp>
#include <Rendering/plan_scene.hpp>
#include <Rendering/texts.hpp>

/// What does the interactive page of a report show? The face before, target and predicted, the bones
/// on their way, the distance map; small enough to be in the report's own file.
///
/// Surfaces are decimated to `ViewerLimits` and told as 16-bit positions (0.01 mm and better), so
/// the page is for looking, not for measuring.
namespace f2b
{

struct ViewerLimits
{
  int skin_triangles = 70000;
  int bone_triangles = 60000; ///< of bone that stays; of all fragments, too
};

/// \param library  text of three.js (r110 or later, the script that defines THREE)
/// \param script   text of the page's own script, Resources/viewer/viewer.js
ViewerParts report_viewer(const PlanScene& scene, const Texts& texts, const std::string& library,
                          const std::string& script, const ViewerLimits& limits = {});

/// A surface of at most so many triangles whose vertices are some of the given ones; `origins` are
/// their indices in it.
Surface decimated(const Surface& surface, int triangles, std::vector<vtkIdType>& origins);

} // namespace f2b
