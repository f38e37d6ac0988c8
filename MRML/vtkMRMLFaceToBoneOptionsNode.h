#ifndef __vtkMRMLFaceToBoneOptionsNode_h
#define __vtkMRMLFaceToBoneOptionsNode_h

#include "vtkMRMLFaceToBoneMovements.h"
#include "vtkMRMLFaceToBoneOptional.h"
#include "vtkSlicerFaceToBoneModuleMRMLExport.h"

#include <vtkMRMLNode.h>

/// \brief How a plan is made: every setting of a case but its cuts and its target.
///
/// What a plan node is asked for; vtkMRMLFaceToBonePlanNode adds what it is made from and what was
/// found. Defaults are those of the case file. Lengths in mm, angles in degrees, stiffness in
/// N/mm^3, positions in RAS.
class VTK_SLICER_FACETOBONE_MODULE_MRML_EXPORT vtkMRMLFaceToBoneOptionsNode : public vtkMRMLNode
{
public:
  vtkAbstractTypeMacro(vtkMRMLFaceToBoneOptionsNode, vtkMRMLNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void UpdateScene(vtkMRMLScene* scene) override;
  vtkMRMLCopyContentMacro(vtkMRMLFaceToBoneOptionsNode);

  /// Folder of standard files that the plan lives in. A scene file names it relative to its own.
  vtkSetMacro(CaseFolder, std::string);
  vtkGetMacro(CaseFolder, std::string);
  vtkSetMacro(CaseName, std::string);
  vtkGetMacro(CaseName, std::string);
  /// CT (file or DICOM folder) and landmarks to segment from; empty: the referenced nodes.
  vtkSetMacro(VolumeFileName, std::string);
  vtkGetMacro(VolumeFileName, std::string);
  vtkSetMacro(LandmarksFileName, std::string);
  vtkGetMacro(LandmarksFileName, std::string);

  /// Found from the histogram where they are not set.
  void SetSkinThresholdHU(double hu);
  bool GetSkinThresholdHU(double hu[1]);
  void RemoveSkinThresholdHU();
  void SetBoneThresholdHU(double hu);
  bool GetBoneThresholdHU(double hu[1]);
  void RemoveBoneThresholdHU();
  /// Box of the face that is meshed: least R, A, S, then most; the front of the head where not set.
  void SetRegion(const double region_ras[6]);
  bool GetRegion(double region_ras[6]);
  void RemoveRegion();

  vtkSetMacro(SpacingMm, double); ///< of the grid that CT, masks and distances are put on
  vtkGetMacro(SpacingMm, double);
  vtkSetMacro(HeadClosingMm, double);
  vtkGetMacro(HeadClosingMm, double);
  vtkSetMacro(BoneClosingMm, double);
  vtkGetMacro(BoneClosingMm, double);
  vtkSetMacro(SkinThicknessMm, double);
  vtkGetMacro(SkinThicknessMm, double);
  /// table1-stable, table1, nazari-2011, or a file.
  vtkSetMacro(Materials, std::string);
  vtkGetMacro(Materials, std::string);
  vtkSetMacro(MeshDensity, double); ///< elements relative to the default
  vtkGetMacro(MeshDensity, double);
  vtkSetMacro(ReleaseMarginMm, double);
  vtkGetMacro(ReleaseMarginMm, double);
  vtkSetMacro(ContactToleranceMm, double);
  vtkGetMacro(ContactToleranceMm, double);
  vtkSetMacro(Threads, int); ///< 0: all cores
  vtkGetMacro(Threads, int);
  vtkSetMacro(MaxNewtonIterations, int);
  vtkGetMacro(MaxNewtonIterations, int);
  vtkSetMacro(StepToleranceMm, double);
  vtkGetMacro(StepToleranceMm, double);
  vtkSetMacro(MaxFitIterations, int);
  vtkGetMacro(MaxFitIterations, int);
  /// lfem, mtm, nfem or nfm-em.
  vtkSetMacro(PredictModel, std::string);
  vtkGetMacro(PredictModel, std::string);

  /// Also plan the best two suggestions fully; the density of the mesh they are computed on, 0: the
  /// case's own, but 0.3 at most.
  vtkSetMacro(SuggestConfirm, bool);
  vtkGetMacro(SuggestConfirm, bool);
  vtkBooleanMacro(SuggestConfirm, bool);
  vtkSetMacro(SuggestDensity, double);
  vtkGetMacro(SuggestDensity, double);

  /// A translation of the report's texts, empty: English; whether it tells where the scan lies.
  vtkSetMacro(ReportTextsFileName, std::string);
  vtkGetMacro(ReportTextsFileName, std::string);
  vtkSetMacro(ReportIdentity, bool);
  vtkGetMacro(ReportIdentity, bool);
  vtkBooleanMacro(ReportIdentity, bool);

  /// The paper's method: K_e, or as stiff as the residual needs.
  vtkSetMacro(ForceStiffness, double);
  vtkGetMacro(ForceStiffness, double);
  vtkSetMacro(ForceStiffnessAutomatic, bool);
  vtkGetMacro(ForceStiffnessAutomatic, bool);
  vtkBooleanMacro(ForceStiffnessAutomatic, bool);
  vtkSetMacro(ForceResidualMm, double);
  vtkGetMacro(ForceResidualMm, double);
  vtkSetMacro(ForceRestLengthMm, double);
  vtkGetMacro(ForceRestLengthMm, double);
  vtkSetMacro(ForceLoad, std::string); ///< following, dead
  vtkGetMacro(ForceLoad, std::string);
  void SetForceLandmarks(const std::vector<std::string>& names); ///< to register by
  std::vector<std::string> GetForceLandmarks() { return this->ForceLandmarks; }

  /// What Predict is asked for; the plan's movement where there is none.
  void SetStatedMovement(const std::string& fragment, const double movement[6]);
  bool GetStatedMovement(const std::string& fragment, double movement[6]);
  std::vector<std::string> GetStatedMovementFragments();
  void RemoveStatedMovements();

  /// Settings of the case that have no property here, as JSON.
  vtkSetMacro(OtherSettings, std::string);
  vtkGetMacro(OtherSettings, std::string);

protected:
  vtkMRMLFaceToBoneOptionsNode();
  ~vtkMRMLFaceToBoneOptionsNode() override;
  vtkMRMLFaceToBoneOptionsNode(const vtkMRMLFaceToBoneOptionsNode&) = delete;
  void operator=(const vtkMRMLFaceToBoneOptionsNode&) = delete;

  void ReadNumbersAndLists(const char* name, const std::string& value);
  void WriteOptions(ostream& of);
  void WriteNumbersAndLists(ostream& of);
  std::string GetCaseFolderInScene();

  std::string CaseFolder, CaseName, VolumeFileName, LandmarksFileName;
  vtkMRMLFaceToBoneOptional<1> SkinThresholdHU, BoneThresholdHU;
  vtkMRMLFaceToBoneOptional<6> Region;
  double SpacingMm = 1, HeadClosingMm = 5, BoneClosingMm = 8, SkinThicknessMm = 1.5;
  std::string Materials = "table1-stable";
  double MeshDensity = 1, ReleaseMarginMm = 5, ContactToleranceMm = 2;
  int Threads = 0, MaxNewtonIterations = 25, MaxFitIterations = 40;
  double StepToleranceMm = 1e-8;
  std::string PredictModel = "nfm-em";
  bool SuggestConfirm = false;
  double SuggestDensity = 0;
  std::string ReportTextsFileName;
  bool ReportIdentity = false;
  double ForceStiffness = 0.02, ForceResidualMm = 0.5, ForceRestLengthMm = 0;
  bool ForceStiffnessAutomatic = false;
  std::string ForceLoad = "following";
  std::vector<std::string> ForceLandmarks;
  vtkMRMLFaceToBoneMovements StatedMovements;
  std::string OtherSettings;
};

#endif
