#include "qFaceToBoneCutsState.h"

#include <Bridge/markups.hpp>
#include <Case/case_settings.hpp>

#include <QRegularExpression>

#include <algorithm>

using nlohmann::json;

namespace
{

/// Parts that are called after their piece go with its name.
void renamePart(std::string& part, const std::string& from, const std::string& to)
{
  if (part.rfind(from + " line ", 0) == 0 || part.rfind(from + " plane ", 0) == 0)
    part.replace(0, from.size(), to);
}

} // namespace

/// The wish, or the wish with the first number that makes it a name of its own.
std::string qFaceToBoneCuts::freeName(const std::string& wish) const
{
  const auto taken = [this](const std::string& name)
  {
    return name == "predicted" ||
           std::any_of(m_now->cuts.begin(), m_now->cuts.end(),
                       [&](const qFaceToBoneCut& cut)
                       { return f2b::file_part(cut.fragment) == f2b::file_part(name); });
  };
  std::string name = wish;
  for (int k = 2; taken(name); ++k)
    name = wish + " " + std::to_string(k);
  return name;
}

bool qFaceToBoneCuts::addCut(qFaceToBoneCut cut)
{
  if (count() >= MostCuts)
    return fail(tr("A case has %1 cuts at most; remove one first").arg(MostCuts));
  cut.fragment = freeName(cut.fragment);
  remember();
  m_now->cuts.push_back(std::move(cut));
  m_current = count() - 1;
  told(true);
  return true;
}

bool qFaceToBoneCuts::addTemplate(const QString& name)
{
  f2b::Landmarks landmarks;
  try
  {
    if (!m_landmarksFile.empty())
      landmarks = f2b::read_landmarks(m_landmarksFile);
    const auto placed = f2b::osteotomy_from_template(name.toStdString(), "", landmarks, 1);
    const json settings = {{"template", name.toStdString()},
                           {"fragment", freeName(placed.fragment)}};
    return addCut(qFaceToBoneReadCut(settings, landmarks));
  }
  catch (const std::exception& error)
  {
    return fail(QString::fromUtf8(error.what()));
  }
}

bool qFaceToBoneCuts::addPlane(const Point& at, bool ofCurrent)
{
  f2b::BoundedPlane plane;
  plane.center = {at[0], at[1], at[2]};
  plane.half_u = plane.half_v = 30;
  if (ofCurrent && has(m_current))
  {
    qFaceToBoneCut* cut = editable(m_current);
    plane.name = cut->fragment + " plane " + std::to_string(cut->planes.size() + 1);
    cut->planes.push_back(plane);
    cut->setDrawn();
    told();
    return true;
  }
  qFaceToBoneCut cut;
  cut.fragment = freeName("piece");
  plane.name = cut.fragment + " plane 1";
  cut.planes.push_back(plane);
  cut.point = plane.center - f2b::Vec3(0, 0, 8);
  cut.setDrawn();
  return addCut(cut);
}

bool qFaceToBoneCuts::addCurve(const qFaceToBoneCutCurve& curve, const Point& free, bool ofCurrent)
{
  if (ofCurrent && has(m_current))
  {
    qFaceToBoneCut* cut = editable(m_current);
    cut->curves.push_back(curve);
    cut->curves.back().saw.name = cut->fragment + " line " + std::to_string(cut->curves.size());
    cut->setDrawn();
    told();
    return true;
  }
  qFaceToBoneCut cut;
  cut.fragment = freeName("piece");
  cut.curves.push_back(curve);
  cut.curves.back().saw.name = cut.fragment + " line 1";
  cut.point = {free[0], free[1], free[2]};
  cut.setDrawn();
  return addCut(cut);
}

bool qFaceToBoneCuts::remove(int cut)
{
  if (!editable(cut))
    return false;
  m_now->cuts.erase(m_now->cuts.begin() + cut);
  told(true);
  return true;
}

bool qFaceToBoneCuts::removePart(int index, int part)
{
  if (!has(index) || part < 0)
    return false;
  const qFaceToBoneCut& there = all()[static_cast<std::size_t>(index)];
  const int planes = static_cast<int>(there.planes.size());
  if (part >= planes + static_cast<int>(there.curves.size()))
    return false;
  qFaceToBoneCut* cut = editable(index);
  if (part < planes)
    cut->planes.erase(cut->planes.begin() + part);
  else
    cut->curves.erase(cut->curves.begin() + (part - planes));
  cut->setDrawn();
  told();
  return true;
}

bool qFaceToBoneCuts::rename(int index, const QString& fragment)
{
  static const QRegularExpression allowed("^[A-Za-z0-9][A-Za-z0-9 _-]{0,39}$");
  if (!has(index))
    return false;
  const std::string old = all()[static_cast<std::size_t>(index)].fragment;
  const std::string name = fragment.trimmed().toStdString();
  if (name == old)
    return true;
  if (!allowed.match(QString::fromStdString(name)).hasMatch())
    return fail(
        tr("'%1' cannot be a piece's name; use letters, digits, spaces, - and _, at most 40")
            .arg(fragment));
  const bool sameFile = f2b::file_part(name) == f2b::file_part(old);
  if (!sameFile && freeName(name) != name)
    return fail(tr("Another piece is called '%1'; choose another name").arg(fragment));
  qFaceToBoneCut* renamed = editable(index);
  renamed->fragment = name;
  for (f2b::BoundedPlane& plane : renamed->planes)
    renamePart(plane.name, old, name);
  for (qFaceToBoneCutCurve& curve : renamed->curves)
    renamePart(curve.saw.name, old, name);
  for (qFaceToBoneCut& cut : m_now->cuts)
    if (cut.movement.is_object() && cut.movement.contains("bite") &&
        cut.movement["bite"].value("with", std::string()) == old)
      cut.movement["bite"]["with"] = name;
  told(true);
  return true;
}

void qFaceToBoneCuts::setKerf(int index, double mm)
{
  if (!has(index) || all()[static_cast<std::size_t>(index)].kerf == mm)
    return;
  editable(index)->kerf = mm;
  told();
}

void qFaceToBoneCuts::setDepth(int index, double mm)
{
  if (!has(index) || all()[static_cast<std::size_t>(index)].curves.empty())
    return;
  qFaceToBoneCut* cut = editable(index);
  for (qFaceToBoneCutCurve& curve : cut->curves)
    curve.saw.depth_mm = mm;
  cut->setDrawn();
  told();
}

void qFaceToBoneCuts::setOverrun(int index, double mm)
{
  if (!has(index))
    return;
  const auto& there = all()[static_cast<std::size_t>(index)].curves;
  if (std::none_of(there.begin(), there.end(),
                   [mm](const qFaceToBoneCutCurve& c) { return c.runsOn() && c.overrun != mm; }))
    return;
  qFaceToBoneCut* cut = editable(index);
  for (qFaceToBoneCutCurve& curve : cut->curves)
    if (curve.runsOn())
    {
      curve.overrun = mm;
      curve.settle();
    }
  cut->setDrawn();
  told();
}

void qFaceToBoneCuts::setPlane(int index, int plane, const f2b::BoundedPlane& placed)
{
  if (!has(index) || plane < 0 ||
      static_cast<std::size_t>(plane) >= all()[static_cast<std::size_t>(index)].planes.size())
    return;
  qFaceToBoneCut* cut = editable(index);
  cut->planes[static_cast<std::size_t>(plane)] = placed;
  cut->setDrawn();
  told();
}

void qFaceToBoneCuts::setCurve(int index, int curve, const qFaceToBoneCutCurve& drawn)
{
  if (!has(index) || curve < 0 ||
      static_cast<std::size_t>(curve) >= all()[static_cast<std::size_t>(index)].curves.size())
    return;
  qFaceToBoneCut* cut = editable(index);
  cut->curves[static_cast<std::size_t>(curve)] = drawn;
  cut->setDrawn();
  told();
}

void qFaceToBoneCuts::setPoint(int index, const Point& free)
{
  qFaceToBoneCut* cut = editable(index);
  if (!cut)
    return;
  cut->point = {free[0], free[1], free[2]};
  cut->pointPlaced = true;
  told();
}

bool qFaceToBoneCuts::placeAnew(int index)
{
  if (!has(index) || all()[static_cast<std::size_t>(index)].templateName.empty())
    return fail(tr("This cut comes from no template; remove it, or use undo"));
  try
  {
    const qFaceToBoneCut& cut = all()[static_cast<std::size_t>(index)];
    json settings = {
        {"template", cut.templateName}, {"fragment", cut.fragment}, {"kerf_mm", cut.kerf}};
    if (!cut.movement.is_null())
      settings["movement"] = cut.movement;
    qFaceToBoneCut anew = qFaceToBoneReadCut(settings, f2b::read_landmarks(m_landmarksFile));
    *editable(index) = std::move(anew);
    told();
    return true;
  }
  catch (const std::exception& error)
  {
    return fail(QString::fromUtf8(error.what()));
  }
}

void qFaceToBoneCuts::setLandmarks(const std::string& file)
{
  m_landmarksFile = file;
  const f2b::Landmarks landmarks = f2b::read_landmarks(file);
  for (qFaceToBoneCut& cut : m_now->cuts)
    if (!cut.drawn && !cut.templateName.empty())
    {
      json settings = {
          {"template", cut.templateName}, {"fragment", cut.fragment}, {"kerf_mm", cut.kerf}};
      if (!cut.movement.is_null())
        settings["movement"] = cut.movement;
      cut = qFaceToBoneReadCut(settings, landmarks);
    }
  told();
}

bool qFaceToBoneCuts::setRule(const QString& fragment, std::size_t coordinate,
                              const qFaceToBoneRule& rule)
{
  if (rule.bounded && !rule.locked && !(rule.least < rule.most))
    return fail(tr("The range from %1 to %2 holds no value; raise its end or lock the coordinate")
                    .arg(rule.least)
                    .arg(rule.most));
  for (int k = 0; k < count(); ++k)
  {
    const qFaceToBoneCut& there = all()[static_cast<std::size_t>(k)];
    if (QString::fromStdString(there.fragment) != fragment)
      continue;
    const json movement = qFaceToBoneWithRule(there.movement, coordinate, rule);
    if (movement == there.movement)
      return true;
    editable(k)->movement = movement;
    told(true);
    return true;
  }
  return fail(tr("No cut is called %1 any more; cut again").arg(fragment));
}
