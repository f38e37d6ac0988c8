#include "qFaceToBoneCaseDocument.h"
#include "qFaceToBoneCut.h"

#include <Bridge/json_file.hpp>
#include <Bridge/vtk_surface.hpp>
#include <Case/case_settings.hpp>
#include <Case/settings_paths.hpp>
#include <Core/error.hpp>

#include <QDir>
#include <QFile>

#include <vtkPolyData.h>

double qFaceToBoneCase::meshDensity() const
{
  const auto mesh = m_document->json.find("mesh");
  return mesh == m_document->json.end() ? 1.0 : mesh->value("density", 1.0);
}

void qFaceToBoneCase::setMeshDensity(double density)
{
  if (isOpen())
    m_document->json["mesh"]["density"] = density;
}

vtkPolyData* qFaceToBoneCase::bone()
{
  if (!m_bone && has("bone.vtp"))
    attempt([this] { m_bone = f2b::read_surface(file("bone.vtp")); });
  return m_bone;
}

/// The case's cuts, or those that were left unfinished. Drawings that nothing needs any more go.
void qFaceToBoneCase::readCuts()
{
  const bool read = attempt(
      [this]
      {
        const nlohmann::json& document = m_document->json;
        const std::string landmarks = has("landmarks.mrk.json")
                                          ? file("landmarks.mrk.json")
                                          : document.value("landmarks", std::string());
        nlohmann::json unfinished;
        if (has(unfinishedCutsFileName))
          unfinished = f2b::with_absolute_paths(f2b::read_json(file(unfinishedCutsFileName)),
                                                file(unfinishedCutsFileName));
        m_cuts.load(document, unfinished, landmarks);
        const QString used = QString::fromStdString(document.dump() + unfinished.dump());
        for (const QString& drawn : QDir(m_folder).entryList({"drawn_*.mrk.json"}, QDir::Files))
          if (!used.contains(drawn))
            QFile::remove(QDir(m_folder).filePath(drawn));
      });
  if (!read)
    m_cuts.clear();
}

bool qFaceToBoneCase::saveCuts()
{
  if (!isOpen() || !QDir(m_folder).exists())
    return true;
  return attempt(
      [this]
      {
        const std::string path = file(unfinishedCutsFileName), aside = path + ".part";
        if (!m_cuts.isChanged())
        {
          QFile::remove(QString::fromStdString(path));
          return;
        }
        const nlohmann::json unfinished = {
            {"osteotomies", m_cuts.osteotomies(m_folder.toStdString())},
            {"protected", m_cuts.spared()}};
        f2b::write_json(aside, f2b::with_folder_paths(unfinished, m_folder.toStdString()));
        std::filesystem::rename(aside, path);
      });
}

void qFaceToBoneCase::requireCuts() const
{
  if (m_cuts.count() == 0)
    throw f2b::Error("cuts", "there is none", "add a cut: a template, a plane or a line");
  for (const qFaceToBoneCut& cut : m_cuts.all())
  {
    if (!cut.problem.empty())
      throw std::runtime_error(cut.problem);
    if (cut.planes.empty() && cut.curves.empty())
      throw f2b::Error("cut '" + cut.fragment + "'", "there is nothing to cut along",
                       "add a plane or a line to it, or remove it");
    for (const qFaceToBoneCutCurve& curve : cut.curves)
      f2b::require_swept(curve.saw, cut.kerf);
  }
}

/// What a step works by: the cuts as they are now where it cuts, else those that the mesh was made
/// by, with the rules of now.
nlohmann::json qFaceToBoneCase::documentFor(Step step) const
{
  nlohmann::json document = m_document->json;
  if (step <= Cuts)
  {
    if (step == Cuts)
      requireCuts();
    if (m_cuts.count() > 0)
    {
      QDir().mkpath(m_folder);
      document["osteotomies"] = m_cuts.osteotomies(m_folder.toStdString());
    }
    document.erase("protected");
    if (!m_cuts.spared().empty())
      document["protected"] = m_cuts.spared();
    return document;
  }
  for (nlohmann::json& osteotomy : document["osteotomies"])
    for (const QString& fragment : m_fragments)
    {
      if (osteotomy.value("fragment", std::string()) != fragment.toStdString())
        continue;
      const nlohmann::json movement = m_cuts.movementOf(fragment.toStdString());
      osteotomy.erase("movement");
      if (!movement.is_null())
        osteotomy["movement"] = movement;
    }
  return document;
}

/// Nerves and roots as objects: yellow, red where a cut comes too near.
void qFaceToBoneCase::showSpared()
{
  std::vector<QString> gone;
  for (const qFaceToBoneObject& o : m_objects.all())
    if (o.key.startsWith("protected/"))
      gone.push_back(o.key);
  for (const qFaceToBoneCuts::Clearance& c : m_cuts.clearances())
  {
    const QString key = "protected/" + c.name;
    if (!c.surface)
      continue;
    const qFaceToBoneObject* there = m_objects.find(key);
    if (!there) // most of it lies inside bone, which is seen through from now on
      for (const char* bone : {"bone", "uncut"})
        m_objects.setOpacity(bone, 0.45);
    if (!there || there->surface != c.surface)
      showSurface(key, c.name, c.surface, qFaceToBoneCuts::colourOfSpared(c.near));
    m_objects.setColour(key, qFaceToBoneCuts::colourOfSpared(c.near));
    gone.erase(std::remove(gone.begin(), gone.end(), key), gone.end());
  }
  for (const QString& key : gone)
    m_objects.remove(key);
}
