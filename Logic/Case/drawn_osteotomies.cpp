#include "Case/drawn_osteotomies.hpp"

#include "Bridge/markups.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Core/error.hpp"

namespace f2b
{
namespace
{

/// Between the points of a curve that is cut or measured.
constexpr double curve_spacing_mm = 1;

std::vector<Vec3> positions(const PointMarkup& markup)
{
  std::vector<Vec3> places;
  for (const ControlPoint& point : markup.points)
    places.push_back(point.position);
  return places;
}

std::vector<Vec3> drawn_points(const PointMarkup& markup, bool straight)
{
  return resampled_curve(positions(markup), markup.type == "ClosedCurve",
                         straight || markup.type == "Line", curve_spacing_mm);
}

Vec3 inwards(const std::vector<Vec3>& points, const ScalarGrid& bone, const Path& file)
{
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points)
    sum -= bone.gradient(p);
  if (!(sum.norm() > 0.3 * static_cast<double>(points.size())))
    throw Error(file.string(), "the bone under this curve faces many ways",
                "state the saw's direction (direction_ras)");
  return sum.normalized();
}

SweptCurve swept(const CurveSettings& settings, const std::string& fragment, const ScalarGrid& bone)
{
  const PointMarkup markup = read_points(settings.markup);
  SweptCurve curve;
  curve.name = curve_name_of(fragment, settings.markup);
  curve.closed = markup.type == "ClosedCurve";
  curve.points = drawn_points(markup, settings.straight);
  curve.direction = settings.direction ? settings.direction->normalized()
                                       : inwards(curve.points, bone, settings.markup);
  curve.depth_mm = settings.depth_mm;
  curve.lead_mm = settings.lead_mm;
  return curve;
}

} // namespace

Osteotomy drawn_osteotomy(const OsteotomySettings& o, const Landmarks& landmarks,
                          const ScalarGrid& bone)
{
  Osteotomy osteotomy;
  if (!o.template_name.empty())
    osteotomy = osteotomy_from_template(o.template_name, o.fragment, landmarks, o.kerf_mm);
  else
    osteotomy.fragment = o.fragment;
  osteotomy.kerf_mm = o.kerf_mm;
  if (o.fragment_point)
    osteotomy.fragment_point = *o.fragment_point;
  if (!o.drawn())
    return osteotomy;
  osteotomy.planes.clear();
  osteotomy.curves.clear();
  for (const Path& file : o.planes)
    for (BoundedPlane& plane : read_planes(file))
      osteotomy.planes.push_back(std::move(plane));
  for (const CurveSettings& curve : o.curves)
  {
    osteotomy.curves.push_back(swept(curve, o.fragment, bone));
    require_swept(osteotomy.curves.back(), o.kerf_mm);
  }
  return osteotomy;
}

std::vector<Vec3> points_of(const ProtectedSettings& structure)
{
  if (structure.curve.empty())
    return to_triangle_mesh(read_surface(structure.mesh)).points;
  return drawn_points(read_points(structure.curve), false);
}

} // namespace f2b
