#pragma once

#include "temporary_folder.hpp"

#include <vtkSlicerFaceToBoneLogic.h>

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkMRMLScene.h>

#include <vtkNew.h>

#include <nlohmann/json.hpp>

/// The virtual patient, coarse, in a scene with the module's logic.
namespace f2b::test
{

/// A case file in a folder, of a sample that is made there as well.
std::filesystem::path write_coarse_case(const std::filesystem::path& folder);

/// The smallest document that the schema allows.
nlohmann::json smallest_case();

struct LogicScene
{
  LogicScene() { logic->SetMRMLScene(scene); }
  ~LogicScene() { logic->SetMRMLScene(nullptr); }
  LogicScene(const LogicScene&) = delete;
  LogicScene& operator=(const LogicScene&) = delete;

  vtkNew<vtkMRMLScene> scene;
  vtkNew<vtkSlicerFaceToBoneLogic> logic;
};

} // namespace f2b::test
