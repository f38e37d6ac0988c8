#ifndef __vtkMRMLFaceToBoneTargetNode_h
#define __vtkMRMLFaceToBoneTargetNode_h

#include "vtkMRMLFaceToBoneMovements.h"
#include "vtkSlicerFaceToBoneModuleMRMLExport.h"

#include <vtkMRMLNode.h>

class vtkMRMLModelNode;

/// \brief The face that the patient should have, and how it was made.
///
/// The target is a model with the vertices of the reference skin moved: its point arrays
/// `displacement` [mm, RAS] and `weight` (0: the vertex does not count) say where to. The settings
/// below tell how the verb Target makes it anew. Lengths in mm, angles in degrees.
class VTK_SLICER_FACETOBONE_MODULE_MRML_EXPORT vtkMRMLFaceToBoneTargetNode : public vtkMRMLNode
{
public:
  static vtkMRMLFaceToBoneTargetNode* New();
  vtkTypeMacro(vtkMRMLFaceToBoneTargetNode, vtkMRMLNode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "FaceToBoneTarget"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLFaceToBoneTargetNode);

  /// Reference roles.
  static constexpr const char* ReferenceSkinRole = "referenceSkin";
  static constexpr const char* TargetSkinRole = "targetSkin";
  static constexpr const char* ScanRole = "scan";
  static constexpr const char* WarpFromRole = "warpFrom"; ///< fiducials on the face
  static constexpr const char* WarpToRole = "warpTo";     ///< where they should go, same labels

  /// Point arrays of the target skin.
  static constexpr const char* DisplacementArrayName = "displacement";
  static constexpr const char* WeightArrayName = "weight";

  vtkMRMLModelNode* GetReferenceSkinNode();
  vtkMRMLModelNode* GetTargetSkinNode();
  vtkMRMLModelNode* GetScanNode();
  void SetReferenceSkinNodeID(const char* id);
  void SetTargetSkinNodeID(const char* id);
  void SetScanNodeID(const char* id);

  enum
  {
    Mesh = 0, ///< the reference skin with moved vertices: sculpted here or in another program
    Scan,     ///< a surface of any vertices that the face is to lie on
    Warp,     ///< points and where they should go
    Movement, ///< the face of a stated movement, for self-tests
    Kind_Last ///< not a kind
  };
  vtkSetClampMacro(Kind, int, Mesh, Kind_Last - 1);
  vtkGetMacro(Kind, int);
  static const char* GetKindAsString(int kind);
  /// -1 for a word that is none.
  static int GetKindFromString(const char* kind);

  /// Where the target comes from when it is made anew; empty: from the referenced nodes.
  vtkSetMacro(MeshFileName, std::string);
  vtkGetMacro(MeshFileName, std::string);
  vtkSetMacro(ScanFileName, std::string);
  vtkGetMacro(ScanFileName, std::string);
  vtkSetMacro(WarpFromFileName, std::string);
  vtkGetMacro(WarpFromFileName, std::string);
  vtkSetMacro(WarpToFileName, std::string);
  vtkGetMacro(WarpToFileName, std::string);

  /// Skin farther from the scan than this does not count.
  vtkSetMacro(ScanReachMm, double);
  vtkGetMacro(ScanReachMm, double);
  /// No effect farther than this from every point of the warp.
  vtkSetMacro(WarpRadiusMm, double);
  vtkGetMacro(WarpRadiusMm, double);
  /// The target counts where it moves the skin by more than this; 0: everywhere.
  vtkSetMacro(MaskMm, double);
  vtkGetMacro(MaskMm, double);

  /// The movement of kind Movement: right, anterior, superior [mm], pitch, roll, yaw [degrees].
  void SetMovement(const std::string& fragment, const double movement[6]);
  bool GetMovement(const std::string& fragment, double movement[6]);
  std::vector<std::string> GetMovementFragments();
  void RemoveMovements();

  /// Result: the longest displacement that counts.
  vtkSetMacro(PeakDisplacementMm, double);
  vtkGetMacro(PeakDisplacementMm, double);

  /// Settings of the case's target that have no property here, as JSON.
  vtkSetMacro(OtherSettings, std::string);
  vtkGetMacro(OtherSettings, std::string);

protected:
  vtkMRMLFaceToBoneTargetNode();
  ~vtkMRMLFaceToBoneTargetNode() override = default;
  vtkMRMLFaceToBoneTargetNode(const vtkMRMLFaceToBoneTargetNode&) = delete;
  void operator=(const vtkMRMLFaceToBoneTargetNode&) = delete;

  int Kind = Warp;
  std::string MeshFileName, ScanFileName, WarpFromFileName, WarpToFileName, OtherSettings;
  double ScanReachMm = 30, WarpRadiusMm = 45, MaskMm = 0, PeakDisplacementMm = 0;
  vtkMRMLFaceToBoneMovements Movements;
};

#endif
