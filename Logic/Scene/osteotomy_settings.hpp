#pragma once

#include <nlohmann/json_fwd.hpp>

class vtkMRMLFaceToBoneOsteotomyNode;

/// How does an osteotomy node hold `osteotomies` of a case file?
namespace f2b
{

/// References of fragments that keep their name stay. An entry without a name bears that of its
/// template until the cut says how the fragment is called.
void osteotomies_to_node(const nlohmann::json& osteotomies, vtkMRMLFaceToBoneOsteotomyNode* node);
nlohmann::json osteotomies_from_node(vtkMRMLFaceToBoneOsteotomyNode* node);

} // namespace f2b
