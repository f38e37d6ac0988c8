#pragma once

#include "Bridge/markups.hpp"
#include "Case/case_folder.hpp"
#include "Core/geometry/osteotomy.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>

class vtkMRMLFaceToBoneOsteotomyNode;
class vtkMRMLStorableNode;

/// Which cuts do the markups of an osteotomy node show?
namespace f2b
{

struct ShownCurve
{
  std::string name;
  PointMarkup markup;
};

/// One fragment's, in the order of its references.
struct ShownCuts
{
  std::vector<BoundedPlane> planes;
  std::vector<ShownCurve> curves; ///< of different names

  bool empty() const { return planes.empty() && curves.empty(); }
};

/// \param scratch  names a file for the nodes' storage to write to, where one is needed
ShownCuts shown_cuts(vtkMRMLFaceToBoneOsteotomyNode* osteotomy, int n,
                     const std::function<Path()>& scratch);

/// Whether the bone was cut so.
bool same_cuts(const ShownCuts& cuts, const Osteotomy& placed);

/// `curves` of the fragment in a case file, with the files that the verb cut writes.
/// \param stated  what it says now: how a curve is sawn stays as it is
/// \param placed  where the bone was cut so far, null if it was not
nlohmann::json curve_settings(const ShownCuts& cuts, const std::string& fragment,
                              const nlohmann::json& stated, const Osteotomy* placed);

/// Whether a node may say something else than its file: a published one whose data were not read
/// does not.
bool holds_data(vtkMRMLStorableNode* node);
/// Writes a node's data with its own storage. Throws Error where that fails.
void write_node(vtkMRMLStorableNode* node, const Path& file);

/// Closer than this [mm] two places are the same: files keep fewer digits than memory.
inline constexpr double same_place_mm = 1e-4;

} // namespace f2b
