#pragma once

#include "temporary_folder.hpp"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneMainWindow.h"
#include "qFaceToBoneThreeDView.h"

#include <Core/sculpting/sculpting_session.hpp>
#include <Rendering/offscreen_display.hpp>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMenuBar>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTimer>
#include <QToolButton>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
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

  // the mouse in the 3D view
  QWidget* view() { return window->threeDView(); }
  void look_from(qFaceToBoneThreeDView::Preset preset)
  {
    window->threeDView()->setPreset(preset);
    for (int k = 0; k < 5; ++k)
      QCoreApplication::processEvents();
  }
  /// Where a point is seen, in the 3D view's own pixels.
  QPoint pixel(const Vec3& p)
  {
    vtkRenderer* renderer = window->threeDView()->mainRenderer();
    renderer->SetWorldPoint(p.x(), p.y(), p.z(), 1);
    renderer->WorldToDisplay();
    const double* d = renderer->GetDisplayPoint();
    return {int(d[0]), view()->height() - 1 - int(d[1])};
  }
  QPoint pixel(const std::array<double, 3>& p) { return pixel(Vec3(p.data())); }
  /// Straight to the view: QTest moves the pointer of the display, and its events come when they like.
  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button = Qt::NoButton,
            Qt::KeyboardModifiers keys = {})
  {
    if (type == QEvent::MouseButtonRelease)
      m_buttons &= ~Qt::MouseButtons(button);
    else
      m_buttons |= button;
    QMouseEvent event(type, at, view()->mapToGlobal(at), button, m_buttons, keys);
    QApplication::sendEvent(view(), &event);
  }
  void move(const QPoint& at) { send(QEvent::MouseMove, at); }
  void press(const QPoint& at)
  {
    move(at);
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
  }
  void release(const QPoint& at)
  {
    move(at);
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
    QCoreApplication::processEvents();
  }
  void click(const QPoint& at)
  {
    press(at);
    release(at);
  }
  void drag(const QPoint& from, const QPoint& by)
  {
    press(from);
    for (int k = 1; k <= 4; ++k)
      move(from + by * k / 4);
    release(from + by);
  }
  void choose_brush(const char* text)
  {
    for (QToolButton* button : window->findChildren<QToolButton*>())
      if (button->text() == text)
        button->click();
  }
  void trigger(const char* action) { window->menuBar()->findChild<QAction*>(action)->trigger(); }
  /// The vertex of the face that is farthest forward.
  std::size_t nose_tip()
  {
    const auto& points = work()->sculpting()->skin().points();
    return static_cast<std::size_t>(std::max_element(points.begin(), points.end(),
                                                     [](const Vec3& a, const Vec3& b)
                                                     { return a.y() < b.y(); }) -
                                    points.begin());
  }
  /// Pictures of the window for people, where FACETOBONE_SCREENSHOTS names a folder.
  void picture(const char* name)
  {
    const QByteArray wanted = qgetenv("FACETOBONE_SCREENSHOTS");
    if (wanted.isEmpty())
      return;
    for (const QSize size : {QSize(1920, 1080), QSize(1366, 768)})
    {
      window->resize(size);
      wait_until([&] { return window->size() == size; }, 5);
      window->threeDView()->fit();
      for (int k = 0; k < 10; ++k)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
      QDir().mkpath(wanted);
      EXPECT_TRUE(window->grab().save(
          QString("%1/%2_%3.png").arg(wanted.constData(), name).arg(size.width())));
    }
  }

  test::TemporaryFolder folder;
  std::unique_ptr<qFaceToBoneMainWindow> window;

private:
  Qt::MouseButtons m_buttons;
};

} // namespace f2b::testing
