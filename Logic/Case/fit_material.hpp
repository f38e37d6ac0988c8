#pragma once

#include "Core/material/law_fit.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Which law follows a stress-strain curve, and how good is it?
namespace f2b
{

struct FitMaterialOptions
{
  std::filesystem::path data;          ///< stress-strain table; empty with `table1`
  bool table1 = false;                 ///< fit the curves of the paper's Table 1 instead
  std::string tissue;                  ///< of Table 1; empty for all three
  std::string law = "yeoh";            ///< yeoh, neo-hookean or mooney-rivlin
  bool stable = false;                 ///< keep every coefficient >= 0
  std::optional<double> poisson_ratio; ///< 0.49, or Table 1's own
  std::filesystem::path folder = ".";  ///< for the material and the plot
};

/// One curve and what was fitted to it.
struct FittedCurve
{
  std::string name; ///< a tissue, or the data file's name
  StressCurve curve;
  LawFit fit;
};

/// What was done; `files` are the material (.json) and the plot (.png).
struct FitMaterialResult
{
  std::vector<FittedCurve> fits;
  std::vector<std::filesystem::path> files;
};

/// Fits, and writes both files. One curve gives an entry for a tissue of a material file; the three
/// of Table 1 give a whole material file. Throws Error.
FitMaterialResult fit_material(const FitMaterialOptions& options);

/// Table 1's own curve of a tissue, as its stable set is fitted to it: uniaxial, incompressible,
/// stretch 1.00 to 1.30 in 61 points.
StressCurve table1_curve(Tissue tissue);

} // namespace f2b
