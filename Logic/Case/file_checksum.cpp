#include "Case/file_checksum.hpp"

#include "Core/error.hpp"

#include <openssl/evp.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>

namespace f2b
{
namespace
{

/// Empty if the stream cannot be read to its end.
std::string sha256_of_stream(std::istream& in)
{
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        EVP_MD_CTX_free);
  bool good = in && context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  std::array<char, 1 << 16> bytes{};
  while (good && in)
  {
    in.read(bytes.data(), bytes.size());
    good = !in.bad() && EVP_DigestUpdate(context.get(), bytes.data(),
                                         static_cast<std::size_t>(in.gcount())) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (!good || EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1)
    return {};
  std::string text;
  for (unsigned i = 0; i < length; ++i)
  {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", digest[i]);
    text += two;
  }
  return text;
}

} // namespace

std::string sha256_of(const Path& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string digest = sha256_of_stream(in);
  if (digest.empty())
    throw Error(file.string(), "it cannot be read", "check the file's permissions");
  return digest;
}

std::string sha256_of_text(const std::string& text)
{
  std::istringstream in(text);
  return sha256_of_stream(in);
}

} // namespace f2b
