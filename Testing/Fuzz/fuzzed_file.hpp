#pragma once

#include <Core/error.hpp>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

/// What may a reader do with any bytes? Return, or throw f2b::Error in one line; all else is a finding.
namespace f2b::fuzz
{

/// A file of these bytes; one a process, in memory where the system has such a folder.
inline std::filesystem::path file_of(const std::uint8_t* data, std::size_t size,
                                     const std::string& extension)
{
  const std::filesystem::path shared = "/dev/shm";
  const std::filesystem::path folder =
      std::filesystem::is_directory(shared) ? shared : std::filesystem::temp_directory_path();
  const std::filesystem::path file =
      folder / ("facetobone-fuzz-" + std::to_string(getpid()) + extension);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return file;
}

/// Runs a reader; aborts where an error is longer than a line or of another type.
template <class Read>
int expect_orderly(Read read)
{
  try
  {
    read();
  }
  catch (const Error& error)
  {
    if (std::string(error.what()).find('\n') != std::string::npos)
      std::abort();
  }
  return 0;
}

} // namespace f2b::fuzz
