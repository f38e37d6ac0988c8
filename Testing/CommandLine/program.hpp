#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What does the built program answer, and what does it leave on the disk?
namespace f2b::test
{

using Path = std::filesystem::path;
using Arguments = std::vector<std::string>;

struct Answer
{
  int exit_code = -1;   ///< -1: ended by a signal
  std::string out, err; ///< neither is a terminal
};

/// Runs facetobone to its end.
Answer run_program(const Arguments& arguments, const Path& working_folder = ".");
/// Starts it without output and kills it (SIGKILL) after a while; whether it was still running. Waits
/// for the end of what it has started, too.
bool run_and_kill(const Arguments& arguments, int after_ms);
/// Runs it as a user who owns nothing, where this process may do so.
Answer run_as_nobody(const Arguments& arguments);

/// Every file and folder below one, hidden ones too, with the files' contents; a folder that is not
/// there has one entry that says so.
std::map<std::string, std::string> snapshot(const Path& folder);

/// Expects exit code 2, nothing on stdout, and one line of plain text on stderr that holds every
/// part and a remedy; a folder must be afterwards what it was before.
void expect_refusal(const Arguments& arguments, const std::vector<std::string>& parts,
                    const Path& folder);
/// The same for an answer that is already there.
void expect_one_line_refusal(const Answer& answer, const std::vector<std::string>& parts);

} // namespace f2b::test
