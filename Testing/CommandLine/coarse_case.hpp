#pragma once

#include "CommandLine/program.hpp"

#include <nlohmann/json.hpp>

/// The virtual patient on a coarse lattice and mesh: everything is there, and quick.
namespace f2b::test
{

/// The sample's folder; made by CTest before the tests, and here if it was not.
Path coarse_sample();
/// Its case with coarse settings and absolute paths.
nlohmann::json coarse_case();
/// Writes a case file and returns its path.
Path write_case(const Path& folder, const nlohmann::json& document,
                const std::string& name = "case.json");

/// A folder of this program's, removed when the program ends.
Path scratch_folder();

} // namespace f2b::test
