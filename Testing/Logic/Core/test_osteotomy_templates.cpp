#include "expect_error.hpp"

#include <Core/geometry/osteotomy_templates.hpp>
#include <Core/geometry/virtual_patient.hpp>

#include <gtest/gtest.h>

namespace f2b
{
namespace
{

/// The virtual patient's facial bones, 2.5 mm apart, and the landmarks on them.
struct Head
{
  ScalarGrid bone;
  Landmarks landmarks;

  Head()
  {
    const VirtualPatient patient;
    for (const NamedPoint& point : patient.landmarks())
      landmarks[point.name] = point.point_ras;
    bone.origin = {-75, -12, -125};
    bone.spacing = 2.5;
    bone.size = {61, 42, 62};
    bone.values.resize(bone.count());
    for (int k = 0; k < bone.size.z(); ++k)
      for (int j = 0; j < bone.size.y(); ++j)
        for (int i = 0; i < bone.size.x(); ++i)
          bone.values[bone.index(i, j, k)] =
              static_cast<float>(patient.bone(bone.position(i, j, k)));
  }

  BonePartition cut(const std::vector<std::string>& templates) const
  {
    std::vector<Osteotomy> osteotomies;
    for (const std::string& name : templates)
      osteotomies.push_back(osteotomy_from_template(name, "", landmarks, 1));
    return cut_bone(bone, bone, osteotomies);
  }

  /// The label of the bone that a landmark lies on.
  int part_at(const BonePartition& partition, const std::string& name) const
  {
    double nearest = 6;
    int found = BonePartition::no_bone;
    for (int k = 0; k < bone.size.z(); ++k)
      for (int j = 0; j < bone.size.y(); ++j)
        for (int i = 0; i < bone.size.x(); ++i)
        {
          const int label = partition.labels.values[partition.labels.index(i, j, k)];
          const double distance = (bone.position(i, j, k) - landmarks.at(name)).norm();
          if (label != BonePartition::no_bone && distance < nearest)
          {
            nearest = distance;
            found = label;
          }
        }
    return found;
  }

  void expect_parts(const std::vector<std::string>& templates,
                    const std::vector<std::vector<std::string>>& free_at,
                    const std::vector<std::string>& uncut_at) const
  {
    const BonePartition partition = cut(templates);
    for (std::size_t f = 0; f < free_at.size(); ++f)
      for (const std::string& name : free_at[f])
        EXPECT_EQ(part_at(partition, name), BonePartition::first_fragment + static_cast<int>(f))
            << name << " with " << templates.front();
    for (const std::string& name : uncut_at)
      EXPECT_EQ(part_at(partition, name), BonePartition::uncut)
          << name << " with " << templates.front();
  }
};

const Head& head()
{
  static const Head instance;
  return instance;
}

TEST(OsteotomyTemplates, EachFreesItsBoneAndLeavesTheRest)
{
  head().expect_parts({"le-fort-1"}, {{"ANS", "A", "U1", "U6_R", "U6_L"}},
                      {"Or_R", "Or_L", "N", "L1", "B", "Pg", "Go_R", "Co_L"});
  head().expect_parts({"le-fort-3"}, {{"ANS", "U1", "U6_R", "Or_R", "Or_L"}},
                      {"L1", "Pg", "Go_R", "Co_L"});
  head().expect_parts({"genioplasty"}, {{"Pg", "Me", "Gn"}}, {"L1", "B", "U1", "Go_R", "Go_L"});
  head().expect_parts({"bsso"}, {{"L1", "B", "Pg", "Me", "Gn"}},
                      {"U1", "U6_R", "U6_L", "ANS", "Go_R", "Go_L", "Co_R", "Co_L"});
}

TEST(OsteotomyTemplates, PyramidFreesNoseAndMaxilla)
{
  head().expect_parts({"le-fort-2"}, {{"ANS", "A", "U1", "U6_R", "U6_L"}},
                      {"L1", "B", "Pg", "Zy_R", "Zy_L", "Go_R", "Co_L"});
}

TEST(OsteotomyTemplates, ZygomaComesAlone)
{
  head().expect_parts({"zygoma-right"}, {{}}, {"ANS", "U1", "U6_R", "N", "Go_R", "Co_R", "Or_L"});
  const BonePartition partition = head().cut({"zygoma-right", "zygoma-left"});
  const auto& volume = partition.fragment_volume_mm3;
  EXPECT_GT(volume[0], 3000);
  EXPECT_LT(volume[0], 30000);
  EXPECT_NEAR(volume[0], volume[1], 0.05 * volume[0]) << "the virtual patient is symmetric";
}

TEST(OsteotomyTemplates, SplitMandibleIsThreeFragments)
{
  head().expect_parts({"bsso", "bsso-right", "bsso-left"},
                      {{"L1", "B", "Pg", "Me"}, {"Go_R", "Co_R"}, {"Go_L", "Co_L"}},
                      {"U1", "U6_R", "ANS", "N", "Zy_R"});
}

TEST(OsteotomyTemplates, JawsAndChinCanBeCutTogether)
{
  head().expect_parts({"bsso", "genioplasty"}, {{"L1", "B"}, {"Pg", "Me"}}, {"U1", "Go_R", "Co_L"});
  for (const char* upper : {"le-fort-1", "le-fort-3"})
    head().expect_parts({"bsso", upper}, {{"L1", "B", "Pg"}, {"U1", "U6_L", "ANS"}},
                        {"Go_L", "Co_R"});
}

TEST(OsteotomyTemplates, OneInsideAnotherIsRefused)
{
  test::expect_error(
      [] {
        (void)head().cut({"le-fort-1", "le-fort-3"});
      },
      {"'maxilla' and 'mid-face'", "same piece"});
}

TEST(OsteotomyTemplates, NeedsTheLandmarksThatItSaysAndNoOthers)
{
  for (const std::string& name : osteotomy_template_names())
  {
    Landmarks needed;
    for (const std::string& landmark : landmarks_of_template(name))
      needed[landmark] = head().landmarks.at(landmark);
    EXPECT_NO_THROW((void)osteotomy_from_template(name, "", needed, 1)) << name;
    for (const auto& [landmark, place] : needed)
    {
      Landmarks others = head().landmarks;
      others.erase(landmark);
      test::expect_error([&] { (void)osteotomy_from_template(name, "", others, 1); },
                         {name, "'" + landmark + "'"});
    }
  }
}

TEST(OsteotomyTemplates, AMissingLandmarkIsNamed)
{
  for (const std::string& name : osteotomy_template_names())
  {
    Landmarks landmarks = head().landmarks;
    landmarks.erase("Or_R");
    test::expect_error([&] { (void)osteotomy_from_template(name, "", landmarks, 1); },
                       {name, "'Or_R'"});
  }
  Landmarks landmarks = head().landmarks;
  landmarks.erase("Go_L");
  test::expect_error([&] { (void)osteotomy_from_template("bsso", "", landmarks, 1); },
                     {"bsso", "'Go_L'"});
}

} // namespace
} // namespace f2b
