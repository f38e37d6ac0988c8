#include "qFaceToBoneCutTools.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneCut.h"
#include "qFaceToBoneThreeDView.h"
#include "vtkFaceToBoneCurveWidget.h"
#include "vtkFaceToBonePlaneWidget.h"
#include "vtkFaceToBoneSawWidget.h"

#include <QScopedValueRollback>
#include <QTimer>

#include <vtkCommand.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace
{

using Point = std::array<double, 3>;

/// Of a line that has just been drawn.
constexpr double overrunMm = 4;

Point toPoint(const f2b::Vec3& p)
{
  return {p.x(), p.y(), p.z()};
}

std::vector<Point> toPoints(const std::vector<f2b::Vec3>& all)
{
  std::vector<Point> points;
  for (const f2b::Vec3& p : all)
    points.push_back(toPoint(p));
  return points;
}

std::vector<f2b::Vec3> toVectors(const std::vector<Point>& all)
{
  std::vector<f2b::Vec3> points;
  for (const Point& p : all)
    points.emplace_back(p.data());
  return points;
}

Point colourOf(int cut)
{
  const QColor colour = qFaceToBoneCuts::colour(cut).darker(125);
  return {colour.redF(), colour.greenF(), colour.blueF()};
}

/// The line as its tool has it now.
void readLine(vtkFaceToBoneCurveRepresentation* look, qFaceToBoneCutCurve& curve)
{
  curve.handles = toVectors(look->GetControlPoints());
  curve.saw.closed = look->GetClosed();
  curve.line = toVectors(look->GetCurve());
  curve.settle();
}

void readSaw(vtkFaceToBoneSawRepresentation* look, qFaceToBoneCutCurve& curve)
{
  curve.saw.direction = f2b::Vec3(look->GetDirection().data());
  curve.saw.depth_mm = look->GetDepth();
  curve.turned = true;
  curve.settle();
}

void showSaw(vtkFaceToBoneSawRepresentation* look, const qFaceToBoneCutCurve& curve)
{
  look->SetLine(toPoints(curve.saw.points), curve.saw.closed);
  look->SetDirection(toPoint(curve.saw.direction));
  look->SetReach(curve.saw.lead_mm, curve.saw.depth_mm);
}

bool isHeld(vtkFaceToBoneToolWidget* tool)
{
  return tool && tool->GetWidgetState() != vtkFaceToBoneToolWidget::Start;
}

} // namespace

qFaceToBoneCutTools::qFaceToBoneCutTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view,
                                         QObject* parent)
    : QObject(parent), m_case(work), m_view(view),
      m_pen(vtkSmartPointer<vtkFaceToBoneCurveWidget>::New()),
      m_penSaw(vtkSmartPointer<vtkFaceToBoneSawWidget>::New())
{
  for (vtkFaceToBoneToolWidget* tool : {static_cast<vtkFaceToBoneToolWidget*>(m_pen),
                                        static_cast<vtkFaceToBoneToolWidget*>(m_penSaw)})
  {
    tool->SetInteractor(view->interactor());
    tool->SetDefaultRenderer(view->mainRenderer());
    tool->GetRepresentation();
  }
  m_pen->AddObserver(vtkCommand::InteractionEvent, this, &qFaceToBoneCutTools::penMoved);
  m_pen->AddObserver(vtkCommand::EndInteractionEvent, this, &qFaceToBoneCutTools::penFinished);
  connect(m_case->cuts(), &qFaceToBoneCuts::changed, this, &qFaceToBoneCutTools::update);
  connect(m_case, &qFaceToBoneCase::loaded, this,
          [this]
          {
            dropDrawing();
            m_bone = nullptr;
            m_layout.clear();
            update();
          });
}

qFaceToBoneCutTools::~qFaceToBoneCutTools()
{
  drop();
  m_pen->SetInteractor(nullptr);
  m_penSaw->SetInteractor(nullptr);
}

void qFaceToBoneCutTools::drop()
{
  for (const Part& part : m_parts)
    for (vtkFaceToBoneToolWidget* tool : {static_cast<vtkFaceToBoneToolWidget*>(part.plane),
                                          static_cast<vtkFaceToBoneToolWidget*>(part.line),
                                          static_cast<vtkFaceToBoneToolWidget*>(part.saw)})
      if (tool)
      {
        tool->RemoveAllObservers();
        tool->SetEnabled(0);
        tool->SetInteractor(nullptr);
      }
  m_parts.clear();
  if (m_dragging)
    m_case->cuts()->endDrag();
  m_dragging = false;
}

/// Which tools there have to be.
auto qFaceToBoneCutTools::layout() const -> Layout
{
  Layout all;
  if (!m_shown)
    return all;
  all.push_back({m_case->cuts()->current()});
  for (const qFaceToBoneCut& cut : m_case->cuts()->all())
  {
    all.push_back({static_cast<int>(cut.planes.size()), cut.problem.empty()});
    for (const qFaceToBoneCutCurve& curve : cut.curves)
      all.push_back({curve.onBone});
  }
  return all;
}

/// The tool that is held leads and is left alone. No tool goes while it is speaking.
void qFaceToBoneCutTools::update()
{
  if (layout() == m_layout)
  {
    for (Part& part : m_parts)
      place(part);
    return m_view->renderSoon();
  }
  if (m_speaking)
    QTimer::singleShot(0, this, &qFaceToBoneCutTools::update);
  else
    rebuild();
}

bool qFaceToBoneCutTools::readBone()
{
  vtkPolyData* bone = m_case->bone();
  if (bone && bone != m_bone)
    m_pen->GetCurveRepresentation()->SetSurface(bone);
  m_bone = bone;
  return bone != nullptr;
}

void qFaceToBoneCutTools::rebuild()
{
  drop();
  m_layout = layout();
  if (m_shown && m_case->bone())
  {
    const auto& cuts = m_case->cuts()->all();
    for (int c = 0; c < static_cast<int>(cuts.size()); ++c)
    {
      const qFaceToBoneCut& cut = cuts[static_cast<std::size_t>(c)];
      for (int k = 0; k < static_cast<int>(cut.planes.size()); ++k)
        addPlane(c, k);
      for (int k = 0; k < static_cast<int>(cut.curves.size()); ++k)
        addLine(c, k);
      if (c == m_case->cuts()->current() && cut.problem.empty())
        addBall(c);
    }
    for (Part& part : m_parts)
      place(part);
  }
  m_view->renderSoon();
}

/// Small things that are held before large ones that they may lie on.
template <class Tool>
vtkSmartPointer<Tool> qFaceToBoneCutTools::makeTool(bool current, float priority)
{
  auto tool = vtkSmartPointer<Tool>::New();
  tool->SetInteractor(m_view->interactor());
  tool->SetDefaultRenderer(m_view->mainRenderer());
  tool->SetProcessEvents(current && !m_drawing);
  tool->SetPriority(priority);
  tool->GetRepresentation();
  tool->AddObserver(vtkCommand::StartInteractionEvent, this, &qFaceToBoneCutTools::dragBegan);
  tool->AddObserver(vtkCommand::InteractionEvent, this, &qFaceToBoneCutTools::partMoved);
  tool->AddObserver(vtkCommand::EndInteractionEvent, this, &qFaceToBoneCutTools::dragEnded);
  return tool;
}

void qFaceToBoneCutTools::addPlane(int cut, int index)
{
  const bool current = cut == m_case->cuts()->current();
  Part part;
  part.cut = cut;
  part.index = index;
  part.plane = makeTool<vtkFaceToBonePlaneWidget>(current, 0.5f);
  part.plane->GetPlaneRepresentation()->SetColour(colourOf(cut));
  part.plane->GetPlaneRepresentation()->SetHandlesShown(current);
  part.plane->SetEnabled(1);
  m_parts.push_back(part);
}

void qFaceToBoneCutTools::addLine(int cut, int index)
{
  const bool current = cut == m_case->cuts()->current();
  const qFaceToBoneCutCurve& curve =
      m_case->cuts()->all()[static_cast<std::size_t>(cut)].curves[static_cast<std::size_t>(index)];
  Part part;
  part.cut = cut;
  part.index = index;
  part.line = makeTool<vtkFaceToBoneCurveWidget>(current, 0.65f);
  part.line->SetDrawing(false);
  vtkFaceToBoneCurveRepresentation* look = part.line->GetCurveRepresentation();
  look->SetColour(colourOf(cut));
  look->SetHandlesShown(current);
  look->SetFree(!curve.onBone);
  if (curve.onBone && readBone())
    look->ShareSurface(*m_pen->GetCurveRepresentation());
  part.saw = makeTool<vtkFaceToBoneSawWidget>(current, 0.6f);
  part.saw->GetSawRepresentation()->SetColour(colourOf(cut));
  part.saw->GetSawRepresentation()->SetHandlesShown(current);
  part.saw->SetEnabled(1);
  part.line->SetEnabled(1);
  m_parts.push_back(part);
}

/// On the piece that is to be free.
void qFaceToBoneCutTools::addBall(int cut)
{
  Part part;
  part.cut = cut;
  part.line = makeTool<vtkFaceToBoneCurveWidget>(true, 0.8f);
  part.line->SetDrawing(false);
  vtkFaceToBoneCurveRepresentation* look = part.line->GetCurveRepresentation();
  const QColor colour = qFaceToBoneCuts::colour(cut);
  look->SetBall({colour.redF(), colour.greenF(), colour.blueF()});
  if (readBone())
    look->ShareSurface(*m_pen->GetCurveRepresentation());
  part.line->SetEnabled(1);
  m_parts.push_back(part);
}

/// Puts a part's tools where the cut has it.
void qFaceToBoneCutTools::place(Part& part)
{
  const qFaceToBoneCut& cut = m_case->cuts()->all()[static_cast<std::size_t>(part.cut)];
  const auto index = static_cast<std::size_t>(part.index);
  if (part.plane && !isHeld(part.plane))
  {
    part.plane->GetPlaneRepresentation()->SetKerf(cut.kerf);
    part.plane->GetPlaneRepresentation()->SetPlane(cut.planes[index]);
  }
  if (part.saw)
  {
    const qFaceToBoneCutCurve& curve = cut.curves[index];
    vtkFaceToBoneCurveRepresentation* look = part.line->GetCurveRepresentation();
    if (!isHeld(part.line) && toVectors(look->GetControlPoints()) != curve.handles)
      look->SetControlPoints(toPoints(curve.handles), curve.saw.closed);
    if (!isHeld(part.saw))
      showSaw(part.saw->GetSawRepresentation(), curve);
  }
  if (part.line && !part.saw && !isHeld(part.line))
  {
    part.line->GetCurveRepresentation()->SetControlPoints({toPoint(cut.point)}, false);
    part.line->GetCurveRepresentation()->SetName("free piece: " + cut.fragment);
  }
}

void qFaceToBoneCutTools::partMoved(vtkObject* tool, unsigned long, void*)
{
  const QScopedValueRollback<bool> speaking(m_speaking, true);
  qFaceToBoneCuts* cuts = m_case->cuts();
  for (const Part& part : m_parts)
  {
    if (part.plane && part.plane == tool)
      cuts->setPlane(part.cut, part.index, part.plane->GetPlaneRepresentation()->GetPlane());
    else if (part.line && part.line == tool && !part.saw)
      cuts->setPoint(part.cut, part.line->GetCurveRepresentation()->GetControlPoint(0));
    else if (part.saw && (part.saw == tool || part.line == tool))
    {
      qFaceToBoneCutCurve curve = cuts->all()[static_cast<std::size_t>(part.cut)]
                                      .curves[static_cast<std::size_t>(part.index)];
      if (part.saw == tool)
        readSaw(part.saw->GetSawRepresentation(), curve);
      else
        readLine(part.line->GetCurveRepresentation(), curve);
      cuts->setCurve(part.cut, part.index, curve);
    }
    else
      continue;
    return tellClearance();
  }
}

void qFaceToBoneCutTools::dragBegan(vtkObject*, unsigned long, void*)
{
  m_dragging = true;
  m_case->cuts()->beginDrag();
}

void qFaceToBoneCutTools::dragEnded(vtkObject*, unsigned long, void*)
{
  m_dragging = false;
  m_case->cuts()->endDrag();
  emit told("");
}

void qFaceToBoneCutTools::tellClearance()
{
  QStringList near;
  for (const qFaceToBoneCuts::Clearance& c : m_case->cuts()->clearances())
    if (c.near)
      near << tr("%1: %2").arg(c.name, c.words);
  emit told(near.join("; "));
}

void qFaceToBoneCutTools::show(bool on)
{
  if (!on)
    dropDrawing();
  m_shown = on;
  update();
}

vtkFaceToBoneCurveWidget* qFaceToBoneCutTools::pen() const
{
  return m_pen;
}

bool qFaceToBoneCutTools::startDrawing(bool ofCurrent)
{
  if (!readBone())
    return false;
  m_ofCurrent = ofCurrent && m_case->cuts()->current() >= 0;
  m_drawing = true;
  vtkFaceToBoneCurveRepresentation* look = m_pen->GetCurveRepresentation();
  look->Clear();
  const int cut = m_ofCurrent ? m_case->cuts()->current() : m_case->cuts()->count();
  look->SetColour(colourOf(cut));
  m_penSaw->GetSawRepresentation()->SetColour(colourOf(cut));
  m_penSaw->GetSawRepresentation()->SetLine({}, false);
  m_penSaw->SetEnabled(1);
  m_pen->SetEnabled(1);
  rebuild(); // what is there is not dragged meanwhile
  emit drawingChanged(true);
  return true;
}

/// The saw goes straight into the bone, until it is turned by its hand.
void qFaceToBoneCutTools::penMoved(vtkObject*, unsigned long, void*)
{
  vtkFaceToBoneCurveRepresentation* look = m_pen->GetCurveRepresentation();
  vtkFaceToBoneSawRepresentation* saw = m_penSaw->GetSawRepresentation();
  saw->SetDirection(look->GetInwards());
  saw->SetLine(look->GetCurve(), look->GetClosed());
}

void qFaceToBoneCutTools::penFinished(vtkObject*, unsigned long, void*)
{
  QTimer::singleShot(0, this, [this] { finishDrawing(); }); // the pen is still at work
}

bool qFaceToBoneCutTools::finishDrawing()
{
  vtkFaceToBoneCurveRepresentation* look = m_pen->GetCurveRepresentation();
  if (!m_drawing || look->GetNumberOfControlPoints() < 2)
    return false;
  qFaceToBoneCutCurve curve;
  curve.onBone = true;
  curve.overrun = overrunMm;
  readSaw(m_penSaw->GetSawRepresentation(), curve);
  readLine(look, curve);
  f2b::Vec3 middle = f2b::Vec3::Zero();
  for (const f2b::Vec3& p : curve.saw.points)
    middle += p / static_cast<double>(curve.saw.points.size());
  if (!curve.saw.closed)
    middle -= f2b::Vec3(0, 0, 8); // below the line, until the ball is dragged elsewhere
  const Point free = look->NearestOnBone(toPoint(middle));
  const bool ofCurrent = m_ofCurrent;
  dropDrawing();
  if (!m_case->cuts()->addCurve(curve, free, ofCurrent))
    emit told(m_case->cuts()->error());
  return true;
}

void qFaceToBoneCutTools::dropDrawing()
{
  if (!m_drawing)
    return;
  m_drawing = false;
  m_pen->SetEnabled(0);
  m_penSaw->SetEnabled(0);
  rebuild();
  emit drawingChanged(false);
}
