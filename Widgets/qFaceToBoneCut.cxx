#include "qFaceToBoneCut.h"

#include <Bridge/markups.hpp>
#include <Case/case_settings.hpp>

#include <QByteArray>
#include <QCryptographicHash>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{

using nlohmann::json;

/// Between the points of a line that is shown and sawn.
constexpr double spacingMm = 1;

json toJson(const f2b::Vec3& p)
{
  return {p.x(), p.y(), p.z()};
}

f2b::Vec3 pointFrom(const json& value)
{
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

qFaceToBoneCutCurve placedCurve(const f2b::SweptCurve& saw)
{
  qFaceToBoneCutCurve curve;
  curve.saw = saw;
  curve.handles = curve.line = saw.points;
  return curve;
}

/// Labelled points of our own lines are those that the surgeon set; the rest lies between them.
qFaceToBoneCutCurve curveFrom(const json& settings)
{
  const auto file = settings.at("markup").get<std::string>();
  const f2b::PointMarkup markup = f2b::read_points(file);
  qFaceToBoneCutCurve curve;
  curve.saw.name = std::filesystem::u8path(file).stem().stem().string();
  curve.saw.closed = markup.type == "ClosedCurve";
  curve.onBone = !(settings.value("straight", false) || markup.type == "Line");
  std::vector<f2b::Vec3> all, labelled;
  for (const f2b::ControlPoint& point : markup.points)
  {
    all.push_back(point.position);
    if (!point.label.empty())
      labelled.push_back(point.position);
  }
  curve.handles = labelled.size() > 1 ? labelled : all;
  if (curve.runsOn() && !all.empty())
    curve.overrun = (curve.handles.front() - all.front()).norm();
  if (curve.overrun > 0)
    all = {all.begin() + 1, all.end() - 1};
  curve.line = curve.onBone ? f2b::resampled_curve(all, curve.saw.closed, false, spacingMm) : all;
  curve.turned = settings.contains("direction_ras");
  if (curve.turned)
    curve.saw.direction = pointFrom(settings.at("direction_ras")).normalized();
  curve.saw.depth_mm = settings.value("depth_mm", 20.0);
  curve.saw.lead_mm = settings.value("lead_mm", 5.0);
  curve.settle();
  return curve;
}

/// A markup's points: the line's own, about 4 mm apart, with the handles labelled among them.
f2b::PointMarkup markupOf(const qFaceToBoneCutCurve& curve)
{
  constexpr double apartMm = 4;
  f2b::PointMarkup markup;
  markup.type = curve.saw.closed ? "ClosedCurve" : "Curve";
  const auto isHandle = [&](const f2b::Vec3& p)
  {
    return std::any_of(curve.handles.begin(), curve.handles.end(),
                       [&](const f2b::Vec3& h) { return (h - p).norm() < 1e-6; });
  };
  for (const f2b::Vec3& p : curve.saw.points)
  {
    const bool handle = isHandle(p);
    const bool end = &p == &curve.saw.points.front() || &p == &curve.saw.points.back();
    double nearest = handle ? apartMm : 0.5 * apartMm;
    if (!handle && !markup.points.empty())
      nearest = (p - markup.points.back().position).norm();
    if (handle || end || nearest >= apartMm)
      markup.points.push_back({handle ? "P" + std::to_string(markup.points.size() + 1) : "", p});
  }
  return markup;
}

std::string checksum(const json& contents)
{
  const QByteArray text = QByteArray::fromStdString(contents.dump());
  return QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex().left(8).toStdString();
}

std::string drawnFile(const std::string& folder, const std::string& name, const json& contents)
{
  const std::string file = "drawn_" + f2b::file_part(name) + "_" + checksum(contents) + ".mrk.json";
  return (std::filesystem::u8path(folder) / file).string();
}

/// To a nanometre: what is written and read again may differ in the last digit.
double rounded(double value)
{
  return 1e-6 * std::round(1e6 * value);
}

json keyOf(const f2b::Vec3& p)
{
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

json keyOf(const f2b::BoundedPlane& p)
{
  return {p.name, keyOf(p.center), keyOf(p.u), keyOf(p.v), rounded(p.half_u), rounded(p.half_v)};
}

json keyOf(const qFaceToBoneCutCurve& curve)
{
  json points = json::array();
  for (const f2b::Vec3& p : curve.handles)
    points.push_back(keyOf(p));
  return {points,
          curve.saw.closed,
          curve.onBone,
          rounded(curve.overrun),
          rounded(curve.saw.depth_mm),
          rounded(curve.saw.lead_mm),
          curve.turned ? keyOf(curve.saw.direction) : json()};
}

json writtenCurve(const qFaceToBoneCutCurve& curve, const std::string& fragment,
                  const std::string& folder)
{
  const std::string file = drawnFile(folder, fragment + " line", keyOf(curve));
  f2b::write_points(file, markupOf(curve));
  json settings = {
      {"markup", file}, {"depth_mm", curve.saw.depth_mm}, {"lead_mm", curve.saw.lead_mm}};
  if (curve.turned)
    settings["direction_ras"] = toJson(curve.saw.direction);
  if (!curve.onBone)
    settings["straight"] = true;
  return settings;
}

} // namespace

void qFaceToBoneCutCurve::settle()
{
  constexpr double basis = 4; // by so much of the line its direction at the end is told [mm]
  saw.points = line;
  if (!runsOn() || line.size() < 2 || !(overrun > 0))
    return;
  const auto beyond = [&](const f2b::Vec3& end, auto next, auto last)
  {
    while (next + 1 != last && (*next - end).norm() < basis)
      ++next;
    f2b::Vec3 along = end - *next;
    along -= saw.direction.dot(along) * saw.direction; // straight on as seen along the saw
    return along.norm() > 1e-6 ? f2b::Vec3(end + overrun * along.normalized()) : end;
  };
  saw.points.insert(saw.points.begin(), beyond(line.front(), line.begin() + 1, line.end()));
  saw.points.push_back(beyond(line.back(), line.rbegin() + 1, line.rend()));
}

f2b::Osteotomy qFaceToBoneCut::osteotomy() const
{
  f2b::Osteotomy osteotomy;
  osteotomy.fragment = fragment;
  osteotomy.planes = planes;
  osteotomy.fragment_point = point;
  osteotomy.kerf_mm = kerf;
  for (const qFaceToBoneCutCurve& curve : curves)
    osteotomy.curves.push_back(curve.saw);
  return osteotomy;
}

void qFaceToBoneCut::setDrawn()
{
  drawn = true;
  pointPlaced = true;
}

qFaceToBoneCut qFaceToBoneReadCut(const json& settings, const f2b::Landmarks& landmarks)
{
  qFaceToBoneCut cut;
  cut.fragment = settings.value("fragment", std::string());
  cut.templateName = settings.value("template", std::string());
  cut.kerf = settings.value("kerf_mm", 1.0);
  cut.movement = settings.value("movement", json());
  cut.drawn = settings.contains("planes") || settings.contains("curves");
  try
  {
    if (!cut.templateName.empty())
    {
      const f2b::Osteotomy placed =
          f2b::osteotomy_from_template(cut.templateName, cut.fragment, landmarks, cut.kerf);
      cut.fragment = placed.fragment;
      cut.point = placed.fragment_point;
      cut.planes = placed.planes;
      for (const f2b::SweptCurve& curve : placed.curves)
        cut.curves.push_back(placedCurve(curve));
    }
    if (cut.drawn)
    {
      cut.planes.clear();
      cut.curves.clear();
    }
    for (const json& file : settings.value("planes", json::array()))
      for (const f2b::BoundedPlane& plane : f2b::read_planes(file.get<std::string>()))
        cut.planes.push_back(plane);
    for (const json& curve : settings.value("curves", json::array()))
    {
      cut.curves.push_back(curveFrom(curve));
      std::string& name = cut.curves.back().saw.name;
      if (name.rfind("drawn_", 0) == 0) // one of our files, which no one else knows
        name = cut.fragment + " line " + std::to_string(cut.curves.size());
    }
    cut.pointPlaced = settings.contains("fragment_point_ras");
    if (cut.pointPlaced)
      cut.point = pointFrom(settings.at("fragment_point_ras"));
  }
  catch (const std::exception& error)
  {
    cut.problem = error.what();
  }
  return cut;
}

json qFaceToBoneWriteCut(const qFaceToBoneCut& cut, const std::string& folder)
{
  json settings = {{"fragment", cut.fragment}, {"kerf_mm", cut.kerf}};
  if (!cut.templateName.empty())
    settings["template"] = cut.templateName;
  if (!cut.movement.is_null() && !cut.movement.empty())
    settings["movement"] = cut.movement;
  if (cut.drawn && !cut.planes.empty())
  {
    json key = json::array();
    for (const f2b::BoundedPlane& plane : cut.planes)
      key.push_back(keyOf(plane));
    const std::string file = drawnFile(folder, cut.fragment + " planes", key);
    f2b::write_planes(file, cut.planes);
    settings["planes"] = {file};
  }
  for (const qFaceToBoneCutCurve& curve : cut.curves)
    if (cut.drawn)
      settings["curves"].push_back(writtenCurve(curve, cut.fragment, folder));
  if (cut.pointPlaced)
    settings["fragment_point_ras"] = toJson(cut.point);
  return settings;
}

json qFaceToBoneKeyOf(const qFaceToBoneCut& cut)
{
  json key = {cut.fragment, cut.templateName, cut.kerf, cut.drawn,
              cut.pointPlaced ? keyOf(cut.point) : json()};
  for (const f2b::BoundedPlane& plane : cut.planes)
    key.push_back(keyOf(plane));
  for (const qFaceToBoneCutCurve& curve : cut.curves)
    key.push_back(keyOf(curve));
  return key;
}

std::vector<qFaceToBoneSpared> qFaceToBoneReadSpared(const json& document)
{
  std::vector<qFaceToBoneSpared> spared;
  for (const json& value : document.value("protected", json::array()))
  {
    const bool isCurve = value.contains("curve");
    spared.push_back({value.at("name").get<std::string>(),
                      value.at(isCurve ? "curve" : "mesh").get<std::string>(), isCurve,
                      value.value("margin_mm", 2.0)});
  }
  return spared;
}

json qFaceToBoneWriteSpared(const std::vector<qFaceToBoneSpared>& spared)
{
  json written = json::array();
  for (const qFaceToBoneSpared& s : spared)
    written.push_back(
        {{"name", s.name}, {s.isCurve ? "curve" : "mesh", s.file}, {"margin_mm", s.margin}});
  return written;
}
