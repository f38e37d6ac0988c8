#include "Case/input_records.hpp"

#include "Bridge/json_file.hpp"
#include "Case/file_checksum.hpp"
#include "Imaging/read_ct.hpp"

#include <algorithm>

namespace f2b
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

json record(const char* input, std::size_t files, const std::string& sha256)
{
  return {{"input", input}, {"files", files}, {"sha256", sha256}};
}

json folder_record(const char* input, const Path& folder)
{
  std::vector<std::string> digests;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !entry.is_symlink())
      digests.push_back(sha256_of(entry.path()));
  std::sort(digests.begin(), digests.end());
  std::string lines;
  for (const std::string& digest : digests)
    lines += digest + "\n";
  return record(input, digests.size(), sha256_of_text(lines));
}

void add_file(json& list, const char* input, const Path& file)
{
  if (!file.empty())
    list.push_back(record(input, 1, sha256_of(file)));
}

} // namespace

json segment_inputs(const CaseSettings& settings)
{
  json list = json::array();
  const Path dicom = dicom_folder_of(settings.ct);
  list.push_back(dicom.empty() ? record("scan", 1, sha256_of(settings.ct))
                               : folder_record("scan", dicom));
  add_file(list, "landmarks", settings.landmarks);
  add_file(list, "seeds", settings.seeds);
  add_file(list, "labels", settings.labels);
  return list;
}

json cut_inputs(const CaseSettings& settings)
{
  json list = json::array();
  for (const OsteotomySettings& o : settings.osteotomies)
  {
    for (const Path& planes : o.planes)
      add_file(list, "cut", planes);
    for (const CurveSettings& curve : o.curves)
      add_file(list, "cut", curve.markup);
  }
  for (const ProtectedSettings& p : settings.protected_structures)
    add_file(list, "protected", p.curve.empty() ? p.mesh : p.curve);
  return list;
}

json target_inputs(const CaseSettings& settings)
{
  json list = json::array();
  const TargetSettings& t = settings.target;
  for (const Path& file : {t.mesh, t.scan, t.warp_from, t.warp_to})
    add_file(list, "target", file);
  return list;
}

json plan_inputs(const CaseSession& session)
{
  json list = json::array();
  for (const char* step : {"segment", "cut", "target"})
    for (const json& input : read_json(session.folder.require(std::string(step) + ".json", step))
                                 .value("inputs", json::array()))
      list.push_back(input);
  const CaseSettings& settings = session.settings;
  if (fs::is_regular_file(settings.materials))
    add_file(list, "materials", settings.materials);
  for (const OsteotomySettings& o : settings.osteotomies)
    if (o.movement.is_object() && o.movement.contains("bite"))
      add_file(list, "splint", fs::u8path(o.movement.at("bite").value("splint", std::string())));
  return list;
}

} // namespace f2b
