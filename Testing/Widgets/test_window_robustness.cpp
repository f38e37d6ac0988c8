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
    if (tool == Ruler)
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
      return !points->rulers().empty() && held(points->rulers().back());
    }
  }
};

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
