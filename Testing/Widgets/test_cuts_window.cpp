#include "Widgets/desktop_patient.hpp"
#include "Widgets/desktop_stage.hpp"
#include "Widgets/random_events.hpp"

#include "qFaceToBoneBoneTools.h"
#include "qFaceToBoneCut.h"
#include "qFaceToBoneCutTools.h"
#include "qFaceToBoneSparedPanel.h"
#include "qFaceToBoneStepsPanel.h"
#include "qFaceToBoneThreeDView.h"
#include "vtkFaceToBoneCurveWidget.h"
#include "vtkFaceToBoneFragmentWidget.h"
#include "vtkFaceToBonePlaneWidget.h"
#include "vtkFaceToBoneSawWidget.h"

#include <Bridge/markups.hpp>

#include <QCheckBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <random>

namespace f2b
{
namespace
{

using testing::wait_until;

/// The window with a patient whose bone is there, at the step of the cuts.
class CutsWindow : public testing::DesktopStage
{
protected:
  void open_segmented(const char* name = "segmented")
  {
    const testing::SegmentedPatient& patient = testing::segmented_patient();
    std::filesystem::copy(patient.folder, folder / name, std::filesystem::copy_options::recursive);
    ASSERT_TRUE(window->open(QString::fromStdString((folder / name).string())))
        << work()->error().toStdString();
    landmarks = read_landmarks(folder / name / "landmarks.mrk.json");
    window->steps()->setCurrentStep(qFaceToBoneCase::Cuts);
    look_from(qFaceToBoneThreeDView::Frontal);
  }
  qFaceToBoneCuts* cuts() { return work()->cuts(); }
  const qFaceToBoneCut& cut(int k) { return cuts()->all().at(std::size_t(k)); }
  template <class Widget>
  Widget* part(const char* name)
  {
    Widget* found = window->findChild<Widget*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  void choose(const char* what)
  {
    for (QAction* action : part<QToolButton>("addCut")->menu()->actions())
      if (action->text() == what)
        return action->trigger();
    FAIL() << what;
  }
  void show_tools() { part<QCheckBox>("planes")->setChecked(true); }
  const qFaceToBoneCutTools::Part& tool(int cut, int index, bool plane)
  {
    for (const auto& p : window->cutTools()->parts())
      if (p.cut == cut && p.index == index && (plane ? bool(p.plane) : bool(p.saw)))
        return p;
    throw std::runtime_error("no such tool");
  }
  /// Height of the mandible's lower border.
  double border_at(double r)
  {
    double lowest = 1e9;
    for (vtkIdType v = 0; v < work()->bone()->GetNumberOfPoints(); ++v)
    {
      const Vec3 p(work()->bone()->GetPoint(v));
      if (std::abs(p.x() - r) < 1 && p.y() > landmarks.at("Pg").y() - 30)
        lowest = std::min(lowest, p.z());
    }
    return lowest;
  }
  /// The chin's line on the bone, from border to border below the canines.
  std::vector<Vec3> chin_line()
  {
    const Vec3 below = 0.5 * (landmarks.at("B") + landmarks.at("Pg"));
    std::vector<Vec3> points;
    for (const double r : {22.0, 13.0, 0.0, -13.0, -22.0})
      points.emplace_back(r, below.y(), below.z());
    points.front().z() = border_at(22) + 2;
    points.back().z() = border_at(-22) + 2;
    return points;
  }
  void draw_chin_line()
  {
    choose("Line drawn on the bone");
    ASSERT_TRUE(window->cutTools()->isDrawing());
    for (const Vec3& p : chin_line())
      click(pixel(p));
  }

  Landmarks landmarks;
};

TEST_F(CutsWindow, ALineClickedOnTheBoneBecomesACut)
{
  open_segmented();
  draw_chin_line();
  EXPECT_EQ(window->cutTools()->pen()->GetCurveRepresentation()->GetNumberOfControlPoints(), 5);
  picture("cuts_drawing");
  QTest::keyClick(view(), Qt::Key_Backspace);
  EXPECT_EQ(window->cutTools()->pen()->GetCurveRepresentation()->GetNumberOfControlPoints(), 4);
  click(pixel(chin_line().back()));
  QTest::keyClick(view(), Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return cuts()->count() == 2; }, 5));
  EXPECT_FALSE(window->cutTools()->isDrawing());
  ASSERT_EQ(cut(1).curves.size(), 1u);
  const qFaceToBoneCutCurve& line = cut(1).curves[0];
  EXPECT_TRUE(line.onBone);
  EXPECT_EQ(line.handles.size(), 5u);
  EXPECT_LT(line.saw.direction.y(), -0.7); // into the face
  EXPECT_FALSE(work()->state(qFaceToBoneCase::Cuts).done);
  trigger("undo");
  EXPECT_EQ(cuts()->count(), 1);
  trigger("redo");
  EXPECT_EQ(cuts()->count(), 2);
}

TEST_F(CutsWindow, PointsSawAndBallOfADrawnLineAreDragged)
{
  open_segmented();
  draw_chin_line();
  part<QPushButton>("finishLine")->click();
  ASSERT_EQ(cuts()->count(), 2);
  picture("cuts_line");
  const Vec3 point = cut(1).curves[0].handles[2];
  drag(pixel(point), QPoint(0, -8));
  EXPECT_GT(cut(1).curves[0].handles[2].z(), point.z() + 0.5);
  EXPECT_EQ(cut(1).curves[0].handles.size(), 5u);
  look_from(qFaceToBoneThreeDView::Right);
  const auto& line = tool(1, 0, false);
  const Vec3 direction = cut(1).curves[0].saw.direction;
  drag(
      pixel(line.saw->GetSawRepresentation()->HandlePosition(vtkFaceToBoneSawRepresentation::Hand)),
      QPoint(0, -20)); // the hand up, the saw down
  EXPECT_LT(cut(1).curves[0].saw.direction.z(), direction.z() - 0.1);
  look_from(qFaceToBoneThreeDView::Frontal);
  const Vec3 ball = cut(1).point;
  drag(pixel(ball), QPoint(10, 0));
  EXPECT_LT(cut(1).point.x(), ball.x() - 0.5); // to the picture's right, the patient's left
  for (int k = 0; k < 3; ++k)
    trigger("undo");
  EXPECT_LT((cut(1).point - ball).norm(), 1e-12);
  EXPECT_LT((cut(1).curves[0].handles[2] - point).norm(), 1e-12);
}

TEST_F(CutsWindow, DrawingIsGivenUpAndEscapeTakesAPressBack)
{
  open_segmented();
  draw_chin_line();
  press(pixel(landmarks.at("ANS") - Vec3(0, 5, 6)));
  QTest::keyClick(view(), Qt::Key_Escape);
  EXPECT_EQ(window->cutTools()->pen()->GetCurveRepresentation()->GetNumberOfControlPoints(), 5);
  part<QPushButton>("dropLine")->click();
  EXPECT_FALSE(window->cutTools()->isDrawing());
  EXPECT_EQ(cuts()->count(), 1);
  choose("Line drawn on the bone");
  window->steps()->setCurrentStep(qFaceToBoneCase::Target); // another step ends it, too
  EXPECT_FALSE(window->cutTools()->isDrawing());
}

TEST_F(CutsWindow, TemplatesAreListedNamedAndDragged)
{
  open_segmented();
  show_tools();
  choose("Sagittal split (BSSO)");
  choose("Zygoma, right");
  ASSERT_EQ(cuts()->count(), 3);
  auto* list = part<QTreeWidget>("cuts");
  ASSERT_EQ(list->topLevelItemCount(), 3);
  EXPECT_EQ(list->topLevelItem(1)->childCount(), 3);
  picture("cuts_list");
  list->topLevelItem(1)->setText(0, "lower jaw");
  ASSERT_TRUE(wait_until([&] { return cut(1).fragment == "lower jaw"; }, 5));
  list->topLevelItem(1)->setText(0, "mid-face"); // taken
  ASSERT_TRUE(wait_until([&] { return !complaint().isEmpty(); }, 5));
  EXPECT_EQ(list->topLevelItem(1)->text(0), "lower jaw");
  part<QDoubleSpinBox>("kerf")->setValue(0.5);
  EXPECT_EQ(cut(2).kerf, 0.5);
  EXPECT_EQ(cut(1).kerf, 1);
  // its line is dragged as a whole, between two handles; then a plane of another cut
  const qFaceToBoneCutCurve before = cut(2).curves[0];
  look_from(qFaceToBoneThreeDView::Frontal);
  const Vec3 between = 0.5 * (before.handles[2] + before.handles[3]);
  drag(pixel(between), QPoint(0, 12));
  const Vec3 by = cut(2).curves[0].handles[0] - before.handles[0];
  EXPECT_LT(by.z(), -0.5);
  for (std::size_t k = 0; k < before.handles.size(); ++k)
    EXPECT_LT((cut(2).curves[0].handles[k] - before.handles[k] - by).norm(), 1e-9);
  list->setCurrentItem(list->topLevelItem(0));
  EXPECT_EQ(cuts()->current(), 0);
  look_from(qFaceToBoneThreeDView::Right);
  const BoundedPlane plane = cut(0).planes[1];
  drag(pixel(tool(0, 1, true)
                 .plane->GetPlaneRepresentation()
                 ->HandlePosition(vtkFaceToBonePlaneRepresentation::Centre)),
       QPoint(9, 0));
  EXPECT_GT((cut(0).planes[1].center - plane.center).norm(), 1);
  part<QToolButton>("resetCut")->click();
  EXPECT_EQ(cut(0).planes[1].center, plane.center);
  EXPECT_FALSE(cut(0).drawn);
  list->setCurrentItem(list->topLevelItem(1)->child(2));
  part<QToolButton>("removeCut")->click();
  EXPECT_EQ(cut(1).planes.size(), 2u);
  list->setCurrentItem(list->topLevelItem(1));
  part<QToolButton>("removeCut")->click();
  EXPECT_EQ(cuts()->count(), 2);
  part<QToolButton>("undoCut")->click();
  EXPECT_EQ(cut(1).fragment, "lower jaw");
}

TEST_F(CutsWindow, ANerveTurnsRedWhileACutComesNear)
{
  open_segmented();
  show_tools();
  look_from(qFaceToBoneThreeDView::Right);
  const BoundedPlane plane = cut(0).planes[0];
  PointMarkup nerve;
  nerve.type = "Curve";
  for (const double u : {30.0, 40.0, 50.0})
    nerve.points.push_back({"", plane.center + u * plane.u + 5 * plane.normal()});
  write_points(folder / "infraorbital_nerve.mrk.json", nerve);
  auto* panel = window->findChild<qFaceToBoneSparedPanel*>();
  ASSERT_TRUE(
      panel->import(QString::fromStdString((folder / "infraorbital_nerve.mrk.json").string())));
  const auto colour = [&]
  { return work()->objects()->find("protected/infraorbital nerve")->colour; };
  const QColor calm = colour();
  std::vector<QString> said;
  QObject::connect(window->cutTools(), &qFaceToBoneCutTools::told, window.get(),
                   [&](const QString& text) { said.push_back(text); });
  const auto& look = *tool(0, 0, true).plane->GetPlaneRepresentation();
  const QPoint from = pixel(look.HandlePosition(vtkFaceToBonePlaneRepresentation::Centre));
  drag(from, pixel(plane.center + 4 * plane.normal()) - pixel(plane.center));
  EXPECT_NE(colour(), calm);
  EXPECT_LT(cuts()->clearances().at(0).distance, 2);
  ASSERT_FALSE(said.empty());
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                          [](const QString& text)
                          { return text.contains("infraorbital nerve") && text.contains("mm"); }));
  EXPECT_NE(part<QTreeWidget>("spared")->topLevelItem(0)->text(1).indexOf("mm"), -1);
  picture("cuts_nerve");
  trigger("undo");
  EXPECT_EQ(colour(), calm);
  EXPECT_FALSE(panel->import("/no/such.vtp"));
  EXPECT_FALSE(complaint().isEmpty());
}

TEST_F(CutsWindow, UnfinishedCutsAreThereAgainAfterClosing)
{
  open_segmented();
  choose("Genioplasty");
  ASSERT_TRUE(cuts()->addPlane({0, 60, -40}, false));
  const QString opened = work()->folder();
  const Vec3 centre = cut(2).planes[0].center;
  window->close();
  window = std::make_unique<qFaceToBoneMainWindow>();
  window->show();
  ASSERT_TRUE(window->open(opened));
  ASSERT_EQ(cuts()->count(), 3);
  EXPECT_EQ(cut(1).templateName, "genioplasty");
  EXPECT_LT((cut(2).planes[0].center - centre).norm(), 1e-9);
  open_segmented("another"); // over unfinished ones
  EXPECT_EQ(cuts()->count(), 1);
  ASSERT_TRUE(window->open(opened));
  EXPECT_EQ(cuts()->count(), 3);
}

TEST_F(CutsWindow, CutsGoneWhileTheirToolIsHeldDoNoHarm)
{
  open_segmented();
  show_tools();
  const auto hold = [&]
  {
    look_from(qFaceToBoneThreeDView::Right);
    const QPoint at = pixel(tool(0, 0, true)
                                .plane->GetPlaneRepresentation()
                                ->HandlePosition(vtkFaceToBonePlaneRepresentation::Centre));
    press(at);
    move(at + QPoint(5, 5));
    return at + QPoint(9, 9);
  };
  QPoint at = hold();
  cuts()->remove(0);
  release(at);
  EXPECT_EQ(cuts()->count(), 0);
  ASSERT_TRUE(cuts()->undo());
  at = hold();
  open_segmented("another");
  release(at);
  at = hold();
  window->steps()->setCurrentStep(qFaceToBoneCase::Plan);
  release(at);
  window->steps()->setCurrentStep(qFaceToBoneCase::Cuts);
  at = hold();
  work()->close();
  release(at);
  EXPECT_FALSE(work()->isOpen());
  ASSERT_TRUE(window->open(QString::fromStdString((folder / "segmented").string())));
  window->steps()->setCurrentStep(qFaceToBoneCase::Cuts);
  hold();
  window->close();
  window.reset();
}

TEST_F(CutsWindow, StepsInEveryOrderAndDoubleClicksAreRefusedOrDone)
{
  open_segmented();
  show_tools();
  std::mt19937 random(3);
  for (int k = 0; k < 40; ++k)
  {
    const auto step = static_cast<qFaceToBoneCase::Step>(1 + random() % 5);
    window->steps()->setCurrentStep(static_cast<int>(random() % 6));
    QPushButton* button = window->steps()->actionButton(step);
    QTest::mouseDClick(button, Qt::LeftButton);
    if (work()->task()->isRunning())
    {
      EXPECT_FALSE(work()->start(step));
      part<QPushButton>("cancel")->click();
      ASSERT_TRUE(wait_until([&] { return !work()->task()->isRunning(); }, 300));
    }
    complaint();
    ASSERT_TRUE(work()->isOpen());
  }
  EXPECT_EQ(cuts()->count(), 1);
}

TEST_F(CutsWindow, SeveralPiecesAreCutMovedByTheirRulesAndThereAgain)
{
  open_segmented();
  show_tools();
  cuts()->remove(0);
  EXPECT_FALSE(work()->start(qFaceToBoneCase::Cuts));
  EXPECT_FALSE(work()->error().isEmpty());
  choose("Le Fort I");
  draw_chin_line();
  part<QPushButton>("finishLine")->click();
  ASSERT_EQ(cuts()->count(), 2);
  ASSERT_TRUE(cuts()->rename(1, "chin"));
  cuts()->setDepth(1, 40);
  ASSERT_EQ(run(qFaceToBoneCase::Cuts), "");
  ASSERT_TRUE(work()->objects()->find("fragment/maxilla"));
  ASSERT_TRUE(work()->objects()->find("fragment/chin"));
  EXPECT_NE(work()->objects()->find("fragment/maxilla")->colour,
            work()->objects()->find("fragment/chin")->colour);
  window->steps()->setCurrentStep(qFaceToBoneCase::Cuts); // a step that is done leads to the next
  const double* box = work()->objects()->find("fragment/chin")->surface->GetBounds();
  EXPECT_LT(box[5], landmarks.at("B").z() + 2); // the chin alone
  EXPECT_TRUE(work()->state(qFaceToBoneCase::Cuts).done);
  EXPECT_FALSE(cuts()->isMoved());
  part<QSlider>("explode")->setValue(12);
  look_from(qFaceToBoneThreeDView::ThreeQuarter);
  picture("cuts_exploded");
  part<QSlider>("explode")->setValue(0);
  cuts()->setKerf(0, 0.7); // then the bone is not as the cuts say
  EXPECT_FALSE(work()->state(qFaceToBoneCase::Cuts).done);
  ASSERT_TRUE(cuts()->undo());
  EXPECT_TRUE(work()->state(qFaceToBoneCase::Cuts).done);

  ASSERT_TRUE(background_ends());
  ASSERT_TRUE(work()->isLive());
  ASSERT_EQ(run(qFaceToBoneCase::Target), "");
  work()->sculpted(true);
  ASSERT_EQ(work()->movements().size(), 2u);
  ASSERT_TRUE(background_ends());
  window->steps()->setCurrentStep(qFaceToBoneCase::Plan);
  window->boneTools()->showGizmos(true);
  ASSERT_TRUE(cuts()->setRule("maxilla", 0, {true, false, 0, 0}));
  ASSERT_TRUE(cuts()->setRule("maxilla", 1, {false, true, -1, 3}));
  const auto maxilla = [&] { return work()->movements().at(0); };
  EXPECT_EQ(maxilla().fragment, "maxilla");
  EXPECT_EQ(maxilla().translation[0], 0);
  EXPECT_LE(maxilla().translation[1], 3);
  work()->setMovement({"maxilla", {5, 12, 2}, {0, 0, 50}});
  EXPECT_EQ(maxilla().translation, (std::array<double, 3>{0, 3, 2}));
  EXPECT_NEAR(maxilla().rotation[2], 45, 1e-9);
  work()->setMovement({"maxilla", {0, 3, 2}, {0, 0, 0}});
  const auto* gizmo = window->boneTools()->gizmos().at(0)->GetFragmentRepresentation();
  EXPECT_TRUE(gizmo->IsLocked(0));
  EXPECT_FALSE(gizmo->IsLocked(1));
  EXPECT_EQ(gizmo->Within(1, 9), 3);
  const QList<QDoubleSpinBox*> right = window->findChildren<QDoubleSpinBox*>("right");
  ASSERT_EQ(right.size(), 2);
  EXPECT_FALSE(right[0]->isEnabled());
  EXPECT_TRUE(right[1]->isEnabled());
  EXPECT_TRUE(window->findChildren<QCheckBox*>("lock_right")[0]->isChecked());
  for (QToolButton* rules : window->findChildren<QToolButton*>("rules"))
    rules->setChecked(true);
  window->findChildren<QCheckBox*>("lock_yaw")[0]->click();
  EXPECT_TRUE(cuts()->rules("maxilla").isLocked(5));
  picture("plan_rules");
  ASSERT_TRUE(background_ends());
  ASSERT_TRUE(work()->isLive());

  ASSERT_TRUE(wait_until([&] { return work()->state(qFaceToBoneCase::Plan).possible; }, 60));
  ASSERT_EQ(run(qFaceToBoneCase::Plan), "");
  EXPECT_EQ(maxilla().translation[0], 0);
  EXPECT_NEAR(maxilla().rotation[2], 0, 1e-9);
  EXPECT_LE(maxilla().translation[1], 3 + 1e-9);
  const QString opened = work()->folder();
  work()->close();
  ASSERT_TRUE(window->open(opened));
  EXPECT_TRUE(cuts()->rules("maxilla").isLocked(0));
  EXPECT_EQ(cuts()->count(), 2);
  EXPECT_FALSE(cuts()->isMoved());
}

/// Mouse, keys and what the panel does, in any order.
TEST_F(CutsWindow, RandomEventsFindNothing)
{
  open_segmented();
  show_tools();
  std::mt19937 random(41);
  const QStringList templates = qFaceToBoneCuts::templates();
  const auto whole = [&](int below) { return static_cast<int>(random() % unsigned(below)); };
  for (int k = 0; k < testing::random_event_count(200); ++k)
  {
    QPoint at(whole(view()->width()), whole(view()->height()));
    const auto& parts = window->cutTools()->parts();
    if (!parts.empty() && whole(2))
    {
      const auto& part = parts[std::size_t(whole(int(parts.size())))];
      if (part.plane)
        at = pixel(part.plane->GetPlaneRepresentation()->HandlePosition(
            static_cast<vtkFaceToBonePlaneRepresentation::Handle>(2 + whole(6))));
      else if (part.saw && whole(2))
        at = pixel(part.saw->GetSawRepresentation()->HandlePosition(
            static_cast<vtkFaceToBoneSawRepresentation::Handle>(1 + whole(2))));
      else if (part.line->GetCurveRepresentation()->GetNumberOfControlPoints() > 0)
        at = pixel(part.line->GetCurveRepresentation()->GetControlPoint(0));
    }
    switch (whole(16))
    {
    case 0:
    case 1:
      send(QEvent::MouseButtonPress, at, whole(4) ? Qt::LeftButton : Qt::RightButton,
           whole(3) ? Qt::NoModifier : Qt::ShiftModifier);
      break;
    case 2:
    case 3:
      send(QEvent::MouseButtonRelease, at, whole(4) ? Qt::LeftButton : Qt::RightButton);
      break;
    case 4:
      send(QEvent::MouseButtonDblClick, at, Qt::LeftButton);
      break;
    case 5:
      QTest::keyClick(view(), whole(2)   ? Qt::Key_Escape
                              : whole(2) ? Qt::Key_Return
                                         : Qt::Key_Delete);
      break;
    case 6:
      cuts()->addTemplate(templates[whole(templates.size())]);
      break;
    case 7:
      trigger(whole(2) ? "undo" : "redo");
      break;
    case 8:
      whole(2) ? cuts()->remove(whole(3)) : cuts()->removePart(whole(3), whole(4));
      break;
    case 9:
      cuts()->setCurrent(whole(8));
      break;
    case 10:
      window->cutTools()->startDrawing(whole(2));
      break;
    case 11:
      whole(2) ? void(window->cutTools()->finishDrawing()) : window->cutTools()->dropDrawing();
      break;
    default:
      move(at);
    }
    QCoreApplication::processEvents();
    for (const qFaceToBoneCut& c : cuts()->all())
      for (const BoundedPlane& plane : c.planes)
      {
        ASSERT_TRUE(plane.center.allFinite());
        ASSERT_NEAR(plane.u.norm(), 1, 1e-9);
      }
  }
  ASSERT_TRUE(work()->saveCuts()) << work()->error().toStdString();
  complaint();
}

} // namespace
} // namespace f2b
