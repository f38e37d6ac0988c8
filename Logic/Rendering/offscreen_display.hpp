#pragma once

#include <string>
#include <sys/types.h>

/// Where does VTK draw when there is no screen?
///
/// Debian's VTK needs an X display with GLX even for pictures that nobody sees. While an
/// OffscreenDisplay lives, this process has one: a local display that the user already has, or a
/// private Xvfb which ends with this object. Xvfb also ends when this process dies in any way, and
/// leaves no file behind. Nothing is ever shown on either.
namespace f2b
{

class OffscreenDisplay
{
public:
  enum class Choice
  {
    UsersOrPrivate, ///< the display in DISPLAY if it is local and has GLX, else a private Xvfb
    Private,        ///< always a private Xvfb, as when no DISPLAY is set
  };

  /// Sets DISPLAY for this process, so construct it before other threads read the environment, and
  /// on a thread that outlives it (Xvfb ends with the thread that started it).
  /// \throws f2b::Error when there is no display and Xvfb is missing or does not start
  explicit OffscreenDisplay(Choice choice = Choice::UsersOrPrivate);
  ~OffscreenDisplay();

  OffscreenDisplay(const OffscreenDisplay&) = delete;
  OffscreenDisplay& operator=(const OffscreenDisplay&) = delete;

  /// As in DISPLAY, such as ":99".
  const std::string& name() const { return m_name; }

  /// Process id of the private Xvfb, or 0 when the user's display serves.
  pid_t private_server() const { return m_server; }

private:
  void start_private_server();
  void restore_environment();

  std::string m_name;
  std::string m_previous_display;
  bool m_had_display = false;
  pid_t m_server = 0;
};

} // namespace f2b
