#include "Widgets/desktop_patient.hpp"
#include "Widgets/desktop_stage.hpp"
#include "Widgets/random_events.hpp"

#include "qFaceToBoneLandmarksPanel.h"
#include "qFaceToBonePointTools.h"
#include "qFaceToBoneRulers.h"
#include "qFaceToBoneSculptPanel.h"
#include "qFaceToBoneStepsPanel.h"
#include "vtkFaceToBonePointsWidget.h"

#include <Bridge/vtk_surface.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include <vtkPolyData.h>

#include <csignal>
#include <random>

#include <unistd.h>

namespace f2b
{
namespace
{

using testing::wait_until;

/// A window whose work is taken away from it in unkind ways.
class RobustWindow : public testing::DesktopStage
{
protected:
  enum Tool
  {
    Brush,
    Handle,
    Landmark,
    Ruler
  };

  QString open_segmented(const char* name = "segmented")
  {
    const testing::SegmentedPatient& patient = testing::segmented_patient();
    if (!std::filesystem::exists(folder / name))
      std::filesystem::copy(patient.folder, folder / name,
                            std::filesystem::copy_options::recursive);
    EXPECT_TRUE(window->open(QString::fromStdString((folder / name).string())))
        << work()->error().toStdString();
    at_target();
    return work()->folder();
  }
  void at_target()
  {
    window->steps()->setCurrentStep(qFaceToBoneCase::Target);
    look_from(qFaceToBoneThreeDView::Right);
  }
  QPoint nose() { return pixel(work()->sculpting()->skin().points()[nose_tip()]) - QPoint(4, 0); }
  std::vector<Vec3> displacement() { return work()->sculpting()->skin().displacement(); }
  void sculpt_nose()
  {
    choose_brush("Elastic");
    drag(nose(), QPoint(12, 0));
    choose_brush("Turn");
  }
  /// Presses on what a tool drags, and moves. \return where the mouse is
  QPoint hold(Tool tool)
  {
    window->steps()->setCurrentStep(tool == Landmark ? qFaceToBoneCase::Surfaces
                                                     : qFaceToBoneCase::Target);
    choose_brush(tool == Brush ? "Elastic" : "Turn");
    window->findChild<QCheckBox*>("handles")->setChecked(tool == Handle);
    look_from(qFaceToBoneThreeDView::Right);
    if (tool == Ruler && work()->rulers()->all().empty())
      work()->rulers()->add({work()->landmarkOnFace("prn"), work()->landmarkOnFace("Pg'")});
    const QPoint at = tool == Brush    ? nose()
                      : tool == Ruler  ? pixel(work()->rulers()->all().back().points[1])
                      : tool == Handle ? pixel(work()->landmarkOnFace("prn"))
                                       : pixel(landmark("prn"));
    press(at);
    move(at + QPoint(7, 0));
    EXPECT_TRUE(is_held(tool)) << tool;
    return at + QPoint(9, 2);
  }
  /// Where it is placed, on the face before.
  std::array<double, 3> landmark(const QString& name)
  {
    for (const auto& landmark : work()->landmarks())
      if (landmark.name == name)
        return landmark.at;
    return {};
  }
  bool is_held(Tool tool)
  {
    const auto* points = window->pointTools();
    const auto held = [](vtkFaceToBonePointsWidget* widget)
    { return widget->GetWidgetState() != vtkFaceToBonePointsWidget::Start; };
    switch (tool)
    {
    case Brush:
      return work()->sculpting() && work()->sculpting()->in_stroke();
    case Handle:
      return held(points->handleTool());
    case Landmark:
      return held(points->landmarkTool());
    default:
      return std::any_of(points->rulers().begin(), points->rulers().end(), held);
    }
  }
};

TEST_F(RobustWindow, CaseGoneWhileAToolIsHeld)
{
  const QString opened = open_segmented();
  sculpt_nose();
  const std::size_t tip = nose_tip();
  for (const Tool tool : {Brush, Handle, Landmark, Ruler})
  {
    SCOPED_TRACE(tool);
    const Vec3 kept = displacement()[tip];
    QPoint at = hold(tool);
    work()->close();
    release(at);
    EXPECT_FALSE(work()->isOpen());
    ASSERT_TRUE(window->open(opened));
    at_target();
    EXPECT_LT((displacement()[tip] - kept).norm(), 8) << "more than the drag itself is lost";
    at = hold(tool);
    answer(QMessageBox::Save);
    open_segmented("another");
    release(at);
    EXPECT_FALSE(work()->sculpting()->in_stroke());
    ASSERT_TRUE(window->open(opened));
    at = hold(tool);
    window->steps()->setCurrentStep(qFaceToBoneCase::Plan);
    release(at);
    EXPECT_FALSE(work()->sculpting()->in_stroke());
  }
}

TEST_F(RobustWindow, WindowGoneWhileAToolIsHeld)
{
  const QString opened = open_segmented();
  sculpt_nose();
  for (const Tool tool : {Brush, Handle, Landmark, Ruler})
  {
    SCOPED_TRACE(tool);
    hold(tool);
    answer(QMessageBox::Save);
    window->close();
    window.reset();
    window = std::make_unique<qFaceToBoneMainWindow>();
    window->show();
    ASSERT_TRUE(window->open(opened));
    EXPECT_TRUE(work()->hasUnsavedChanges());
    EXPECT_GT(displacement()[nose_tip()].y(), 1);
    hold(tool);
    window.reset(); // without a word
    window = std::make_unique<qFaceToBoneMainWindow>();
    window->show();
    ASSERT_TRUE(window->open(opened));
  }
}

TEST_F(RobustWindow, WhatIsHeldIsRemoved)
{
  open_segmented();
  QPoint at = hold(Ruler);
  emit work()->objects()->removeWanted(work()->rulers()->all().back().key);
  release(at);
  EXPECT_TRUE(work()->rulers()->all().empty());
  at = hold(Landmark);
  for (const auto& landmark : work()->landmarks())
    work()->removeLandmark(landmark.name);
  release(at);
  complaint();
  at_target();
  const auto before = displacement();
  at = hold(Brush);
  trigger("undo");
  trigger("redo");
  work()->sculpting()->fill_mask(1);
  release(at);
  EXPECT_FALSE(work()->sculpting()->in_stroke());
  while (work()->undo())
  {
  }
  EXPECT_EQ(displacement(), before);
}

/// Steps make surfaces and bone anew while brush and cuts are at them; the window closes while they
/// run, or when they have just ended.
TEST_F(RobustWindow, WindowIsUsedResizedAndClosedDuringRuns)
{
  const QString opened = open_segmented();
  sculpt_nose();
  for (const auto step : {qFaceToBoneCase::Surfaces, qFaceToBoneCase::Cuts})
  {
    SCOPED_TRACE(step);
    ASSERT_TRUE(work()->start(step)) << work()->error().toStdString();
    std::mt19937 random(5);
    for (int k = 0; k < 8; ++k)
    {
      window->resize(700 + int(random() % 900), 500 + int(random() % 500));
      window->steps()->setCurrentStep(int(random() % 6));
      const int button = int(random() % 4) + 1; // not the target's, which would take the case's own
      QTest::mouseDClick(
          window->steps()->actionButton(button < qFaceToBoneCase::Target ? button : button + 1),
          Qt::LeftButton);
      at_target();
      sculpt_nose();
      work()->undo();
      work()->cuts()->addTemplate("genioplasty");
      work()->cuts()->undo();
      complaint();
    }
    // as when it closes: a step that ends begins the strokes' history anew, and the undo above may have
    // come after that
    const auto sculpted = displacement();
    answer(QMessageBox::Save);
    EXPECT_TRUE(window->close());
    window.reset();
    window = std::make_unique<qFaceToBoneMainWindow>();
    window->show();
    ASSERT_TRUE(window->open(opened));
    EXPECT_TRUE(work()->state(qFaceToBoneCase::Surfaces).done);
    ASSERT_EQ(displacement().size(), sculpted.size());
    EXPECT_LT((displacement()[nose_tip()] - sculpted[nose_tip()]).norm(), 1e-9);
  }
}

/// Mouse, keys and what the panels do, in any order, at the face and its points.
TEST_F(RobustWindow, RandomEventsAtTheFaceFindNothing)
{
  open_segmented();
  std::mt19937 random(71);
  const auto whole = [&](int below) { return static_cast<int>(random() % unsigned(below)); };
  const std::vector<const char*> brushes = {"Turn",   "Grab",    "Elastic", "Draw",
                                            "Smooth", "Flatten", "Erase",   "Mask"};
  const auto landmarks = work()->landmarks();
  const auto tick = [&](const char* name) { window->findChild<QCheckBox*>(name)->toggle(); };
  const auto press_button = [&](const char* name)
  { window->findChild<QPushButton*>(name)->click(); };
  for (int k = 0; k < testing::random_event_count(400); ++k)
  {
    QPoint at(whole(view()->width()), whole(view()->height()));
    if (whole(2))
      at = pixel(
          work()->sculpting()->skin().points()[random() % work()->sculpting()->skin().size()]);
    switch (whole(24))
    {
    case 0:
    case 1:
    case 2:
      send(QEvent::MouseButtonPress, at, whole(4) ? Qt::LeftButton : Qt::RightButton,
           whole(3)   ? Qt::NoModifier
           : whole(2) ? Qt::ShiftModifier
                      : Qt::ControlModifier);
      break;
    case 3:
    case 4:
    case 5:
      send(QEvent::MouseButtonRelease, at, whole(4) ? Qt::LeftButton : Qt::RightButton);
      break;
    case 6:
      send(QEvent::MouseButtonDblClick, at, Qt::LeftButton);
      break;
    case 7:
      QTest::keyClick(view(), std::array{Qt::Key_Escape, Qt::Key_BracketLeft, Qt::Key_BracketRight,
                                         Qt::Key_Return, Qt::Key_Delete}[std::size_t(whole(5))]);
      break;
    case 8:
      choose_brush(brushes[std::size_t(whole(int(brushes.size())))]);
      break;
    case 9:
      tick(whole(2) ? "handles" : "symmetric");
      break;
    case 10:
      trigger(whole(3) ? "undo" : "redo");
      break;
    case 11:
      press_button(whole(2) ? "distance" : "angle");
      break;
    case 12:
      press_button("placeLandmark");
      break;
    case 13:
      if (!work()->rulers()->all().empty())
        emit work()->objects()->removeWanted(work()->rulers()->all().front().key);
      break;
    case 14:
      work()->removeLandmark(landmarks[random() % landmarks.size()].name);
      break;
    case 15:
      window->steps()->setCurrentStep(whole(6));
      break;
    case 16:
      at_target();
      break;
    case 17:
      window->findChild<QToolButton*>("compare")->toggle();
      break;
    case 18:
      window->findChild<QComboBox*>("colour")->setCurrentIndex(whole(4));
      window->findChild<QSlider*>("split")->setValue(whole(101));
      break;
    case 19:
      if (!whole(8))
        window->resize(600 + whole(900), 450 + whole(500));
      break;
    default:
      move(at);
    }
    QCoreApplication::processEvents();
  }
  for (const Vec3& d : displacement())
    ASSERT_TRUE(d.allFinite());
  if (work()->sculpting()->in_stroke())
    work()->sculpting()->end_stroke();
  while (work()->undo())
  {
  }
  complaint();
}

/// A window that is killed where it stands; the test program runs it in a process of its own.
class KilledWindowDeathTest : public RobustWindow
{
protected:
  KilledWindowDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  /// One folder for the process that dies and the one that looks at what it left.
  Path shared()
  {
    constexpr const char* name = "FACETOBONE_FOLDER_OF_THE_KILLED";
    if (qEnvironmentVariableIsEmpty(name))
    {
      const Path made = folder / "shared";
      std::filesystem::copy(testing::segmented_patient().folder, made,
                            std::filesystem::copy_options::recursive);
      qputenv(name, made.c_str());
    }
    m_told = name;
    return Path(qgetenv(name).toStdString());
  }
  ~KilledWindowDeathTest() override { qunsetenv(m_told); }

  void open_shared()
  {
    ASSERT_TRUE(window->open(QString::fromStdString(shared().string())))
        << work()->error().toStdString();
    at_target();
  }
  [[noreturn]] void die()
  {
    std::filesystem::remove_all(folder.path());
    ::raise(SIGKILL);
    std::abort();
  }
  void sculpt_and_die_after_the_autosave()
  {
    QSettings().setValue("autosaveSeconds", 1);
    window = std::make_unique<qFaceToBoneMainWindow>();
    window->show();
    open_shared();
    sculpt_nose();
    work()->cuts()->addTemplate("genioplasty");
    write_surface(shared() / "expected.vtp", with_points(work()->objects()->find("skin")->surface,
                                                         work()->sculpting()->skin().points()));
    if (wait_until(
            [&]
            {
              return std::filesystem::exists(shared() / "sculpted.vtp") &&
                     std::filesystem::exists(shared() / "unfinished_cuts.json");
            },
            60))
      die();
    std::_Exit(1);
  }
  void die_while_it_cuts()
  {
    open_shared();
    double furthest = 0;
    QObject::connect(work()->task(), &qFaceToBoneTask::progressed, window.get(),
                     [&](const QString&, double fraction) { furthest = fraction; });
    if (work()->start(qFaceToBoneCase::Cuts) && wait_until([&] { return furthest > 0.3; }, 300))
      die();
    std::_Exit(1);
  }

private:
  const char* m_told = "";
};

TEST_F(KilledWindowDeathTest, FaceAndCutsAreThereAgainAsTheAutosaveLeftThem)
{
  (void)shared();
  EXPECT_EXIT(sculpt_and_die_after_the_autosave(), ::testing::KilledBySignal(SIGKILL), "");
  open_shared();
  EXPECT_TRUE(work()->hasUnsavedChanges());
  const auto expected = points_of(read_surface(shared() / "expected.vtp"));
  ASSERT_EQ(expected.size(), displacement().size());
  for (std::size_t v = 0; v < expected.size(); ++v)
    ASSERT_LT((expected[v] - work()->sculpting()->skin().points()[v]).norm(), 1e-9);
  EXPECT_GT(displacement()[nose_tip()].y(), 1);
  ASSERT_EQ(work()->cuts()->count(), 2);
  EXPECT_TRUE(work()->cuts()->isMoved());
}

TEST_F(KilledWindowDeathTest, ARunThatWasKilledLeavesTheCaseAsItWas)
{
  (void)shared();
  EXPECT_EXIT(die_while_it_cuts(), ::testing::KilledBySignal(SIGKILL), "");
  open_shared();
  EXPECT_TRUE(work()->state(qFaceToBoneCase::Surfaces).done);
  EXPECT_FALSE(work()->state(qFaceToBoneCase::Cuts).done);
  ASSERT_EQ(run(qFaceToBoneCase::Cuts), "");
  EXPECT_TRUE(work()->state(qFaceToBoneCase::Cuts).done);
}

} // namespace
} // namespace f2b
