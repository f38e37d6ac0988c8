#include "vtkMRMLVolumeNode.h"

#include "vtkMRMLTransformNode.h"
#include "vtkMRMLVolumeDisplayNode.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkEventForwarderCommand.h>
#include <vtkGeneralTransform.h>
#include <vtkImageData.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <cmath>

vtkMRMLVolumeNode::~vtkMRMLVolumeNode()
{
  this->StopForwarding();
  if (this->ImageProducer)
  {
    this->ImageProducer->RemoveObserver(this->MRMLCallbackCommand);
  }
}

void vtkMRMLVolumeNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLVectorMacro(spacing, Spacing, double, 3);
  vtkMRMLWriteXMLVectorMacro(origin, Origin, double, 3);
  vtkMRMLWriteXMLEndMacro();
  of << " ijkToRASDirections=\"";
  for (const auto& row : this->IJKToRASDirections)
  {
    for (const double direction : row)
    {
      of << vtkMRMLNumberText(direction) << " ";
    }
  }
  of << "\"";
}

void vtkMRMLVolumeNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLVectorMacro(spacing, Spacing, double, 3);
  vtkMRMLReadXMLVectorMacro(origin, Origin, double, 3);
  if (!std::strcmp(xmlReadAttName, "ijkToRASDirections"))
  {
    double directions[3][3] = {};
    const char* rest = xmlReadAttValue;
    for (int i = 0; i < 9 && vtkMRMLNextNumber(rest, directions[i / 3][i % 3]); ++i)
    {
    }
    this->SetIJKToRASDirections(directions);
  }
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLVolumeNode::CopyContent(vtkMRMLNode* anode, bool deepCopy)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::CopyContent(anode, deepCopy);
  auto* node = vtkMRMLVolumeNode::SafeDownCast(anode);
  if (!node)
  {
    return;
  }
  vtkSmartPointer<vtkImageData> image = node->GetImageData();
  if (image && deepCopy)
  {
    image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(node->GetImageData());
  }
  this->SetAndObserveImageData(image);
  this->CopyOrientation(node);
}

void vtkMRMLVolumeNode::ProcessMRMLEvents(vtkObject* caller, unsigned long event, void* callData)
{
  this->Superclass::ProcessMRMLEvents(caller, event, callData);
  if (caller && caller == this->ImageProducer && event == vtkCommand::ModifiedEvent)
  {
    this->StorableModified();
    this->InvokeCustomModifiedEvent(vtkMRMLVolumeNode::ImageDataModifiedEvent);
  }
}

vtkMRMLVolumeDisplayNode* vtkMRMLVolumeNode::GetVolumeDisplayNode()
{
  return vtkMRMLVolumeDisplayNode::SafeDownCast(this->GetDisplayNode());
}

bool vtkMRMLVolumeNode::GetModifiedSinceRead()
{
  return this->Superclass::GetModifiedSinceRead() ||
         (this->GetImageData() &&
          this->GetImageData()->GetMTime() > this->GetStoredTime().GetMTime());
}

// --- Voxels ------------------------------------------------------------------------------------

void vtkMRMLVolumeNode::SetAndObserveImageData(vtkImageData* image)
{
  if (image && image == this->ForwardedImage)
  {
    return;
  }
  this->StopForwarding();
  if (!image)
  {
    this->SetImageDataConnection(nullptr);
    return;
  }
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  this->SetImageDataConnection(producer->GetOutputPort());
  this->DataEventForwarder = vtkSmartPointer<vtkEventForwarderCommand>::New();
  this->DataEventForwarder->SetTarget(producer);
  this->ForwardedImage = image;
  image->AddObserver(vtkCommand::ModifiedEvent, this->DataEventForwarder);
}

void vtkMRMLVolumeNode::StopForwarding()
{
  if (this->ForwardedImage)
  {
    this->ForwardedImage->RemoveObserver(this->DataEventForwarder);
    this->ForwardedImage = nullptr;
    this->DataEventForwarder = nullptr;
  }
}

void vtkMRMLVolumeNode::SetImageDataConnection(vtkAlgorithmOutput* inputPort)
{
  if (this->ImageDataConnection == inputPort)
  {
    return;
  }
  this->StopForwarding();
  if (this->ImageProducer)
  {
    this->ImageProducer->RemoveObserver(this->MRMLCallbackCommand);
  }
  this->ImageDataConnection = inputPort;
  this->ImageProducer = inputPort ? inputPort->GetProducer() : nullptr;
  if (this->ImageProducer)
  {
    this->ImageProducer->AddObserver(vtkCommand::ModifiedEvent, this->MRMLCallbackCommand);
  }
  this->StorableModified();
  this->Modified();
  this->InvokeCustomModifiedEvent(vtkMRMLVolumeNode::ImageDataModifiedEvent, this);
}

vtkImageData* vtkMRMLVolumeNode::GetImageData()
{
  if (!this->ImageProducer)
  {
    return nullptr;
  }
  this->ImageProducer->Update();
  return vtkImageData::SafeDownCast(
      this->ImageProducer->GetOutputDataObject(this->ImageDataConnection->GetIndex()));
}

// --- Geometry ----------------------------------------------------------------------------------

void vtkMRMLVolumeNode::CopyOrientation(vtkMRMLVolumeNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->SetIJKToRASDirections(node->IJKToRASDirections);
  this->SetSpacing(node->Spacing);
  this->SetOrigin(node->Origin);
}

void vtkMRMLVolumeNode::SetIJKToRASDirections(double dirs[3][3])
{
  if (std::equal(&dirs[0][0], &dirs[0][0] + 9, &this->IJKToRASDirections[0][0]))
  {
    return;
  }
  std::copy(&dirs[0][0], &dirs[0][0] + 9, &this->IJKToRASDirections[0][0]);
  this->StorableModified();
  this->Modified();
}

void vtkMRMLVolumeNode::GetIJKToRASDirections(double dirs[3][3])
{
  std::copy(&this->IJKToRASDirections[0][0], &this->IJKToRASDirections[0][0] + 9, &dirs[0][0]);
}

void vtkMRMLVolumeNode::SetSpacing(double arg1, double arg2, double arg3)
{
  double spacing[3] = {arg1, arg2, arg3};
  this->SetSpacing(spacing);
}

void vtkMRMLVolumeNode::SetSpacing(double arg[3])
{
  if (!std::equal(arg, arg + 3, this->Spacing))
  {
    std::copy(arg, arg + 3, this->Spacing);
    this->StorableModified();
    this->Modified();
  }
}

void vtkMRMLVolumeNode::SetOrigin(double arg1, double arg2, double arg3)
{
  double origin[3] = {arg1, arg2, arg3};
  this->SetOrigin(origin);
}

void vtkMRMLVolumeNode::SetOrigin(double arg[3])
{
  if (!std::equal(arg, arg + 3, this->Origin))
  {
    std::copy(arg, arg + 3, this->Origin);
    this->StorableModified();
    this->Modified();
  }
}

void vtkMRMLVolumeNode::GetIJKToRASMatrix(vtkMatrix4x4* mat)
{
  mat->Identity();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      mat->SetElement(row, column, this->IJKToRASDirections[row][column] * this->Spacing[column]);
    }
    mat->SetElement(row, 3, this->Origin[row]);
  }
}

void vtkMRMLVolumeNode::GetRASToIJKMatrix(vtkMatrix4x4* mat)
{
  this->GetIJKToRASMatrix(mat);
  mat->Invert();
}

void vtkMRMLVolumeNode::SetIJKToRASMatrix(vtkMatrix4x4* mat)
{
  double directions[3][3];
  double spacing[3];
  double origin[3];
  for (int column = 0; column < 3; ++column)
  {
    spacing[column] = std::hypot(mat->GetElement(0, column), mat->GetElement(1, column),
                                 mat->GetElement(2, column));
    for (int row = 0; row < 3; ++row)
    {
      directions[row][column] = mat->GetElement(row, column) / spacing[column];
    }
    origin[column] = mat->GetElement(column, 3);
  }
  MRMLNodeModifyBlocker blocker(this);
  this->SetIJKToRASDirections(directions);
  this->SetSpacing(spacing);
  this->SetOrigin(origin);
}

void vtkMRMLVolumeNode::SetRASToIJKMatrix(vtkMatrix4x4* mat)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(mat, inverse);
  this->SetIJKToRASMatrix(inverse);
}

void vtkMRMLVolumeNode::GetIJKToRASDirectionMatrix(vtkMatrix4x4* mat)
{
  mat->Identity();
  for (int i = 0; i < 9; ++i)
  {
    mat->SetElement(i / 3, i % 3, this->IJKToRASDirections[i / 3][i % 3]);
  }
}

void vtkMRMLVolumeNode::SetIJKToRASDirectionMatrix(vtkMatrix4x4* mat)
{
  double directions[3][3];
  for (int i = 0; i < 9; ++i)
  {
    directions[i / 3][i % 3] = mat->GetElement(i / 3, i % 3);
  }
  this->SetIJKToRASDirections(directions);
}

/// Of the voxels' outer corners.
void vtkMRMLVolumeNode::BoundsThrough(vtkAbstractTransform* rasTransform, double bounds[6])
{
  this->vtkMRMLDisplayableNode::GetBounds(bounds);
  vtkImageData* image = this->GetImageData();
  if (!image)
  {
    return;
  }
  int size[3];
  image->GetDimensions(size);
  vtkNew<vtkMatrix4x4> matrix;
  this->GetIJKToRASMatrix(matrix);
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double ijk[4] = {-0.5 + (corner & 1) * size[0], -0.5 + (corner >> 1 & 1) * size[1],
                           -0.5 + (corner >> 2) * size[2], 1.0};
    double ras[4];
    matrix->MultiplyPoint(ijk, ras);
    double point[3];
    rasTransform->TransformPoint(ras, point);
    box.AddPoint(point);
  }
  box.GetBounds(bounds);
}

void vtkMRMLVolumeNode::GetRASBounds(double bounds[6])
{
  vtkNew<vtkGeneralTransform> toWorld;
  vtkMRMLTransformNode::GetTransformBetweenNodes(this->GetParentTransformNode(), nullptr, toWorld);
  this->BoundsThrough(toWorld, bounds);
}

void vtkMRMLVolumeNode::GetBounds(double bounds[6])
{
  this->BoundsThrough(vtkNew<vtkGeneralTransform>(), bounds);
}

void vtkMRMLVolumeNode::ApplyTransformMatrix(vtkMatrix4x4* transformMatrix)
{
  vtkNew<vtkMatrix4x4> matrix;
  this->GetIJKToRASMatrix(matrix);
  vtkMatrix4x4::Multiply4x4(transformMatrix, matrix, matrix);
  this->SetIJKToRASMatrix(matrix);
}
