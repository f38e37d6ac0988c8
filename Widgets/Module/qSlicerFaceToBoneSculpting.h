#ifndef __qSlicerFaceToBoneSculpting_h
#define __qSlicerFaceToBoneSculpting_h

#include <QObject>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class qFaceToBoneBrushPanel;
class vtkFaceToBoneSkinSculpting;
class vtkMRMLFaceToBonePlanNode;
class vtkSlicerFaceToBoneLogic;

/// Sculpting in Slicer: the brush panel's brush on a plan's target, in the first 3D view that there is.
///
/// Finds the view and tells brush and panel of each other; all else is vtkFaceToBoneSkinSculpting's.
class qSlicerFaceToBoneSculpting : public QObject
{
  Q_OBJECT

public:
  /// \param panel  outlives this
  explicit qSlicerFaceToBoneSculpting(qFaceToBoneBrushPanel* panel, QObject* parent = nullptr);
  ~qSlicerFaceToBoneSculpting() override;

  vtkFaceToBoneSkinSculpting* tool();
  /// The plan's skin, target and landmarks as they are now; null: none.
  void setPlan(vtkMRMLFaceToBonePlanNode* plan);
  void setLogic(vtkSlicerFaceToBoneLogic* logic);
  /// Puts the brush down, such as when the user goes to another module.
  void stop();
  /// What the user needs to know: why the brush does nothing, or how far the strokes go.
  QString statusText();

public slots:
  /// Takes the first 3D view of the layout, or none.
  void findView();

signals:
  void changed();

private:
  void follow(bool sculpting);
  void takeBrush();
  void onChanged();

  qFaceToBoneBrushPanel* m_panel;
  vtkNew<vtkFaceToBoneSkinSculpting> m_tool;
  vtkWeakPointer<vtkMRMLFaceToBonePlanNode> m_plan;
  vtkSlicerFaceToBoneLogic* m_logic = nullptr;
  bool m_following = false;

  Q_DISABLE_COPY(qSlicerFaceToBoneSculpting);
};

#endif
