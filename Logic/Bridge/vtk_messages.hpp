#pragma once

#include <memory>

/// Did VTK complain while something was read or written?
namespace f2b
{

/// While it lives, VTK's warnings and errors are kept off the terminal, and errors are remembered.
/// Not for concurrent use.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool error() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> m_implementation;
};

} // namespace f2b
