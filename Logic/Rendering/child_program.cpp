#include <Rendering/child_program.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace f2b
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_message_bytes = 2000;

// Runs in the child between fork and exec: only async-signal-safe calls are allowed here.
[[noreturn]] void become(const char* program, char* const* arguments, int messages, pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
  {
    _exit(127);
  }
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv(program, arguments);
  _exit(127);
}

// Until the child closes its stderr, or the deadline; false at the deadline.
bool read_messages(int descriptor, Clock::time_point deadline, std::string& text)
{
  for (;;)
  {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready == 0)
    {
      return false;
    }
    std::array<char, 4096> bytes{};
    const ssize_t count = ready > 0 ? read(descriptor, bytes.data(), bytes.size()) : -1;
    if (count == 0 || (count < 0 && errno != EINTR))
    {
      return true;
    }
    text.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (text.size() > 2 * kept_message_bytes)
    {
      text.erase(0, text.size() - kept_message_bytes);
    }
  }
}

} // namespace

std::optional<std::filesystem::path> find_program(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    const std::string candidate = folder + "/" + name;
    if (!folder.empty() && access(candidate.c_str(), X_OK) == 0)
    {
      return candidate;
    }
  }
  return {};
}

ChildResult run_program(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, std::chrono::seconds limit)
{
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  std::transform(words.begin(), words.end(), std::back_inserter(pointers),
                 [](std::string& word) { return word.data(); });
  pointers.push_back(nullptr);
  ChildResult result;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    return result;
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0)
  {
    become(words[0].c_str(), pointers.data(), ends[1], parent);
  }
  close(ends[1]);
  if (child > 0)
  {
    result.timed_out = !read_messages(ends[0], Clock::now() + limit, result.messages);
    if (result.timed_out)
    {
      kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    result.exit_code = WIFEXITED(status) && !result.timed_out ? WEXITSTATUS(status) : -1;
  }
  close(ends[0]);
  return result;
}

} // namespace f2b
