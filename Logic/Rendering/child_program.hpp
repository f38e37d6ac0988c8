#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// How is another program run so that it never outlives us?
namespace f2b
{

/// The path of a program that PATH has, if it has it.
std::optional<std::filesystem::path> find_program(const std::string& name);

struct ChildResult
{
  int exit_code = -1; ///< -1: ended by a signal, or by the limit
  bool timed_out = false;
  std::string messages; ///< the end of what it wrote to stderr
};

/// Runs a program to its end, without input and with a quiet stdout. It is killed when it takes
/// longer than `limit`, and when this process ends in any way.
ChildResult run_program(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, std::chrono::seconds limit);

} // namespace f2b
