#pragma once

#include "Case/case_folder.hpp"

class vtkMRMLFaceToBonePlanNode;

/// Which numbers and sentences of a case does the plan node show?
namespace f2b
{

/// Movements, intervals, figures, warnings and findings of plan.json, mesh.json, segment.json and
/// suggest.json, and with what they were made; what a file that is no more said is forgotten.
void read_results(const CaseOutlook& files, vtkMRMLFaceToBonePlanNode* plan);

/// Current where the step's results are there.
void set_step_statuses(const CaseOutlook& files, vtkMRMLFaceToBonePlanNode* plan);

} // namespace f2b
