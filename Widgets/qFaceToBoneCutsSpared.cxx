#include "qFaceToBoneCutsState.h"

#include <Bridge/vtk_surface.hpp>
#include <Case/drawn_osteotomies.hpp>
#include <Core/error.hpp>
#include <Core/geometry/trimmed_cuts.hpp>

#include <QFileInfo>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>

namespace
{

/// A nerve or a line as a tube that can be seen in 3D and in the slices.
vtkSmartPointer<vtkPolyData> tubeOf(const std::vector<f2b::Vec3>& points)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(points.size()));
  for (const f2b::Vec3& p : points)
    lines->InsertCellPoint(places->InsertNextPoint(p.data()));
  vtkNew<vtkPolyData> line;
  line->SetPoints(places);
  line->SetLines(lines);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(1.2);
  tube->SetNumberOfSides(12);
  tube->CappingOn();
  tube->Update();
  return tube->GetOutput();
}

bool isMarkup(const QString& file)
{
  return file.endsWith(".json", Qt::CaseInsensitive);
}

} // namespace

auto qFaceToBoneCuts::structure(const qFaceToBoneSpared& spared) const
    -> std::shared_ptr<const Structure>
{
  std::shared_ptr<const Structure>& known = m_structures[spared.file];
  if (known)
    return known;
  f2b::ProtectedSettings settings;
  settings.name = spared.name;
  (spared.isCurve ? settings.curve : settings.mesh) = std::filesystem::u8path(spared.file);
  auto made = std::make_shared<Structure>();
  made->points = f2b::points_of(settings);
  if (made->points.empty())
    throw f2b::Error(spared.file, "it holds no points", "draw the structure first");
  made->surface = spared.isCurve ? tubeOf(made->points)
                                 : f2b::read_surface(std::filesystem::u8path(spared.file));
  known = made;
  return known;
}

QColor qFaceToBoneCuts::colourOfSpared(bool near)
{
  return near ? QColor(225, 25, 30) : QColor(245, 205, 20);
}

bool qFaceToBoneCuts::addSpared(const QString& file)
{
  qFaceToBoneSpared added;
  const QFileInfo info(file);
  added.isCurve = isMarkup(file);
  added.file = info.absoluteFilePath().toStdString();
  added.name = info.fileName().section('.', 0, 0).replace('_', ' ').toStdString();
  if (added.name.empty())
    added.name = "structure";
  const std::string wish = added.name;
  const auto taken = [&]
  {
    return std::any_of(m_now->spared.begin(), m_now->spared.end(),
                       [&](const qFaceToBoneSpared& s) { return s.name == added.name; });
  };
  for (int k = 2; taken(); ++k)
    added.name = wish + " " + std::to_string(k);
  try
  {
    m_structures.erase(added.file); // it may have been drawn anew
    structure(added);
  }
  catch (const std::exception& error)
  {
    return fail(QString::fromUtf8(error.what()));
  }
  remember();
  m_now->spared.push_back(added);
  told();
  return true;
}

void qFaceToBoneCuts::removeSpared(int index)
{
  if (index < 0 || static_cast<std::size_t>(index) >= m_now->spared.size())
    return;
  remember();
  m_now->spared.erase(m_now->spared.begin() + index);
  told();
}

void qFaceToBoneCuts::setMargin(int index, double mm)
{
  if (index < 0 || static_cast<std::size_t>(index) >= m_now->spared.size() ||
      m_now->spared[static_cast<std::size_t>(index)].margin == mm)
    return;
  remember();
  m_now->spared[static_cast<std::size_t>(index)].margin = mm;
  told();
}

auto qFaceToBoneCuts::clearances() const -> const std::vector<Clearance>&
{
  if (m_clearancesKnown)
    return m_clearances;
  std::vector<f2b::Osteotomy> osteotomies;
  for (const qFaceToBoneCut& cut : m_now->cuts)
    osteotomies.push_back(cut.osteotomy());
  std::vector<Clearance>& all = m_clearances;
  all.clear();
  for (const qFaceToBoneSpared& spared : m_now->spared)
  {
    Clearance c;
    c.name = QString::fromStdString(spared.name);
    c.margin = spared.margin;
    try
    {
      const auto known = structure(spared);
      c.surface = known->surface;
      const f2b::SawClearance nearest = f2b::saw_clearance(known->points, osteotomies);
      c.distance = std::max(0.0, nearest.distance_mm);
      c.near = nearest.distance_mm < spared.margin;
      const QString cut = QString::fromStdString(nearest.cut);
      c.words = !std::isfinite(nearest.distance_mm) ? tr("no cut is near")
                : nearest.distance_mm <= 0
                    ? tr("%1 goes through it").arg(cut)
                    : tr("%1 mm from %2").arg(c.distance, 0, 'f', 1).arg(cut);
    }
    catch (const std::exception& error)
    {
      c.words = QString::fromUtf8(error.what());
    }
    all.push_back(c);
  }
  m_clearancesKnown = true;
  return all;
}
