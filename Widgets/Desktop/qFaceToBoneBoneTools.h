#ifndef qFaceToBoneBoneTools_h
#define qFaceToBoneBoneTools_h

#include <QObject>

#include <vtkSmartPointer.h>

#include <vector>

class qFaceToBoneCase;
class qFaceToBoneThreeDView;
class vtkFaceToBoneFragmentWidget;
class vtkObject;

/// The gizmos in the 3D view that move fragments by hand, one a fragment, as far as its rules allow.
class qFaceToBoneBoneTools : public QObject
{
  Q_OBJECT

public:
  qFaceToBoneBoneTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view, QObject* parent);
  ~qFaceToBoneBoneTools() override;

  void showGizmos(bool on);
  const std::vector<vtkSmartPointer<vtkFaceToBoneFragmentWidget>>& gizmos() const
  {
    return m_gizmos;
  }

private:
  void updateGizmos();
  void gizmoMoved(vtkObject* tool, unsigned long, void*);

  qFaceToBoneCase* m_case;
  qFaceToBoneThreeDView* m_view;
  std::vector<vtkSmartPointer<vtkFaceToBoneFragmentWidget>> m_gizmos;
  bool m_showGizmos = false;
};

#endif
