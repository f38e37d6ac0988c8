#include "CommandLine/tidy_after_kill.hpp"

#include "Case/case_folder.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace f2b
{
namespace
{

/// Until the other end says that it ends, or is closed by its death.
[[noreturn]] void watch(int socket, const Path& case_folder)
{
  ::setsid(); // what is sent to the program's group or terminal is not for its watcher
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::dup2(nowhere, standard);
  char farewell = 0;
  ssize_t count = 0;
  do
    count = ::read(socket, &farewell, 1);
  while (count < 0 && errno == EINTR);
  if (count == 0)
    tidy_case_folder(case_folder);
  ::_exit(0);
}

} // namespace

TidyAfterKill::TidyAfterKill(const std::filesystem::path& case_folder)
{
  int ends[2];
  if (case_folder.empty() || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return;
  m_watcher = ::fork();
  if (m_watcher == 0)
  {
    ::close(ends[0]);
    watch(ends[1], case_folder);
  }
  ::close(ends[1]);
  m_socket = ends[0];
}

TidyAfterKill::~TidyAfterKill()
{
  if (m_socket < 0)
    return;
  const char farewell = 1;
  (void)::send(m_socket, &farewell, 1, MSG_NOSIGNAL);
  ::close(m_socket);
  while (m_watcher > 0 && ::waitpid(m_watcher, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

} // namespace f2b
