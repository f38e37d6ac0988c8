#include "Imaging/volume_header.hpp"

#include "Core/error.hpp"
#include "Imaging/voxel_buffer.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

[[noreturn]] void truncated(const fs::path& path, std::uintmax_t held, std::uintmax_t promised)
{
  throw Error(path.string(),
              "is truncated: " + std::to_string(held) + " of " + std::to_string(promised) +
                  " bytes of voxels",
              "copy or export the file again");
}

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// All numbers of a text in order; whatever is not part of one separates them. Knows nan and inf.
std::vector<double> numbers(std::string text)
{
  for (char& c : text)
    if (c == '(' || c == ')' || c == ',' || c == '"')
      c = ' ';
  std::istringstream in(text);
  std::vector<double> values;
  for (std::string word; in >> word;)
  {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str())
      values.push_back(value);
  }
  return values;
}

/// `key<separator>value` lines up to a line that `is_last` accepts; tells where the data begins.
template <class IsLast>
std::map<std::string, std::string> key_values(std::istream& in, const std::string& separator,
                                              IsLast is_last)
{
  std::map<std::string, std::string> values;
  int lines = 0;
  for (std::string line; lines < 10000 && std::getline(in, line); ++lines)
  {
    const std::size_t at = line.find(separator);
    if (at != std::string::npos)
      values[trimmed(line.substr(0, at))] = trimmed(line.substr(at + separator.size()));
    if (is_last(line))
      break;
  }
  return values;
}

std::size_t meta_type_size(const std::string& type)
{
  if (type.find("SHORT") != std::string::npos)
    return 2;
  if (type.find("DOUBLE") != std::string::npos || type.find("LONG_LONG") != std::string::npos)
    return 8;
  return type.find("CHAR") != std::string::npos ? 1 : 4;
}

/// Bytes that a zlib stream yields, as far as it goes.
std::uintmax_t inflated_size(std::istream& in)
{
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK)
    return 0;
  std::vector<unsigned char> packed(1 << 16), plain(1 << 18);
  std::uintmax_t total = 0;
  int state = Z_OK;
  while (state == Z_OK && in)
  {
    in.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
    stream.next_in = packed.data();
    stream.avail_in = static_cast<unsigned>(in.gcount());
    while (state == Z_OK && stream.avail_in > 0)
    {
      stream.next_out = plain.data();
      stream.avail_out = static_cast<unsigned>(plain.size());
      state = inflate(&stream, Z_NO_FLUSH);
      total += plain.size() - stream.avail_out;
    }
  }
  inflateEnd(&stream);
  return total;
}

bool is_true(const std::string& text)
{
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

void check_meta_data(const fs::path& path, std::istream& in,
                     const std::map<std::string, std::string>& keys)
{
  auto value = [&](const char* key) { return keys.count(key) ? keys.at(key) : std::string(); };
  std::uintmax_t promised = meta_type_size(value("ElementType"));
  for (const double n : numbers(value("DimSize")))
    promised *= static_cast<std::uintmax_t>(std::max(n, 0.0));
  const std::vector<double> channels = numbers(value("ElementNumberOfChannels"));
  if (!channels.empty())
    promised *= static_cast<std::uintmax_t>(channels[0]);
  std::ifstream separate;
  std::istream* data = &in;
  fs::path data_path = path;
  if (value("ElementDataFile") != "LOCAL")
  {
    data_path = path.parent_path() / value("ElementDataFile");
    if (!fs::is_regular_file(data_path))
      return; // A list or pattern of files: left to ITK, which fails when one is missing.
    separate.open(data_path, std::ios::binary);
    data = &separate;
  }
  const auto begin = static_cast<std::uintmax_t>(data->tellg());
  const std::uintmax_t held =
      is_true(value("CompressedData")) ? inflated_size(*data) : fs::file_size(data_path) - begin;
  if (held < promised)
    truncated(data_path, held, promised);
}

struct GzClose
{
  void operator()(gzFile file) const { gzclose(file); }
};
using GzHandle = std::unique_ptr<std::remove_pointer_t<gzFile>, GzClose>;

constexpr std::size_t nifti_header_size = 348;

template <class T>
T value_at(const unsigned char* bytes, bool swapped)
{
  std::array<unsigned char, sizeof(T)> part;
  std::copy_n(bytes, sizeof(T), part.begin());
  if (swapped)
    std::reverse(part.begin(), part.end());
  T value;
  std::memcpy(&value, part.data(), sizeof(T));
  return value;
}

/// The header of a NIfTI-1 file, in the byte order of this machine where asked for.
class NiftiHeader
{
public:
  explicit NiftiHeader(const std::array<unsigned char, nifti_header_size>& bytes)
      : m_bytes(bytes), m_swapped(raw<int>(0, false) != static_cast<int>(nifti_header_size))
  {
  }
  bool valid() const
  {
    return raw<int>(0, m_swapped) == static_cast<int>(nifti_header_size) && dimension(0) >= 1 &&
           dimension(0) <= 7;
  }
  short dimension(int a) const { return raw<short>(40 + 2 * a, m_swapped); }
  bool swapped() const { return m_swapped; }
  short type() const { return raw<short>(70, m_swapped); }
  short bits() const { return raw<short>(72, m_swapped); }
  float voxel_size(int a) const { return raw<float>(76 + 4 * a, m_swapped); }
  float data_offset() const { return raw<float>(108, m_swapped); }

  std::uintmax_t data_size() const
  {
    std::uintmax_t bytes = static_cast<std::uintmax_t>(std::max<short>(bits(), 0)) / 8;
    for (int a = 1; a <= std::clamp<int>(dimension(0), 0, 7); ++a)
      bytes *= static_cast<std::uintmax_t>(std::max<short>(dimension(a), 1));
    return bytes;
  }

private:
  template <class T>
  T raw(std::size_t at, bool swapped) const
  {
    return value_at<T>(m_bytes.data() + at, swapped);
  }

  std::array<unsigned char, nifti_header_size> m_bytes;
  bool m_swapped;
};

/// The NIfTI library turns NaN voxels into zeros on its own.
/// \param before  bytes of voxels that came before this chunk
void require_numbers(const fs::path& path, const NiftiHeader& header,
                     const std::vector<unsigned char>& chunk, std::uintmax_t before)
{
  const short float_type = 16, double_type = 64;
  const std::size_t width = header.type() == float_type ? 4 : 8;
  if (header.type() != float_type && header.type() != double_type)
    return;
  for (std::size_t at = 0; at + width <= chunk.size(); at += width)
  {
    const double value = width == 4 ? value_at<float>(&chunk[at], header.swapped())
                                    : value_at<double>(&chunk[at], header.swapped());
    if (!std::isfinite(value))
      throw Error(path.string(),
                  "voxel " + std::to_string((before + at) / width) + " is " + std::to_string(value),
                  "export the CT again in Hounsfield units");
  }
}

} // namespace

void check_nrrd(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  const auto keys =
      key_values(in, ":", [](const std::string& line) { return trimmed(line).empty(); });
  std::vector<double> spacing;
  if (keys.count("spacings"))
    spacing = numbers(keys.at("spacings"));
  else if (keys.count("space directions"))
  {
    const std::vector<double> v = numbers(keys.at("space directions"));
    for (std::size_t a = 0; a + 2 < v.size(); a += 3)
      spacing.push_back(std::sqrt(v[a] * v[a] + v[a + 1] * v[a + 1] + v[a + 2] * v[a + 2]));
  }
  if (spacing.size() == 3)
    require_spacing(spacing.data(), path.string());
}

void check_meta_image(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  const auto keys = key_values(
      in, "=", [](const std::string& line) { return line.rfind("ElementDataFile", 0) == 0; });
  for (const char* key : {"ElementSpacing", "ElementSize"})
    if (keys.count(key))
    {
      const std::vector<double> spacing = numbers(keys.at(key));
      if (spacing.size() == 3)
        require_spacing(spacing.data(), path.string());
    }
  check_meta_data(path, in, keys);
}

void check_nifti(const fs::path& path)
{
  const GzHandle file(gzopen(path.c_str(), "rb"));
  std::array<unsigned char, nifti_header_size> bytes{};
  if (!file ||
      gzread(file.get(), bytes.data(), nifti_header_size) != static_cast<int>(nifti_header_size))
    throw Error(path.string(), "is truncated: it ends inside the NIfTI header",
                "copy or export the file again");
  const NiftiHeader header(bytes);
  if (!header.valid())
    throw Error(path.string(), "is not a NIfTI-1 file, or a damaged one",
                "export the CT again as .nii or .nii.gz");
  const double spacing[3] = {header.voxel_size(1), header.voxel_size(2), header.voxel_size(3)};
  require_spacing(spacing, path.string());
  const auto offset = static_cast<z_off_t>(header.data_offset());
  gzseek(file.get(), offset, SEEK_SET);
  std::vector<unsigned char> chunk(1 << 20);
  std::uintmax_t total = 0;
  for (int n; (n = gzread(file.get(), chunk.data(), static_cast<unsigned>(chunk.size()))) > 0;)
  {
    chunk.resize(static_cast<std::size_t>(n));
    require_numbers(path, header, chunk, total);
    total += static_cast<std::uintmax_t>(n);
    chunk.resize(1 << 20);
  }
  if (total < header.data_size())
    truncated(path, total, header.data_size());
}

} // namespace f2b
