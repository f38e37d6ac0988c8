#pragma once

#include <Core/error.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace f2b::test
{

/// Expects one line of `Error` that holds every one of `parts`, a remedy after a semicolon, and not
/// a word on the terminal.
template <class Action>
void expect_error(Action action, const std::vector<std::string>& parts)
{
  ::testing::internal::CaptureStderr();
  std::string message;
  try
  {
    action();
    message = "(no error)";
  }
  catch (const Error& error)
  {
    message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::BadInput) << message;
  }
  catch (const std::exception& error)
  {
    message = std::string("(not an f2b::Error) ") + error.what();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  EXPECT_NE(message.find("; "), std::string::npos) << "no remedy in: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
}

} // namespace f2b::test
