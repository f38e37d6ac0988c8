#include "qFaceToBoneMainWindow.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <clocale>

int main(int argc, char** argv)
{
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
  parser.addPositionalArgument("case", "Case folder, case.mrml or case file (JSON)", "[case]");
  parser.process(application);
  qFaceToBoneMainWindow window;
  window.show();
  if (!parser.positionalArguments().isEmpty())
    window.open(parser.positionalArguments().first());
  return QApplication::exec();
}
