#include "Bridge/calculix_file.hpp"
#include "Bridge/material_file.hpp"
#include "Case/case_session.hpp"
#include "Core/mesh/split_prisms.hpp"
#include "Logic/Core/slab_mesh.hpp"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

/// Do we and CalculiX find the same equilibrium, and who is faster?
///
/// The same plain linear tetrahedra (prisms split), material, volumetric law and equal increments
/// of one movement. Both sides count from the mesh in memory or on disk to the last displacement:
/// ours building the model and solving, ccx its whole run. Prints JSON; exit 77 without ccx.

namespace
{

using namespace f2b;
using nlohmann::json;

struct Request
{
  std::string mesh; ///< a case folder, or slab:CELLS
  std::string materials;
  RigidMotion motion;
  int increments = 5;
  Path work;
};

/// Wall-clock and processor seconds of something that was done.
struct Cost
{
  double wall = 0, processor = 0;
};

double processor_seconds(int whose)
{
  rusage usage{};
  getrusage(whose, &usage);
  return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

template <class Action>
Cost cost_of(int whose, const Action& action)
{
  const double before = processor_seconds(whose);
  const Stopwatch watch;
  action();
  return {watch.seconds(), processor_seconds(whose) - before};
}

json told(const Cost& cost)
{
  return {{"wall_s", cost.wall}, {"processor_s", cost.processor}};
}

/// How well ccx's own measure of equilibrium is met: the largest unbalanced force over the mean of
/// the elements' nodal forces (both by component).
double calculix_residual(const MixedMesh& mesh, const MaterialSet& materials,
                         const ElasticModel& model, const std::vector<Vec3>& x)
{
  double sum = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
  {
    Tet4::Positions rest, here;
    for (Eigen::Index a = 0; a < 4; ++a)
    {
      const auto node = std::size_t(mesh.tets[t][std::size_t(a)]);
      rest.col(a) = mesh.X[node];
      here.col(a) = x[node];
    }
    sum += std::visit([&](const auto& law)
                      { return element_forces(make_tet4(rest), here, law).cwiseAbs().sum(); },
                      materials.of(mesh.tet_tissue[t]));
  }
  return model.forces(x).lpNorm<Eigen::Infinity>() / (sum / double(12 * mesh.tets.size()));
}

/// Our solve, in equal increments of the displacement as ccx ramps it, or as our solver likes.
struct OurSolve
{
  OurSolve(const ForwardProblem& problem, int increments)
  {
    cost = cost_of(RUSAGE_SELF, [&] { solve(problem, increments); });
    // measured after the clock has stopped
    residual = calculix_residual(problem.mesh, problem.materials, *model, x);
  }

  void solve(const ForwardProblem& problem, int increments)
  {
    tissue = std::make_unique<Discretization>(problem.mesh);
    model = std::make_unique<ElasticModel>(*tissue, problem.materials,
                                           held_nodes(problem.mesh, Held::BoneAndFragments));
    EquilibriumOptions options;
    options.step_tolerance_mm = 3e-7; // leaves less than 1e-6 in ccx's measure
    EquilibriumSolver solver(*model, options);
    const std::vector<Vec3> u = fragment_displacements(problem);
    x = problem.mesh.X;
    for (int i = 1; i <= increments; ++i)
    {
      std::vector<Vec3> target = problem.mesh.X;
      for (std::size_t n = 0; n < target.size(); ++n)
        target[n] += double(i) / increments * u[n];
      summary.add(solver.move_to(x, target));
      if (!summary.converged())
        throw std::runtime_error("our solver did not reach increment " + std::to_string(i));
    }
  }

  json told_json() const
  {
    const SolveEffort& effort = summary.effort;
    return {{"time_s", time_split(effort)},
            {"cg_iterations", effort.cg_iterations},
            {"factorization_gflop", 1e-9 * effort.factorization_flops},
            {"wall_s", cost.wall},
            {"processor_s", cost.processor},
            {"newton_iterations", summary.newton_iterations},
            {"factorizations", summary.effort.factorizations},
            {"residual", residual}};
  }

  std::unique_ptr<Discretization> tissue;
  std::unique_ptr<ElasticModel> model;
  std::vector<Vec3> x;
  EquilibriumSummary summary;
  Cost cost;
  double residual = 0;
};

std::string output_of(const std::string& command)
{
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  char buffer[256];
  while (pipe && fgets(buffer, sizeof buffer, pipe.get()))
    text += buffer;
  return text;
}

std::string calculix_version()
{
  std::istringstream words(output_of("ccx -v 2>/dev/null"));
  std::string version;
  for (std::string word; words >> word;)
    version = word; // the last one
  return version;
}

Cost run_calculix(const Path& deck)
{
  const std::string command = "cd '" + deck.parent_path().string() + "' && OMP_NUM_THREADS=2 ccx " +
                              deck.stem().string() + " > " + deck.stem().string() + ".log 2>&1";
  int status = 0;
  const Cost cost = cost_of(RUSAGE_CHILDREN, [&] { status = std::system(command.c_str()); });
  if (status != 0)
    throw std::runtime_error("ccx failed; see its log beside " + deck.string());
  return cost;
}

/// Displacements in the last block that ccx printed.
std::vector<Vec3> read_displacements(const Path& file, std::size_t nodes)
{
  std::vector<Vec3> u(nodes, Vec3::Zero());
  std::size_t count = 0;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::size_t node = 0;
    Vec3 value;
    if (line.find("displacements") != std::string::npos)
      count = 0;
    else if (words >> node >> value[0] >> value[1] >> value[2])
    {
      u.at(node - 1) = value;
      ++count;
    }
  }
  if (count != nodes)
    throw std::runtime_error(file.string() + " has " + std::to_string(count) + " of " +
                             std::to_string(nodes) + " displacements: ccx did not finish");
  return u;
}

int count_of(const Path& file, const std::string& part)
{
  int count = 0;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    count += line.find(part) != std::string::npos;
  return count;
}

json difference(const MixedMesh& mesh, const std::vector<Vec3>& x, const std::vector<Vec3>& u)
{
  double sum = 0, worst = 0, largest = 0;
  for (std::size_t n = 0; n < x.size(); ++n)
  {
    const double apart = (x[n] - mesh.X[n] - u[n]).norm();
    sum += apart * apart;
    worst = std::max(worst, apart);
    largest = std::max(largest, u[n].norm());
  }
  return {{"largest_displacement_mm", largest},
          {"rms_relative", std::sqrt(sum / double(x.size())) / largest},
          {"max_relative", worst / largest}};
}

json compare(const ForwardProblem& problem, const Request& request)
{
  std::filesystem::create_directories(request.work);
  const Path deck = std::filesystem::absolute(request.work) / "forward.inp";
  std::ofstream(deck) << calculix_deck(problem, {"FaceToBone against ccx", request.increments});
  const OurSolve ours(problem, request.increments);
  const OurSolve our_way(problem, 1);
  const Cost theirs = run_calculix(deck);
  const Path printed = Path(deck).replace_extension(".dat");
  const Path log = Path(deck).replace_extension(".log");
  json ccx = told(theirs);
  ccx["version"] = calculix_version();
  ccx["iterations"] = count_of(log, " iteration ");
  return {{"deck", deck.string()},
          {"nodes", problem.mesh.X.size()},
          {"tets", problem.mesh.tets.size()},
          {"increments", request.increments},
          {"difference",
           difference(problem.mesh, ours.x, read_displacements(printed, problem.mesh.X.size()))},
          {"ccx", ccx},
          {"ours", ours.told_json()},
          {"ours_in_one_increment", our_way.told_json()},
          {"times_faster", theirs.wall / ours.cost.wall},
          {"times_faster_processor", theirs.processor / ours.cost.processor},
          {"times_faster_in_one_increment", theirs.wall / our_way.cost.wall}};
}

json compare(Request request)
{
  const MaterialSet materials = read_materials(request.materials);
  if (request.mesh.rfind("slab:", 0) == 0)
  {
    testing::SlabOptions slab = {std::stoi(request.mesh.substr(5)), 3, 80, 14, 1.5, 4, 0.4};
    const MixedMesh mesh = split_prisms(testing::make_slab(slab));
    return compare({mesh, materials, {request.motion}}, request);
  }
  const CaseSession session = CaseSession::open(request.mesh);
  const LoadedFace face(session);
  const MixedMesh mesh = split_prisms(face.mesh);
  std::vector<RigidMotion> motions = rest_motions(face.model());
  request.motion.reference_point = face.reference_points.front();
  motions.front() = request.motion;
  return compare({mesh, materials, motions}, request);
}

RigidMotion motion_from(const std::string& text)
{
  std::istringstream numbers(text);
  double v[6] = {};
  for (double& value : v)
  {
    numbers >> value;
    numbers.ignore(1, ',');
  }
  if (numbers.bad())
    throw std::runtime_error("the movement is not six numbers");
  const double degree = std::acos(-1.0) / 180;
  RigidMotion motion;
  motion.translation = {v[0], v[1], v[2]};
  motion.rotation = rotation_from({v[3] * degree, v[4] * degree, v[5] * degree});
  return motion;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 6)
  {
    std::cerr << "usage: compare_calculix CASE_FOLDER|slab:CELLS MATERIALS "
                 "right,anterior,superior,pitch,roll,yaw INCREMENTS WORK_FOLDER\n";
    return 2;
  }
  if (std::system("command -v ccx > /dev/null 2>&1") != 0)
  {
    std::cerr << "compare_calculix: there is no ccx here (Debian: calculix-ccx)\n";
    return 77;
  }
  try
  {
    const json result =
        compare({argv[1], argv[2], motion_from(argv[3]), std::stoi(argv[4]), argv[5]});
    std::cout << result.dump(2) << "\n";
    return result["difference"]["rms_relative"] < 0.005 ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << "compare_calculix: " << error.what() << "\n";
    return 1;
  }
}
