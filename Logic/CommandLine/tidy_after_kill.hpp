#pragma once

#include <filesystem>

#include <sys/types.h>

/// Who tidies up a case folder when the program is killed?
namespace f2b
{

/// A process beside this one that waits for its end. Where that is sudden (SIGKILL, a crash), it
/// finishes or drops what the case folder was being changed to, as the next step would, so that no
/// half-made file stays; otherwise it does nothing.
///
/// Make it before the first thread: it forks. Where that fails there is none.
class TidyAfterKill
{
public:
  explicit TidyAfterKill(const std::filesystem::path& case_folder);
  ~TidyAfterKill();
  TidyAfterKill(const TidyAfterKill&) = delete;
  TidyAfterKill& operator=(const TidyAfterKill&) = delete;

private:
  int m_socket = -1;
  pid_t m_watcher = -1;
};

} // namespace f2b
