#pragma once

#include <nlohmann/json_fwd.hpp>

class vtkMRMLFaceToBoneOsteotomyNode;
class vtkMRMLFaceToBonePlanNode;
class vtkMRMLFaceToBoneTargetNode;

/// How do a case file and nodes say the same? Keys and units: Resources/Schema/case.schema.json.
///
/// The plan node holds the options, the osteotomy node cuts and rules of movement, the target node
/// how the target is made. What has no property is kept as JSON in `OtherSettings`, so that no
/// setting is lost on the way there and back; settings at their default may be left out.
namespace f2b
{

/// The nodes of one case.
struct CaseNodes
{
  vtkMRMLFaceToBonePlanNode* plan = nullptr;
  vtkMRMLFaceToBoneOsteotomyNode* osteotomy = nullptr;
  vtkMRMLFaceToBoneTargetNode* target = nullptr;

  /// What a plan references; throws Error where it names no target or no osteotomy.
  static CaseNodes of(vtkMRMLFaceToBonePlanNode* plan);
};

/// \param document  as a case file or case.json, valid by its schema
void settings_to_nodes(nlohmann::json document, const CaseNodes& nodes);

/// The nodes' case document; whether it is complete and valid, its reader says.
nlohmann::json settings_from_nodes(const CaseNodes& nodes);

/// The same settings without those at their default.
nlohmann::json canonical_settings(const nlohmann::json& document);
/// Whether two documents ask for the same, defaults stated or not.
bool same_settings(const nlohmann::json& a, const nlohmann::json& b);

} // namespace f2b
