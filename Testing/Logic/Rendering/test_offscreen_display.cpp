#include <Rendering/offscreen_display.hpp>
#include <Rendering/quiet_messages.hpp>

#include <Core/error.hpp>

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{

using f2b::OffscreenDisplay;

bool is_running(pid_t process)
{
  // A zombie that waits for its new parent has ended too.
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  return std::getline(stat, text) && text.find(") Z") == std::string::npos;
}

bool has_files(const std::string& display_name)
{
  const std::string number = display_name.substr(1);
  return std::filesystem::exists("/tmp/.X11-unix/X" + number) ||
         std::filesystem::exists("/tmp/.X" + number + "-lock");
}

template <class Condition>
bool becomes_true_within_5_s(Condition condition)
{
  for (int i = 0; i < 500 && !condition(); ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

/// What a child process tells about its display.
struct ChildReport
{
  pid_t server = 0;
  std::array<char, 32> name{};
};

struct Child
{
  pid_t process = 0;
  ChildReport report;
};

// A process with a display of its own that waits to be killed; ends with 1 if it gets none.
Child start_child(uid_t user)
{
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  Child child;
  child.process = fork();
  if (child.process == 0)
  {
    if (user != getuid() && setuid(user) != 0)
    {
      _exit(1);
    }
    try
    {
      const OffscreenDisplay display(OffscreenDisplay::Choice::Private);
      ChildReport report;
      report.server = display.private_server();
      display.name().copy(report.name.data(), report.name.size() - 1);
      if (write(ends[1], &report, sizeof report) == sizeof report)
      {
        pause();
      }
    }
    catch (const f2b::Error&)
    {
    }
    _exit(1);
  }
  close(ends[1]);
  EXPECT_EQ(read(ends[0], &child.report, sizeof child.report),
            static_cast<ssize_t>(sizeof child.report));
  close(ends[0]);
  return child;
}

void kill_hard(pid_t process)
{
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
}

class Display : public testing::Test
{
protected:
  void SetUp() override { unsetenv("DISPLAY"); }
};

TEST_F(Display, PrivateServerStartsAndLeavesNothing)
{
  std::string name;
  pid_t server = 0;
  {
    const OffscreenDisplay display;
    name = display.name();
    server = display.private_server();
    EXPECT_GT(server, 0);
    EXPECT_TRUE(is_running(server));
    EXPECT_EQ(std::getenv("DISPLAY"), name);
  }
  EXPECT_FALSE(is_running(server));
  EXPECT_FALSE(has_files(name));
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST_F(Display, UsableDisplayIsShared)
{
  const OffscreenDisplay first;
  const OffscreenDisplay second;
  EXPECT_EQ(second.private_server(), 0);
  EXPECT_EQ(second.name(), first.name());
}

TEST_F(Display, UnusableDisplayIsReplacedAndRestored)
{
  setenv("DISPLAY", ":987", 1);
  {
    const OffscreenDisplay display;
    EXPECT_GT(display.private_server(), 0);
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), ":987");
}

TEST_F(Display, TwoProcessesDoNotDisturbEachOther)
{
  const Child first = start_child(getuid());
  const Child second = start_child(getuid());
  EXPECT_STRNE(first.report.name.data(), second.report.name.data());
  kill_hard(first.process);
  EXPECT_TRUE(becomes_true_within_5_s([&] { return !is_running(first.report.server); }));
  setenv("DISPLAY", second.report.name.data(), 1);
  EXPECT_EQ(OffscreenDisplay().private_server(), 0) << "the second display is still usable";
  kill_hard(second.process);
}

TEST_F(Display, KilledProcessLeavesNothing)
{
  const Child child = start_child(getuid());
  const std::string name = child.report.name.data();
  ASSERT_GT(child.report.server, 0);
  kill_hard(child.process);
  EXPECT_TRUE(becomes_true_within_5_s([&] { return !is_running(child.report.server); }));
  EXPECT_TRUE(becomes_true_within_5_s([&] { return !has_files(name); }));
}

TEST_F(Display, OrdinaryUserHasOneToo)
{
  if (getuid() != 0)
  {
    GTEST_SKIP() << "only root can become somebody else";
  }
  constexpr uid_t nobody = 65534;
  const Child child = start_child(nobody);
  EXPECT_GT(child.report.server, 0);
  kill_hard(child.process);
  EXPECT_TRUE(becomes_true_within_5_s([&] { return !is_running(child.report.server); }));
}

TEST_F(Display, MissingXvfbIsOneClearLine)
{
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  try
  {
    const OffscreenDisplay display;
    ADD_FAILURE() << "a display without Xvfb";
  }
  catch (const f2b::Error& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("Xvfb was not found"), std::string::npos) << text;
    EXPECT_NE(text.find("xvfb"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
  setenv("PATH", path.c_str(), 1);
}

TEST(QuietMessages, KeepsVtkOffTheTerminalAndRemembersTheFirstError)
{
  testing::internal::CaptureStderr();
  {
    const f2b::QuietMessages messages;
    EXPECT_EQ(messages.first_error(), "");
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->Update(); // an input is missing
    EXPECT_NE(messages.first_error().find("vtkPolyDataMapper"), std::string::npos);
    EXPECT_EQ(messages.first_error().find('\n'), std::string::npos);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
