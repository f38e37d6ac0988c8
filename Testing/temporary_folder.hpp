#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace f2b::test
{

/// A folder of this process's running test, with a space and an umlaut in its name; gone afterwards.
/// Programs that run beside it, such as those of another working copy, have folders of their own.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    m_path = std::filesystem::temp_directory_path() /
             (std::string("f2b gesicht ü ") + test->test_suite_name() + "." + test->name() + " " +
              std::to_string(::getpid()));
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directories(m_path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(m_path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
  const std::filesystem::path& path() const { return m_path; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const
  {
    std::filesystem::create_directories((m_path / name).parent_path());
    std::ofstream(m_path / name, std::ios::binary) << bytes;
    return m_path / name;
  }

  std::size_t file_count() const
  {
    const std::filesystem::directory_iterator files(m_path);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

private:
  std::filesystem::path m_path;
};

/// Drops the last `bytes` of a file.
inline void cut_off(const std::filesystem::path& file, std::uintmax_t bytes)
{
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - bytes);
}

inline std::string read_text(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace f2b::test
