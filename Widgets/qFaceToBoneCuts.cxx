#include "qFaceToBoneCutsState.h"

#include <Bridge/markups.hpp>
#include <QFileInfo>

#include <algorithm>

namespace
{

using nlohmann::json;

constexpr int mostUndo = 200;

json keyOf(const std::vector<qFaceToBoneCut>& cuts)
{
  json key = json::array();
  for (const qFaceToBoneCut& cut : cuts)
    key.push_back(qFaceToBoneKeyOf(cut));
  return key;
}

json rulesOf(const std::vector<qFaceToBoneCut>& cuts)
{
  json key = json::array();
  for (const qFaceToBoneCut& cut : cuts)
    key.push_back(cut.movement);
  return key;
}

} // namespace

qFaceToBoneCuts::qFaceToBoneCuts(QObject* parent)
    : QObject(parent), m_now(std::make_unique<State>()), m_loaded(std::make_unique<State>())
{
}

qFaceToBoneCuts::~qFaceToBoneCuts() = default;

QStringList qFaceToBoneCuts::templates()
{
  QStringList names;
  for (const std::string& name : f2b::osteotomy_template_names())
    names << QString::fromStdString(name);
  return names;
}

QString qFaceToBoneCuts::titleOf(const QString& name)
{
  static const std::map<QString, const char*> titles = {
      {"le-fort-1", QT_TR_NOOP("Le Fort I")},
      {"le-fort-2", QT_TR_NOOP("Le Fort II")},
      {"le-fort-3", QT_TR_NOOP("Le Fort III")},
      {"bsso", QT_TR_NOOP("Sagittal split (BSSO)")},
      {"bsso-right", QT_TR_NOOP("Sagittal split: right ramus")},
      {"bsso-left", QT_TR_NOOP("Sagittal split: left ramus")},
      {"genioplasty", QT_TR_NOOP("Genioplasty")},
      {"zygoma-right", QT_TR_NOOP("Zygoma, right")},
      {"zygoma-left", QT_TR_NOOP("Zygoma, left")}};
  const auto found = titles.find(name);
  return found == titles.end() ? name : tr(found->second);
}

QColor qFaceToBoneCuts::colour(int cut)
{
  static const QColor colours[] = {{230, 159, 0}, {86, 180, 233}, {0, 158, 115},  {204, 121, 167},
                                   {0, 114, 178}, {213, 94, 0},   {240, 228, 66}, {120, 94, 180}};
  return colours[std::max(0, cut) % MostCuts];
}

bool qFaceToBoneCuts::fail(const QString& message)
{
  m_error = message;
  return false;
}

bool qFaceToBoneCuts::has(int cut) const
{
  return cut >= 0 && cut < count();
}

const std::vector<qFaceToBoneCut>& qFaceToBoneCuts::all() const
{
  return m_now->cuts;
}

int qFaceToBoneCuts::count() const
{
  return static_cast<int>(m_now->cuts.size());
}

void qFaceToBoneCuts::load(const json& document, const json& unfinished,
                           const std::string& landmarksFile)
{
  m_landmarksFile = landmarksFile;
  f2b::Landmarks landmarks;
  try
  {
    if (!landmarksFile.empty() && QFileInfo::exists(QString::fromStdString(landmarksFile)))
      landmarks = f2b::read_landmarks(landmarksFile);
  }
  catch (const std::exception& error) // templates will miss them, and say so
  {
    m_error = QString::fromUtf8(error.what());
  }
  const auto stateOf = [&](const json& from)
  {
    State state;
    for (const json& osteotomy : from.value("osteotomies", json::array()))
      state.cuts.push_back(qFaceToBoneReadCut(osteotomy, landmarks));
    state.spared = qFaceToBoneReadSpared(from);
    return state;
  };
  *m_loaded = stateOf(document);
  *m_now = unfinished.is_object() ? stateOf(unfinished) : *m_loaded;
  m_undo.clear();
  m_redo.clear();
  m_structures.clear();
  m_clearancesKnown = false;
  m_dragging = false;
  m_current = m_now->cuts.empty() ? -1 : 0;
  emit changed();
  emit rulesChanged();
}

void qFaceToBoneCuts::clear()
{
  load(json::object(), json(), "");
}

json qFaceToBoneCuts::osteotomies(const std::string& folder) const
{
  json written = json::array();
  for (const qFaceToBoneCut& cut : m_now->cuts)
    written.push_back(qFaceToBoneWriteCut(cut, folder));
  return written;
}

json qFaceToBoneCuts::spared() const
{
  return qFaceToBoneWriteSpared(m_now->spared);
}

bool qFaceToBoneCuts::isMoved() const
{
  return keyOf(m_now->cuts) != keyOf(m_loaded->cuts);
}

bool qFaceToBoneCuts::isChanged() const
{
  return isMoved() || rulesOf(m_now->cuts) != rulesOf(m_loaded->cuts) ||
         spared() != qFaceToBoneWriteSpared(m_loaded->spared);
}

void qFaceToBoneCuts::keepRules()
{
  for (qFaceToBoneCut& cut : m_loaded->cuts)
    cut.movement = movementOf(cut.fragment);
}

void qFaceToBoneCuts::setCurrent(int cut)
{
  if (!has(cut) || cut == m_current)
    return;
  m_current = cut;
  emit changed();
}

void qFaceToBoneCuts::beginDrag()
{
  m_dragging = true;
  m_remembered = false;
}

/// A drag that was taken back is no step of undo.
void qFaceToBoneCuts::endDrag()
{
  if (m_dragging && m_remembered && !m_undo.empty() &&
      keyOf(m_undo.back().cuts) == keyOf(m_now->cuts))
    m_undo.pop_back();
  m_dragging = m_remembered = false;
}

/// Before a change: what there was, for undo.
void qFaceToBoneCuts::remember()
{
  if (m_dragging && m_remembered)
    return;
  m_remembered = true;
  m_now->current = m_current;
  m_undo.push_back(*m_now);
  if (m_undo.size() > mostUndo)
    m_undo.erase(m_undo.begin());
  m_redo.clear();
}

qFaceToBoneCut* qFaceToBoneCuts::editable(int cut)
{
  if (!has(cut))
    return nullptr;
  remember();
  return &m_now->cuts[static_cast<std::size_t>(cut)];
}

void qFaceToBoneCuts::told(bool rules)
{
  m_error.clear();
  m_clearancesKnown = false;
  m_current = std::max(std::min(m_current, count() - 1), count() > 0 ? 0 : -1);
  emit changed();
  if (rules)
    emit rulesChanged();
}

bool qFaceToBoneCuts::canUndo() const
{
  return !m_undo.empty();
}

bool qFaceToBoneCuts::canRedo() const
{
  return !m_redo.empty();
}

bool qFaceToBoneCuts::step(std::vector<State>& from, std::vector<State>& to)
{
  if (from.empty() || m_dragging)
    return false;
  const json rules = rulesOf(m_now->cuts);
  m_now->current = m_current;
  to.push_back(*m_now);
  *m_now = from.back();
  from.pop_back();
  m_current = m_now->current;
  told(rules != rulesOf(m_now->cuts));
  return true;
}

bool qFaceToBoneCuts::undo()
{
  return step(m_undo, m_redo);
}

bool qFaceToBoneCuts::redo()
{
  return step(m_redo, m_undo);
}

qFaceToBoneRules qFaceToBoneCuts::rules(const QString& fragment) const
{
  return qFaceToBoneRulesFrom(movementOf(fragment.toStdString()));
}

json qFaceToBoneCuts::movementOf(const std::string& fragment) const
{
  for (const qFaceToBoneCut& cut : m_now->cuts)
    if (cut.fragment == fragment)
      return cut.movement;
  return {};
}
