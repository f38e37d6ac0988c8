#pragma once

#include "vtkMRMLDisplayableNode.h"

#include <vtkAlgorithmOutput.h>

class vtkAlgorithm;
class vtkEventForwarderCommand;
class vtkImageData;
class vtkMRMLVolumeDisplayNode;

/// Voxels, and the matrix that takes their indices IJK to RAS [mm]. The image itself has unit spacing
/// and zero origin.
class VTK_MRML_EXPORT vtkMRMLVolumeNode : public vtkMRMLDisplayableNode
{
public:
  vtkTypeMacro(vtkMRMLVolumeNode, vtkMRMLDisplayableNode);
  vtkMRMLNode* CreateNodeInstance() override = 0;
  const char* GetNodeTagName() override = 0;
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  vtkMRMLCopyContentMacro(vtkMRMLVolumeNode);
  void ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData) override;

  enum
  {
    ImageDataModifiedEvent = 18001
  };
  virtual void SetAndObserveImageData(vtkImageData* ImageData);
  virtual vtkImageData* GetImageData();
  virtual void SetImageDataConnection(vtkAlgorithmOutput* inputPort);
  vtkAlgorithmOutput* GetImageDataConnection() { return this->ImageDataConnection; }
  virtual vtkMRMLVolumeDisplayNode* GetVolumeDisplayNode();

  /// \name Geometry; the columns of the directions are those of I, J and K
  ///@{
  void CopyOrientation(vtkMRMLVolumeNode* node);
  void SetIJKToRASDirections(double dirs[3][3]);
  void GetIJKToRASDirections(double dirs[3][3]);
  vtkGetVector3Macro(Spacing, double);
  virtual void SetSpacing(double arg1, double arg2, double arg3);
  virtual void SetSpacing(double arg[3]);
  vtkGetVector3Macro(Origin, double);
  virtual void SetOrigin(double arg1, double arg2, double arg3);
  virtual void SetOrigin(double arg[3]);
  void GetIJKToRASMatrix(vtkMatrix4x4* mat);
  void GetRASToIJKMatrix(vtkMatrix4x4* mat);
  void SetIJKToRASMatrix(vtkMatrix4x4* mat);
  void SetRASToIJKMatrix(vtkMatrix4x4* mat);
  void GetIJKToRASDirectionMatrix(vtkMatrix4x4* mat);
  void SetIJKToRASDirectionMatrix(vtkMatrix4x4* mat);
  void GetRASBounds(double bounds[6]) override;
  void GetBounds(double bounds[6]) override;
  void ApplyTransformMatrix(vtkMatrix4x4* transformMatrix) override;
  ///@}
  bool GetModifiedSinceRead() override;

protected:
  vtkMRMLVolumeNode() = default;
  ~vtkMRMLVolumeNode() override;
  vtkMRMLVolumeNode(const vtkMRMLVolumeNode&) = delete;
  void operator=(const vtkMRMLVolumeNode&) = delete;

  double IJKToRASDirections[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  double Spacing[3] = {1.0, 1.0, 1.0};
  double Origin[3] = {0.0, 0.0, 0.0};

private:
  void StopForwarding();
  void BoundsThrough(vtkAbstractTransform* rasTransform, double bounds[6]);

  vtkSmartPointer<vtkAlgorithm> ImageProducer; ///< observed, and held for its output
  vtkSmartPointer<vtkAlgorithmOutput> ImageDataConnection;
  vtkSmartPointer<vtkImageData> ForwardedImage;
  vtkSmartPointer<vtkEventForwarderCommand> DataEventForwarder;
};
