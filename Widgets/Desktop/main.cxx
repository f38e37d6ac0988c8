#include "qFaceToBoneCase.h"
#include "qFaceToBoneMainWindow.h"
#include "qFaceToBoneThreeDView.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <clocale>
#include <ctime>
#include <iostream>

int main(int argc, char** argv)
{
  QElapsedTimer since;
  since.start();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C"); // Qt sets the user's; files have points in their numbers
  QApplication::setApplicationName("FaceToBone");
  QApplication::setOrganizationName("FaceToBone");
  QApplication::setApplicationVersion(FACETOBONE_VERSION);
  QCommandLineParser parser;
  parser.setApplicationDescription("Plans cranio-maxillofacial surgery from the face backwards. "
                                   "Research software, not a medical "
                                   "device.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("case", "Case folder, case.mrml, case file (JSON) or CT", "[case]");
  parser.addOption({"time-first-image", "Print the seconds until the case or CT is seen, and end"});
  parser.process(application);
  qFaceToBoneMainWindow window;
  window.show();
  if (!parser.positionalArguments().isEmpty())
    window.open(parser.positionalArguments().first());
  if (parser.isSet("time-first-image"))
  {
    qFaceToBoneCase* work = window.work();
    bool seen = false;
    QObject::connect(window.threeDView(), &qFaceToBoneThreeDView::drawn, [&] { seen = true; });
    // a case in which nothing has been found yet is seen when its CT has been read
    constexpr int most_ms = 60000; // of a display that draws nothing
    QTimer wake;
    wake.start(50);
    while (!seen && since.elapsed() < most_ms &&
           (work->task()->isRunning() || work->background()->isRunning() ||
            !work->objects()->all().empty()))
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (!seen)
    {
      std::cerr << "nothing was seen\n";
      return 1;
    }
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    std::cout << "first image after " << static_cast<double>(since.elapsed()) / 1000.0 << " s, "
              << double(spent.tv_sec) + 1e-9 * double(spent.tv_nsec)
              << " s of the window's thread on a processor" << std::endl;
    return 0;
  }
  return QApplication::exec();
}
