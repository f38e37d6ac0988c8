#include "qFaceToBoneThreeDView.h"

#include "qFaceToBoneObjects.h"

#include <Rendering/colour_maps.hpp>

#include <QMetaObject>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

struct qFaceToBoneThreeDView::Pane
{
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkTextActor> title;
  std::map<QString, vtkSmartPointer<vtkActor>> actors;
};

namespace
{

vtkSmartPointer<vtkTextActor> makeTitle()
{
  auto title = vtkSmartPointer<vtkTextActor>::New();
  title->GetTextProperty()->SetFontSize(17);
  title->GetTextProperty()->SetBold(1);
  title->GetTextProperty()->SetColor(0.13, 0.15, 0.18);
  title->GetTextProperty()->SetVerticalJustificationToTop();
  title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title->SetPosition(0.015, 0.985);
  return title;
}

const char* const compareKeys[] = {"skin", "target", "predicted"};

} // namespace

qFaceToBoneThreeDView::qFaceToBoneThreeDView(qFaceToBoneObjects* objects, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), m_objects(objects),
      m_bar(vtkSmartPointer<vtkScalarBarActor>::New()),
      m_barTitle(vtkSmartPointer<vtkTextActor>::New()),
      m_crosshair(vtkSmartPointer<vtkActor>::New())
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0); // depth peeling and multisampling do not go together
  window->SetAlphaBitPlanes(1);
  setRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  // tools and camera ask for a picture once or more with every event: one is drawn after it
  interactor()->EnableRenderOff();
  m_renderRequests = interactor()->AddObserver(vtkCommand::RenderEvent, this,
                                               &qFaceToBoneThreeDView::onRenderRequested);
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  for (int k = 0; k < 3; ++k)
  {
    Pane pane{vtkSmartPointer<vtkRenderer>::New(), makeTitle(), {}};
    pane.renderer->SetBackground(0.955, 0.962, 0.970);
    pane.renderer->SetBackground2(0.82, 0.85, 0.89);
    pane.renderer->GradientBackgroundOn();
    pane.renderer->SetActiveCamera(camera);
    pane.renderer->SetUseDepthPeeling(1);
    pane.renderer->SetMaximumNumberOfPeels(4);
    pane.renderer->UseFXAAOn();
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(0.85);
    lights->AddLightsToRenderer(pane.renderer);
    pane.renderer->AddViewProp(pane.title);
    window->AddRenderer(pane.renderer);
    m_panes.push_back(pane);
  }
  m_bar->SetVisibility(false);
  m_bar->SetNumberOfLabels(5);
  m_bar->SetOrientationToHorizontal();
  m_bar->SetPosition(0.3, 0.02);
  m_bar->SetWidth(0.4);
  m_bar->SetHeight(0.08);
  m_bar->SetTextPositionToPrecedeScalarBar(); // labels below, title above
  m_bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : {m_bar->GetLabelTextProperty(), m_bar->GetTitleTextProperty()})
  {
    text->SetFontSize(13);
    text->SetColor(0.13, 0.15, 0.18);
    text->ItalicOff();
    text->ShadowOff();
    text->BoldOff();
  }
  m_bar->SetTitle(""); // VTK's own runs into the labels: ours stands above
  m_barTitle->GetTextProperty()->ShallowCopy(m_bar->GetLabelTextProperty());
  m_barTitle->GetTextProperty()->SetJustificationToCentered();
  m_barTitle->GetTextProperty()->SetVerticalJustificationToBottom();
  m_barTitle->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  m_barTitle->SetPosition(0.5, 0.115);
  m_barTitle->VisibilityOff();
  mainRenderer()->AddViewProp(m_bar);
  mainRenderer()->AddViewProp(m_barTitle);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.6);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  m_crosshair->SetMapper(mapper);
  m_crosshair->GetProperty()->SetColor(0.85, 0.1, 0.1);
  m_crosshair->VisibilityOff();
  m_crosshair->PickableOff();
  mainRenderer()->AddActor(m_crosshair);
  connect(m_objects, &qFaceToBoneObjects::listChanged, this, &qFaceToBoneThreeDView::rebuild);
  connect(m_objects, &qFaceToBoneObjects::objectChanged, this,
          &qFaceToBoneThreeDView::updateObject);
  connect(this, &QOpenGLWidget::frameSwapped, this,
          [this]
          {
            if (m_fitted && !m_renderPending)
              emit drawn();
          });
  setLayoutOfViews(Single);
  setPreset(ThreeQuarter);
}

qFaceToBoneThreeDView::~qFaceToBoneThreeDView()
{
  interactor()->RemoveObserver(m_renderRequests); // tools may keep the interactor
}

vtkRenderer* qFaceToBoneThreeDView::mainRenderer() const
{
  return m_panes.front().renderer;
}

/// Many changes, one picture; after the event that is being handled and before the next one.
void qFaceToBoneThreeDView::renderSoon()
{
  if (m_renderPending)
    return;
  m_renderPending = true;
  QMetaObject::invokeMethod(
      this, [this] { drawNow(); }, Qt::QueuedConnection);
}

void qFaceToBoneThreeDView::drawNow()
{
  m_renderPending = false;
  if (!m_fitted) // the first time that there is something to see
    fitCamera();
  placeSplit();
  renderWindow()->Render();
}

void qFaceToBoneThreeDView::paintGL()
{
  m_painting = true;
  QVTKOpenGLNativeWidget::paintGL();
  m_painting = false;
}

/// The widget itself asks while it is painted, as after its size has changed: it cannot wait.
void qFaceToBoneThreeDView::onRenderRequested()
{
  if (m_painting)
    drawNow();
  else
    renderSoon();
}

std::vector<QString> qFaceToBoneThreeDView::keysOf(std::size_t pane) const
{
  std::vector<QString> keys;
  for (const qFaceToBoneObject& object : m_objects->all())
  {
    bool shown = pane == 0;
    if (m_layout == Compare)
      shown = object.key == compareKeys[pane];
    if (shown)
      keys.push_back(object.key);
  }
  return keys;
}

void qFaceToBoneThreeDView::rebuild()
{
  for (std::size_t k = 0; k < m_panes.size(); ++k)
  {
    Pane& pane = m_panes[k];
    for (const auto& [key, actor] : pane.actors)
      pane.renderer->RemoveActor(actor);
    pane.actors.clear();
    for (const QString& key : keysOf(k))
    {
      auto actor = vtkSmartPointer<vtkActor>::New();
      vtkNew<vtkPolyDataMapper> mapper;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetInterpolationToPhong();
      actor->GetProperty()->SetSpecular(0.12);
      actor->GetProperty()->SetSpecularPower(18);
      pane.renderer->AddActor(actor);
      pane.actors[key] = actor;
      updateActor(actor, key);
    }
  }
  updateBar();
  if (m_objects->all().empty())
    m_fitted = false;
  renderSoon();
}

void qFaceToBoneThreeDView::updateObject(const QString& key)
{
  for (const Pane& pane : m_panes)
    if (const auto found = pane.actors.find(key); found != pane.actors.end())
      updateActor(found->second, key);
  updateBar();
  renderSoon();
}

void qFaceToBoneThreeDView::updateActor(vtkActor* actor, const QString& key)
{
  const qFaceToBoneObject* object = m_objects->find(key);
  auto* mapper = static_cast<vtkPolyDataMapper*>(actor->GetMapper());
  mapper->SetInputData(object->surface);
  actor->SetVisibility(object->visible || m_layout == Compare);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(object->colour.redF(), object->colour.greenF(), object->colour.blueF());
  look->SetOpacity(m_layout == Compare ? 1 : object->opacity);
  const bool mapped = !object->colourArray.isEmpty() &&
                      object->surface->GetPointData()->HasArray(qPrintable(object->colourArray));
  mapper->SetScalarVisibility(mapped);
  look->SetAmbient(mapped ? 0.3 : 0.1);
  look->SetDiffuse(mapped ? 0.65 : 0.9);
  if (mapped)
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(qPrintable(object->colourArray));
    mapper->SetLookupTable(object->diverging ? f2b::diverging_map(object->range)
                                             : f2b::sequential_map(object->range));
    mapper->UseLookupTableScalarRangeOn();
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(object->matrix.data());
  if (m_explode > 0 && key.startsWith("fragment/"))
  {
    // away from the bone that stays: forward and down, as the face's fragments lie in front of it
    const double* box = object->surface->GetBounds();
    const qFaceToBoneObject* stays = m_objects->find("uncut");
    double way[3] = {0, 1, -0.5};
    if (stays)
    {
      const double* b = stays->surface->GetBounds();
      for (int k = 0; k < 3; ++k)
        way[k] = 0.5 * (box[2 * k] + box[2 * k + 1] - b[2 * k] - b[2 * k + 1]);
    }
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    for (int k = 0; k < 3 && length > 0; ++k)
      matrix->SetElement(k, 3, matrix->GetElement(k, 3) + m_explode * way[k] / length);
  }
  actor->SetUserMatrix(matrix);
}

/// The bar belongs to the first visible object that is coloured by values.
void qFaceToBoneThreeDView::updateBar()
{
  m_bar->SetVisibility(false);
  m_barTitle->SetVisibility(false);
  for (const qFaceToBoneObject& object : m_objects->all())
  {
    if (object.colourArray.isEmpty() || !object.visible)
      continue;
    m_bar->SetLookupTable(object.diverging ? f2b::diverging_map(object.range)
                                           : f2b::sequential_map(object.range));
    m_barTitle->SetInput(qPrintable(
        object.colourArray == "unreached_mm"      ? tr("left of the target [mm]")
        : object.colourArray == "displacement_mm" ? tr("displacement, outward positive [mm]")
                                                  : object.colourArray));
    m_bar->SetVisibility(true);
    m_barTitle->SetVisibility(true);
    return;
  }
}

void qFaceToBoneThreeDView::setLayoutOfViews(Layout layout)
{
  static const char* const titles[] = {"Before", "Target", "Predicted"};
  m_layout = layout;
  for (int k = 0; k < 3; ++k)
  {
    Pane& pane = m_panes[static_cast<std::size_t>(k)];
    const bool drawn = layout == Compare || k == 0;
    pane.renderer->SetDraw(drawn);
    if (layout == Compare)
      pane.renderer->SetViewport(k / 3.0, 0, (k + 1) / 3.0, 1);
    else
      pane.renderer->SetViewport(0, 0, k == 0 ? 1 : 0.001, k == 0 ? 1 : 0.001);
    pane.title->SetInput(layout == Compare ? qPrintable(tr(titles[k])) : "");
  }
  const bool narrow = layout == Compare;
  m_bar->SetNumberOfLabels(narrow ? 3 : 5);
  m_bar->SetPosition(narrow ? 0.1 : 0.3, 0.02);
  m_bar->SetWidth(narrow ? 0.8 : 0.4);
  rebuild();
}

void qFaceToBoneThreeDView::setPreset(Preset preset)
{
  // towards the viewer, and up, in RAS
  static constexpr double sides[][6] = {{0, 1, 0, 0, 0, 1},       {1, 0, 0, 0, 0, 1},
                                        {-1, 0, 0, 0, 0, 1},      {0.75, 1, 0.15, 0, 0, 1},
                                        {0, 0.55, -1, 0, 1, 0.5}, {0, 0, 1, 0, 1, 0}};
  const double* s = sides[preset];
  vtkCamera* camera = mainRenderer()->GetActiveCamera();
  double focus[3];
  camera->GetFocalPoint(focus);
  camera->SetPosition(focus[0] + 500 * s[0], focus[1] + 500 * s[1], focus[2] + 500 * s[2]);
  camera->SetViewUp(s[3], s[4], s[5]);
  fit();
}

/// All of what is visible, with a little room, whatever the shape of the panes.
void qFaceToBoneThreeDView::fitCamera()
{
  vtkRenderer* renderer = mainRenderer();
  double box[6];
  renderer->ComputeVisiblePropBounds(box);
  if (box[0] <= box[1])
  {
    m_fitted = true;
    vtkCamera* camera = renderer->GetActiveCamera();
    double towards[3], up[3], right[3], middle[3];
    camera->GetDirectionOfProjection(towards);
    camera->OrthogonalizeViewUp();
    camera->GetViewUp(up);
    vtkMath::Cross(towards, up, right);
    double across = 0, high = 0;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = 0.5 * (box[2 * k] + box[2 * k + 1]);
      const double half = 0.5 * (box[2 * k + 1] - box[2 * k]);
      across += std::abs(right[k]) * half;
      high += std::abs(up[k]) * half;
    }
    const int panes = m_layout == Compare ? 3 : 1;
    const double aspect = double(std::max(1, width())) / std::max(1, panes * height());
    const double room = m_bar->GetVisibility() ? 0.16 : 0; // of the height, below: for the bar
    const double scale = 1.03 * std::max(high / (1 - room), across / aspect);
    const double raised = std::max(0.0, high - (1 - 2 * room) * scale);
    for (int k = 0; k < 3 && room > 0; ++k)
      middle[k] -= raised * up[k];
    camera->SetFocalPoint(middle);
    camera->SetPosition(middle[0] - 500 * towards[0], middle[1] - 500 * towards[1],
                        middle[2] - 500 * towards[2]);
    camera->SetParallelScale(scale);
  }
  for (const Pane& pane : m_panes)
    pane.renderer->ResetCameraClippingRange();
}

void qFaceToBoneThreeDView::fit()
{
  fitCamera();
  renderSoon();
}

void qFaceToBoneThreeDView::setExplode(double mm)
{
  m_explode = mm;
  for (const qFaceToBoneObject& object : m_objects->all())
    if (object.key.startsWith("fragment/"))
      updateObject(object.key);
}

void qFaceToBoneThreeDView::setCrosshair(const double point[3])
{
  m_crosshair->SetPosition(point[0], point[1], point[2]);
  m_crosshair->VisibilityOn();
  renderSoon();
}

void qFaceToBoneThreeDView::setSplit(double share)
{
  m_split = share;
  for (const char* key : {"target", "predicted"})
    if (m_objects->find(key))
      updateObject(key); // as the list says, where it is not split any more
  renderSoon();
}

/// Cuts target and predicted face at an upright plane of the picture.
void qFaceToBoneThreeDView::placeSplit()
{
  Pane& pane = m_panes.front();
  for (const char* key : {"target", "predicted"})
    if (const auto found = pane.actors.find(key); found != pane.actors.end())
      found->second->GetMapper()->RemoveAllClippingPlanes();
  if (m_layout != Single || m_split >= 1 || !pane.actors.count("predicted"))
    return;
  vtkRenderer* renderer = pane.renderer;
  const int* size = renderer->GetSize();
  double world[2][3];
  for (int k = 0; k < 2; ++k)
  {
    renderer->SetDisplayPoint(m_split * size[0] + k, 0.5 * size[1], 0.5);
    renderer->DisplayToWorld();
    const double* p = renderer->GetWorldPoint();
    for (int i = 0; i < 3; ++i)
      world[k][i] = p[i] / p[3];
  }
  const double right[3] = {world[1][0] - world[0][0], world[1][1] - world[0][1],
                           world[1][2] - world[0][2]};
  for (const bool predicted : {false, true})
  {
    const double sign = predicted ? 1 : -1;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(world[0]);
    plane->SetNormal(sign * right[0], sign * right[1], sign * right[2]);
    vtkActor* actor = pane.actors.at(predicted ? "predicted" : "target");
    actor->GetMapper()->AddClippingPlane(plane);
    actor->GetProperty()->SetOpacity(1); // two faces are compared, not what lies in them
    actor->VisibilityOn();
  }
}

bool qFaceToBoneThreeDView::savePicture(const QString& path)
{
  drawNow();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(renderWindow());
  grab->ShouldRerenderOff();
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(path.toLocal8Bit().constData());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
