#include "qFaceToBoneCaseDocument.h"
#include "qFaceToBoneCut.h"

#include <Bridge/markups.hpp>
#include <Core/error.hpp>
#include <Core/geometry/cephalometry.hpp>
#include <Core/geometry/nearest_vertex.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <QDir>

#include <filesystem>
#include <set>

namespace
{

f2b::Vec3 vectorOf(const std::array<double, 3>& p)
{
  return {p[0], p[1], p[2]};
}

/// Whole or not at all.
void replaceLandmarks(const std::string& path, const f2b::Landmarks& landmarks)
{
  const std::string beside = path + ".part";
  f2b::write_landmarks(beside, landmarks);
  std::filesystem::rename(beside, path);
}

} // namespace

/// Those that were placed here count more than the file that the case began with.
void qFaceToBoneCase::loadLandmarksOfCase()
{
  m_document->landmarks.clear();
  if (has(placedLandmarksFileName))
    m_document->json["landmarks"] = file(placedLandmarksFileName);
  const std::string named = m_document->json.value("landmarks", std::string());
  if (has(placedLandmarksFileName))
    m_document->landmarks = f2b::read_landmarks(file(placedLandmarksFileName));
  else if (has("landmarks.mrk.json"))
    m_document->landmarks = f2b::read_landmarks(file("landmarks.mrk.json"));
  else if (!named.empty() && std::filesystem::is_regular_file(named))
    m_document->landmarks = f2b::read_landmarks(named);
  emit landmarksChanged();
}

std::vector<qFaceToBoneCase::Landmark> qFaceToBoneCase::landmarks() const
{
  std::set<std::string> needed;
  for (const qFaceToBoneCut& cut : m_cuts.all())
    if (!cut.drawn && !cut.templateName.empty())
      for (const std::string& name : f2b::landmarks_of_template(cut.templateName))
        needed.insert(name);
  std::vector<Landmark> all;
  for (const f2b::LandmarkDefinition& definition : f2b::landmark_definitions())
  {
    Landmark landmark{QString::fromUtf8(definition.name),
                      QString::fromUtf8(definition.meaning),
                      false,
                      false,
                      {}};
    landmark.needed = needed.count(definition.name) > 0;
    if (const auto found = m_document->landmarks.find(definition.name);
        found != m_document->landmarks.end())
    {
      landmark.placed = true;
      landmark.at = {found->second.x(), found->second.y(), found->second.z()};
    }
    all.push_back(landmark);
  }
  return all;
}

QStringList qFaceToBoneCase::missingLandmarks() const
{
  QStringList names;
  for (const Landmark& landmark : landmarks())
    if (landmark.needed && !landmark.placed)
      names << landmark.name;
  return names;
}

bool qFaceToBoneCase::placeLandmark(const QString& name, const std::array<double, 3>& at)
{
  if (!isOpen())
    return fail(tr("There is no case yet; open one first"));
  m_document->landmarks[name.toStdString()] = vectorOf(at);
  return attempt([this] { landmarksEdited(); });
}

bool qFaceToBoneCase::removeLandmark(const QString& name)
{
  if (!m_document->landmarks.erase(name.toStdString()))
    return fail(tr("The landmark %1 is not placed").arg(name));
  return attempt([this] { landmarksEdited(); });
}

bool qFaceToBoneCase::loadLandmarks(const QString& path)
{
  if (!isOpen())
    return fail(tr("There is no case yet; open one first"));
  return attempt(
      [&]
      {
        for (const auto& [name, at] : f2b::read_landmarks(path.toStdString()))
          m_document->landmarks[name] = at;
        landmarksEdited();
      });
}

/// A case of a CT alone names a list of landmarks before any is placed.
void qFaceToBoneCase::keepLandmarks()
{
  const std::string placed = file(placedLandmarksFileName);
  if (m_document->json.value("landmarks", std::string()) != placed || has(placedLandmarksFileName))
    return;
  QDir().mkpath(m_folder);
  replaceLandmarks(placed, m_document->landmarks);
}

/// Files of the folder say what is placed, for the next step and for the next start.
void qFaceToBoneCase::landmarksEdited()
{
  QDir().mkpath(m_folder);
  replaceLandmarks(file(placedLandmarksFileName), m_document->landmarks);
  m_document->json["landmarks"] = file(placedLandmarksFileName);
  if (has("segment.json"))
    replaceLandmarks(file("landmarks.mrk.json"), m_document->landmarks);
  m_cuts.setLandmarks(file(placedLandmarksFileName));
  findRides();
  emit landmarksChanged();
  emit planChanged();
  emit changed();
}

std::array<double, 3> qFaceToBoneCase::landmarkOnFace(const QString& name) const
{
  const auto found = m_document->landmarks.find(name.toStdString());
  if (!m_sculpting || found == m_document->landmarks.end())
    return {};
  const f2b::SculptedSkin& skin = m_sculpting->skin();
  const f2b::Vec3& now = skin.points()[f2b::nearest_vertex(skin.rest(), found->second)];
  return {now.x(), now.y(), now.z()};
}

/// On both sides: what lies in the middle stays in it, what does not has a partner.
void qFaceToBoneCase::beginDrag(const std::array<double, 3>& point, double radiusMm, bool bothSides)
{
  constexpr double middleMm = 3;
  if (!m_sculpting)
    return;
  m_drag = std::make_unique<Drag>();
  m_drag->from = {vectorOf(point)};
  if (bothSides)
  {
    m_drag->mirror = symmetryPlane();
    const f2b::SymmetryPlane& plane = *m_drag->mirror;
    if (std::abs(plane.normal.dot(vectorOf(point) - plane.point)) > middleMm)
      m_drag->from.push_back(plane.mirrored(vectorOf(point)));
  }
  m_sculpting->begin_warp(m_drag->from, radiusMm, "landmark");
}

void qFaceToBoneCase::drag(const std::array<double, 3>& by)
{
  if (!m_drag || !m_sculpting || !m_sculpting->in_stroke())
    return;
  f2b::Vec3 way = vectorOf(by);
  std::vector<f2b::Vec3> to = m_drag->from;
  if (m_drag->mirror && to.size() == 2)
    to[1] += m_drag->mirror->mirrored_vector(way);
  else if (m_drag->mirror)
    way -= m_drag->mirror->normal.dot(way) * m_drag->mirror->normal;
  to[0] += way;
  if (attempt([&] { m_sculpting->drag_warp(to); }))
    sculpted(false);
}

void qFaceToBoneCase::endDrag(bool keep)
{
  m_drag.reset();
  if (!m_sculpting || !m_sculpting->in_stroke())
    return;
  keep ? m_sculpting->end_stroke() : m_sculpting->cancel_stroke();
  sculpted(true);
}
