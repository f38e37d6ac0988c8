#include "vtkMRMLScalarVolumeDisplayNode.h"

#include <vtkObjectFactory.h>

vtkMRMLNodeNewMacro(vtkMRMLScalarVolumeDisplayNode);

void vtkMRMLScalarVolumeDisplayNode::WriteXML(ostream& of, int indent)
{
  this->Superclass::WriteXML(of, indent);
  vtkMRMLWriteXMLBeginMacro(of);
  vtkMRMLWriteXMLFloatMacro(window, Window);
  vtkMRMLWriteXMLFloatMacro(level, Level);
  vtkMRMLWriteXMLFloatMacro(upperThreshold, UpperThreshold);
  vtkMRMLWriteXMLFloatMacro(lowerThreshold, LowerThreshold);
  vtkMRMLWriteXMLIntMacro(interpolate, Interpolate);
  vtkMRMLWriteXMLBooleanMacro(windowLevelLocked, WindowLevelLocked);
  vtkMRMLWriteXMLIntMacro(autoWindowLevel, AutoWindowLevel);
  vtkMRMLWriteXMLIntMacro(applyThreshold, ApplyThreshold);
  vtkMRMLWriteXMLIntMacro(autoThreshold, AutoThreshold);
  vtkMRMLWriteXMLEndMacro();
}

void vtkMRMLScalarVolumeDisplayNode::ReadXMLAttributes(const char** atts)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::ReadXMLAttributes(atts);
  vtkMRMLReadXMLBeginMacro(atts);
  vtkMRMLReadXMLFloatMacro(window, Window);
  vtkMRMLReadXMLFloatMacro(level, Level);
  vtkMRMLReadXMLFloatMacro(upperThreshold, UpperThreshold);
  vtkMRMLReadXMLFloatMacro(lowerThreshold, LowerThreshold);
  vtkMRMLReadXMLIntMacro(interpolate, Interpolate);
  vtkMRMLReadXMLBooleanMacro(windowLevelLocked, WindowLevelLocked);
  vtkMRMLReadXMLIntMacro(autoWindowLevel, AutoWindowLevel);
  vtkMRMLReadXMLIntMacro(applyThreshold, ApplyThreshold);
  vtkMRMLReadXMLIntMacro(autoThreshold, AutoThreshold);
  vtkMRMLReadXMLEndMacro();
}

void vtkMRMLScalarVolumeDisplayNode::Copy(vtkMRMLNode* node)
{
  MRMLNodeModifyBlocker blocker(this);
  this->Superclass::Copy(node);
  vtkMRMLCopyBeginMacro(node);
  vtkMRMLCopyBooleanMacro(WindowLevelLocked);
  vtkMRMLCopyIntMacro(AutoWindowLevel);
  this->SetWindowLevel(copySourceNode->Window, copySourceNode->Level);
  vtkMRMLCopyIntMacro(AutoThreshold);
  vtkMRMLCopyIntMacro(ApplyThreshold);
  this->SetThreshold(copySourceNode->LowerThreshold, copySourceNode->UpperThreshold);
  vtkMRMLCopyIntMacro(Interpolate);
  vtkMRMLCopyEndMacro();
}

void vtkMRMLScalarVolumeDisplayNode::SetDefaultColorMap()
{
  this->SetAndObserveColorNodeID("vtkMRMLColorTableNodeGrey");
}

void vtkMRMLScalarVolumeDisplayNode::SetWindow(double window)
{
  this->SetWindowLevel(window, this->Level);
}

void vtkMRMLScalarVolumeDisplayNode::SetLevel(double level)
{
  this->SetWindowLevel(this->Window, level);
}

void vtkMRMLScalarVolumeDisplayNode::SetWindowLevel(double window, double level)
{
  if (this->Window != window || this->Level != level)
  {
    this->Window = window;
    this->Level = level;
    this->Modified();
  }
}

void vtkMRMLScalarVolumeDisplayNode::SetWindowLevelMinMax(double min, double max)
{
  this->SetWindowLevel(max - min, 0.5 * (min + max));
}

void vtkMRMLScalarVolumeDisplayNode::SetApplyThreshold(int apply)
{
  if (this->ApplyThreshold != apply)
  {
    this->ApplyThreshold = apply;
    this->Modified();
  }
}

void vtkMRMLScalarVolumeDisplayNode::SetLowerThreshold(double lower)
{
  this->SetThreshold(lower, this->UpperThreshold);
}

void vtkMRMLScalarVolumeDisplayNode::SetUpperThreshold(double upper)
{
  this->SetThreshold(this->LowerThreshold, upper);
}

void vtkMRMLScalarVolumeDisplayNode::SetThreshold(double lower, double upper)
{
  if (this->LowerThreshold != lower || this->UpperThreshold != upper)
  {
    this->LowerThreshold = lower;
    this->UpperThreshold = upper;
    this->Modified();
  }
}
