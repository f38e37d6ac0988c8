#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace f2b::test
{

/// Runs work in a child process of its own, silent; \return its process id
template <class Work>
pid_t start_child(const Work& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout))
    {
      _exit(3);
    }
    alarm(60); // what hangs is killed
    work();
    _exit(0);
  }
  return child;
}

/// How a child ended: its exit code, or minus the signal that ended it.
inline int end_of(pid_t child)
{
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace f2b::test
