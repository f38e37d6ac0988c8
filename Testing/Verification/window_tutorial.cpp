#include "window_driver.hpp"

#include "qFaceToBoneCut.h"
#include "qFaceToBoneCutTools.h"
#include "qFaceToBoneRulers.h"
#include "qFaceToBoneSliceView.h"
#include "qFaceToBoneSparedPanel.h"
#include "vtkFaceToBonePlaneWidget.h"
#include "vtkFaceToBonePointsWidget.h"
#include "vtkFaceToBoneSawWidget.h"

#include <Bridge/markups.hpp>
#include <Case/case_settings.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>
#include <QWheelEvent>

#include <iostream>

/// Does what Resources/Documentation/tutorial.md says, by the words on buttons and boxes, on the
/// sample patient; pictures every step. Fails where something is not there or does not happen.
///
///   window_tutorial FOLDER
namespace f2b
{
namespace
{

using testing::json;
using testing::Photographer;
using testing::Surgeon;
using testing::wait_until;

void require(bool holds, const std::string& what)
{
  if (!holds)
    throw std::runtime_error("the tutorial does not hold: " + what);
}

/// A surgeon who knows nothing but the words.
class Resident : public Surgeon
{
public:
  using Surgeon::Surgeon;

  /// A control that is seen, by its words.
  template <class Control>
  Control* named(const QString& text)
  {
    for (Control* control : window().template findChildren<Control*>())
      if (control->isVisible() && control->text() == text)
        return control;
    throw std::runtime_error("nothing that is seen says '" + text.toStdString() + "'");
  }
  void press(const QString& text)
  {
    auto* button = named<QAbstractButton>(text);
    require(button->isEnabled(), "'" + text.toStdString() + "' cannot be pressed");
    button->click();
    QCoreApplication::processEvents();
  }
  /// Presses the button of a step, which is the one that is bold, and waits for its end.
  void do_step(qFaceToBoneCase::Step step, const QString& text)
  {
    require(wait_until([&] { return work()->state(step).possible; }, 900),
            "the step cannot be done: " + work()->state(step).text.toStdString());
    QPushButton* button = window().steps()->actionButton(step);
    require(button->text() == text, "the button says '" + button->text().toStdString() +
                                        "' and not '" + text.toStdString() + "'");
    require(button->isEnabled(), "'" + text.toStdString() + "' cannot be pressed");
    std::string message;
    const auto seen =
        QObject::connect(work()->task(), &qFaceToBoneTask::ended,
                         [&](bool, const QString& told) { message = told.toStdString(); });
    button->click();
    require(work()->task()->isRunning(), "nothing runs after '" + text.toStdString() + "'");
    wait_until([&] { return !work()->task()->isRunning(); }, 1800);
    QObject::disconnect(seen);
    require(message.empty() && work()->state(step).done, text.toStdString() + ": " + message);
  }
  /// Where a step's name is pressed.
  void choose(qFaceToBoneCase::Step step) { window().steps()->setCurrentStep(step); }
  void tab(const QString& name)
  {
    auto* tabs = find<QTabWidget>("tabs");
    for (int k = 0; k < tabs->count(); ++k)
      if (tabs->tabText(k) == name)
      {
        tabs->setCurrentIndex(k);
        QCoreApplication::processEvents();
        return;
      }
    throw std::runtime_error("no tab is called " + name.toStdString());
  }
  void look(qFaceToBoneThreeDView::Preset preset)
  {
    window().threeDView()->setPreset(preset);
    for (int k = 0; k < 5; ++k)
      QCoreApplication::processEvents();
  }
  void colour(const QString& name)
  {
    auto* box = find<QComboBox>("colour");
    require(box->findText(name) >= 0, "no colouring is called " + name.toStdString());
    box->setCurrentText(name);
  }
  void shortcut(const char* action) { window().findChild<QAction*>(action)->trigger(); }
  Vec3 nose()
  {
    const auto at = work()->landmarkOnFace("prn");
    return {at[0], at[1] - 1, at[2]};
  }
};

void open_the_patient(Resident& r)
{
  r.photographer().take(r.window(), "0_welcome");
  r.press("Try it on the sample patient");
  require(r.work()->task()->isRunning(), "the sample is not made");
  wait_until([&] { return !r.work()->task()->isRunning(); }, 900);
  r.settle();
  require(r.work()->ct() && r.work()->objects()->find("raw/bone"), "the CT is not seen at once");
  r.photographer().take(r.window(), "1_opened");
}

void surfaces(Resident& r)
{
  r.do_step(qFaceToBoneCase::Surfaces, "Find");
  r.choose(qFaceToBoneCase::Surfaces);
  require(r.work()->objects()->find("skin") && r.work()->objects()->find("bone"),
          "skin and bone do not appear");
  require(r.work()->missingLandmarks().isEmpty(), "the sample lacks landmarks");
  qFaceToBoneSliceView* slice = r.window().sliceView(0);
  const auto point = slice->crosshair();
  const QPoint at(slice->width() / 3, slice->height() / 3);
  const auto mouse =
      [&](QEvent::Type type, const QPoint& where, Qt::MouseButton button, Qt::MouseButtons held)
  {
    QMouseEvent event(type, where, button, held, {});
    QApplication::sendEvent(slice, &event);
  };
  mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, at + QPoint(9, 9), Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, at + QPoint(9, 9), Qt::LeftButton, Qt::NoButton);
  require(slice->crosshair() != point && r.window().sliceView(2)->crosshair() == slice->crosshair(),
          "left drag does not move the crosshair");
  const auto before = slice->crosshair();
  QWheelEvent wheel(at, slice->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(slice, &wheel);
  require(slice->crosshair() != before, "the wheel does not go to the next slice");
  r.look(qFaceToBoneThreeDView::Frontal);
  const Vec3 placed = r.landmark("prn");
  r.drag(placed, 6, 4);
  require((r.landmark("prn") - placed).norm() > 0.2, "a landmark cannot be dragged");
  r.look(qFaceToBoneThreeDView::ThreeQuarter);
  r.photographer().take(r.window(), "2_surfaces");
}

void cuts(Resident& r, const Path& folder)
{
  qFaceToBoneCuts* cuts = r.work()->cuts();
  r.choose(qFaceToBoneCase::Cuts);
  require(cuts->count() == 1 && cuts->all()[0].templateName == "le-fort-3",
          "the sample's cut is no mid-face by Le Fort III");
  r.named<QCheckBox>("Show and drag the cuts")->setChecked(true);
  r.look(qFaceToBoneThreeDView::Right);
  const Vec3 centre = cuts->all()[0].planes[0].center;
  const auto& parts = r.window().cutTools()->parts();
  require(!parts.empty() && parts[0].plane, "no plane is shown");
  r.drag(Vec3(parts[0]
                  .plane->GetPlaneRepresentation()
                  ->HandlePosition(vtkFaceToBonePlaneRepresentation::Centre)
                  .data()),
         5, 3);
  require(cuts->all()[0].planes[0].center != centre, "the plane is not dragged by its middle");
  r.shortcut("undo");
  require(cuts->all()[0].planes[0].center == centre, "Ctrl+Z does not take it back");

  bool chosen = false;
  for (QAction* action : r.named<QToolButton>("Add")->menu()->actions())
    if (action->text() == "Line drawn on the bone")
    {
      action->trigger();
      chosen = true;
    }
  require(chosen && r.window().cutTools()->isDrawing(), "Add offers no line");
  r.look(qFaceToBoneThreeDView::Frontal);
  for (const Vec3& at : r.chin_line())
    r.click(at);
  r.photographer().take(r.window(), "3_line_drawing");
  r.key("Return");
  require(wait_until([&] { return cuts->count() == 2; }, 5), "Return does not end the line");
  const Vec3 third = cuts->all()[1].curves[0].handles[2];
  r.look(qFaceToBoneThreeDView::Frontal);
  r.drag(third, 0, 4);
  require(cuts->all()[1].curves[0].handles[2] != third, "its points cannot be dragged");
  r.shortcut("undo");
  const auto* list = r.find<QTreeWidget>("cuts");
  list->topLevelItem(1)->setText(0, "chin");
  require(wait_until([&] { return cuts->all()[1].fragment == "chin"; }, 5),
          "a name cannot be changed");
  r.find<QDoubleSpinBox>("depth")->setValue(40);
  require(cuts->all()[1].curves[0].saw.depth_mm == 40, "the depth is not the chosen piece's");
  r.photographer().take(r.window(), "3_line");

  PointMarkup nerve{"Curve", {}};
  const Vec3 end = r.chin_line().front() + Vec3(1, -8, 12);
  for (const double t : {0.0, 0.5, 1.0})
    nerve.points.push_back({"", end + t * (r.landmark("Go_R") + Vec3(-6, 12, 14) - end)});
  write_points(folder / "nerve_right.mrk.json", nerve);
  r.named<QPushButton>("Import...");
  require(r.window().findChild<qFaceToBoneSparedPanel*>()->import(
              QString::fromStdString((folder / "nerve_right.mrk.json").string())),
          "a nerve cannot be imported");
  r.look(qFaceToBoneThreeDView::ThreeQuarter);
  r.photographer().take(r.window(), "3_nerve");
  r.do_step(qFaceToBoneCase::Cuts, "Cut");
  r.choose(qFaceToBoneCase::Cuts);
  require(r.work()->objects()->find("fragment/chin") &&
              r.work()->objects()->find("fragment/mid-face"),
          "there are no two fragments");
  r.find<QSlider>("explode")->setValue(15);
  r.named<QCheckBox>("Show and drag the cuts")->setChecked(false);
  r.photographer().take(r.window(), "3_cuts_exploded");
  r.find<QSlider>("explode")->setValue(0);
}

void target(Resident& r)
{
  r.choose(qFaceToBoneCase::Target);
  r.settle();
  require(r.work()->isLive(), "no live preview");
  r.do_step(qFaceToBoneCase::Target, "Take");
  r.choose(qFaceToBoneCase::Target);
  r.press("Elastic");
  r.look(qFaceToBoneThreeDView::Right);
  const auto displacement = [&] { return r.work()->sculpting()->skin().displacement(); };
  const auto taken = displacement();
  const auto bones = r.work()->movements();
  r.drag(r.nose(), 12, 0);
  require(displacement() != taken, "the brush does nothing");
  require(!r.work()->movements().empty() &&
              (bones.empty() || r.work()->movements()[0].translation != bones[0].translation),
          "the bones do not follow");
  r.shortcut("undo");
  require(displacement() == taken, "Ctrl+Z does not take the stroke back");
  r.move(r.nose());
  const double radius = r.find<QDoubleSpinBox>("radius")->value();
  r.key("bracketright");
  require(r.find<QDoubleSpinBox>("radius")->value() > radius, "] does not change the radius");
  r.press("Turn");
  auto* landmark = r.find<QComboBox>("landmark");
  require(landmark->findText("sn") >= 0, "there is no sn");
  landmark->setCurrentText("sn");
  r.find<QDoubleSpinBox>("move_forward")->setValue(4);
  const auto sn = r.work()->landmarkOnFace("sn");
  r.press("Move");
  require(std::abs(r.work()->landmarkOnFace("sn")[1] - sn[1] - 4) < 0.01, "sn does not go 4 mm");
  r.named<QCheckBox>("Handles in the 3D view")->setChecked(true);
  const auto chin = r.work()->landmarkOnFace("Pg'");
  r.drag(Vec3(chin.data()), 6, 0);
  require(r.work()->landmarkOnFace("Pg'")[1] > chin[1] + 0.5, "the handle does not drag the face");
  r.shortcut("undo");
  r.colour("Displacement");
  r.photographer().take(r.window(), "4_target");
  r.colour("Skin colour");
  r.named<QCheckBox>("Handles in the 3D view")->setChecked(false);
  r.settle();
  r.do_step(qFaceToBoneCase::Target, "Keep");
}

void plan(Resident& r)
{
  r.settle();
  r.do_step(qFaceToBoneCase::Plan, "Plan");
  r.choose(qFaceToBoneCase::Plan);
  r.settle();
  r.look(qFaceToBoneThreeDView::ThreeQuarter);
  r.photographer().take(r.window(), "5_plan");
  r.named<QCheckBox>("Move the bones by hand")->setChecked(true);
  const auto planned = r.work()->movements();
  r.find<QDoubleSpinBox>("forward")->setValue(planned[0].translation[1] + 1);
  require(std::abs(r.work()->movements()[0].translation[1] - planned[0].translation[1] - 1) < 0.01,
          "numbers do not move the bone");
  r.settle();
  r.press("Rules");
  r.find<QCheckBox>("lock_yaw")->click();
  require(r.work()->cuts()->rules(planned[0].fragment).isLocked(5), "yaw is not locked");
  r.photographer().take(r.window(), "5_by_hand");
  r.find<QCheckBox>("lock_yaw")->click();
  r.press("Rules");
  r.named<QCheckBox>("Move the bones by hand")->setChecked(false);
  r.settle();
  r.press("Compare");
  r.colour("Left of the target");
  r.photographer().take(r.window(), "6_compare");
  r.colour("Skin colour");
  r.press("Compare");
  r.find<QSlider>("split")->setValue(50);
  r.photographer().take(r.window(), "6_split");
  r.find<QSlider>("split")->setValue(100);
  const bool before = r.work()->objects()->find("skin")->visible;
  r.shortcut("beforeAfter");
  require(r.work()->objects()->find("skin")->visible != before, "B does not change the face");
  r.choose(qFaceToBoneCase::Target);
  r.look(qFaceToBoneThreeDView::Right);
  r.tab("Measures");
  require(r.work()->measures().size() > 3, "few measures");
  r.press("Distance");
  r.click(r.nose());
  const auto chin = r.work()->landmarkOnFace("Pg'");
  r.click(Vec3(chin[0], chin[1] - 1, chin[2]));
  require(r.work()->rulers()->all().size() == 1, "no distance is measured");
  r.press("Angle");
  const auto sn = r.work()->landmarkOnFace("sn");
  for (const Vec3& at :
       {r.nose(), Vec3(sn[0], sn[1] - 2, sn[2]), Vec3(chin[0], chin[1] - 2, chin[2] + 4)})
    r.click(at);
  require(r.work()->rulers()->all().size() == 2, "no angle is measured");
  r.photographer().take(r.window(), "7_measures");
  r.tab("Objects");
  r.photographer().take(r.window(), "7_objects");
  r.press(QString::fromUtf8("\xc3\x97"));
  require(wait_until([&] { return r.work()->rulers()->all().size() == 1; }, 5),
          "a measure cannot be removed");
  r.tab("Step");
}

json followed_in(const Path& folder)
{
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  QStandardPaths::setTestModeEnabled(false); // all goes into the folder
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                     QString::fromStdString((folder / "settings").string()));
  Photographer photographer(QString::fromStdString(folder.string()));
  qFaceToBoneMainWindow window;
  window.show();
  Resident resident(window, photographer);
  open_the_patient(resident);
  surfaces(resident);
  cuts(resident, folder);
  target(resident);
  plan(resident);
  resident.do_step(qFaceToBoneCase::Report, "Write");
  resident.choose(qFaceToBoneCase::Report);
  require(std::filesystem::exists(Path(resident.work()->folder().toStdString()) / "report.html"),
          "there is no report.html");
  resident.look(qFaceToBoneThreeDView::ThreeQuarter);
  photographer.take(window, "8_report");
  return photographer.told();
}

} // namespace
} // namespace f2b

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "window_tutorial FOLDER\n";
    return 2;
  }
  const f2b::Path folder = argv[1];
  qputenv("XDG_DATA_HOME", (folder / "data").c_str());
  return f2b::testing::in_application([&] { return f2b::followed_in(folder); });
}
