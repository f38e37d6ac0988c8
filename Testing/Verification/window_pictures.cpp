#include "window_driver.hpp"

#include "qFaceToBoneCut.h"
#include "qFaceToBoneCutTools.h"
#include "qFaceToBoneLandmarksPanel.h"
#include "qFaceToBonePointTools.h"
#include "qFaceToBoneRulers.h"
#include "qFaceToBoneStepsPanel.h"
#include "qFaceToBoneThreeDView.h"

#include <Bridge/json_file.hpp>
#include <Bridge/markups.hpp>
#include <Case/case_settings.hpp>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QSlider>
#include <QTabWidget>
#include <QToolButton>

#include <vtkPolyData.h>

#include <nlohmann/json.hpp>

#include <iostream>

/// Drives the window through every step of a case, and of its bare CT, and pictures each at two
/// sizes; tells what is clipped or unnamed.
///
///   window_pictures CASE.json FOLDER
namespace f2b
{
namespace
{

using nlohmann::json;
using testing::Photographer;
using testing::Surgeon;
using testing::wait_until;

/// A CT alone: what is seen at once, and what it says of landmarks that are not there.
json bare_ct(Surgeon& s, const QString& ct)
{
  QElapsedTimer since;
  since.start();
  if (!s.window().open(ct))
    throw std::runtime_error(s.work()->error().toStdString());
  wait_until([&] { return !s.work()->task()->isRunning(); }, 300);
  const double seconds = static_cast<double>(since.elapsed()) / 1000.0;
  s.photographer().take(s.window(), "ct_1_opened");
  s.run(qFaceToBoneCase::Surfaces);
  s.show(qFaceToBoneCase::Surfaces, "ct_2_surfaces");
  s.show(qFaceToBoneCase::Cuts, "ct_3_cuts_want_landmarks");
  const auto state = s.work()->state(qFaceToBoneCase::Cuts);
  return {{"seconds_to_first_image", seconds}, {"cuts_say", state.text.toStdString()}};
}

/// A genioplasty, clicked on the bone below the canines from border to border; and a nerve near it.
void draw_chin(Surgeon& s)
{
  qFaceToBoneCuts* cuts = s.work()->cuts();
  const Vec3 middle = 0.5 * (s.landmark("B") + s.landmark("Pg"));
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::Frontal);
  QCoreApplication::processEvents();
  if (!s.window().cutTools()->startDrawing(false))
    throw std::runtime_error("no line can be drawn");
  for (const Vec3& at : s.chin_line())
    s.click(at);
  s.photographer().take(s.window(), "3_line_drawing");
  const int drawn = cuts->count();
  if (!s.window().cutTools()->finishDrawing() || cuts->count() != drawn + 1 ||
      !cuts->rename(drawn, "chin"))
    throw std::runtime_error("the line became no cut");
  cuts->setDepth(drawn, 40);
  s.photographer().take(s.window(), "3_line");
  PointMarkup nerve{"Curve", {}};
  const Vec3 foramen = middle + Vec3(21, -6, 4), angle = s.landmark("Go_R") + Vec3(-6, 12, 14);
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
    nerve.points.push_back({"", foramen + t * (angle - foramen)});
  const Path file = Path(s.work()->folder().toStdString()).parent_path() / "nerve_right.mrk.json";
  write_points(file, nerve);
  if (!cuts->addSpared(QString::fromStdString(file.string())))
    throw std::runtime_error(cuts->error().toStdString());
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::ThreeQuarter);
  s.photographer().take(s.window(), "3_nerve");
}

/// Gizmos, and the rules of the first piece.
void by_hand(Surgeon& s)
{
  s.settle();
  s.find<QCheckBox>("hand")->setChecked(true);
  s.find<QToolButton>("rules")->setChecked(true);
  s.photographer().take(s.window(), "5_by_hand");
  s.find<QToolButton>("rules")->setChecked(false);
  s.find<QCheckBox>("hand")->setChecked(false);
}

void whole_way(Surgeon& s)
{
  s.run(qFaceToBoneCase::Surfaces);
  s.show(qFaceToBoneCase::Surfaces, "2_surfaces");
  s.window().steps()->setCurrentStep(qFaceToBoneCase::Cuts);
  s.find<QCheckBox>("planes")->setChecked(true);
  s.photographer().take(s.window(), "3_cuts_placed");
  draw_chin(s);
  s.run(qFaceToBoneCase::Cuts);
  s.window().steps()->setCurrentStep(qFaceToBoneCase::Cuts);
  s.find<QCheckBox>("planes")->setChecked(false);
  s.find<QSlider>("explode")->setValue(15);
  s.photographer().take(s.window(), "3_cuts_exploded");
  s.find<QSlider>("explode")->setValue(0);
  s.settle();
  s.run(qFaceToBoneCase::Target);
  s.settle();
  s.show(qFaceToBoneCase::Target, "4_target");
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::Right);
  s.find<QCheckBox>("handles")->setChecked(true);
  if (!s.work()->moveLandmark("sn", {0, 2, 0}, 35))
    throw std::runtime_error(s.work()->error().toStdString());
  s.find<QComboBox>("colour")->setCurrentIndex(1);
  s.photographer().take(s.window(), "4_target_displacement");
  s.find<QComboBox>("colour")->setCurrentIndex(0);
  s.find<QCheckBox>("handles")->setChecked(false);
  s.settle();
  s.run(qFaceToBoneCase::Target);
  s.run(qFaceToBoneCase::Plan);
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::ThreeQuarter);
  s.show(qFaceToBoneCase::Plan, "5_plan");
  s.find<QToolButton>("compare")->setChecked(true);
  s.find<QComboBox>("colour")->setCurrentIndex(3);
  s.photographer().take(s.window(), "6_compare");
  s.find<QComboBox>("colour")->setCurrentIndex(0);
  s.find<QToolButton>("compare")->setChecked(false);
  s.find<QSlider>("split")->setValue(50);
  s.photographer().take(s.window(), "6_split");
  s.find<QSlider>("split")->setValue(100);
  by_hand(s);
  const auto a = s.work()->landmarkOnFace("prn"), b = s.work()->landmarkOnFace("Pg'"),
             c = s.work()->landmarkOnFace("sn");
  s.work()->rulers()->add({a, b});
  s.work()->rulers()->add({a, c, b});
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::Right);
  s.tab(2, "7_measures");
  s.tab(1, "7_objects");
  s.run(qFaceToBoneCase::Report);
  s.window().threeDView()->setPreset(qFaceToBoneThreeDView::ThreeQuarter);
  s.show(qFaceToBoneCase::Report, "8_report");
}

json pictures_of(const Path& source, const QString& pictures)
{
  QDir(pictures).removeRecursively();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, pictures + "/settings");
  Photographer photographer(pictures);
  const Path folder = pictures.toStdString();
  const json document = with_absolute_paths(read_json(source), source);
  const auto linked_ct = folder / "ct alone";
  std::filesystem::create_directories(linked_ct);
  const Path ct = parse_settings(document, source).ct;
  json told;
  {
    qFaceToBoneMainWindow window;
    window.show();
    photographer.take(window, "0_welcome");
    Surgeon surgeon(window, photographer);
    std::filesystem::create_symlink(ct, linked_ct / ct.filename());
    told["bare_ct"] =
        bare_ct(surgeon, QString::fromStdString((linked_ct / ct.filename()).string()));
  }
  const Path own = folder / "case.json";
  write_json(own, document);
  qFaceToBoneMainWindow window;
  window.show();
  Surgeon surgeon(window, photographer);
  if (!window.open(QString::fromStdString(own.string())))
    throw std::runtime_error(surgeon.work()->error().toStdString());
  surgeon.settle(); // its CT is read
  photographer.take(window, "1_opened");
  whole_way(surgeon);
  told.update(photographer.told());
  return told;
}

} // namespace
} // namespace f2b

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "window_pictures CASE.json FOLDER\n";
    return 2;
  }
  return f2b::testing::in_application(
      [&] { return f2b::pictures_of(argv[1], QString::fromLocal8Bit(argv[2])); });
}
