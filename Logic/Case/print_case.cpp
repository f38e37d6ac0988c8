#include "Case/print_case.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/print_file.hpp"
#include "Bridge/vtk_surface.hpp"
#include "Case/fragment_json.hpp"
#include "Core/error.hpp"
#include "Rendering/atomic_file.hpp"

#include <functional>

namespace f2b
{
namespace
{

/// \param place  where a file of that name is to be written
void write_fragments(const CaseFolder& folder, const std::string& format,
                     const std::function<Path(const std::string&)>& place)
{
  const nlohmann::json plan = read_json(folder.require("plan.json", "plan"));
  for (const nlohmann::json& f : plan.at("methods").at("rigid-fit").at("fragments"))
  {
    const std::string name = file_part(f.at("name").get<std::string>());
    TriangleMesh fragment =
        to_triangle_mesh(read_surface(folder.require("fragment_" + name + ".vtp", "cut")));
    const RigidMotion motion = motion_from(f);
    for (const char* state : {"rest", "planned"})
    {
      if (state == std::string("planned"))
        for (Vec3& p : fragment.points)
          p = motion.apply(p);
      write_file_atomically(place(name + "_" + state + "." + format),
                            format == "stl" ? stl_text(fragment) : ply_bytes(fragment));
    }
  }
}

} // namespace

void export_fragments(CaseSession& session, const std::string& format, const Path& folder)
{
  if (!folder.empty())
  {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
      throw Error(folder.string(), "the folder cannot be made: " + failed.message(),
                  "give one where you may write");
    write_fragments(session.folder, format, [&](const std::string& name) { return folder / name; });
    return;
  }
  CaseChange change(session.folder);
  write_fragments(session.folder, format,
                  [&](const std::string& name) { return change.file("print/" + name); });
  change.commit("export " + format);
}

} // namespace f2b
