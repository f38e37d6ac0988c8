#include "qFaceToBoneTask.h"

#include <QMetaObject>

#include <exception>
#include <new>

namespace
{

/// Leaves the work when the user has cancelled it.
struct Cancelled
{
};

} // namespace

qFaceToBoneTask::qFaceToBoneTask(QObject* parent) : QObject(parent) {}

qFaceToBoneTask::~qFaceToBoneTask()
{
  cancel();
  if (m_thread.joinable())
    m_thread.join();
}

bool qFaceToBoneTask::start(const QString& title, Work work, std::function<void()> then)
{
  if (m_running)
    return false;
  if (m_thread.joinable())
    m_thread.join();
  m_running = true;
  m_cancelled = false;
  m_title = title;
  m_then = std::move(then);
  emit started(title);
  m_thread = std::thread([this, work = std::move(work)] { run(work); });
  return true;
}

void qFaceToBoneTask::cancel()
{
  m_cancelled = true;
}

void qFaceToBoneTask::run(const Work& work)
{
  bool succeeded = false;
  QString message;
  try
  {
    work(
        [this](std::string_view what, double fraction)
        {
          if (m_cancelled)
            throw Cancelled();
          const QString text = QString::fromUtf8(what.data(), static_cast<int>(what.size()));
          QMetaObject::invokeMethod(
              this, [this, text, fraction] { emit progressed(text, fraction); },
              Qt::QueuedConnection);
        });
    succeeded = true;
  }
  catch (const Cancelled&)
  {
  }
  catch (const std::bad_alloc&)
  {
    message = tr("Memory ran out; use a lower mesh density or close other programs");
  }
  catch (const std::exception& error)
  {
    message = QString::fromUtf8(error.what());
  }
  QMetaObject::invokeMethod(
      this, [this, succeeded, message] { end(succeeded, message, m_then); }, Qt::QueuedConnection);
}

void qFaceToBoneTask::end(bool succeeded, const QString& message, const std::function<void()>& then)
{
  const std::function<void()> afterwards = then; // it may start the next piece of work
  QString told = message;
  m_running = false;
  if (succeeded && afterwards)
  {
    try
    {
      afterwards();
    }
    catch (const std::exception& error)
    {
      succeeded = false;
      told = QString::fromUtf8(error.what());
    }
  }
  emit ended(succeeded, told);
}
