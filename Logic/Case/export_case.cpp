#include "Bridge/calculix_file.hpp"
#include "Bridge/febio_file.hpp"
#include "Bridge/mesh_file.hpp"
#include "Case/verbs.hpp"
#include "Core/error.hpp"
#include "Core/mesh/split_prisms.hpp"
#include "Rendering/atomic_file.hpp"

#include <unistd.h>

namespace f2b
{
namespace
{

/// Writes the problem to a file that nobody reads yet.
void write_problem(const ForwardProblem& problem, const std::string& title,
                   const ExportOptions& options, const Path& file)
{
  const DeckOptions deck = {title, options.increments};
  if (options.format == "vtu")
    write_mesh(file, problem.mesh, {{"prescribed_displacement", fragment_displacements(problem)}});
  else
    write_file_atomically(file, options.format == "febio" ? febio_deck(problem, deck)
                                                          : calculix_deck(problem, deck));
}

void require_outside(const CaseFolder& folder, const Path& file)
{
  const Path relative = std::filesystem::weakly_canonical(file).lexically_relative(folder.path());
  if (!relative.empty() && *relative.begin() != "..")
    throw Error(file.string(), "it lies in the case folder, whose files have their own names",
                "leave out -o, or give a file elsewhere");
}

/// A file beside another, which takes its place when it is whole.
class FileBeside
{
public:
  explicit FileBeside(const Path& file)
      : m_file(file), m_path(file.parent_path() /
                             ("." + std::to_string(::getpid()) + "-" + file.filename().string()))
  {
  }
  ~FileBeside()
  {
    std::error_code ignored;
    std::filesystem::remove(m_path, ignored);
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  const Path& path() const { return m_path; }
  void take_its_place() const
  {
    std::error_code failed;
    std::filesystem::rename(m_path, m_file, failed);
    if (failed)
      throw Error(m_file.string(), "it cannot be written: " + failed.message(),
                  "give a file in a folder that you may write to");
  }

private:
  Path m_file, m_path;
};

Path file_name(const std::string& format)
{
  return format == "febio" ? "export.feb" : format == "vtu" ? "export.vtu" : "export.inp";
}

} // namespace

void export_case(CaseSession& session, const ExportOptions& options)
{
  if (!options.file.empty())
    require_outside(session.folder, options.file);
  session.progress("exporting", 0);
  const LoadedFace face(session);
  const MixedMesh mesh = options.split_prisms ? split_prisms(face.mesh) : face.mesh;
  const ForwardProblem problem = {mesh, face.materials, motions_to_predict(session, face)};
  const std::string title = "Forward problem of the case '" + session.settings.name + "'.";
  if (!options.file.empty())
  {
    const FileBeside file(options.file);
    write_problem(problem, title, options, file.path());
    file.take_its_place();
  }
  else
  {
    CaseChange change(session.folder);
    write_problem(problem, title, options, change.file(file_name(options.format).string()));
    change.commit("export " + options.format);
  }
  session.progress("exported", 1);
}

} // namespace f2b
