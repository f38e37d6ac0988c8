#include "Case/fit_material.hpp"

#include "Bridge/key_hint.hpp"
#include "Bridge/material_file.hpp"
#include "Bridge/stress_strain_file.hpp"
#include "Case/fit_summary.hpp"
#include "Core/error.hpp"
#include "Rendering/atomic_file.hpp"
#include "Rendering/curve_plot.hpp"
#include "Rendering/offscreen_display.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace f2b
{
namespace
{

using nlohmann::ordered_json;
using Path = std::filesystem::path;

constexpr Tissue tissues[] = {Tissue::Skin, Tissue::Fat, Tissue::Muscle};

FittedLaw fitted_law(const std::string& name)
{
  if (name == "neo-hookean")
    return FittedLaw::OneTermNeoHookean;
  if (name == "mooney-rivlin")
    return FittedLaw::TwoTermMooneyRivlin;
  if (name == "yeoh")
    return FittedLaw::ThreeTermYeoh;
  throw Error("--law", "'" + name + "' cannot be fitted",
              hint_for(name, {"yeoh", "neo-hookean", "mooney-rivlin"}, "laws"));
}

FittedCurve fitted(const std::string& name, const StressCurve& curve,
                   const FitMaterialOptions& options, double poisson_ratio)
{
  FitOptions fit;
  fit.law = fitted_law(options.law);
  fit.stable = options.stable;
  fit.poisson_ratio = options.poisson_ratio.value_or(poisson_ratio);
  return {name, curve, fit_law(curve, fit)};
}

std::vector<FittedCurve> fitted_curves(const FitMaterialOptions& options)
{
  if (!options.table1)
    return {
        fitted(options.data.filename().string(), read_stress_curve(options.data), options, 0.49)};
  const MaterialSet table1 = read_materials("table1");
  std::vector<FittedCurve> fits;
  for (const Tissue tissue : tissues)
    if (options.tissue.empty() || options.tissue == name_of(tissue))
      fits.push_back(
          fitted(name_of(tissue), table1_curve(tissue), options, poisson_ratio(table1.of(tissue))));
  if (fits.empty())
    throw Error("--table1", "'" + options.tissue + "' is no tissue of Table 1",
                hint_for(options.tissue, {"skin", "fat", "muscle"}, "tissues"));
  return fits;
}

/// What the files are called; the default fit of Table 1 has its set's name.
std::string name_of_result(const FitMaterialOptions& options)
{
  std::string name = options.table1 ? "table1" : options.data.stem().string();
  if (!options.tissue.empty())
    name += "-" + options.tissue;
  if (options.stable)
    name += "-stable";
  return options.table1 && options.stable && options.law == "yeoh" ? name
                                                                   : name + "-" + options.law;
}

std::string command_of(const FitMaterialOptions& options)
{
  std::string command = "facetobone fit-material ";
  command += options.table1 ? "--table1" : options.data.filename().string();
  if (!options.tissue.empty())
    command += " " + options.tissue;
  command += " --law " + options.law;
  if (options.stable)
    command += " --stable";
  if (options.poisson_ratio)
    command += " --poisson-ratio " + ordered_json(*options.poisson_ratio).dump();
  return command;
}

/// Six digits, in MPa: as much as a residual can tell.
double rounded(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::stod(text);
}

const char* method_of(const FitMaterialOptions& options)
{
  return options.stable ? "linear least squares on the nominal stress of incompressible matter, "
                          "every coefficient >= 0"
                        : "linear least squares on the nominal stress of incompressible matter";
}

std::string data_of(const FittedCurve& fit, const FitMaterialOptions& options)
{
  return (options.table1 ? "Table 1 curve (not measured points): " : fit.name + ": ") +
         curve_description(fit.curve);
}

std::string stable_range_of(const Law& law)
{
  std::string words;
  for (const Loading loading : {Loading::Uniaxial, Loading::Equibiaxial})
    words += std::string(words.empty() ? "uniaxial: " : "; equibiaxial: ") +
             range_words(growing_range(law, loading, Compressibility::Incompressible), loading);
  return words;
}

/// An entry for one tissue; it says its units, so that it may stand in any material file.
ordered_json tissue_document(const FittedCurve& fit, const FitMaterialOptions& options)
{
  ordered_json entry = tissue_entry(fit.fit.law);
  entry["units"] = "MPa";
  entry["fit"] = {{"data", data_of(fit, options)},
                  {"command", command_of(options)},
                  {"method", method_of(options)},
                  {"rms_residual_mpa", rounded(fit.fit.rms_residual)},
                  {"largest_stress_mpa", rounded(fit.curve.largest_stress())},
                  {"stable_range", stable_range_of(fit.fit.law)}};
  return entry;
}

ordered_json set_document(const std::vector<FittedCurve>& fits, const FitMaterialOptions& options)
{
  ordered_json document, entries, residuals, stresses, ranges;
  for (const FittedCurve& fit : fits)
  {
    entries[fit.name] = tissue_entry(fit.fit.law);
    residuals[fit.name] = rounded(fit.fit.rms_residual);
    stresses[fit.name] = rounded(fit.curve.largest_stress());
    ranges[fit.name] = stable_range_of(fit.fit.law);
  }
  document["name"] = name_of_result(options);
  document["description"] =
      "Laws (" + options.law + ") fitted to the uniaxial curves of the paper's Table 1" +
      (options.stable ? " with no negative coefficient, so that they are stable at every stretch"
                      : "");
  document["units"] = "MPa";
  document["volumetric_law"] = "barrier";
  document["tissues"] = entries;
  document["stable_range"] = ranges;
  document["fit"] = {{"data", data_of(fits.front(), options)},
                     {"command", command_of(options)},
                     {"method", method_of(options)},
                     {"rms_residual_mpa", residuals},
                     {"largest_stress_mpa", stresses}};
  return document;
}

PlottedSeries fitted_line(const FittedCurve& fit)
{
  const auto [low, high] =
      std::minmax_element(fit.curve.deformation.begin(), fit.curve.deformation.end());
  const double rest = rest_of(fit.curve.loading);
  const StressCurve line = sampled_curve(fit.fit.law, fit.curve.loading, std::min(*low, rest),
                                         std::max(*high, rest), 121);
  return {"", line.deformation, line.stress, PlottedSeries::Style::Line, {}};
}

CurvePlot plot_of(const std::vector<FittedCurve>& fits, const FitMaterialOptions& options)
{
  CurvePlot plot;
  plot.title = "Least-squares fit, law '" + options.law + "'" +
               (options.stable ? ", no negative coefficient" : "");
  const Loading loading = fits.front().curve.loading;
  plot.x_title = loading == Loading::SimpleShear ? "Amount of shear [1]"
                 : loading == Loading::Uniaxial  ? "Stretch, uniaxial [1]"
                                                 : "Stretch, equibiaxial [1]";
  plot.y_title = "Nominal stress [kPa]";
  for (std::size_t i = 0; i < fits.size(); ++i)
  {
    const FittedCurve& fit = fits[i];
    PlottedSeries line = fitted_line(fit);
    line.label = options.table1 ? fit.name + ", fit" : "fit";
    line.colour = fragment_colour(i);
    PlottedSeries data = {options.table1 ? fit.name + ", Table 1 curve" : "data, " + fit.name,
                          fit.curve.deformation, fit.curve.stress, PlottedSeries::Style::Points,
                          line.colour};
    if (options.table1) // a formula's curve must not look like measured points
      data.style = PlottedSeries::Style::DashedLine;
    for (double& part : data.colour)
      part *= 0.5;
    plot.series.push_back(line);
    plot.series.push_back(data);
  }
  for (PlottedSeries& series : plot.series)
    for (double& stress : series.y)
      stress *= 1000;
  return plot;
}

void make_folder(const Path& folder)
{
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (!std::filesystem::is_directory(folder))
    throw Error(folder.string(), "the folder cannot be made", "check the path and its permissions");
}

} // namespace

StressCurve table1_curve(Tissue tissue)
{
  StressCurve curve =
      sampled_curve(read_materials("table1").of(tissue), Loading::Uniaxial, 1.0, 1.3, 61);
  curve.source = std::string("Table 1's curve of ") + name_of(tissue);
  return curve;
}

FitMaterialResult fit_material(const FitMaterialOptions& options)
{
  if (options.table1 == !options.data.empty())
    throw Error("fit-material", "it needs one source of stress and strain",
                "give either a table (DATA.csv) or --table1");
  FitMaterialResult result;
  result.fits = fitted_curves(options);
  const bool set = result.fits.size() > 1;
  const ordered_json document =
      set ? set_document(result.fits, options) : tissue_document(result.fits.front(), options);
  make_folder(options.folder);
  const std::string name = name_of_result(options);
  result.files = {options.folder / (name + ".json"), options.folder / (name + ".png")};
  const OffscreenDisplay display;
  write_png(draw_plot(plot_of(result.fits, options)), result.files[1]);
  write_file_atomically(result.files[0], document.dump(2) + "\n");
  return result;
}

} // namespace f2b
