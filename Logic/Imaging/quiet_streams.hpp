#pragma once

#include <itkObject.h>

#include <iostream>
#include <sstream>

/// How are the warnings kept off the terminal that ITK's readers print on their own?
namespace f2b
{

/// Swallows std::cerr, std::cout and ITK's warnings while it lives. Not for concurrent use.
class QuietStreams
{
public:
  QuietStreams()
      : m_cerr(std::cerr.rdbuf(m_text.rdbuf())), m_cout(std::cout.rdbuf(m_text.rdbuf())),
        m_warnings(itk::Object::GetGlobalWarningDisplay())
  {
    itk::Object::GlobalWarningDisplayOff();
  }
  ~QuietStreams()
  {
    std::cerr.rdbuf(m_cerr);
    std::cout.rdbuf(m_cout);
    itk::Object::SetGlobalWarningDisplay(m_warnings);
  }
  QuietStreams(const QuietStreams&) = delete;
  QuietStreams& operator=(const QuietStreams&) = delete;

  std::string text() const { return m_text.str(); }

private:
  std::ostringstream m_text;
  std::streambuf* m_cerr;
  std::streambuf* m_cout;
  bool m_warnings;
};

} // namespace f2b
