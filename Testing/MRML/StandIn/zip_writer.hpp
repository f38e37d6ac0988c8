#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace f2b::test
{

/// A zip file of these names and contents, stored without compression: also with names that a good
/// program would not write.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files)
{
  const auto number = [](std::uint32_t value, int bytes)
  {
    std::string text;
    for (int i = 0; i < bytes; ++i)
    {
      text += static_cast<char>(value >> 8 * i & 0xff);
    }
    return text;
  };
  const auto checksum = [](const std::string& bytes)
  {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes)
    {
      crc ^= static_cast<unsigned char>(byte);
      for (int bit = 0; bit < 8; ++bit)
      {
        crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
      }
    }
    return ~crc;
  };
  std::string body;
  std::string directory;
  for (const auto& [name, content] : files)
  {
    const auto size = static_cast<std::uint32_t>(content.size());
    const std::string common = number(20, 2) + number(0x800, 2) + number(0, 2) + number(0, 4) +
                               number(checksum(content), 4) + number(size, 4) + number(size, 4) +
                               number(static_cast<std::uint32_t>(name.size()), 2) + number(0, 2);
    directory += "PK\x01\x02" + number(0x0314, 2) + common + number(0, 2) + number(0, 2) +
                 number(0, 2) + number(0100644U << 16, 4) +
                 number(static_cast<std::uint32_t>(body.size()), 4) + name;
    body += "PK\x03\x04" + common + name + content;
  }
  const auto count = static_cast<std::uint32_t>(files.size());
  return body + directory + "PK\x05\x06" + number(0, 4) + number(count, 2) + number(count, 2) +
         number(static_cast<std::uint32_t>(directory.size()), 4) +
         number(static_cast<std::uint32_t>(body.size()), 4) + number(0, 2);
}

} // namespace f2b::test
