#pragma once

#include <stdexcept>
#include <string>

/// How does FaceToBone say that it cannot go on?
namespace f2b
{

/// Which of the command line's exit codes an error maps to.
enum class ErrorKind
{
  BadInput,  ///< exit 2: a file, a value or a usage that the user can mend
  Numerical, ///< exit 3: the computation did not reach an answer
};

/// A text as it can stand in one line of a terminal: line breaks and other control characters, which
/// may come from a file, are written out.
inline std::string one_line(const std::string& text)
{
  std::string line;
  for (const char c : text)
  {
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n')
      line += "\\n";
    else if (c == '\t')
      line += "\\t";
    else if (code < 0x20 || code == 0x7f)
      line += {'\\', 'x', "0123456789abcdef"[code >> 4], "0123456789abcdef"[code & 15]};
    else
      line += c;
  }
  return line;
}

/// An error in one line: `subject: problem; remedy`.
class Error : public std::runtime_error
{
public:
  /// \param subject  the file, key or quantity that is wrong, as the user knows it
  /// \param problem  what is wrong with it, with the value
  /// \param remedy   what the user can do about it
  Error(const std::string& subject, const std::string& problem, const std::string& remedy,
        ErrorKind kind = ErrorKind::BadInput)
      : std::runtime_error(one_line(subject + ": " + problem + "; " + remedy)), m_kind(kind)
  {
  }

  ErrorKind kind() const { return m_kind; }

private:
  ErrorKind m_kind;
};

} // namespace f2b
