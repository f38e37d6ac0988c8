#include <Core/geometry/movement_words.hpp>

#include <gtest/gtest.h>

namespace
{

using f2b::amount_text;
using f2b::describe_movement;
using f2b::MovementRow;
using f2b::MovementUnit;
using f2b::RotationDegrees;
using f2b::translation_phrase;
using f2b::Vec3;

MovementRow row_of(const std::vector<MovementRow>& rows, const std::string& axis)
{
  for (const MovementRow& row : rows)
  {
    if (row.axis == axis)
    {
      return row;
    }
  }
  ADD_FAILURE() << "no row " << axis;
  return {};
}

TEST(MovementWords, TableTwoCaseReadsAsItsGeometry)
{
  const auto rows = describe_movement({2, 11, -5}, {5, 2.5, 0});
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(row_of(rows, "Coronal").direction, "Forward");
  EXPECT_EQ(amount_text(row_of(rows, "Coronal")), "11.00 mm");
  EXPECT_EQ(row_of(rows, "Axial").direction, "Downwards");
  EXPECT_EQ(amount_text(row_of(rows, "Axial")), "5.00 mm");
  EXPECT_EQ(row_of(rows, "Sagittal").direction, "Right");
  EXPECT_EQ(row_of(rows, "Coronal/center").direction, "Counter-clockwise");
  EXPECT_EQ(amount_text(row_of(rows, "Coronal/center")), "2.50\u00b0");
  EXPECT_EQ(row_of(rows, "Sagittal/center").direction, "Counter-clockwise");
  EXPECT_EQ(row_of(rows, "Axial/center").direction, "None");
}

TEST(MovementWords, RowsKeepTheOrderOfTheTable)
{
  const auto rows = describe_movement(Vec3::Zero(), {});
  const std::vector<std::string> axes{"Coronal",  "Axial",           "Coronal/center",
                                      "Sagittal", "Sagittal/center", "Axial/center"};
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    EXPECT_EQ(rows.at(i).axis, axes[i]);
    EXPECT_EQ(rows.at(i).direction, "None");
  }
}

TEST(MovementWords, OppositeMovementHasOppositeWordsAndSameAmount)
{
  const auto rows = describe_movement({-2, -11, 5}, {-5, -2.5, -1});
  EXPECT_EQ(row_of(rows, "Coronal").direction, "Backward");
  EXPECT_EQ(row_of(rows, "Axial").direction, "Upwards");
  EXPECT_EQ(row_of(rows, "Sagittal").direction, "Left");
  EXPECT_EQ(row_of(rows, "Coronal/center").direction, "Clockwise");
  EXPECT_EQ(row_of(rows, "Sagittal/center").direction, "Clockwise");
  EXPECT_EQ(row_of(rows, "Axial/center").direction, "Clockwise");
  EXPECT_DOUBLE_EQ(row_of(rows, "Coronal").amount, 11);
}

// A viewer's right hand is e_right, up is e_up; counter-clockwise takes right towards up.
TEST(MovementWords, PositiveAnglesTurnCounterClockwiseForTheStatedViewer)
{
  const Vec3 right(1, 0, 0), anterior(0, 1, 0), superior(0, 0, 1);
  struct Viewer
  {
    Vec3 stands_at, up;
  };
  // In front of the patient, at the right side, above (the patient's face towards the top).
  for (const Viewer& viewer :
       {Viewer{anterior, superior}, Viewer{right, superior}, Viewer{superior, anterior}})
  {
    const Vec3 viewers_right = viewer.up.cross(viewer.stands_at);
    // Small right-handed rotation about the axis that points at the viewer.
    const Vec3 change = viewer.stands_at.cross(viewers_right);
    EXPECT_GT(change.dot(viewer.up), 0);
  }
}

TEST(MovementWords, PhraseLeavesOutWhatIsNotMoved)
{
  EXPECT_EQ(translation_phrase({2, 11, -5}), "11.0 mm forward, 5.0 mm down, 2.0 mm right");
  EXPECT_EQ(translation_phrase({-0.3, 0.04, 0}), "0.3 mm left");
  EXPECT_EQ(translation_phrase(Vec3::Zero()), "no translation");
  EXPECT_EQ(f2b::rotation_phrase({5, -2.5, 0.04}),
            "2.5 degrees clockwise (coronal), 5.0 degrees counter-clockwise (sagittal)");
  EXPECT_EQ(f2b::rotation_phrase({0, 0, -1}), "1.0 degrees clockwise (axial)");
  EXPECT_EQ(f2b::rotation_phrase({}), "no rotation");
}

} // namespace
