#ifndef qFaceToBonePointTools_h
#define qFaceToBonePointTools_h

#include "vtkFaceToBonePointsWidget.h"

#include <QObject>

#include <vtkSmartPointer.h>

#include <vector>

class qFaceToBoneCase;
class qFaceToBoneLandmarksPanel;
class qFaceToBoneMeasuresPanel;
class qFaceToBoneSculptPanel;
class qFaceToBoneThreeDView;
class vtkObject;

/// Points in the 3D view: landmarks that are placed on the surfaces, landmarks of the face that
/// drag it, and rulers.
class qFaceToBonePointTools : public QObject
{
  Q_OBJECT

public:
  qFaceToBonePointTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view,
                        qFaceToBoneLandmarksPanel* landmarks, qFaceToBoneSculptPanel* sculpt,
                        qFaceToBoneMeasuresPanel* measures, QObject* parent);
  ~qFaceToBonePointTools() override;

  /// Landmarks with their names, to be placed and moved.
  void showLandmarks(bool on);
  /// Handles on the face that is sculpted.
  void showHandles(bool on);

  vtkFaceToBonePointsWidget* landmarkTool() const { return m_landmarks; }
  vtkFaceToBonePointsWidget* handleTool() const { return m_handles; }
  /// The ruler that is being placed.
  vtkFaceToBonePointsWidget* rulerTool() const { return m_placing; }
  const std::vector<vtkSmartPointer<vtkFaceToBonePointsWidget>>& rulers() const { return m_rulers; }

private:
  vtkSmartPointer<vtkFaceToBonePointsWidget> make();
  void update();
  void updateLandmarks();
  void updateHandles();
  void updateRulers();
  void landmarkPlaced(vtkObject*, unsigned long, void*);
  void landmarkMoved(vtkObject*, unsigned long, void*);
  void handleHeld(vtkObject*, unsigned long, void*);
  void handleMoved(vtkObject*, unsigned long, void*);
  void handleLeft(vtkObject*, unsigned long, void*);
  void rulerPlaced(vtkObject*, unsigned long, void*);
  void rulerMoved(vtkObject* tool, unsigned long, void*);
  void rulerLeft(vtkObject*, unsigned long, void*);
  void keepRulers();

  qFaceToBoneCase* m_case;
  qFaceToBoneThreeDView* m_view;
  qFaceToBoneLandmarksPanel* m_landmarksPanel;
  qFaceToBoneSculptPanel* m_sculptPanel;
  qFaceToBoneMeasuresPanel* m_measuresPanel;
  vtkSmartPointer<vtkFaceToBonePointsWidget> m_landmarks, m_handles, m_placing;
  std::vector<vtkSmartPointer<vtkFaceToBonePointsWidget>> m_rulers;
  std::vector<QString> m_landmarkNames; ///< of the tool's points
  bool m_showLandmarks = false, m_showHandles = false;
};

#endif
