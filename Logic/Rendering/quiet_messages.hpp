#pragma once

#include <memory>
#include <string>

/// How are VTK's warnings and errors kept off the user's terminal, and yet not lost?
///
/// While a QuietMessages lives, VTK's messages of this process are collected instead of printed.
namespace f2b
{

class QuietMessages
{
public:
  QuietMessages();
  ~QuietMessages();

  QuietMessages(const QuietMessages&) = delete;
  QuietMessages& operator=(const QuietMessages&) = delete;

  /// The first error that VTK reported, on one line; empty if there was none.
  std::string first_error() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace f2b
