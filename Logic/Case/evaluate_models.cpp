#include "Case/evaluation.hpp"

#include "Case/fragment_json.hpp"
#include "Core/models/face_models.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

using nlohmann::json;

/// The paper's Table 3 [mm].
json paper_row(FaceModelKind model)
{
  auto row = [](double average, double variance, double maximum) {
    return json{{"mean", average}, {"variance", variance}, {"max", maximum}};
  };
  switch (model)
  {
  case FaceModelKind::Lfem:
    return row(1.34, 1.42, 3.52);
  case FaceModelKind::Mtm:
    return row(1.25, 1.28, 3.53);
  case FaceModelKind::Nfem:
    return row(1.17, 1.25, 2.43);
  case FaceModelKind::NfmEm:
    return row(0.93, 0.79, 1.93);
  }
  return {};
}

std::vector<double> only(std::vector<double> area, const std::vector<int>& fragment_below, bool cut)
{
  for (std::size_t v = 0; v < area.size(); ++v)
    if ((fragment_below[v] >= 0) != cut)
      area[v] = 0;
  return area;
}

/// The model with the least mean error, and what to think of it.
json verdict(const json& rows)
{
  const auto best = std::min_element(rows.begin(), rows.end(),
                                     [](const json& a, const json& b)
                                     { return a["error_mm"]["mean"] < b["error_mm"]["mean"]; });
  return {{"least_mean_error", (*best)["model"]},
          {"note", "the order is what this run gave; nothing was tuned for it"}};
}

} // namespace

json compare_models(const Evaluation& e, const ActualOutcome& actual, std::vector<Vec3>& mixed_face)
{
  json rows = json::array();
  MapPanels maps;
  maps.bar_title = "predicted - actual face [mm], negative: behind it";
  for (const FaceModelKind kind :
       {FaceModelKind::Lfem, FaceModelKind::Mtm, FaceModelKind::Nfem, FaceModelKind::NfmEm})
  {
    const Stopwatch watch;
    FaceModelOptions options;
    options.equilibrium = equilibrium_options(e.session.settings);
    FaceModelResult face = predict_with(kind, {e.face.mesh, e.face.materials, actual.motions},
                                        e.face.map, options, e.session.progress);
    const std::vector<double> distance = actual.distances(face.skin_displacement);
    json row = {{"model", name_of(kind)},
                {"error_mm", error_json(skin_error(distance, actual.area))},
                {"paper_mm", paper_row(kind)},
                {"seconds", watch.seconds()}};
    for (const bool cut : {true, false})
      row[cut ? "cut_mm" : "outside_cut_mm"] =
          error_json(skin_error(distance, only(actual.area, e.parts.fragment_below, cut)));
    if (actual.exact_distances)
      row["without_noise_mm"] =
          error_json(skin_error(actual.exact_distances(face.skin_displacement), actual.area));
    row["converged"] =
        kind == FaceModelKind::Mtm ? face.relaxation.converged : face.equilibrium.converged();
    row["load_reached"] = kind == FaceModelKind::Mtm ? 1 : face.equilibrium.load_reached;
    rows.push_back(std::move(row));
    maps.panels.push_back(
        {skin_with_distance(e.face, face.skin_displacement, distance, actual.area), name_of(kind),
         text_of(skin_error(distance, actual.area))});
    if (kind == FaceModelKind::NfmEm)
      mixed_face = std::move(face.skin_displacement);
  }
  write_png(map_panels_picture(maps, {700, 900}), e.file("experiment1.png"));
  return {{"rows", rows}, {"verdict", verdict(rows)}};
}

} // namespace f2b
