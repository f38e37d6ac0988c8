#ifndef qFaceToBoneThreeDView_h
#define qFaceToBoneThreeDView_h

#include <QVTKOpenGLNativeWidget.h>

#include <vtkSmartPointer.h>

#include <map>
#include <vector>

class qFaceToBoneObjects;
class vtkActor;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

/// The 3D view: all objects, from the sides that surgeons look from, alone or compared.
class qFaceToBoneThreeDView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  enum Preset
  {
    Frontal,
    Right,
    Left,
    ThreeQuarter,
    Submental,
    Top,
  };
  enum Layout
  {
    Single,  ///< all that is visible
    Compare, ///< before, target and predicted face side by side, one camera
  };

  qFaceToBoneThreeDView(qFaceToBoneObjects* objects, QWidget* parent = nullptr);
  ~qFaceToBoneThreeDView() override;

  void setPreset(Preset preset);
  void fit();
  void setLayoutOfViews(Layout layout);
  Layout layoutOfViews() const { return m_layout; }
  /// Draws fragments apart from their common middle by so much [mm].
  void setExplode(double mm);
  /// Where the slices' crosshair is [mm, RAS].
  void setCrosshair(const double point[3]);
  /// Share of the view, from the left, in which the target is shown; the predicted face is in the
  /// rest. 1: no split.
  void setSplit(double share);
  vtkRenderer* mainRenderer() const;
  void renderSoon();
  /// What is seen, as a picture file. \return false if it cannot be written
  bool savePicture(const QString& path);

signals:
  void drawn(); ///< all that there is to see is on the screen

protected:
  void paintGL() override;

private:
  struct Pane;
  void drawNow();
  void onRenderRequested();
  void fitCamera();
  void rebuild();
  void updateObject(const QString& key);
  void updateActor(vtkActor* actor, const QString& key);
  void updateBar();
  void placeSplit();
  std::vector<QString> keysOf(std::size_t pane) const;

  qFaceToBoneObjects* m_objects;
  std::vector<Pane> m_panes;
  Layout m_layout = Single;
  double m_explode = 0, m_split = 1;
  bool m_renderPending = false, m_painting = false, m_fitted = false;
  unsigned long m_renderRequests = 0; ///< observer of the interactor's
  vtkSmartPointer<vtkScalarBarActor> m_bar;
  vtkSmartPointer<vtkTextActor> m_barTitle;
  vtkSmartPointer<vtkActor> m_crosshair;
};

#endif
