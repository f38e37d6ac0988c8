#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Which labels does a NRRD file hold, and what are they called? Plain arrays, because ITK's headers
/// bring an Eigen of their own.
namespace f2b
{

struct LabelVolume
{
  int size[3] = {0, 0, 0};
  std::vector<unsigned short> values;
  double to_index[3][4] = {};          ///< rows: index along i, j, k from a point in LPS [mm]
  std::map<int, std::string> segments; ///< names by value, of a Slicer segmentation
  bool is_segmentation = false;

  /// -1 outside.
  int at_lps(double l, double p, double s) const;
};

/// Throws Error naming the file.
LabelVolume read_label_volume(const std::filesystem::path& file);

} // namespace f2b
