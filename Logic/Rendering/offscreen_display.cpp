#include <Rendering/offscreen_display.hpp>

#include <Core/error.hpp>
#include <Rendering/child_program.hpp>

#include <X11/Xlib.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace f2b
{

namespace
{

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds start_limit{20000};
constexpr milliseconds polite_stop_limit{3000};
const char* const remedy = "install the Debian package xvfb or set DISPLAY to a local display";

// A display forwarded by ssh has no modern OpenGL, and VTK aborts on it: only local ones will do.
bool is_usable(const std::string& display_name)
{
  const bool is_local = display_name.rfind(":", 0) == 0 || display_name.rfind("unix:", 0) == 0;
  Display* display = is_local ? XOpenDisplay(display_name.c_str()) : nullptr;
  if (!display)
  {
    return false;
  }
  int opcode = 0, event = 0, error = 0;
  const bool has_glx = XQueryExtension(display, "GLX", &opcode, &event, &error);
  XCloseDisplay(display);
  return has_glx;
}

std::string require_program(const std::string& name)
{
  if (const auto program = find_program(name))
  {
    return program->string();
  }
  throw Error("display", "there is none, and " + name + " was not found", remedy);
}

// Runs in the child between fork and exec: only async-signal-safe calls are allowed here.
[[noreturn]] void become_server(const char* program, int number_pipe, pid_t parent)
{
  // SIGTERM and not SIGKILL, so that Xvfb still removes its socket when our process is killed.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent)
  {
    _exit(1);
  }
  setpgid(0, 0); // Ctrl-C in the terminal must not take the display away before we stop it
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  constexpr int number_descriptor = 3;
  if (number_pipe == number_descriptor)
  {
    fcntl(number_pipe, F_SETFD, 0);
  }
  else
  {
    dup2(number_pipe, number_descriptor);
  }
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execl(program, "Xvfb", "-displayfd", "3", "-nolisten", "tcp", "-screen", "0", "1600x1200x24",
        "-noreset", static_cast<char*>(nullptr));
  _exit(127);
}

// The server writes its display number and a newline once it accepts clients.
std::string read_display_number(int descriptor)
{
  std::string number;
  const auto deadline = Clock::now() + start_limit;
  while (number.empty() || number.back() != '\n')
  {
    const auto left = std::chrono::duration_cast<milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{descriptor, POLLIN, 0};
    if (left <= 0 || (poll(&waiting, 1, static_cast<int>(left)) <= 0 && errno != EINTR))
    {
      return {};
    }
    std::array<char, 32> text{};
    const ssize_t count = read(descriptor, text.data(), text.size());
    if (count == 0 || (count < 0 && errno != EINTR))
    {
      return {};
    }
    number.append(text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  number.pop_back();
  return number;
}

bool has_ended(pid_t child)
{
  const pid_t answer = waitpid(child, nullptr, WNOHANG);
  return answer == child || (answer < 0 && errno == ECHILD);
}

void stop_server(pid_t child)
{
  kill(child, SIGTERM);
  const auto deadline = Clock::now() + polite_stop_limit;
  while (Clock::now() < deadline)
  {
    if (has_ended(child))
    {
      return;
    }
    std::this_thread::sleep_for(milliseconds(5));
  }
  kill(child, SIGKILL);
  while (waitpid(child, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

} // namespace

OffscreenDisplay::OffscreenDisplay(Choice choice)
{
  const char* display = std::getenv("DISPLAY");
  m_had_display = display != nullptr;
  m_previous_display = display ? display : "";
  if (choice == Choice::UsersOrPrivate && is_usable(m_previous_display))
  {
    m_name = m_previous_display;
    return;
  }
  start_private_server();
  setenv("DISPLAY", m_name.c_str(), 1);
}

OffscreenDisplay::~OffscreenDisplay()
{
  if (m_server > 0)
  {
    stop_server(m_server);
    restore_environment();
  }
}

void OffscreenDisplay::start_private_server()
{
  const std::string program = require_program("Xvfb");
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0)
  {
    throw Error("display", std::string("no pipe: ") + std::strerror(errno), "close other programs");
  }
  const pid_t parent = getpid();
  m_server = fork();
  if (m_server == 0)
  {
    become_server(program.c_str(), pipe_ends[1], parent);
  }
  close(pipe_ends[1]);
  const std::string number = m_server > 0 ? read_display_number(pipe_ends[0]) : std::string();
  close(pipe_ends[0]);
  m_name = ":" + number;
  if (number.empty() || !is_usable(m_name))
  {
    if (m_server > 0)
    {
      stop_server(m_server);
    }
    m_server = 0;
    throw Error("display", program + " did not start a display with GLX", remedy);
  }
}

void OffscreenDisplay::restore_environment()
{
  if (m_had_display)
  {
    setenv("DISPLAY", m_previous_display.c_str(), 1);
  }
  else
  {
    unsetenv("DISPLAY");
  }
}

} // namespace f2b
