#include "window_driver.hpp"

#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <ctime>
#include <numeric>

/// How long do the fragments of a planned case take to follow the mouse?
///
///   window_moves CASE_FOLDER
///
/// Opens the case, waits for the live preview, and drags the nose; prints as JSON what a move costs
/// the window's thread, from the event to fragments that have been moved, without drawing.
namespace f2b
{
namespace
{

using nlohmann::json;
using testing::Photographer;
using testing::Surgeon;
using testing::wait_until;

double thread_seconds()
{
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return double(spent.tv_sec) + 1e-9 * double(spent.tv_nsec);
}

json moves_of_the_nose(const QString& folder, int moves)
{
  QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QSettings().setValue("autosaveSeconds", 100000); // nothing is kept in the case's folder
  qFaceToBoneMainWindow window;
  window.show();
  Photographer nobody(QDir::tempPath());
  Surgeon s(window, nobody);
  if (!window.open(folder))
    throw std::runtime_error(s.work()->error().toStdString());
  if (!wait_until([&] { return s.work()->isLive(); }, 600))
    throw std::runtime_error("there is no live preview");
  s.settle();
  window.steps()->setCurrentStep(qFaceToBoneCase::Target);
  for (QToolButton* button : window.findChildren<QToolButton*>())
    if (button->text() == "Elastic")
      button->click();
  window.threeDView()->setPreset(qFaceToBoneThreeDView::Right);
  QCoreApplication::processEvents();
  vtkRenderWindowInteractor* mouse = window.threeDView()->interactor();
  const auto nose = s.work()->landmarkOnFace("prn");
  s.move(Vec3(nose[0], nose[1] - 1, nose[2]));
  const int* at = mouse->GetEventPosition();
  const int x = at[0], y = at[1];
  mouse->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  std::vector<double> spent;
  int followed = 0;
  auto before = s.work()->movements();
  for (int k = 1; k <= moves; ++k)
  {
    mouse->SetEventInformation(x + k, y);
    const double begin = thread_seconds();
    mouse->InvokeEvent(vtkCommand::MouseMoveEvent);
    spent.push_back(1000 * (thread_seconds() - begin));
    const auto after = s.work()->movements();
    followed += !after.empty() && (before.empty() || after[0].translation != before[0].translation);
    before = after;
  }
  mouse->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  s.settle();
  return {{"mean_ms", std::accumulate(spent.begin(), spent.end(), 0.0) / moves},
          {"largest_ms", *std::max_element(spent.begin(), spent.end())},
          {"moves", moves},
          {"moves_that_fragments_followed", followed},
          {"vertices", s.work()->sculpting()->skin().size()}};
}

} // namespace
} // namespace f2b

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "window_moves CASE_FOLDER\n";
    return 2;
  }
  return f2b::testing::in_application(
      [&] { return f2b::moves_of_the_nose(QString::fromLocal8Bit(argv[1]), 40); });
}
