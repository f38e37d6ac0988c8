#ifndef qFaceToBoneBoneTools_h
#define qFaceToBoneBoneTools_h

#include <QObject>

#include <vtkSmartPointer.h>

#include <vector>

class qFaceToBoneCase;
class qFaceToBoneThreeDView;
class vtkFaceToBoneFragmentWidget;
class vtkFaceToBonePlaneWidget;
class vtkObject;

/// The tools on the bone in the 3D view: one plane widget a cut, one gizmo a fragment.
class qFaceToBoneBoneTools : public QObject
{
  Q_OBJECT

public:
  qFaceToBoneBoneTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view, QObject* parent);
  ~qFaceToBoneBoneTools() override;

  void showPlanes(bool on);
  void showGizmos(bool on);
  const std::vector<vtkSmartPointer<vtkFaceToBonePlaneWidget>>& planeTools() const
  {
    return m_planes;
  }
  const std::vector<vtkSmartPointer<vtkFaceToBoneFragmentWidget>>& gizmos() const
  {
    return m_gizmos;
  }

private:
  void makePlanes();
  void updateGizmos();
  void planeMoved(vtkObject* tool, unsigned long, void*);
  void gizmoMoved(vtkObject* tool, unsigned long, void*);
  void drop();

  qFaceToBoneCase* m_case;
  qFaceToBoneThreeDView* m_view;
  std::vector<vtkSmartPointer<vtkFaceToBonePlaneWidget>> m_planes;
  std::vector<vtkSmartPointer<vtkFaceToBoneFragmentWidget>> m_gizmos;
  bool m_showPlanes = false, m_showGizmos = false;
};

#endif
