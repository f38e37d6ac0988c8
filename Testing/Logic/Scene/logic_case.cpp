#include "Logic/Scene/logic_case.hpp"

#include "Bridge/json_file.hpp"
#include "Case/verbs.hpp"

namespace f2b::test
{

using nlohmann::json;

std::filesystem::path write_coarse_case(const std::filesystem::path& folder)
{
  SampleOptions options;
  options.spacing_mm = 2.5;
  write_sample(folder / "sample", options, no_progress);
  json document = read_json(folder / "sample/case.json");
  document["region_ras"] = {{"min", {-60, 5, -120}}, {"max", {60, 115, 10}}};
  document["segmentation"] = {{"spacing_mm", 2.5}};
  document["mesh"] = {{"density", 0.05}};
  document["solver"] = {{"max_fit_iterations", 2}, {"step_tolerance_mm", 1e-4}};
  write_json(folder / "sample/coarse.json", document);
  return folder / "sample/coarse.json";
}

json smallest_case()
{
  return {{"schema", "facetobone-case/1"},
          {"ct", "ct.nrrd"},
          {"landmarks", "l.mrk.json"},
          {"osteotomies", {{{"fragment", "mid-face"}, {"template", "le-fort-3"}}}},
          {"target", {{"mesh", "skin.vtp"}}}};
}

} // namespace f2b::test
