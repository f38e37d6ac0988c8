#ifndef __qSlicerFaceToBoneTools_h
#define __qSlicerFaceToBoneTools_h

#include <QObject>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

class qFaceToBoneBrushPanel;
class vtkFaceToBoneFragmentHands;
class vtkFaceToBoneSkinSculpting;
class vtkMRMLFaceToBonePlanNode;
class vtkSlicerFaceToBoneLogic;

/// Our 3D tools in Slicer: the brush panel's brush on a plan's target, and its fragments by hand, in the
/// first 3D view that there is.
///
/// Finds the view and tells brush and panel of each other; all else is the tools' own.
class qSlicerFaceToBoneTools : public QObject
{
  Q_OBJECT

public:
  /// \param panel  outlives this
  explicit qSlicerFaceToBoneTools(qFaceToBoneBrushPanel* panel, QObject* parent = nullptr);
  ~qSlicerFaceToBoneTools() override;

  vtkFaceToBoneSkinSculpting* sculpting();
  vtkFaceToBoneFragmentHands* hands();
  /// The plan's skin, target, landmarks and fragments as they are now; null: none.
  void setPlan(vtkMRMLFaceToBonePlanNode* plan);
  void setLogic(vtkSlicerFaceToBoneLogic* logic);
  void moveByHand(bool on);
  /// Puts all down, such as when the user goes to another module.
  void stop();
  /// What the user needs to know: why a tool does nothing, or where it works.
  QString sculptingText();
  QString handsText();

public slots:
  /// Takes the first 3D view of the layout, or none.
  void findView();

signals:
  void changed();
  /// The movements that Predict is asked for are others now.
  void movementStated();

private:
  void follow(bool sculpting);
  void takeBrush();
  void onChanged();
  void onLetGo();

  qFaceToBoneBrushPanel* m_panel;
  vtkNew<vtkFaceToBoneSkinSculpting> m_sculpting;
  vtkNew<vtkFaceToBoneFragmentHands> m_hands;
  vtkWeakPointer<vtkMRMLFaceToBonePlanNode> m_plan;
  vtkSlicerFaceToBoneLogic* m_logic = nullptr;
  bool m_following = false;

  Q_DISABLE_COPY(qSlicerFaceToBoneTools);
};

#endif
