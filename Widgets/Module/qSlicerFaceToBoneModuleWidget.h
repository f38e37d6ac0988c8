#ifndef __qSlicerFaceToBoneModuleWidget_h
#define __qSlicerFaceToBoneModuleWidget_h

#include "qSlicerFaceToBoneModuleExport.h"

#include <ctkVTKObject.h>
#include <qSlicerAbstractModuleWidget.h>

class qSlicerFaceToBoneModuleWidgetPrivate;
class vtkMRMLFaceToBonePlanNode;
class vtkMRMLNode;

/// The module's panel: a plan, its inputs, and its steps from CT to report.
///
/// What it shows is the plan node's state and nothing else; a change of a control goes to the node,
/// and a change of the node to the controls. Steps run beside the event loop.
class Q_SLICER_QTMODULES_FACETOBONE_EXPORT qSlicerFaceToBoneModuleWidget
    : public qSlicerAbstractModuleWidget
{
  Q_OBJECT
  QVTK_OBJECT

public:
  typedef qSlicerAbstractModuleWidget Superclass;
  explicit qSlicerFaceToBoneModuleWidget(QWidget* parent = nullptr);
  ~qSlicerFaceToBoneModuleWidget() override;

  void enter() override;
  void exit() override;
  bool setEditedNode(vtkMRMLNode* node, QString role = QString(),
                     QString context = QString()) override;

public slots:
  void setPlanNode(vtkMRMLNode* node);

protected:
  void setup() override;
  void setMRMLScene(vtkMRMLScene* scene) override;

protected slots:
  void updateWidgetFromMRML();
  void updateProgress();
  void updatePlanFromWidget();
  void setInputVolume(vtkMRMLNode* node);
  void setLandmarks(vtkMRMLNode* node);
  void setOsteotomy(vtkMRMLNode* node);
  void setTarget(vtkMRMLNode* node);
  void addPlan(vtkMRMLNode* node);
  void openCase();
  void cancel();
  void processLogicEvents();
  void onSceneEndClose();

private:
  void startStep(int step);

  QScopedPointer<qSlicerFaceToBoneModuleWidgetPrivate> d_ptr;
  Q_DECLARE_PRIVATE(qSlicerFaceToBoneModuleWidget);
  Q_DISABLE_COPY(qSlicerFaceToBoneModuleWidget);
};

#endif
