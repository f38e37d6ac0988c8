#include "qFaceToBonePointTools.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneLandmarksPanel.h"
#include "qFaceToBoneMeasuresPanel.h"
#include "qFaceToBoneRulers.h"
#include "qFaceToBoneSculptPanel.h"
#include "qFaceToBoneThreeDView.h"

#include <QMessageBox>

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <cstdio>

vtkSmartPointer<vtkFaceToBonePointsWidget> qFaceToBonePointTools::make()
{
  auto tool = vtkSmartPointer<vtkFaceToBonePointsWidget>::New();
  tool->SetInteractor(m_view->interactor());
  tool->SetDefaultRenderer(m_view->mainRenderer());
  tool->CreateDefaultRepresentation();
  tool->GetPointsRepresentation()->SetRenderer(m_view->mainRenderer());
  return tool;
}

qFaceToBonePointTools::qFaceToBonePointTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view,
                                             qFaceToBoneLandmarksPanel* landmarks,
                                             qFaceToBoneSculptPanel* sculpt,
                                             qFaceToBoneMeasuresPanel* measures, QObject* parent)
    : QObject(parent), m_case(work), m_view(view), m_landmarksPanel(landmarks),
      m_sculptPanel(sculpt), m_measuresPanel(measures), m_landmarks(make()), m_handles(make()),
      m_placing(make())
{
  m_landmarks->GetPointsRepresentation()->SetColour({0.1, 0.3, 0.75});
  m_landmarks->AddObserver(vtkCommand::PlacePointEvent, this,
                           &qFaceToBonePointTools::landmarkPlaced);
  m_landmarks->AddObserver(vtkCommand::EndInteractionEvent, this,
                           &qFaceToBonePointTools::landmarkMoved);
  m_handles->SetOnSurface(false);
  m_handles->SetPriority(0.6F); // before the brush, where the two overlap
  m_handles->GetPointsRepresentation()->SetColour({0.05, 0.45, 0.3});
  m_handles->AddObserver(vtkCommand::StartInteractionEvent, this,
                         &qFaceToBonePointTools::handleHeld);
  m_handles->AddObserver(vtkCommand::InteractionEvent, this, &qFaceToBonePointTools::handleMoved);
  m_handles->AddObserver(vtkCommand::EndInteractionEvent, this, &qFaceToBonePointTools::handleLeft);
  m_placing->SetPriority(0.7F);
  m_placing->GetPointsRepresentation()->SetRuler(true);
  m_placing->AddObserver(vtkCommand::PlacePointEvent, this, &qFaceToBonePointTools::rulerPlaced);
  connect(m_landmarksPanel, &qFaceToBoneLandmarksPanel::placingChanged, this,
          &qFaceToBonePointTools::update);
  connect(m_case, &qFaceToBoneCase::landmarksChanged, this, &qFaceToBonePointTools::update);
  connect(m_case, &qFaceToBoneCase::skinChanged, this, &qFaceToBonePointTools::updateHandles);
  connect(m_case, &qFaceToBoneCase::loaded, this, &qFaceToBonePointTools::update);
  connect(m_sculptPanel, &qFaceToBoneSculptPanel::handlesShown, this,
          &qFaceToBonePointTools::update);
  connect(m_case->rulers(), &qFaceToBoneRulers::changed, this,
          &qFaceToBonePointTools::updateRulers);
  connect(m_case->objects(), &qFaceToBoneObjects::objectChanged, this,
          [this](const QString& key)
          {
            if (key.startsWith("ruler/"))
              updateRulers();
          });
  connect(m_case->objects(), &qFaceToBoneObjects::removeWanted, this,
          [this](const QString& key)
          {
            if (m_case->rulers()->remove(key))
              keepRulers();
          });
  connect(m_measuresPanel, &qFaceToBoneMeasuresPanel::rulerWanted, this,
          [this](int points)
          {
            m_placing->SetWanted(points);
            m_placing->GetPointsRepresentation()->SetPoints({});
            m_placing->SetEnabled(points > 0);
            m_view->renderSoon();
          });
}

qFaceToBonePointTools::~qFaceToBonePointTools()
{
  for (const auto& tool : m_rulers)
    tool->SetInteractor(nullptr);
  for (const auto& tool : {m_landmarks, m_handles, m_placing})
    tool->SetInteractor(nullptr);
}

void qFaceToBonePointTools::showLandmarks(bool on)
{
  m_showLandmarks = on;
  if (!on)
    m_landmarksPanel->stopPlacing();
  update();
}

void qFaceToBonePointTools::showHandles(bool on)
{
  m_showHandles = on;
  update();
}

void qFaceToBonePointTools::update()
{
  updateLandmarks();
  updateHandles();
}

void qFaceToBonePointTools::updateLandmarks()
{
  const bool shown = m_showLandmarks && m_case->isOpen();
  if (bool(m_landmarks->GetEnabled()) != shown)
    m_landmarks->SetEnabled(shown);
  if (shown && m_landmarks->GetWidgetState() == vtkFaceToBonePointsWidget::Start)
  {
    std::vector<std::array<double, 3>> points;
    std::vector<std::string> names;
    m_landmarkNames.clear();
    for (const qFaceToBoneCase::Landmark& landmark : m_case->landmarks())
      if (landmark.placed)
      {
        points.push_back(landmark.at);
        names.push_back(landmark.name.toStdString());
        m_landmarkNames.push_back(landmark.name);
      }
    m_landmarks->GetPointsRepresentation()->SetPoints(points, names);
    m_landmarks->SetWanted(m_landmarksPanel->isPlacing() ? int(points.size()) + 1 : 0);
  }
  m_view->renderSoon();
}

/// With every move of the brush.
void qFaceToBonePointTools::updateHandles()
{
  const bool wanted = m_showHandles && m_sculptPanel->showsHandles() && m_case->sculpting();
  if (!wanted && !m_handles->GetEnabled())
    return;
  if (m_handles->GetWidgetState() == vtkFaceToBonePointsWidget::Start)
  {
    std::vector<std::array<double, 3>> points;
    std::vector<std::string> names;
    for (const QString& name : wanted ? m_case->faceLandmarks() : QStringList())
    {
      points.push_back(m_case->landmarkOnFace(name));
      names.push_back(name.toStdString());
    }
    m_handles->GetPointsRepresentation()->SetPoints(points, names);
    if (bool(m_handles->GetEnabled()) != wanted)
      m_handles->SetEnabled(wanted);
  }
  m_view->renderSoon();
}

void qFaceToBonePointTools::landmarkPlaced(vtkObject*, unsigned long, void*)
{
  const auto point = m_landmarks->GetPointsRepresentation()->GetPoints().back();
  if (!m_case->placeLandmark(m_landmarksPanel->current(), point))
    QMessageBox::warning(m_view, tr("Landmarks"), m_case->error());
  m_landmarksPanel->advance();
}

void qFaceToBonePointTools::landmarkMoved(vtkObject*, unsigned long, void*)
{
  const auto held = static_cast<std::size_t>(m_landmarks->GetHeld());
  if (held >= m_landmarkNames.size())
    return;
  const auto point = m_landmarks->GetPointsRepresentation()->GetPoints()[held];
  m_landmarksPanel->setCurrent(m_landmarkNames[held]);
  if (m_landmarks->GetDragged() == std::array<double, 3>{}) // only taken hold of
    return;
  if (!m_case->placeLandmark(m_landmarkNames[held], point))
    QMessageBox::warning(m_view, tr("Landmarks"), m_case->error());
}

void qFaceToBonePointTools::handleHeld(vtkObject*, unsigned long, void*)
{
  vtkFaceToBonePointsRepresentation* shown = m_handles->GetPointsRepresentation();
  m_case->beginDrag(shown->GetPoints()[static_cast<std::size_t>(m_handles->GetHeld())],
                    m_sculptPanel->warpRadius(), m_sculptPanel->isSymmetric());
}

void qFaceToBonePointTools::handleMoved(vtkObject*, unsigned long, void*)
{
  const auto by = m_handles->GetDragged();
  m_case->drag(by);
  char text[96];
  std::snprintf(text, sizeof text, "R %+.1f  A %+.1f  S %+.1f mm", by[0], by[1], by[2]);
  const int* at = m_view->interactor()->GetEventPosition();
  m_handles->GetPointsRepresentation()->ShowText(text, at[0], at[1]);
}

void qFaceToBonePointTools::handleLeft(vtkObject*, unsigned long, void*)
{
  m_case->endDrag(m_handles->GetDragged() != std::array<double, 3>{});
  update();
}

void qFaceToBonePointTools::rulerPlaced(vtkObject*, unsigned long, void*)
{
  const auto points = m_placing->GetPointsRepresentation()->GetPoints();
  if (static_cast<int>(points.size()) < m_placing->GetWanted())
    return;
  m_placing->SetWanted(0);
  m_placing->GetPointsRepresentation()->SetPoints({});
  m_case->rulers()->add(points);
  keepRulers();
  m_measuresPanel->rulerPlaced();
}

void qFaceToBonePointTools::rulerMoved(vtkObject* tool, unsigned long, void*)
{
  const auto& rulers = m_case->rulers()->all();
  for (std::size_t k = 0; k < m_rulers.size() && k < rulers.size(); ++k)
    if (m_rulers[k] == tool)
      m_case->rulers()->setPoints(rulers[k].key,
                                  m_rulers[k]->GetPointsRepresentation()->GetPoints());
}

void qFaceToBonePointTools::rulerLeft(vtkObject*, unsigned long, void*)
{
  keepRulers();
}

void qFaceToBonePointTools::keepRulers()
{
  try
  {
    m_case->rulers()->keep();
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(m_view, tr("Measures"), QString::fromUtf8(error.what()));
  }
}

/// One tool a ruler; the one that is held leads and is left alone.
void qFaceToBonePointTools::updateRulers()
{
  const auto& rulers = m_case->rulers()->all();
  while (m_rulers.size() > rulers.size())
  {
    m_rulers.back()->SetEnabled(0);
    m_rulers.back()->SetInteractor(nullptr);
    m_rulers.pop_back();
  }
  while (m_rulers.size() < rulers.size())
  {
    m_rulers.push_back(make());
    m_rulers.back()->GetPointsRepresentation()->SetRuler(true);
    m_rulers.back()->AddObserver(vtkCommand::InteractionEvent, this,
                                 &qFaceToBonePointTools::rulerMoved);
    m_rulers.back()->AddObserver(vtkCommand::EndInteractionEvent, this,
                                 &qFaceToBonePointTools::rulerLeft);
  }
  for (std::size_t k = 0; k < rulers.size(); ++k)
  {
    if (m_rulers[k]->GetWidgetState() != vtkFaceToBonePointsWidget::Start)
      continue;
    const qFaceToBoneObject* object = m_case->objects()->find(rulers[k].key);
    m_rulers[k]->GetPointsRepresentation()->SetPoints(rulers[k].points);
    if (object)
      m_rulers[k]->GetPointsRepresentation()->SetColour(
          {object->colour.redF(), object->colour.greenF(), object->colour.blueF()});
    const bool visible = object && object->visible;
    if (bool(m_rulers[k]->GetEnabled()) != visible)
      m_rulers[k]->SetEnabled(visible);
  }
  m_view->renderSoon();
}
