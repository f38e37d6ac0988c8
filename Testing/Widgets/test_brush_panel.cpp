#include "qFaceToBoneBrushPanel.h"

#include <Core/sculpting/brush.hpp>

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QToolButton>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace f2b
{
namespace
{

/// The panel alone, as a host without a case holds it.
class BrushPanel : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    static char name[] = "test", option[] = "-platform", platform[] = "offscreen";
    static char* names[] = {name, option, platform, nullptr};
    static int count = 3;
    if (!QApplication::instance())
      static const QApplication application(count, names);
  }
  BrushPanel() : panel(std::make_unique<qFaceToBoneBrushPanel>()) {}

  void click(const QString& text)
  {
    for (QToolButton* button : panel->findChildren<QToolButton*>())
      if (button->text() == text)
        return button->click();
    FAIL() << text.toStdString();
  }
  QCheckBox* box(const QString& text)
  {
    for (QCheckBox* found : panel->findChildren<QCheckBox*>())
      if (found->text() == text)
        return found;
    return nullptr;
  }

  std::unique_ptr<qFaceToBoneBrushPanel> panel;
};

TEST_F(BrushPanel, EachButtonIsItsBrushAndTurnIsNone)
{
  EXPECT_FALSE(panel->isSculpting());
  QSignalSpy told(panel.get(), &qFaceToBoneBrushPanel::sculptingChanged);
  const std::pair<const char*, BrushKind> kinds[] = {
      {"Grab", BrushKind::Grab},       {"Elastic", BrushKind::ElasticGrab},
      {"Draw", BrushKind::Draw},       {"Smooth", BrushKind::Smooth},
      {"Flatten", BrushKind::Flatten}, {"Erase", BrushKind::Erase},
      {"Mask", BrushKind::Mask}};
  for (const auto& [name, kind] : kinds)
  {
    click(name);
    EXPECT_TRUE(panel->isSculpting());
    EXPECT_EQ(panel->brush().kind, kind) << name;
  }
  click("Turn");
  EXPECT_FALSE(panel->isSculpting());
  EXPECT_EQ(told.count(), 8);
  EXPECT_FALSE(told.last().at(0).toBool());
}

TEST_F(BrushPanel, SettingsAreTheBrushs)
{
  QSignalSpy told(panel.get(), &qFaceToBoneBrushPanel::brushChanged);
  panel->findChildren<QDoubleSpinBox*>().at(0)->setValue(22);
  EXPECT_EQ(panel->brush().radius_mm, 22);
  panel->findChildren<QDoubleSpinBox*>().at(1)->setValue(40);
  EXPECT_DOUBLE_EQ(panel->brush().strength, 0.4);
  EXPECT_EQ(told.count(), 2);
  EXPECT_TRUE(std::isinf(panel->brush().depth_mm));
  box("Not deeper than")->setChecked(true);
  EXPECT_EQ(panel->brush().depth_mm, 20);
  box("Only skin that is seen")->setChecked(false);
  EXPECT_FALSE(panel->brush().front_faces_only);
  EXPECT_TRUE(panel->isSymmetric());
  box("Both sides alike")->setChecked(false);
  EXPECT_FALSE(panel->isSymmetric());
  EXPECT_FALSE(panel->brush().symmetry); // the plane is the host's to find
}

TEST_F(BrushPanel, ABrushTurnedInTheViewIsShownWithoutAnEcho)
{
  QSignalSpy told(panel.get(), &qFaceToBoneBrushPanel::brushChanged);
  Brush brush = panel->brush();
  brush.radius_mm = 30;
  brush.strength = 0.5;
  panel->setBrush(brush);
  EXPECT_EQ(panel->findChildren<QDoubleSpinBox*>().at(0)->value(), 30);
  EXPECT_EQ(panel->findChildren<QDoubleSpinBox*>().at(1)->value(), 50);
  EXPECT_EQ(told.count(), 0);
}

TEST_F(BrushPanel, AHostPutsTheBrushDownOnce)
{
  click("Draw");
  QSignalSpy told(panel.get(), &qFaceToBoneBrushPanel::sculptingChanged);
  panel->stopSculpting();
  panel->stopSculpting();
  EXPECT_FALSE(panel->isSculpting());
  EXPECT_EQ(told.count(), 1);
  click("Draw");
  EXPECT_TRUE(panel->isSculpting());
}

} // namespace
} // namespace f2b
