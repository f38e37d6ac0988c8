#include "qFaceToBoneRulers.h"

#include "qFaceToBoneObjects.h"
#include "vtkFaceToBonePointsRepresentation.h"

#include <Bridge/markups.hpp>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>

namespace
{

vtkSmartPointer<vtkPolyData> lineOf(const std::vector<qFaceToBoneRulers::Point>& points)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(points.size()));
  for (const auto& p : points)
    lines->InsertCellPoint(places->InsertNextPoint(p.data()));
  auto line = vtkSmartPointer<vtkPolyData>::New();
  line->SetPoints(places);
  line->SetLines(lines);
  return line;
}

} // namespace

qFaceToBoneRulers::qFaceToBoneRulers(qFaceToBoneObjects* objects, QObject* parent)
    : QObject(parent), m_objects(objects)
{
}

void qFaceToBoneRulers::show(const Ruler& ruler)
{
  QString value = QString::fromStdString(vtkFaceToBonePointsRepresentation::Measured(ruler.points));
  qFaceToBoneObject object;
  object.key = ruler.key;
  object.name = (ruler.points.size() == 2 ? tr("Distance %1") : tr("Angle %1"))
                    .arg(value.replace(" deg", QString::fromUtf8("\xc2\xb0")));
  object.surface = lineOf(ruler.points);
  object.colour = {115, 26, 128};
  object.removable = true;
  m_objects->put(object);
}

QString qFaceToBoneRulers::add(const std::vector<Point>& points)
{
  m_rulers.push_back({QString("ruler/%1").arg(m_next++), points});
  show(m_rulers.back());
  emit changed();
  return m_rulers.back().key;
}

void qFaceToBoneRulers::setPoints(const QString& key, const std::vector<Point>& points)
{
  for (Ruler& ruler : m_rulers)
    if (ruler.key == key)
    {
      ruler.points = points;
      show(ruler);
    }
}

bool qFaceToBoneRulers::remove(const QString& key)
{
  const auto found =
      std::find_if(m_rulers.begin(), m_rulers.end(), [&](const Ruler& r) { return r.key == key; });
  if (found == m_rulers.end())
    return false;
  m_rulers.erase(found);
  m_objects->remove(key);
  emit changed();
  return true;
}

void qFaceToBoneRulers::keep() const
{
  std::vector<f2b::PointMarkup> markups;
  for (const Ruler& ruler : m_rulers)
  {
    f2b::PointMarkup markup{ruler.points.size() == 2 ? "Line" : "Angle", {}};
    for (const Point& p : ruler.points)
      markup.points.push_back(
          {ruler.key.toStdString() + "-" + std::to_string(markup.points.size() + 1),
           {p[0], p[1], p[2]}});
    markups.push_back(markup);
  }
  if (m_file.empty())
    return;
  if (markups.empty())
  {
    std::filesystem::remove(m_file);
    return;
  }
  std::filesystem::create_directories(std::filesystem::path(m_file).parent_path());
  const std::string beside = m_file + ".part";
  f2b::write_point_markups(beside, markups);
  std::filesystem::rename(beside, m_file);
}

void qFaceToBoneRulers::load(const std::string& file)
{
  for (const Ruler& ruler : m_rulers)
    m_objects->remove(ruler.key);
  m_rulers.clear();
  m_next = 1;
  m_file = file;
  if (!m_file.empty() && std::filesystem::exists(m_file))
    for (const f2b::PointMarkup& markup : f2b::read_point_markups(m_file))
    {
      Ruler ruler{QString("ruler/%1").arg(m_next++), {}};
      for (const f2b::ControlPoint& p : markup.points)
        ruler.points.push_back({p.position.x(), p.position.y(), p.position.z()});
      if (ruler.points.size() != 2 && ruler.points.size() != 3)
        continue;
      m_rulers.push_back(ruler);
      show(ruler);
    }
  emit changed();
}
