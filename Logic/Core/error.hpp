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

/// An error in one line: `subject: problem; remedy`.
class Error : public std::runtime_error
{
public:
  /// \param subject  the file, key or quantity that is wrong, as the user knows it
  /// \param problem  what is wrong with it, with the value
  /// \param remedy   what the user can do about it
  Error(const std::string& subject, const std::string& problem, const std::string& remedy,
        ErrorKind kind = ErrorKind::BadInput)
      : std::runtime_error(subject + ": " + problem + "; " + remedy), m_kind(kind)
  {
  }

  ErrorKind kind() const { return m_kind; }

private:
  ErrorKind m_kind;
};

} // namespace f2b
