#include <Rendering/html_text.hpp>

#include <Core/error.hpp>

#include <fstream>
#include <sstream>

namespace f2b
{

std::string html_escaped(std::string_view text)
{
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text)
  {
    const bool is_control = (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') ||
                            static_cast<unsigned char>(c) == 0x7f;
    switch (c)
    {
    case '&':
      escaped += "&amp;";
      break;
    case '<':
      escaped += "&lt;";
      break;
    case '>':
      escaped += "&gt;";
      break;
    case '"':
      escaped += "&quot;";
      break;
    case '\'':
      escaped += "&#39;";
      break;
    default:
      escaped += is_control ? std::string("\xef\xbf\xbd") : std::string(1, c);
    }
  }
  return escaped;
}

std::string base64(std::string_view bytes)
{
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += k <= count ? alphabet[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string png_data_uri(const std::filesystem::path& png)
{
  std::ifstream file(png, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  if (!file || bytes.str().compare(0, signature.size(), signature) != 0)
  {
    throw Error(png.string(), "not a readable PNG picture", "draw the pictures again");
  }
  return "data:image/png;base64," + base64(bytes.str());
}

} // namespace f2b
