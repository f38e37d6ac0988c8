#pragma once

#include "temporary_folder.hpp"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneMainWindow.h"

#include <Rendering/offscreen_display.hpp>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <gtest/gtest.h>

#include <clocale>
#include <memory>

/// The main window on a display that nobody sees, with settings and folders of its own.
namespace f2b::testing
{

/// One application for a test program; it ends before the program's static objects do.
class ApplicationEnvironment : public ::testing::Environment
{
public:
  void SetUp() override
  {
    m_display = std::make_unique<OffscreenDisplay>();
    qputenv("QT_QPA_PLATFORM", "xcb");
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
    m_application = std::make_unique<QApplication>(m_count, m_names);
    std::setlocale(LC_NUMERIC, "C");
    QStandardPaths::setTestModeEnabled(true);
  }
  void TearDown() override
  {
    m_application.reset();
    m_display.reset();
  }

private:
  int m_count = 1;
  char m_name[5] = "test";
  char* m_names[2] = {m_name, nullptr};
  std::unique_ptr<OffscreenDisplay> m_display;
  std::unique_ptr<QApplication> m_application;
};
inline ::testing::Environment* const application_environment =
    ::testing::AddGlobalTestEnvironment(new ApplicationEnvironment);

/// Works through the window's events until something holds. \return whether it did within the time
template <class Condition>
bool wait_until(Condition condition, int seconds)
{
  QElapsedTimer since;
  since.start();
  QTimer wake; // so that a condition that no event makes true is looked at again
  wake.start(20);
  while (!condition())
  {
    if (since.elapsed() > 1000LL * seconds)
      return false;
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return true;
}

class DesktopStage : public ::testing::Test
{
protected:
  DesktopStage()
  {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString((folder / "settings").string()));
    window = std::make_unique<qFaceToBoneMainWindow>();
    window->show();
    QCoreApplication::processEvents();
  }
  qFaceToBoneCase* work() { return window->work(); }
  /// Does a step and waits for its end. \return the message of a failure
  std::string run(qFaceToBoneCase::Step step, int seconds = 500)
  {
    QString message = "it could not be started: ";
    const auto seen = QObject::connect(work()->task(), &qFaceToBoneTask::ended,
                                       [&](bool, const QString& text) { message = text; });
    if (work()->start(step))
      wait_until([&] { return !work()->task()->isRunning(); }, seconds);
    else
      message += work()->error();
    QObject::disconnect(seen);
    return message.toStdString();
  }
  bool background_ends(int seconds = 300)
  {
    return wait_until([&] { return !work()->background()->isRunning(); }, seconds);
  }
  /// Presses a button of the next question of what becomes of unkept work; how often so far is in
  /// `answered`.
  void answer(QMessageBox::StandardButton button)
  {
    auto* waiting = new QTimer(window.get());
    QObject::connect(waiting, &QTimer::timeout, window.get(),
                     [this, waiting, button]
                     {
                       auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                       if (!box || box->objectName() != "unsaved")
                         return;
                       waiting->deleteLater();
                       ++answered;
                       box->button(button)->click();
                     });
    waiting->start(0);
  }
  int answered = 0;
  /// The text of the box that complains, which is closed; empty if there is none.
  QString complaint()
  {
    QString text;
    for (QMessageBox* box : window->findChildren<QMessageBox*>("complaint"))
    {
      text = box->text();
      box->close();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return text;
  }

  test::TemporaryFolder folder;
  std::unique_ptr<qFaceToBoneMainWindow> window;
};

} // namespace f2b::testing
