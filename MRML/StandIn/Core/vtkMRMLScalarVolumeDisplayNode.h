#pragma once

#include "vtkMRMLVolumeDisplayNode.h"

/// Window, level and thresholds of a scalar volume.
class VTK_MRML_EXPORT vtkMRMLScalarVolumeDisplayNode : public vtkMRMLVolumeDisplayNode
{
public:
  static vtkMRMLScalarVolumeDisplayNode* New();
  vtkTypeMacro(vtkMRMLScalarVolumeDisplayNode, vtkMRMLVolumeDisplayNode);
  vtkMRMLNode* CreateNodeInstance() override;
  const char* GetNodeTagName() override { return "VolumeDisplay"; }
  void ReadXMLAttributes(const char** atts) override;
  void WriteXML(ostream& of, int indent) override;
  void Copy(vtkMRMLNode* node) override;
  void SetDefaultColorMap() override;

  double GetWindow() { return this->Window; }
  virtual void SetWindow(double window);
  double GetLevel() { return this->Level; }
  virtual void SetLevel(double level);
  virtual void SetWindowLevel(double window, double level);
  void SetWindowLevelMinMax(double min, double max);
  double GetWindowLevelMin() { return this->Level - 0.5 * this->Window; }
  double GetWindowLevelMax() { return this->Level + 0.5 * this->Window; }
  vtkGetMacro(WindowLevelLocked, bool);
  vtkSetMacro(WindowLevelLocked, bool);
  vtkGetMacro(AutoWindowLevel, int);
  vtkSetMacro(AutoWindowLevel, int);
  vtkBooleanMacro(AutoWindowLevel, int);
  vtkGetMacro(ApplyThreshold, int);
  virtual void SetApplyThreshold(int apply);
  vtkBooleanMacro(ApplyThreshold, int);
  vtkGetMacro(AutoThreshold, int);
  vtkSetMacro(AutoThreshold, int);
  vtkBooleanMacro(AutoThreshold, int);
  virtual double GetLowerThreshold() { return this->LowerThreshold; }
  virtual void SetLowerThreshold(double lower);
  virtual double GetUpperThreshold() { return this->UpperThreshold; }
  virtual void SetUpperThreshold(double upper);
  virtual void SetThreshold(double lower, double upper);
  vtkGetMacro(Interpolate, int);
  vtkSetMacro(Interpolate, int);
  vtkBooleanMacro(Interpolate, int);

protected:
  vtkMRMLScalarVolumeDisplayNode() = default;
  ~vtkMRMLScalarVolumeDisplayNode() override = default;
  vtkMRMLScalarVolumeDisplayNode(const vtkMRMLScalarVolumeDisplayNode&) = delete;
  void operator=(const vtkMRMLScalarVolumeDisplayNode&) = delete;

private:
  double Window = 256.0;
  double Level = 128.0;
  double LowerThreshold = VTK_SHORT_MIN;
  double UpperThreshold = VTK_SHORT_MAX;
  int Interpolate = 1;
  bool WindowLevelLocked = false;
  int AutoWindowLevel = 1;
  int ApplyThreshold = 0;
  int AutoThreshold = 0;
};
