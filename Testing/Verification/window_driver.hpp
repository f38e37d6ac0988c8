#pragma once

#include "Widgets/desktop_stage.hpp"

#include "qFaceToBoneStepsPanel.h"

#include <QAbstractButton>
#include <QDir>
#include <QLabel>
#include <QTabWidget>

#include <vtkCommand.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <nlohmann/json.hpp>

#include <iostream>

/// Who works in the window where no test looks on.
namespace f2b::testing
{

using nlohmann::json;

/// Does a program's work in an application on a display of its own, and prints what it tells.
/// \return the program's exit code
template <class Work>
int in_application(Work work)
{
  try
  {
    ApplicationEnvironment application;
    application.SetUp();
    const json told = work();
    std::cout << told.dump(1) << "\n";
    application.TearDown();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}

/// Pictures of the window at two sizes, and what is clipped or unnamed in them.
class Photographer
{
public:
  explicit Photographer(QString folder) : m_folder(std::move(folder)) { QDir().mkpath(m_folder); }

  void take(qFaceToBoneMainWindow& window, const char* name)
  {
    for (const QSize size : {QSize(1920, 1080), QSize(1366, 768)})
    {
      window.resize(size);
      wait_until([&] { return window.size() == size; }, 5);
      window.threeDView()->fit();
      for (int k = 0; k < 12; ++k) // outlines of slices wait a little
        QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
      QElapsedTimer since;
      since.start();
      wait_until([&] { return since.elapsed() > 400; }, 1);
      if (!window.grab().save(QString("%1/%2_%3.png").arg(m_folder, name).arg(size.width())))
        throw std::runtime_error("a picture cannot be written");
      ++m_taken;
      look_for_faults(window, QString("%1_%2").arg(name).arg(size.width()));
    }
  }
  json told() const
  {
    return {{"pictures", m_taken}, {"clipped", m_clipped}, {"unnamed", m_unnamed}};
  }

private:
  /// Words that do not fit their widget, and controls that say nothing of themselves.
  void look_for_faults(qFaceToBoneMainWindow& window, const QString& where)
  {
    for (QWidget* widget : window.findChildren<QWidget*>())
    {
      if (!widget->isVisible())
        continue;
      const auto* label = qobject_cast<QLabel*>(widget);
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      const QString text = label ? label->text() : button ? button->text() : QString();
      const int needed = label && label->wordWrap() ? label->heightForWidth(label->width()) : 0;
      const int line = label ? widget->minimumSizeHint().width()
                             : widget->fontMetrics().horizontalAdvance(text) + 6;
      const bool narrow = !(label && label->wordWrap()) && widget->width() < line;
      if (!text.isEmpty() && (narrow || widget->height() + 1 < needed))
        m_clipped.push_back((where + ": " + text).toStdString());
      if (button && text.isEmpty() && button->icon().isNull() && button->toolTip().isEmpty() &&
          !button->inherits("QTabBar") && !QString(button->objectName()).startsWith("qt_"))
        m_unnamed.push_back((where + ": " + button->metaObject()->className()).toStdString());
    }
  }

  QString m_folder;
  int m_taken = 0;
  std::vector<std::string> m_clipped, m_unnamed;
};

/// Does what a surgeon does.
class Surgeon
{
public:
  Surgeon(qFaceToBoneMainWindow& window, Photographer& photographer)
      : m_window(window), m_photographer(photographer)
  {
  }

  void run(qFaceToBoneCase::Step step)
  {
    std::string message;
    const auto seen =
        QObject::connect(work()->task(), &qFaceToBoneTask::ended,
                         [&](bool, const QString& text) { message = text.toStdString(); });
    wait_until([&] { return work()->state(step).possible; }, 900);
    if (!work()->start(step))
      message = work()->error().toStdString();
    wait_until([&] { return !work()->task()->isRunning(); }, 1800);
    QObject::disconnect(seen);
    if (!message.empty())
      throw std::runtime_error(message);
  }
  void settle()
  {
    wait_until([&] { return !work()->background()->isRunning(); }, 1800);
  }
  void show(qFaceToBoneCase::Step step, const char* name)
  {
    m_window.steps()->setCurrentStep(step);
    m_photographer.take(m_window, name);
  }
  void tab(int index, const char* name)
  {
    auto* tabs = m_window.findChild<QTabWidget*>("tabs");
    tabs->setCurrentIndex(index);
    m_photographer.take(m_window, name);
    tabs->setCurrentIndex(0);
  }
  template <class Control>
  Control* find(const char* name)
  {
    return m_window.findChild<Control*>(name);
  }
  Vec3 landmark(const QString& name)
  {
    for (const qFaceToBoneCase::Landmark& landmark : work()->landmarks())
      if (landmark.name == name && landmark.placed)
        return Vec3(landmark.at.data());
    throw std::runtime_error(name.toStdString() + " is not placed");
  }
  /// A genioplasty on the bone, below the canines from border to border.
  std::vector<Vec3> chin_line()
  {
    const Vec3 middle = 0.5 * (landmark("B") + landmark("Pg"));
    std::vector<Vec3> points;
    for (const double right : {22.0, 13.0, 0.0, -13.0, -22.0})
      points.push_back(middle + Vec3(right, 0, 0));
    points.front().z() = border_of_chin(22) + 2;
    points.back().z() = border_of_chin(-22) + 2;
    return points;
  }

  // the mouse in the 3D view; places are seen in it
  void move(const Vec3& at, int right = 0, int up = 0)
  {
    vtkRenderer* renderer = m_window.threeDView()->mainRenderer();
    renderer->SetWorldPoint(at.x(), at.y(), at.z(), 1);
    renderer->WorldToDisplay();
    const double* d = renderer->GetDisplayPoint();
    m_window.threeDView()->interactor()->SetEventInformation(static_cast<int>(d[0]) + right,
                                                             static_cast<int>(d[1]) + up);
    invoke(vtkCommand::MouseMoveEvent);
  }
  void click(const Vec3& at) { drag(at, 0, 0); }
  /// So many pixels to the right and up.
  void drag(const Vec3& from, int right, int up)
  {
    move(from);
    invoke(vtkCommand::LeftButtonPressEvent);
    for (int k = 1; k <= 4 && (right || up); ++k)
      move(from, right * k / 4, up * k / 4);
    invoke(vtkCommand::LeftButtonReleaseEvent);
    QCoreApplication::processEvents();
  }
  void invoke(unsigned long event) { m_window.threeDView()->interactor()->InvokeEvent(event); }
  void key(const char* symbol)
  {
    m_window.threeDView()->interactor()->SetKeySym(symbol);
    invoke(vtkCommand::KeyPressEvent);
    QCoreApplication::processEvents();
  }

  qFaceToBoneCase* work() { return m_window.work(); }
  Photographer& photographer() { return m_photographer; }
  qFaceToBoneMainWindow& window() { return m_window; }

private:
  /// The chin's lower border at some way to the right of the middle.
  double border_of_chin(double right)
  {
    const Vec3 chin = landmark("Pg");
    vtkPolyData* bone = work()->bone();
    double lowest = chin.z();
    for (vtkIdType v = 0; v < bone->GetNumberOfPoints(); ++v)
    {
      const Vec3 p(bone->GetPoint(v));
      if (std::abs(p.x() - chin.x() - right) < 1 && p.y() > chin.y() - 30)
        lowest = std::min(lowest, p.z());
    }
    return lowest;
  }

  qFaceToBoneMainWindow& m_window;
  Photographer& m_photographer;
};

} // namespace f2b::testing
