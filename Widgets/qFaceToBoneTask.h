#ifndef qFaceToBoneTask_h
#define qFaceToBoneTask_h

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <string_view>
#include <thread>

/// How does a long step run without the window standing still?
///
/// One piece of work at a time in a thread of its own. It tells its progress through a callback, out
/// of which an exception is thrown when the user cancels. Everything else, signals too, happens in
/// the thread that made the task.
class qFaceToBoneTask : public QObject
{
  Q_OBJECT

public:
  using Progress = std::function<void(std::string_view what, double fraction)>;
  using Work = std::function<void(const Progress&)>;

  explicit qFaceToBoneTask(QObject* parent = nullptr);
  /// Cancels and waits.
  ~qFaceToBoneTask() override;

  /// \param then  called in this thread after work that ended without an exception
  /// \return false if other work is still going on
  bool start(const QString& title, Work work, std::function<void()> then = {});
  bool isRunning() const { return m_running; }
  QString title() const { return m_title; }
  /// Asks the work to stop at its next word of progress.
  void cancel();

signals:
  void started(const QString& title);
  void progressed(const QString& what, double fraction);
  /// \param message  one sentence; empty after success and after cancelling
  void ended(bool succeeded, const QString& message);

private:
  void run(const Work& work);
  void end(bool succeeded, const QString& message, const std::function<void()>& then);

  std::thread m_thread;
  std::atomic<bool> m_cancelled{false};
  bool m_running = false;
  QString m_title;
  std::function<void()> m_then;
};

#endif
