#include "CommandLine/program.hpp"

#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <functional>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace f2b::test
{
namespace
{

namespace fs = std::filesystem;

/// Becomes the program; never returns.
[[noreturn]] void become(const Arguments& arguments, const Path& out, const Path& err)
{
  const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  std::vector<char*> words = {const_cast<char*>(FACETOBONE_PROGRAM)};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(FACETOBONE_PROGRAM, words.data());
  ::_exit(127);
}

Answer run_after(const std::function<bool()>& prepare, const Arguments& arguments)
{
  static int count = 0;
  const Path stem = fs::temp_directory_path() /
                    ("f2b answer " + std::to_string(::getpid()) + " " + std::to_string(++count));
  const Path out = stem.string() + ".out", err = stem.string() + ".err";
  // made here, so that another user may write to them
  for (const Path& file : {out, err})
    ::close(::open(file.c_str(), O_WRONLY | O_CREAT, 0666)), fs::permissions(file, fs::perms(0666));
  const pid_t child = ::fork();
  if (child == 0)
  {
    if (!prepare())
      ::_exit(126);
    become(arguments, out, err);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const Answer answer{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
  fs::remove(out);
  fs::remove(err);
  return answer;
}

} // namespace

Answer run_program(const Arguments& arguments, const Path& working_folder)
{
  return run_after([&] { return ::chdir(working_folder.c_str()) == 0; }, arguments);
}

Answer run_as_nobody(const Arguments& arguments)
{
  return run_after([] { return ::geteuid() != 0 || ::setuid(65534) == 0; }, arguments);
}

bool run_and_kill(const Arguments& arguments, int after_ms)
{
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const pid_t child = ::fork();
  if (child == 0)
    become(arguments, "/dev/null", "/dev/null");
  ::close(ends[1]);
  std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
  int status = 0;
  const bool running = ::waitpid(child, &status, WNOHANG) == 0;
  if (running)
  {
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
  }
  char nothing; // whatever it has started holds the other end
  while (::read(ends[0], &nothing, 1) < 0 && errno == EINTR)
  {
  }
  ::close(ends[0]);
  return running;
}

std::map<std::string, std::string> snapshot(const Path& folder)
{
  if (!fs::exists(folder))
    return {{"", "not there"}};
  std::map<std::string, std::string> entries;
  if (fs::is_regular_file(folder))
    return {{"", read_text(folder)}};
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    entries[entry.path().lexically_relative(folder).string()] =
        entry.is_regular_file() ? read_text(entry.path()) : "folder";
  return entries;
}

void expect_one_line_refusal(const Answer& answer, const std::vector<std::string>& parts)
{
  EXPECT_EQ(answer.exit_code, 2) << answer.err;
  EXPECT_EQ(answer.out, "");
  ASSERT_FALSE(answer.err.empty());
  EXPECT_EQ(answer.err.find('\n'), answer.err.size() - 1) << "not one line: " << answer.err;
  EXPECT_TRUE(std::none_of(answer.err.begin(), answer.err.end() - 1,
                           [](unsigned char c) { return c < ' '; }))
      << answer.err;
  EXPECT_NE(answer.err.find("; "), std::string::npos) << "no remedy: " << answer.err;
  for (const std::string& part : parts)
    EXPECT_NE(answer.err.find(part), std::string::npos)
        << "'" << part << "' is not in: " << answer.err;
}

void expect_refusal(const Arguments& arguments, const std::vector<std::string>& parts,
                    const Path& folder)
{
  std::string line;
  for (const std::string& argument : arguments)
    line += " " + argument;
  SCOPED_TRACE("facetobone" + line);
  const auto before = snapshot(folder);
  expect_one_line_refusal(run_program(arguments), parts);
  EXPECT_TRUE(snapshot(folder) == before) << folder << " has changed";
}

} // namespace f2b::test
