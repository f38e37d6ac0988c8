#include "temporary_folder.hpp"

#include <Core/error.hpp>
#include <Rendering/atomic_file.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>

namespace
{

using f2b::test::read_text;
using f2b::test::TemporaryFolder;

std::string error_of_writing(const std::filesystem::path& path, const std::string& bytes)
{
  try
  {
    f2b::write_file_atomically(path, bytes);
  }
  catch (const f2b::Error& error)
  {
    return error.what();
  }
  return {};
}

TEST(AtomicFile, ReplacesTheOldFileAndLeavesNoOther)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  f2b::write_file_atomically(path, "old");
  f2b::write_file_atomically(path, std::string("n\0w", 3));
  EXPECT_EQ(read_text(path), std::string("n\0w", 3));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, MissingFolderIsNamed)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "nowhere" / "a.txt";
  EXPECT_EQ(error_of_writing(path, "x").rfind(path.string() + ": cannot be written", 0), 0u);
}

// A full disk, played by a limit on the size of files.
TEST(AtomicFile, FailureHalfWayKeepsTheOldFileAndLeavesNoRest)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  f2b::write_file_atomically(path, "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1024;
  const auto previous = signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = error_of_writing(path, std::string(100000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, previous);
  EXPECT_NE(error.find(path.string()), std::string::npos);
  EXPECT_EQ(read_text(path), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

} // namespace
