#include "Bridge/grid_file.hpp"
#include "Bridge/json_file.hpp"
#include "Bridge/markups.hpp"
#include "Case/cut_surfaces.hpp"
#include "Case/drawn_osteotomies.hpp"
#include "Case/input_records.hpp"
#include "Case/placed_osteotomies.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/geometry/trimmed_cuts.hpp"
#include "Core/mesh/contact.hpp"
#include "Meshing/isosurface.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace f2b
{
namespace
{

using nlohmann::json;

std::string one_digit(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string in_brackets(const Vec3& p)
{
  return "(" + one_digit(p.x()) + ", " + one_digit(p.y()) + ", " + one_digit(p.z()) + ")";
}

/// How near the cuts come to what they should spare; warnings go to `notes`.
json clearances(const std::vector<ProtectedSettings>& structures,
                const std::vector<Osteotomy>& osteotomies, json& notes)
{
  json told = json::array();
  for (const ProtectedSettings& structure : structures)
  {
    const SawClearance c = saw_clearance(points_of(structure), osteotomies);
    const bool cut = c.distance_mm <= 0, near = c.distance_mm < structure.margin_mm;
    told.push_back({{"name", structure.name},
                    {"distance_mm", std::max(0.0, c.distance_mm)},
                    {"cut", c.cut},
                    {"at_ras", to_json(c.at)},
                    {"margin_mm", structure.margin_mm},
                    {"sawn_through", cut},
                    {"within_margin", near}});
    if (near)
      notes.push_back("The cut " + c.cut +
                      (cut ? " goes through " : " is " + one_digit(c.distance_mm) + " mm from ") +
                      "the protected structure '" + structure.name + "' at RAS " +
                      in_brackets(c.at) + ".");
  }
  return told;
}

/// Planes that part nothing are not sawn: that is said, but of planes that may miss.
void tell_left_out(const Osteotomy& drawn, const Osteotomy& placed, json& notes)
{
  for (const BoundedPlane& plane : drawn.planes)
  {
    const bool kept = std::any_of(placed.planes.begin(), placed.planes.end(),
                                  [&](const auto& p) { return p.name == plane.name; });
    if (!kept && !plane.may_miss)
      notes.push_back(
          "The plane '" + plane.name + "' of '" + drawn.fragment +
          "' parts no bone and was left out; draw a cut that is to end inside bone as a "
          "curve.");
  }
}

/// One fragment, with its surface and its cuts as markups for editing.
json write_fragment(CaseChange& change, const Osteotomy& o, const TriangleMesh& surface,
                    double volume_mm3)
{
  const auto polydata = with_normals(to_polydata(surface));
  const SurfaceCheck check = check_surface(polydata);
  const std::string part = file_part(o.fragment);
  write_surface(change.file("fragment_" + part + ".vtp"), polydata);
  if (!o.planes.empty())
    write_planes(change.file("cuts_" + part + ".mrk.json"), o.planes);
  json curves = json::array();
  for (const SweptCurve& curve : o.curves)
  {
    PointMarkup markup;
    markup.type = curve.closed ? "ClosedCurve" : "Curve";
    for (const Vec3& p : curve.points)
      markup.points.push_back({curve.name, p});
    write_points(change.file(cut_curve_file(o.fragment, curve.name)), markup);
    curves.push_back(to_json(curve));
  }
  return {{"name", o.fragment},
          {"reference_point_ras", to_json(area_centroid(surface))},
          {"fragment_point_ras", to_json(o.fragment_point)},
          {"kerf_mm", o.kerf_mm},
          {"planes", o.planes.size()},
          {"curves", curves},
          {"volume_mm3", volume_mm3},
          {"open_edges", check.open_edges},
          {"non_manifold_edges", check.non_manifold_edges}};
}

/// Saws with as little room around the bone that each plane parts as leaves no bridge: where bone is
/// thinner than the lattice, the lattice does not tell how far it goes. The partition's planes are
/// those that were sawn.
CutSurfaces sawn_surfaces(const TriangleMesh& bone, BonePartition& partition)
{
  const BonePartition drawn = partition;
  std::optional<Error> refusal;
  for (const double room_mm : {4.0, 8.0, 16.0, 32.0})
  {
    partition.osteotomies = trimmed_cuts(drawn, room_mm);
    try
    {
      auto cut = cut_surfaces(bone, partition);
      if (auto* surfaces = std::get_if<CutSurfaces>(&cut))
        return std::move(*surfaces);
      refusal = bridge_error(std::get<BoneBridge>(cut), partition);
    }
    catch (const Error& error)
    {
      if (error.kind() != ErrorKind::Numerical) // which other blades may not meet
        throw;
      refusal = error;
    }
  }
  throw *refusal;
}

} // namespace

void cut_case(CaseSession& session)
{
  const Stopwatch watch;
  require_cuts(session.settings);
  const CaseFolder& folder = session.folder;
  const ScalarGrid bone = read_scalar_grid(folder.require("bone_distance.nrrd", "segment"));
  const ScalarGrid closed =
      read_scalar_grid(folder.require("closed_bone_distance.nrrd", "segment"));
  const TriangleMesh surface =
      to_triangle_mesh(read_surface(folder.require("bone.vtp", "segment")));
  const Landmarks landmarks = folder.has("landmarks.mrk.json")
                                  ? read_landmarks(folder.file("landmarks.mrk.json"))
                                  : Landmarks{};
  std::vector<Osteotomy> osteotomies;
  for (const OsteotomySettings& o : session.settings.osteotomies)
    osteotomies.push_back(drawn_osteotomy(o, landmarks, bone));

  session.progress("cutting the bone", 0.1);
  BonePartition partition = cut_bone(bone, closed, osteotomies);
  json fragments = json::array(), notes = json::array();
  session.progress("sawing its surface", 0.4);
  const CutSurfaces cut = sawn_surfaces(surface, partition);
  for (std::size_t f = 0; f < osteotomies.size(); ++f)
    tell_left_out(osteotomies[f], partition.osteotomies[f], notes);
  osteotomies = partition.osteotomies;

  session.progress("writing", 0.9);
  CaseChange change(session.folder);
  session.write_settings(change.folder());
  std::vector<BoundedPlane> planes;
  for (std::size_t f = 0; f < osteotomies.size(); ++f)
  {
    fragments.push_back(
        write_fragment(change, osteotomies[f], cut.parts[f + 1], cut.volume_mm3[f + 1]));
    fragments.back()["template"] = session.settings.osteotomies[f].template_name;
    planes.insert(planes.end(), osteotomies[f].planes.begin(), osteotomies[f].planes.end());
    for (std::size_t p = 0; p < osteotomies[f].planes.size(); ++p) // Slicer edits one markup a file
      write_planes(change.file(cut_plane_file(osteotomies[f].fragment, p)),
                   {osteotomies[f].planes[p]});
  }
  write_surface(change.file("uncut_bone.vtp"), with_normals(to_polydata(cut.parts[0])));
  write_planes(change.file("cuts.mrk.json"), planes);
  write_grid(change.file("bone_parts.nrrd"), partition.labels);
  const json spared = clearances(session.settings.protected_structures, osteotomies, notes);
  write_json(change.file("cut.json"), {{"seconds", watch.seconds()},
                                       {"fragments", fragments},
                                       {"bone_mm3", cut.bone_mm3},
                                       {"uncut_mm3", cut.volume_mm3[0]},
                                       {"kerf_mm3", cut.kerf_mm3},
                                       {"imbalance", cut.imbalance},
                                       {"protected", spared},
                                       {"inputs", cut_inputs(session.settings)},
                                       {"notes", notes}});
  change.commit("cut");
  session.progress("cut", 1);
}

} // namespace f2b
