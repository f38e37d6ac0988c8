#pragma once

#include "Case/case_folder.hpp"
#include "Scene/scene_settings.hpp"

class vtkMRMLScene;

/// How do a case folder and its case.mrml agree?
namespace f2b
{

/// The text of case.mrml for what a case will hold: its earlier scene, with nodes brought up to the
/// files. No data are read. Nodes are made: call it in the thread that owns the scenes.
/// \param classes  a scene that knows the classes of our nodes and of markups
std::string case_scene_text(const CaseOutlook& files, vtkMRMLScene* classes);

/// Adds a case's nodes to a scene: those of its case.mrml, or made from its files where it has none.
/// Settings come from case.json where that was changed after case.mrml was written.
CaseNodes open_case_scene(const CaseOutlook& files, vtkMRMLScene* scene, bool read_data);

/// A new plan with its osteotomy and target.
CaseNodes add_case_nodes(vtkMRMLScene* scene, const std::string& name);

} // namespace f2b
