#include <Rendering/atomic_file.hpp>

#include <Core/error.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace f2b
{

namespace
{

[[noreturn]] void fail(const std::filesystem::path& path, int error_number)
{
  const bool is_full = error_number == ENOSPC || error_number == EDQUOT;
  throw Error(path.string(), std::string("cannot be written: ") + std::strerror(error_number),
              is_full ? "free some disk space" : "choose a folder that exists and is writable");
}

// 0, or the error number of what went wrong.
int write_all(int descriptor, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR)
    {
      return errno;
    }
    bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return fsync(descriptor) == 0 ? 0 : errno;
}

} // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes)
{
  const std::filesystem::path temporary =
      path.parent_path() / ("." + path.filename().string() + ".part-" + std::to_string(getpid()));
  const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    fail(path, errno);
  }
  int problem = write_all(descriptor, bytes);
  if (close(descriptor) != 0 && problem == 0)
  {
    problem = errno;
  }
  if (problem == 0 && rename(temporary.c_str(), path.c_str()) != 0)
  {
    problem = errno;
  }
  if (problem != 0)
  {
    unlink(temporary.c_str());
    fail(path, problem);
  }
}

} // namespace f2b
