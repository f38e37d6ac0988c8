#pragma once

#include "Case/case_session.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>

/// What do the programs share that measure something on a case that is segmented, cut and meshed?
namespace f2b::verification
{

/// The first fragment 2 mm to the right, 11 forwards, 5 downwards; pitch 5, roll 2.5 degrees (paper
/// Table 2).
inline std::vector<RigidMotion> table_2_motions(const LoadedFace& face)
{
  const double degree = std::acos(-1.0) / 180;
  std::vector<RigidMotion> motions = rest_motions(face.model());
  motions.front().translation = {2, 11, -5};
  motions.front().rotation = rotation_from({5 * degree, 2.5 * degree, 0});
  return motions;
}

/// Prints what `measure` tells of the case folder that is the program's argument; its exit code.
template <class Measure>
int print_of_case(const char* program, int argc, char** argv, const Measure& measure)
{
  if (argc != 2)
  {
    std::cerr << "usage: " << program << " CASE_FOLDER (segmented, cut and meshed)\n";
    return 2;
  }
  try
  {
    std::cout << measure(CaseSession::open(argv[1])).dump(2) << "\n";
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what() << "\n";
    return 1;
  }
}

} // namespace f2b::verification
