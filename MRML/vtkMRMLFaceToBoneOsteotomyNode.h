#ifndef __vtkMRMLFaceToBoneOsteotomyNode_h
#define __vtkMRMLFaceToBoneOsteotomyNode_h

#include "vtkSlicerFaceToBoneModuleMRMLExport.h"

#include <vtkMRMLNode.h>

struct vtkMRMLFaceToBoneFragment;
struct vtkMRMLFaceToBoneRule;
class vtkMRMLModelNode;

/// \brief The bone, where it is cut, and what each fragment may do.
///
/// An ordered list of fragments with distinct names. A fragment is cut by a template that is placed
/// from landmarks, or by planes and curves: markups that this node references, or files. Its bone at
/// rest is a referenced model that never moves. References of a fragment carry its name in their role, so that
/// fragments can come and go. Positions in RAS; lengths in mm, angles in degrees.
class VTK_SLICER_FACETOBONE_MODULE_MRML_EXPORT vtkMRMLFaceToBoneOsteotomyNode : public vtkMRMLNode
{
public:
  static vtkMRMLFaceToBoneOsteotomyNode* New();
  vtkTypeMacro(vtkMRMLFaceToBoneOsteotomyNode, vtkMRMLNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "FaceToBoneOsteotomy"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLFaceToBoneOsteotomyNode);

  /// Reference roles. Those that end in '/' are followed by the fragment's name.
  static constexpr const char* BoneRole = "bone";
  static constexpr const char* UncutBoneRole = "uncutBone";
  static constexpr const char* LandmarksRole = "landmarks";
  static constexpr const char* CutPlanesRole = "cutPlanes/";
  static constexpr const char* CutCurvesRole = "cutCurves/";
  static constexpr const char* RestFragmentRole = "restFragment/";

  vtkMRMLModelNode* GetBoneNode();
  vtkMRMLModelNode* GetUncutBoneNode();
  vtkMRMLNode* GetLandmarksNode();
  void SetBoneNodeID(const char* id);
  void SetUncutBoneNodeID(const char* id);
  void SetLandmarksNodeID(const char* id);

  int GetNumberOfFragments();
  /// The new fragment's index; -1 if the name is taken or not valid: letters, digits, spaces, '_'
  /// and '-', the first one a letter or digit, 40 at most.
  int AddFragment(const std::string& name);
  /// With its rules and references. The referenced nodes stay in the scene.
  void RemoveNthFragment(int n);
  void RemoveAllFragments();
  std::string GetNthFragmentName(int n);
  /// References follow. Whether the name could be taken.
  bool SetNthFragmentName(int n, const std::string& name);
  /// -1 if there is none.
  int GetFragmentIndex(const std::string& name);
  /// Puts the fragments in the order of their names here; others follow as they were.
  void SortFragments(const std::vector<std::string>& names);

  /// le-fort-1, le-fort-3, ...; empty: cut by planes.
  void SetNthFragmentTemplate(int n, const std::string& name);
  std::string GetNthFragmentTemplate(int n);
  /// A point on the bone that is to be free. Whether there is one.
  void SetNthFragmentPoint(int n, const double point_ras[3]);
  bool GetNthFragmentPoint(int n, double point_ras[3]);
  void RemoveNthFragmentPoint(int n);
  /// Width of bone that the saw takes.
  void SetNthFragmentKerfMm(int n, double kerf);
  double GetNthFragmentKerfMm(int n);
  /// Files of planes, where no node stands for them.
  void SetNthFragmentPlaneFileNames(int n, const std::vector<std::string>& names);
  std::vector<std::string> GetNthFragmentPlaneFileNames(int n);

  /// Planes that cut the fragment free, in order (vtkMRMLMarkupsPlaneNode).
  int GetNthFragmentNumberOfPlanes(int n);
  vtkMRMLNode* GetNthFragmentPlaneNode(int n, int plane);
  void AddNthFragmentPlaneNodeID(int n, const char* id);
  void RemoveNthFragmentPlaneNodeIDs(int n);
  /// Lines on the bone along which it is sawn, in order (vtkMRMLMarkupsCurveNode).
  int GetNthFragmentNumberOfCurves(int n);
  vtkMRMLNode* GetNthFragmentCurveNode(int n, int curve);
  void AddNthFragmentCurveNodeID(int n, const char* id);
  void RemoveNthFragmentCurveNodeIDs(int n);
  vtkMRMLModelNode* GetNthFragmentRestNode(int n);
  void SetNthFragmentRestNodeID(int n, const char* id);

  /// Coordinates of a movement: shifts of the reference point and rotations about +R, +A, +S.
  enum
  {
    Right = 0,
    Anterior,
    Superior,
    Pitch,
    Roll,
    Yaw,
    Coordinate_Last ///< not a coordinate
  };
  static const char* GetCoordinateAsString(int coordinate);
  /// -1 for a word that is none.
  static int GetCoordinateFromString(const char* coordinate);

  /// A locked coordinate stays at 0.
  void SetNthFragmentLocked(int n, int coordinate, bool locked);
  bool GetNthFragmentLocked(int n, int coordinate);
  /// [least, most] of a coordinate. Whether it is bounded.
  void SetNthFragmentBounds(int n, int coordinate, const double bounds[2]);
  bool GetNthFragmentBounds(int n, int coordinate, double bounds[2]);
  void RemoveNthFragmentBounds(int n, int coordinate);
  /// What a coordinate is expected to be, and its standard deviation. Whether anything is expected.
  void SetNthFragmentPrior(int n, int coordinate, const double expected_sd[2]);
  bool GetNthFragmentPrior(int n, int coordinate, double expected_sd[2]);
  void RemoveNthFragmentPrior(int n, int coordinate);
  /// Other rules of movement (hinge, bite), as JSON of the case file's form; empty: none.
  void SetNthFragmentOtherRules(int n, const std::string& rules);
  std::string GetNthFragmentOtherRules(int n);
  /// Settings of the fragment that have no property here, as JSON.
  void SetNthFragmentOtherSettings(int n, const std::string& settings);
  std::string GetNthFragmentOtherSettings(int n);

protected:
  vtkMRMLFaceToBoneOsteotomyNode();
  ~vtkMRMLFaceToBoneOsteotomyNode() override;
  vtkMRMLFaceToBoneOsteotomyNode(const vtkMRMLFaceToBoneOsteotomyNode&) = delete;
  void operator=(const vtkMRMLFaceToBoneOsteotomyNode&) = delete;

  /// Null, with an error, where there is none.
  vtkMRMLFaceToBoneFragment* GetNthFragment(int n);
  vtkMRMLFaceToBoneRule* GetNthRule(int n, int coordinate);
  std::string GetNthFragmentRole(int n, const char* role);
  void MoveReferences(const std::string& from, const std::string& to);

  std::vector<vtkMRMLFaceToBoneFragment> Fragments;
};

#endif
