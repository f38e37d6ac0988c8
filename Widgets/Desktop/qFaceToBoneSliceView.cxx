#include "qFaceToBoneSliceView.h"

#include "qFaceToBoneObjects.h"

#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <cmath>

struct qFaceToBoneSliceView::Outline
{
  vtkSmartPointer<vtkTransformPolyDataFilter> placed;
  vtkSmartPointer<vtkCutter> cut;
  vtkSmartPointer<vtkActor> actor;
};

qFaceToBoneSliceView::qFaceToBoneSliceView(Orientation orientation, qFaceToBoneObjects* objects,
                                           QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), m_orientation(orientation), m_objects(objects),
      m_renderer(vtkSmartPointer<vtkRenderer>::New()),
      m_mapper(vtkSmartPointer<vtkImageSliceMapper>::New()),
      m_slice(vtkSmartPointer<vtkImageSlice>::New()), m_plane(vtkSmartPointer<vtkPlane>::New()),
      m_cross(vtkSmartPointer<vtkPolyData>::New()), m_text(vtkSmartPointer<vtkTextActor>::New())
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  setRenderWindow(window);
  window->AddRenderer(m_renderer);
  interactor()->SetInteractorStyle(nullptr); // our own mouse, below
  m_renderer->SetBackground(0, 0, 0);
  m_renderer->GetActiveCamera()->ParallelProjectionOn();
  m_mapper->SetOrientation(orientation);
  m_slice->SetMapper(m_mapper);
  m_slice->VisibilityOff();
  m_renderer->AddViewProp(m_slice);
  double normal[3] = {0, 0, 0};
  normal[orientation] = 1;
  m_plane->SetNormal(normal);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(m_cross);
  vtkNew<vtkActor> cross;
  cross->SetMapper(mapper);
  cross->GetProperty()->SetColor(0.95, 0.35, 0.3);
  cross->GetProperty()->SetLineWidth(1);
  cross->GetProperty()->LightingOff();
  m_renderer->AddActor(cross);
  m_text->GetTextProperty()->SetFontSize(13);
  m_text->GetTextProperty()->SetColor(0.9, 0.92, 0.95);
  m_text->GetTextProperty()->SetBackgroundColor(0, 0, 0);
  m_text->GetTextProperty()->SetBackgroundOpacity(0.65);
  m_text->SetPosition(6, 5);
  m_renderer->AddViewProp(m_text);
  setMinimumSize(120, 90);
  connect(m_objects, &qFaceToBoneObjects::listChanged, this, &qFaceToBoneSliceView::rebuild);
  connect(m_objects, &qFaceToBoneObjects::objectChanged, this,
          &qFaceToBoneSliceView::updateOutline);
  setWindowLevel(m_window, m_level);
}

qFaceToBoneSliceView::~qFaceToBoneSliceView() = default;

void qFaceToBoneSliceView::renderSoon()
{
  if (m_renderPending)
    return;
  m_renderPending = true;
  QTimer::singleShot(0, this,
                     [this]
                     {
                       m_renderPending = false;
                       renderWindow()->Render();
                     });
}

/// Outlines may lag a little behind the brush: cutting surfaces is slow.
void qFaceToBoneSliceView::renderLater()
{
  if (m_laterPending)
    return;
  m_laterPending = true;
  QTimer::singleShot(150, this,
                     [this]
                     {
                       m_laterPending = false;
                       renderSoon();
                     });
}

void qFaceToBoneSliceView::setImage(vtkImageData* image)
{
  m_image = image;
  m_slice->SetVisibility(image != nullptr);
  m_mapper->SetInputData(image);
  if (image)
  {
    double middle[3];
    image->GetCenter(middle);
    setCrosshair({middle[0], middle[1], middle[2]});
    fit();
  }
  updateText();
  renderSoon();
}

void qFaceToBoneSliceView::fit()
{
  placeCamera();
  if (!m_image)
    return;
  const int right = m_orientation == Sagittal ? 1 : 0, up = m_orientation == Axial ? 1 : 2;
  const double* b = m_image->GetBounds();
  const double aspect = double(std::max(1, width())) / std::max(1, height());
  m_renderer->GetActiveCamera()->SetParallelScale(
      0.51 * std::max(b[2 * up + 1] - b[2 * up], (b[2 * right + 1] - b[2 * right]) / aspect));
  renderSoon();
}

void qFaceToBoneSliceView::placeCamera()
{
  // side of the viewer: left of the patient, front, feet
  static constexpr double sides[3][3] = {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  double middle[3] = {0, 0, 0};
  if (m_image)
    m_image->GetCenter(middle);
  middle[m_orientation] = m_point[static_cast<std::size_t>(m_orientation)];
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->SetFocalPoint(middle);
  const double* s = sides[m_orientation];
  camera->SetPosition(middle[0] + 500 * s[0], middle[1] + 500 * s[1], middle[2] + 500 * s[2]);
  if (m_orientation == Axial)
    camera->SetViewUp(0, 1, 0);
  else
    camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(1, 1000);
}

void qFaceToBoneSliceView::setCrosshair(const std::array<double, 3>& point)
{
  const auto along = static_cast<std::size_t>(m_orientation);
  const double shift = point[along] - m_point[along];
  m_point = point;
  m_plane->SetOrigin(point.data());
  if (m_image)
  {
    const double* spacing = m_image->GetSpacing();
    const double* origin = m_image->GetOrigin();
    m_mapper->SetSliceNumber(
        static_cast<int>(std::lround((point[along] - origin[along]) / spacing[along])));
  }
  // camera and lines go with the slice; the lines lie a little towards the viewer
  vtkCamera* camera = m_renderer->GetActiveCamera();
  for (const bool focus : {true, false})
  {
    double p[3];
    focus ? camera->GetFocalPoint(p) : camera->GetPosition(p);
    p[along] += shift;
    focus ? camera->SetFocalPoint(p) : camera->SetPosition(p);
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const double lift = m_orientation == Coronal ? 2 : -2;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axis != along)
    {
      std::array<double, 3> a = point, b = point;
      a[axis] -= 400;
      b[axis] += 400;
      a[along] += lift;
      b[along] += lift;
      lines->InsertNextCell(2);
      lines->InsertCellPoint(points->InsertNextPoint(a.data()));
      lines->InsertCellPoint(points->InsertNextPoint(b.data()));
    }
  m_cross->Initialize();
  m_cross->SetPoints(points);
  m_cross->SetLines(lines);
  updateText();
  renderSoon();
}

void qFaceToBoneSliceView::setWindowLevel(double window, double level)
{
  m_window = std::clamp(window, 20.0, 6000.0);
  m_level = std::clamp(level, -1500.0, 4000.0);
  m_slice->GetProperty()->SetColorWindow(m_window);
  m_slice->GetProperty()->SetColorLevel(m_level);
  renderSoon();
}

void qFaceToBoneSliceView::updateText()
{
  static const char* const names[] = {"Sagittal  R", "Coronal  A", "Axial  S"};
  QString text = tr(names[m_orientation]);
  if (m_image)
    text += QString(" %1 mm").arg(m_point[static_cast<std::size_t>(m_orientation)], 0, 'f', 1);
  m_text->SetInput(qPrintable(text));
}

void qFaceToBoneSliceView::rebuild()
{
  for (const auto& [key, outline] : m_outlines)
    m_renderer->RemoveActor(outline.actor);
  m_outlines.clear();
  for (const qFaceToBoneObject& object : m_objects->all())
  {
    Outline o{vtkSmartPointer<vtkTransformPolyDataFilter>::New(), vtkSmartPointer<vtkCutter>::New(),
              vtkSmartPointer<vtkActor>::New()};
    o.cut->SetInputConnection(o.placed->GetOutputPort());
    o.cut->SetCutFunction(m_plane);
    o.cut->GenerateCutScalarsOff();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(o.cut->GetOutputPort());
    mapper->ScalarVisibilityOff();
    o.actor->SetMapper(mapper);
    o.actor->GetProperty()->SetLineWidth(1.6f);
    o.actor->GetProperty()->LightingOff();
    // in front of the image, behind the crosshair
    o.actor->SetPosition(m_orientation == Sagittal ? -1 : 0, m_orientation == Coronal ? 1 : 0,
                         m_orientation == Axial ? -1 : 0);
    m_renderer->AddActor(o.actor);
    m_outlines[object.key] = o;
    updateOutline(object.key);
  }
  renderSoon();
}

void qFaceToBoneSliceView::updateOutline(const QString& key)
{
  const auto found = m_outlines.find(key);
  const qFaceToBoneObject* object = m_objects->find(key);
  if (found == m_outlines.end() || !object)
    return;
  const Outline& outline = found->second;
  vtkNew<vtkTransform> transform;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(object->matrix.data());
  transform->SetMatrix(matrix);
  outline.placed->SetInputData(object->surface);
  outline.placed->SetTransform(transform);
  outline.actor->SetVisibility(object->visible);
  const QColor& c = object->colour;
  outline.actor->GetProperty()->SetColor(c.redF(), c.greenF(), c.blueF());
  renderLater();
}

void qFaceToBoneSliceView::moveCrosshairTo(const QPoint& pixel)
{
  if (!m_image)
    return;
  const double scale = devicePixelRatioF();
  m_renderer->SetDisplayPoint(pixel.x() * scale, (height() - 1 - pixel.y()) * scale, 0);
  m_renderer->DisplayToWorld();
  const double* p = m_renderer->GetWorldPoint();
  std::array<double, 3> point{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
  const double* b = m_image->GetBounds();
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = std::clamp(point[k], b[2 * k], b[2 * k + 1]);
  point[static_cast<std::size_t>(m_orientation)] = m_point[static_cast<std::size_t>(m_orientation)];
  emit crosshairMoved(point);
}

void qFaceToBoneSliceView::mousePressEvent(QMouseEvent* event)
{
  m_last = event->pos();
  if (event->button() == Qt::LeftButton)
    moveCrosshairTo(event->pos());
}

void qFaceToBoneSliceView::mouseMoveEvent(QMouseEvent* event)
{
  const QPoint by = event->pos() - m_last;
  m_last = event->pos();
  if (event->buttons() & Qt::LeftButton)
    moveCrosshairTo(event->pos());
  else if (event->buttons() & Qt::RightButton)
  {
    setWindowLevel(m_window + 5 * by.x(), m_level - 3 * by.y());
    emit windowLevelChanged(m_window, m_level);
  }
  else if (event->buttons() & Qt::MiddleButton)
  {
    vtkCamera* camera = m_renderer->GetActiveCamera();
    const double mm = 2 * camera->GetParallelScale() / std::max(1, height());
    double up[3], towards[3], right[3];
    camera->GetViewUp(up);
    camera->GetDirectionOfProjection(towards);
    vtkMath::Cross(towards, up, right);
    double p[3], f[3];
    camera->GetPosition(p);
    camera->GetFocalPoint(f);
    for (int k = 0; k < 3; ++k)
    {
      const double shift = mm * (-by.x() * right[k] + by.y() * up[k]);
      p[k] += shift;
      f[k] += shift;
    }
    camera->SetPosition(p);
    camera->SetFocalPoint(f);
    renderSoon();
  }
}

// not the interactor's: it has no style
void qFaceToBoneSliceView::mouseReleaseEvent(QMouseEvent*) {}
void qFaceToBoneSliceView::mouseDoubleClickEvent(QMouseEvent*) {}

void qFaceToBoneSliceView::wheelEvent(QWheelEvent* event)
{
  if (!m_image || event->angleDelta().y() == 0)
    return;
  const double turn = event->angleDelta().y() > 0 ? 1 : -1;
  if (event->modifiers() & Qt::ControlModifier)
  {
    m_renderer->GetActiveCamera()->Zoom(turn > 0 ? 1.15 : 1 / 1.15);
    return renderSoon();
  }
  const auto along = static_cast<std::size_t>(m_orientation);
  std::array<double, 3> point = m_point;
  const double* b = m_image->GetBounds();
  point[along] = std::clamp(point[along] + turn * m_image->GetSpacing()[along], b[2 * along],
                            b[2 * along + 1]);
  emit crosshairMoved(point);
}

void qFaceToBoneSliceView::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  fit();
}
