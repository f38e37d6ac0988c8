#ifndef qFaceToBoneSliceView_h
#define qFaceToBoneSliceView_h

#include <QVTKOpenGLNativeWidget.h>

#include <vtkSmartPointer.h>

#include <array>
#include <map>

class qFaceToBoneObjects;
class vtkActor;
class vtkCutter;
class vtkImageData;
class vtkImageSlice;
class vtkImageSliceMapper;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

/// One slice through the CT, with the outlines of all surfaces that are shown.
///
/// Axial: seen from the feet; coronal: from the front; sagittal: from the left. Left drag: crosshair;
/// right drag: window and level; middle drag: shift; wheel: next slice; Ctrl and wheel: zoom.
class qFaceToBoneSliceView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  enum Orientation
  {
    Sagittal, ///< normal R
    Coronal,  ///< normal A
    Axial,    ///< normal S
  };

  qFaceToBoneSliceView(Orientation orientation, qFaceToBoneObjects* objects,
                       QWidget* parent = nullptr);
  ~qFaceToBoneSliceView() override;

  void setImage(vtkImageData* image);
  void setCrosshair(const std::array<double, 3>& point);
  void setWindowLevel(double window, double level);
  const std::array<double, 3>& crosshair() const { return m_point; }
  void fit();

signals:
  void crosshairMoved(const std::array<double, 3>& point);
  void windowLevelChanged(double window, double level);

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Outline;
  void moveCrosshairTo(const QPoint& pixel);
  void updateOutline(const QString& key);
  void rebuild();
  void placeCamera();
  void updateText();
  void renderSoon();
  void renderLater();

  Orientation m_orientation;
  qFaceToBoneObjects* m_objects;
  vtkSmartPointer<vtkImageData> m_image;
  vtkSmartPointer<vtkRenderer> m_renderer;
  vtkSmartPointer<vtkImageSliceMapper> m_mapper;
  vtkSmartPointer<vtkImageSlice> m_slice;
  vtkSmartPointer<vtkPlane> m_plane;
  vtkSmartPointer<vtkPolyData> m_cross;
  vtkSmartPointer<vtkTextActor> m_text;
  std::map<QString, Outline> m_outlines;
  std::array<double, 3> m_point{};
  double m_window = 2000, m_level = 400;
  QPoint m_last;
  bool m_renderPending = false, m_laterPending = false;
};

#endif
