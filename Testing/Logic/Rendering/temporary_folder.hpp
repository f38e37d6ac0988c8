#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

/// A folder of a test's own that ends with it.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "f2b-rendering-XXXXXX").string();
    m_path = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(m_path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

  std::size_t file_count() const
  {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(m_path))
    {
      count += entry.exists() ? 1 : 0;
    }
    return count;
  }

private:
  std::filesystem::path m_path;
};
