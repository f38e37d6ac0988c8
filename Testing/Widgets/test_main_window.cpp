#include "Widgets/desktop_patient.hpp"
#include "Widgets/desktop_stage.hpp"

#include "qFaceToBoneSliceView.h"
#include "qFaceToBoneStepsPanel.h"
#include "qFaceToBoneThreeDView.h"
#include "vtkFaceToBoneSculptRepresentation.h"
#include "vtkFaceToBoneSculptWidget.h"

#include <Bridge/json_file.hpp>
#include <Case/verbs.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <vtkPolyData.h>
#include <vtkRenderer.h>

namespace f2b
{
namespace
{

using testing::coarse_patient;
using testing::SegmentedPatient;
using testing::wait_until;

class MainWindow : public testing::DesktopStage
{
protected:
  /// Opens a copy of the patient whose skin and bone have been found.
  void open_segmented()
  {
    static const SegmentedPatient patient;
    std::filesystem::copy(patient.folder, folder / "segmented",
                          std::filesystem::copy_options::recursive);
    ASSERT_TRUE(window->open(QString::fromStdString((folder / "segmented").string())))
        << work()->error().toStdString();
    window->steps()->setCurrentStep(qFaceToBoneCase::Target);
    window->threeDView()->setPreset(qFaceToBoneThreeDView::Right);
    QCoreApplication::processEvents();
  }
  void sculpt_nose()
  {
    choose_brush("Elastic");
    drag(pixel_of(nose_tip()) - QPoint(4, 0), QPoint(12, 0));
  }
  std::vector<Vec3> displacement() { return work()->sculpting()->skin().displacement(); }
  void trigger(const char* action) { window->menuBar()->findChild<QAction*>(action)->trigger(); }

  /// Opens a copy of the patient.
  void open_patient()
  {
    std::filesystem::copy(coarse_patient().folder, folder / "patient",
                          std::filesystem::copy_options::recursive);
    ASSERT_TRUE(window->open(QString::fromStdString((folder / "patient/case.json").string())))
        << work()->error().toStdString();
  }
  qFaceToBoneCase::StepState state(qFaceToBoneCase::Step step) { return work()->state(step); }

  /// Where a vertex of the face is seen, in the 3D view's own pixels.
  QPoint pixel_of(std::size_t vertex)
  {
    const Vec3 p = work()->sculpting()->skin().points()[vertex];
    vtkRenderer* renderer = window->threeDView()->mainRenderer();
    renderer->SetWorldPoint(p.x(), p.y(), p.z(), 1);
    renderer->WorldToDisplay();
    const double* d = renderer->GetDisplayPoint();
    return {int(d[0]), window->threeDView()->height() - 1 - int(d[1])};
  }
  std::size_t nose_tip()
  {
    const auto& points = work()->sculpting()->skin().points();
    return static_cast<std::size_t>(std::max_element(points.begin(), points.end(),
                                                     [](const Vec3& a, const Vec3& b)
                                                     { return a.y() < b.y(); }) -
                                    points.begin());
  }
  void choose_brush(const char* text)
  {
    for (QToolButton* button : window->findChildren<QToolButton*>())
      if (button->text() == text)
        button->click();
  }
  void drag(const QPoint& from, const QPoint& by)
  {
    QWidget* view = window->threeDView();
    QTest::mouseMove(view, from);
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    for (int k = 1; k <= 4; ++k)
      QTest::mouseMove(view, from + by * k / 4);
    QTest::mouseRelease(view, Qt::LeftButton, {}, from + by);
    QCoreApplication::processEvents();
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
};

TEST_F(MainWindow, StartsWithAWelcomeAndNothingToDoButOpen)
{
  picture("0_welcome");
  EXPECT_FALSE(work()->isOpen());
  EXPECT_TRUE(state(qFaceToBoneCase::Ct).possible);
  for (const auto step : {qFaceToBoneCase::Surfaces, qFaceToBoneCase::Cuts, qFaceToBoneCase::Target,
                          qFaceToBoneCase::Plan, qFaceToBoneCase::Report})
  {
    EXPECT_FALSE(state(step).possible);
    EXPECT_FALSE(work()->start(step));
    EXPECT_FALSE(work()->error().isEmpty());
  }
}

TEST_F(MainWindow, WhatIsNoCaseIsRefusedAndNothingChanges)
{
  folder.write("other.json", "{}");
  folder.write("broken.json", "{");
  for (const char* name : {"other.json", "broken.json", "absent.json", "."})
  {
    EXPECT_FALSE(window->open(QString::fromStdString((folder / name).string()))) << name;
    EXPECT_FALSE(complaint().isEmpty()) << name;
    EXPECT_FALSE(work()->isOpen());
  }
}

TEST_F(MainWindow, MenusUndoAndRedoStrokesExactly)
{
  open_segmented();
  const auto rest = displacement();
  sculpt_nose();
  const auto once = displacement();
  ASSERT_NE(once, rest);
  sculpt_nose();
  const auto twice = displacement();
  trigger("undo");
  EXPECT_EQ(displacement(), once);
  trigger("undo");
  trigger("undo"); // nothing more
  EXPECT_EQ(displacement(), rest);
  trigger("redo");
  trigger("redo");
  EXPECT_EQ(displacement(), twice);
}

TEST_F(MainWindow, LandmarkMovesByNumbers)
{
  open_segmented();
  ASSERT_TRUE(work()->moveLandmark("sn", {0, 4, 0}, 30)) << work()->error().toStdString();
  double most = 0;
  for (const Vec3& d : displacement())
    most = std::max(most, d.y());
  EXPECT_NEAR(most, 4, 1e-6);
  EXPECT_FALSE(work()->moveLandmark("no such", {0, 4, 0}, 30));
  EXPECT_NE(work()->error(), "");
}

TEST_F(MainWindow, SculptedFaceIsThereAgainAfterClosingUnkept)
{
  open_segmented();
  sculpt_nose();
  const auto sculpted = displacement();
  const QString opened = work()->folder();
  window->close();
  window = std::make_unique<qFaceToBoneMainWindow>();
  window->show();
  ASSERT_TRUE(window->open(opened));
  EXPECT_TRUE(work()->hasUnsavedChanges());
  const auto recovered = displacement();
  ASSERT_EQ(recovered.size(), sculpted.size());
  for (std::size_t v = 0; v < sculpted.size(); ++v)
    ASSERT_LT((recovered[v] - sculpted[v]).norm(), 1e-9);
}

TEST_F(MainWindow, AnotherCaseOverASculptedOneLosesNothing)
{
  open_segmented();
  sculpt_nose();
  const auto sculpted = displacement();
  const QString first = work()->folder();
  open_patient();
  EXPECT_FALSE(work()->sculpting());
  ASSERT_TRUE(window->open(first));
  ASSERT_EQ(displacement().size(), sculpted.size());
  EXPECT_LT((displacement()[nose_tip()] - sculpted[nose_tip()]).norm(), 1e-9);
}

TEST_F(MainWindow, CancelledStepLeavesTheCaseAsItWas)
{
  open_patient();
  bool cancelled = false;
  QObject::connect(work()->task(), &qFaceToBoneTask::progressed, window.get(),
                   [&](const QString&, double)
                   {
                     if (!cancelled)
                       window->findChild<QPushButton*>("cancel")->click();
                     cancelled = true;
                   });
  EXPECT_EQ(run(qFaceToBoneCase::Surfaces), "");
  EXPECT_TRUE(cancelled);
  EXPECT_FALSE(state(qFaceToBoneCase::Surfaces).done);
  EXPECT_FALSE(work()->start(qFaceToBoneCase::Cuts));
  EXPECT_TRUE(state(qFaceToBoneCase::Surfaces).possible);
}

TEST_F(MainWindow, ClosingDuringARunEndsIt)
{
  open_patient();
  ASSERT_TRUE(work()->start(qFaceToBoneCase::Surfaces));
  EXPECT_FALSE(work()->start(qFaceToBoneCase::Surfaces)); // one at a time
  EXPECT_FALSE(window->open("elsewhere"));
  complaint();
  window->close();
  window.reset();
}

TEST_F(MainWindow, CrosshairIsOneForAllSlices)
{
  open_segmented();
  qFaceToBoneSliceView* slice = window->sliceView(1);
  QTest::mouseClick(slice, Qt::LeftButton, {}, QPoint(slice->width() / 3, slice->height() / 3));
  const auto point = slice->crosshair();
  EXPECT_EQ(window->sliceView(0)->crosshair(), point);
  EXPECT_EQ(window->sliceView(2)->crosshair(), point);
  EXPECT_GT(point[0], 1); // the picture's left is the patient's right
}

TEST_F(MainWindow, SampleCaseFromCtToReport)
{
  open_patient();
  picture("1_opened");
  EXPECT_EQ(window->steps()->currentStep(), int(qFaceToBoneCase::Surfaces));
  ASSERT_EQ(run(qFaceToBoneCase::Surfaces), "");
  ASSERT_TRUE(state(qFaceToBoneCase::Surfaces).done);
  ASSERT_TRUE(work()->sculpting());
  window->steps()->setCurrentStep(qFaceToBoneCase::Surfaces);
  picture("2_surfaces");

  std::string background;
  QObject::connect(work()->background(), &qFaceToBoneTask::ended, window.get(),
                   [&](bool, const QString& message) { background = message.toStdString(); });
  ASSERT_EQ(run(qFaceToBoneCase::Cuts), "");
  window->steps()->setCurrentStep(qFaceToBoneCase::Cuts);
  ASSERT_TRUE(state(qFaceToBoneCase::Cuts).done);
  EXPECT_TRUE(std::filesystem::exists(Path(work()->folder().toStdString()) / "case.mrml"));
  std::string keys;
  for (const qFaceToBoneObject& object : work()->objects()->all())
    keys += object.key.toStdString() + " ";
  ASSERT_TRUE(work()->objects()->find("fragment/mid-face")) << keys;
  window->findChild<QSlider*>("explode")->setValue(15);
  for (QCheckBox* box : window->findChildren<QCheckBox*>("planes"))
    box->setChecked(true);
  picture("3_cuts");
  window->findChild<QSlider*>("explode")->setValue(0);
  ASSERT_TRUE(background_ends());
  ASSERT_TRUE(work()->isLive()) << background;

  // the case's own target, then the brush
  ASSERT_EQ(run(qFaceToBoneCase::Target), "");
  EXPECT_TRUE(state(qFaceToBoneCase::Target).done);
  ASSERT_TRUE(background_ends());
  window->steps()->setCurrentStep(qFaceToBoneCase::Target);
  const std::size_t nose = nose_tip();
  const Vec3 before = work()->sculpting()->skin().displacement()[nose];
  window->threeDView()->setPreset(qFaceToBoneThreeDView::Right);
  wait_until([] { return true; }, 1);
  QCoreApplication::processEvents();
  choose_brush("Elastic");
  drag(pixel_of(nose) - QPoint(4, 0), QPoint(12, 0));
  const Vec3 after = work()->sculpting()->skin().displacement()[nose];
  EXPECT_GT((after - before).y(), 1) << "the brush did not reach the nose";
  EXPECT_TRUE(work()->hasUnsavedChanges());
  QElapsedTimer since;
  since.start();
  work()->sculpted(false);
  std::cout << "preview: " << since.nsecsElapsed() / 1'000'000 << " ms for "
            << work()->sculpting()->skin().size() << " vertices\n";
  window->findChild<QComboBox*>("colour")->setCurrentIndex(1);
  picture("4_target");
  window->findChild<QComboBox*>("colour")->setCurrentIndex(0);
  ASSERT_TRUE(background_ends());
  ASSERT_EQ(work()->movements().size(), 1u);
  EXPECT_GT(work()->movements()[0].translation[1], 1); // forward

  // the solve that a stroke asks for may begin late on a busy machine
  wait_until([&] { return state(qFaceToBoneCase::Target).possible; }, 60);
  ASSERT_EQ(run(qFaceToBoneCase::Target), "");
  EXPECT_FALSE(work()->hasUnsavedChanges());
  ASSERT_EQ(run(qFaceToBoneCase::Plan), "");
  EXPECT_TRUE(state(qFaceToBoneCase::Plan).done);
  window->steps()->setCurrentStep(qFaceToBoneCase::Plan);
  window->threeDView()->setPreset(qFaceToBoneThreeDView::ThreeQuarter);
  picture("5_plan");
  window->findChild<QToolButton*>("compare")->setChecked(true);
  window->findChild<QComboBox*>("colour")->setCurrentIndex(3);
  picture("6_compare");
  window->findChild<QComboBox*>("colour")->setCurrentIndex(0);
  window->findChild<QToolButton*>("compare")->setChecked(false);
  ASSERT_EQ(run(qFaceToBoneCase::Report), "");
  window->steps()->setCurrentStep(qFaceToBoneCase::Report);
  EXPECT_TRUE(state(qFaceToBoneCase::Report).done);
  picture("7_report");

  // what was done is there again
  const QString opened = work()->folder();
  const auto planned = work()->movements();
  work()->close();
  EXPECT_FALSE(work()->isOpen());
  ASSERT_TRUE(window->open(opened));
  EXPECT_TRUE(state(qFaceToBoneCase::Report).done);
  // files hold points: their difference from the reference is rounded
  EXPECT_LT((work()->sculpting()->skin().displacement()[nose] - after).norm(), 1e-9);
  ASSERT_EQ(work()->movements().size(), 1u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(work()->movements()[0].translation[k], planned[0].translation[k], 1e-9);
}

} // namespace
} // namespace f2b
