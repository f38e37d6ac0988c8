#pragma once

#include "node_test.hpp"

/// Nodes of which every property differs from its default, with numbers that six digits lose.
namespace f2b::test
{

inline void fill(vtkMRMLFaceToBoneTargetNode* target)
{
  target->SetKind(vtkMRMLFaceToBoneTargetNode::Movement);
  target->SetMeshFileName("a b/ü.vtp");
  target->SetScanFileName("scan \"quoted\" & <odd>.stl");
  target->SetWarpFromFileName("from.mrk.json");
  target->SetWarpToFileName("to.mrk.json");
  target->SetScanReachMm(1.0 / 3);
  target->SetWarpRadiusMm(123.45678901234567);
  target->SetMaskMm(0.1);
  target->SetPeakDisplacementMm(11.000000000000002);
  target->SetOtherSettings(R"({"key":"a;b%25 'c'"})");
  const double movement[6] = {2, 11.123456789012345, -5, 5, 2.5, 1e-9};
  target->SetMovement("mid-face", movement);
}

inline void fill(vtkMRMLFaceToBoneOsteotomyNode* osteotomy)
{
  osteotomy->AddFragment("mid-face");
  osteotomy->AddFragment("Chin 2_b");
  osteotomy->SetNthFragmentTemplate(0, "le-fort-3");
  osteotomy->SetNthFragmentKerfMm(1, 0.70000000000000007);
  const double point[3] = {1.0 / 3, -2e-7, 12345.678901234567};
  osteotomy->SetNthFragmentPoint(1, point);
  osteotomy->SetNthFragmentPlaneFileNames(1, {"a;b.mrk.json", "c=%d.mrk.json"});
  osteotomy->SetNthFragmentLocked(0, vtkMRMLFaceToBoneOsteotomyNode::Roll, true);
  const double bounds[2] = {0, 8.1}, prior[2] = {-0.1, 1.0 / 7};
  osteotomy->SetNthFragmentBounds(0, vtkMRMLFaceToBoneOsteotomyNode::Anterior, bounds);
  osteotomy->SetNthFragmentPrior(1, vtkMRMLFaceToBoneOsteotomyNode::Superior, prior);
  osteotomy->SetNthFragmentOtherRules(1, R"({"hinge":{"axis":["Co_R","Co_L"]}})");
  osteotomy->SetNthFragmentOtherSettings(0, R"({"later":1})");
}

inline void fill_options(vtkMRMLFaceToBonePlanNode* plan)
{
  plan->SetSelectedMethod(vtkMRMLFaceToBonePlanNode::VirtualForce);
  plan->SetCaseFolder("/some where/cäse");
  plan->SetCaseName("Case \"1\" <&>");
  plan->SetVolumeFileName("ct.nrrd");
  plan->SetLandmarksFileName("landmarks.mrk.json");
  plan->SetSkinThresholdHU(-251.12345678901234);
  plan->SetBoneThresholdHU(250.1);
  const double region[6] = {-76.1, -10, -134, 76, 115, 50.000000000000007};
  plan->SetRegion(region);
  plan->SetSpacingMm(1.1);
  plan->SetHeadClosingMm(4.9);
  plan->SetBoneClosingMm(7.9);
  plan->SetSkinThicknessMm(1.6000000000000001);
  plan->SetMaterials("own.json");
  plan->SetMeshDensity(0.15);
  plan->SetReleaseMarginMm(5.5);
  plan->SetContactToleranceMm(2.2);
  plan->SetThreads(2);
  plan->SetMaxNewtonIterations(26);
  plan->SetStepToleranceMm(1.2345678901234567e-9);
  plan->SetMaxFitIterations(41);
  plan->SetPredictModel("lfem");
  plan->SetSuggestConfirm(true);
  plan->SetSuggestDensity(0.1);
  plan->SetReportTextsFileName("de.json");
  plan->SetReportIdentity(true);
  plan->SetForceStiffness(0.030000000000000002);
  plan->SetForceStiffnessAutomatic(true);
  plan->SetForceResidualMm(0.6);
  plan->SetForceRestLengthMm(0.1);
  plan->SetForceLoad("dead");
  plan->SetForceLandmarks({"A", "B;", "C%"});
  plan->SetOtherSettings(R"({"notes":"line 1\nline 2"})");
  const double movement[6] = {1, 2, 3, 4, 5, 6.1};
  plan->SetStatedMovement("mid-face", movement);
}

inline void fill_results(vtkMRMLFaceToBonePlanNode* plan)
{
  const double movement[6] = {2.0000000000000004, 11, -5, 5, 2.5, 0},
               reference[3] = {1, 2, 1.0 / 3};
  const double interval[2] = {-0.3, 0.30000000000000004};
  for (int method = 0; method < vtkMRMLFaceToBonePlanNode::Method_Last; ++method)
  {
    plan->SetMovement(method, "mid-face", movement, reference);
    plan->SetMovement(method, "Chin 2_b", movement, reference);
    plan->SetMovementInterval(method, "mid-face", 1, interval);
  }
  plan->SetFigure("rigid-fit/skin_error_mm/mean", 0.41000000000000003);
  plan->SetFigure("mesh/tets", 110000);
  plan->SetWarnings({"one; with 100 %", "two"});
  plan->SetFindings({"the target asks for more"});
  plan->SetSuggestions({"le-fort-3: 93 %"});
  plan->SetProvenance("FaceToBone 0.1.0");
  plan->SetStepStatus(vtkMRMLFaceToBonePlanNode::Segment, vtkMRMLFaceToBonePlanNode::Current);
  plan->SetStepStatus(vtkMRMLFaceToBonePlanNode::Plan, vtkMRMLFaceToBonePlanNode::Stale);
  plan->SetStatusCode(2);
  plan->SetStatusText("mesh.density: 9 is too much; 8 at most");
}

inline void fill(vtkMRMLFaceToBonePlanNode* plan)
{
  fill_options(plan);
  fill_results(plan);
}

} // namespace f2b::test
