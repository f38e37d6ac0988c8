#include "qFaceToBoneCaseDocument.h"

#include <Bridge/markups.hpp>
#include <Case/case_folder.hpp>
#include <Core/error.hpp>
#include <Core/geometry/osteotomy_templates.hpp>

QStringList qFaceToBoneCase::templates() const
{
  QStringList names;
  for (const std::string& name : f2b::osteotomy_template_names())
    names << QString::fromStdString(name);
  return names;
}

QString qFaceToBoneCase::cutTemplate() const
{
  return isOpen() ? QString::fromStdString(m_document->osteotomy().value("template", std::string()))
                  : QString();
}

void qFaceToBoneCase::setCutTemplate(const QString& name)
{
  if (!isOpen() || name == cutTemplate())
    return;
  nlohmann::json& osteotomy = m_document->osteotomy();
  osteotomy = {{"fragment", name == "le-fort-3"     ? "mid-face"
                            : name == "le-fort-1"   ? "maxilla"
                            : name == "genioplasty" ? "chin"
                                                    : "mandible"},
               {"template", name.toStdString()},
               {"kerf_mm", osteotomy.value("kerf_mm", 1.0)}};
  placeCutPlanes();
  emit changed();
}

double qFaceToBoneCase::kerf() const
{
  return isOpen() ? m_document->osteotomy().value("kerf_mm", 1.0) : 1.0;
}

void qFaceToBoneCase::setKerf(double mm)
{
  if (isOpen())
    m_document->osteotomy()["kerf_mm"] = mm;
}

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

const std::vector<f2b::BoundedPlane>& qFaceToBoneCase::cutPlanes() const
{
  return m_document->planes;
}

std::size_t qFaceToBoneCase::cutPlaneCount() const
{
  return m_document->planes.size();
}

/// Where the case's template or its files put the planes.
void qFaceToBoneCase::placeCutPlanes()
{
  Document& d = *m_document;
  d.planes.clear();
  d.planesEdited = false;
  const bool placed = attempt(
      [&]
      {
        const nlohmann::json& osteotomy = d.osteotomy();
        if (osteotomy.contains("template"))
        {
          const f2b::Osteotomy found = f2b::osteotomy_from_template(
              osteotomy.at("template").get<std::string>(),
              osteotomy.at("fragment").get<std::string>(), d.landmarks, kerf());
          d.planes = found.planes;
          d.fragmentPoint = found.fragment_point;
          return;
        }
        for (const auto& path : osteotomy.at("planes"))
          for (const f2b::BoundedPlane& plane : f2b::read_planes(path.get<std::string>()))
            d.planes.push_back(plane);
        const nlohmann::json& point = osteotomy.at("fragment_point_ras");
        for (int k = 0; k < 3; ++k)
          d.fragmentPoint[k] = point.at(static_cast<std::size_t>(k)).get<double>();
      });
  if (!placed)
    m_notes << m_error;
  emit cutPlanesChanged();
}

void qFaceToBoneCase::setCutPlane(std::size_t index, const f2b::BoundedPlane& plane)
{
  if (index >= m_document->planes.size())
    return;
  m_document->planes[index] = plane;
  m_document->planesEdited = true;
}

void qFaceToBoneCase::addCutPlane(const std::array<double, 3>& at)
{
  f2b::BoundedPlane plane;
  plane.name = "plane " + std::to_string(m_document->planes.size() + 1);
  plane.center = {at[0], at[1], at[2]};
  plane.half_u = plane.half_v = 30;
  m_document->planes.push_back(plane);
  m_document->planesEdited = true;
  emit cutPlanesChanged();
}

void qFaceToBoneCase::removeCutPlane(std::size_t index)
{
  if (index >= m_document->planes.size())
    return;
  m_document->planes.erase(m_document->planes.begin() + static_cast<std::ptrdiff_t>(index));
  m_document->planesEdited = true;
  emit cutPlanesChanged();
}

/// Planes moved by hand become files of the case, which the cut reads.
void qFaceToBoneCase::keepCutPlanes()
{
  Document& d = *m_document;
  if (!d.planesEdited)
    return;
  if (d.planes.empty())
    throw f2b::Error("cuts", "there is no plane to cut along", "add a plane or choose a template");
  nlohmann::json& osteotomy = d.osteotomy();
  const std::string path = file(drawnPlanesFileName);
  f2b::write_planes(path, d.planes);
  osteotomy.erase("template");
  osteotomy["planes"] = {path};
  osteotomy["fragment_point_ras"] = {d.fragmentPoint.x(), d.fragmentPoint.y(), d.fragmentPoint.z()};
  d.planesEdited = false;
}
