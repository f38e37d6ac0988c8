#ifndef __vtkMRMLFaceToBonePlanNode_h
#define __vtkMRMLFaceToBonePlanNode_h

#include "vtkMRMLFaceToBoneOptionsNode.h"
#include "vtkSlicerFaceToBoneModuleMRMLExport.h"

#include <map>

struct vtkMRMLFaceToBonePlannedMovement;
class vtkMRMLFaceToBoneOsteotomyNode;
class vtkMRMLFaceToBoneTargetNode;
class vtkMRMLLinearTransformNode;
class vtkMRMLModelNode;
class vtkMRMLVolumeNode;

/// \brief One plan: what it is made from, how, what was found, and how far it has come.
///
/// State only; vtkSlicerFaceToBoneLogic does the work. Lengths in mm, angles in degrees, stiffness
/// in N/mm^3, positions in RAS. A movement is right, anterior, superior [mm], pitch, roll, yaw
/// [degrees]: x' = R (x - c) + c + t with R = Rz(yaw) Ry(roll) Rx(pitch) about the reference point c.
class VTK_SLICER_FACETOBONE_MODULE_MRML_EXPORT vtkMRMLFaceToBonePlanNode
    : public vtkMRMLFaceToBoneOptionsNode
{
public:
  static vtkMRMLFaceToBonePlanNode* New();
  vtkTypeMacro(vtkMRMLFaceToBonePlanNode, vtkMRMLFaceToBoneOptionsNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "FaceToBonePlan"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLFaceToBonePlanNode);

  enum
  {
    ProgressEvent = 21700 ///< GetProgress or GetProgressText changed; no state that is saved
  };

  // --- What it is made from and what was made, by reference role

  static constexpr const char* InputVolumeRole = "inputVolume"; ///< the CT to segment
  static constexpr const char* CaseVolumeRole = "caseVolume";   ///< the CT on the case's grid
  static constexpr const char* LabelsRole = "labels"; ///< labelmap: air, skin, fat, muscle, bone
  static constexpr const char* SkinRole = "skin";     ///< the reference skin
  static constexpr const char* BoneRole = "bone";
  static constexpr const char* MeshRole = "mesh";           ///< tissue: prisms on tetrahedra
  static constexpr const char* LandmarksRole = "landmarks"; ///< fiducials
  static constexpr const char* TargetRole = "target";       ///< vtkMRMLFaceToBoneTargetNode
  static constexpr const char* OsteotomyRole = "osteotomy"; ///< vtkMRMLFaceToBoneOsteotomyNode
  /// The face of the movement that the verb Predict was asked for, and the fragments there.
  static constexpr const char* StatedPredictionRole = "statedPrediction";
  static constexpr const char* StatedFragmentRole = "statedFragment/";

  vtkMRMLVolumeNode* GetInputVolumeNode();
  vtkMRMLModelNode* GetSkinNode();
  vtkMRMLModelNode* GetBoneNode();
  vtkMRMLModelNode* GetMeshNode();
  vtkMRMLNode* GetLandmarksNode();
  vtkMRMLFaceToBoneTargetNode* GetTargetNode();
  vtkMRMLFaceToBoneOsteotomyNode* GetOsteotomyNode();
  vtkMRMLModelNode* GetStatedPredictionNode();
  void SetInputVolumeNodeID(const char* id);
  void SetSkinNodeID(const char* id);
  void SetBoneNodeID(const char* id);
  void SetMeshNodeID(const char* id);
  void SetLandmarksNodeID(const char* id);
  void SetTargetNodeID(const char* id);
  void SetOsteotomyNodeID(const char* id);

  /// The two ways from the face to the bone.
  enum
  {
    RigidFit = 0,
    VirtualForce,
    Method_Last ///< not a method
  };
  vtkSetClampMacro(SelectedMethod, int, RigidFit, Method_Last - 1);
  vtkGetMacro(SelectedMethod, int);
  /// rigid-fit, virtual-force.
  static const char* GetSelectedMethodAsString(int method);
  static int GetSelectedMethodFromString(const char* method);

  /// Roles of a method's results: rigidFitTransform/NAME, rigidFitFragment/NAME,
  /// rigidFitPrediction; virtualForceTransform/NAME, ...
  static std::string GetTransformRole(int method, const std::string& fragment);
  static std::string GetFragmentRole(int method, const std::string& fragment);
  static std::string GetPredictionRole(int method);
  /// The movement, from the fragment at rest to where it is planned.
  vtkMRMLLinearTransformNode* GetTransformNode(int method, const std::string& fragment);
  /// The fragment at rest again, under that transform.
  vtkMRMLModelNode* GetFragmentNode(int method, const std::string& fragment);
  /// The face that the movement gives, with `signed_distance_mm` to the target.
  vtkMRMLModelNode* GetPredictionNode(int method);
  static constexpr const char* DistanceArrayName = "signed_distance_mm";
  static constexpr const char* UnreachableArrayName = "unreachable_mm";

  // --- Results

  void SetMovement(int method, const std::string& fragment, const double movement[6],
                   const double reference_ras[3]);
  bool GetMovement(int method, const std::string& fragment, double movement[6]);
  bool GetReferencePoint(int method, const std::string& fragment, double point_ras[3]);
  std::vector<std::string> GetMovementFragments(int method);
  /// 90 % interval of a coordinate of the movement (0: right ... 5: yaw).
  void SetMovementInterval(int method, const std::string& fragment, int coordinate,
                           const double interval[2]);
  bool GetMovementInterval(int method, const std::string& fragment, int coordinate,
                           double interval[2]);
  void RemoveMovements();

  /// Named numbers, such as `rigid-fit/skin_error_mm/mean` or `mesh/tets`: paths into plan.json.
  void SetFigure(const std::string& name, double value);
  /// NaN where there is none.
  double GetFigure(const std::string& name);
  std::vector<std::string> GetFigureNames();
  /// Those whose name begins so; all for an empty text.
  void RemoveFigures(const std::string& beginning);

  /// Sentences: what to be wary of, what the target asks and the cuts give, which cuts would reach.
  void SetWarnings(const std::vector<std::string>& sentences);
  std::vector<std::string> GetWarnings() { return this->Warnings; }
  void SetFindings(const std::vector<std::string>& sentences);
  std::vector<std::string> GetFindings() { return this->Findings; }
  void SetSuggestions(const std::vector<std::string>& sentences);
  std::vector<std::string> GetSuggestions() { return this->Suggestions; }
  /// With what it was made: JSON of `date` (UTC), `made` (the file that is so old), `methods`,
  /// `ct_nrrd_sha256` and `versions` by program and library.
  vtkSetMacro(Provenance, std::string);
  vtkGetMacro(Provenance, std::string);

  // --- How far it has come

  enum
  {
    Segment = 0,
    Cut,
    Mesh,
    Target,
    Suggest,
    Plan,
    Predict,
    Report,
    Step_Last ///< not a step
  };
  enum
  {
    NotDone = 0,
    Current,
    Stale, ///< what it rests on has changed since: no current result
    StepStatus_Last
  };
  static const char* GetStepAsString(int step);
  static int GetStepFromString(const char* step);
  void SetStepStatus(int step, int status);
  int GetStepStatus(int step);

  /// How the last step ended: 0 done, 1 other failure, 2 bad input, 3 numerical failure, 4 cancelled.
  vtkSetMacro(StatusCode, int);
  vtkGetMacro(StatusCode, int);
  /// One sentence for people; empty when all is well.
  vtkSetMacro(StatusText, std::string);
  vtkGetMacro(StatusText, std::string);

  /// The step that is being done, -1: none; not saved.
  vtkSetMacro(RunningStep, int);
  vtkGetMacro(RunningStep, int);
  /// Invokes ProgressEvent. \param fraction  of the step, 0 to 1
  void SetProgress(double fraction, const std::string& text);
  vtkGetMacro(Progress, double);
  vtkGetMacro(ProgressText, std::string);

protected:
  vtkMRMLFaceToBonePlanNode();
  ~vtkMRMLFaceToBonePlanNode() override;
  vtkMRMLFaceToBonePlanNode(const vtkMRMLFaceToBonePlanNode&) = delete;
  void operator=(const vtkMRMLFaceToBonePlanNode&) = delete;

  /// Null where there is none.
  vtkMRMLFaceToBonePlannedMovement* FindMovement(int method, const std::string& fragment);
  void ReadResult(const char* name, const std::string& value);
  void WriteResults(ostream& of);
  std::string GetStepStatusesAsText();
  void SetStepStatusesFromText(const std::string& text);

  int SelectedMethod = RigidFit;
  std::vector<vtkMRMLFaceToBonePlannedMovement> Movements[Method_Last];
  std::map<std::string, double> Figures;
  std::vector<std::string> Warnings, Findings, Suggestions;
  std::string Provenance;

  int StepStatus[Step_Last] = {};
  int StatusCode = 0;
  std::string StatusText;
  int RunningStep = -1;
  double Progress = 0;
  std::string ProgressText;
};

#endif
