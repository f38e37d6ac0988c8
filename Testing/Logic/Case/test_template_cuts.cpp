#include <Bridge/markups.hpp>
#include <Core/mesh/contact.hpp>
#include <Imaging/read_ct.hpp>
#include <Imaging/segment_head.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

namespace f2b
{
namespace
{

namespace fs = std::filesystem;

struct RealHead
{
  const char* name;
  const char* ct;
  std::optional<Box> region_ras;
};

const RealHead real_heads[] = {
    {"cthead_unc", "cthead_unc/ct.nrrd", Box{{-190, -132, 2}, {-20, 0, 158}}},
    {"phantom_imagex", "phantom_imagex/dicom", {}}};

/// With its own landmarks, on a lattice of 2 mm.
class TemplateCuts : public ::testing::TestWithParam<RealHead>
{
};

/// Do the templates free the right bone of heads that were not made for them? Teeth in occlusion
/// join the jaws in both CTs.
TEST_P(TemplateCuts, FreeTheirBoneOfARealHead)
{
  const char* given = std::getenv("FACETOBONE_DATA");
  const fs::path ct = fs::path(given ? given : FACETOBONE_DATA_DEFAULT) / GetParam().ct;
  if (!fs::exists(ct))
    GTEST_SKIP() << "no " << ct << "; set FACETOBONE_DATA";
  const Landmarks landmarks = read_landmarks(
      fs::path(FACETOBONE_TEST_DATA) / (GetParam().name + std::string("_landmarks.mrk.json")));
  SegmentOptions options;
  options.spacing_mm = 2;
  options.region_ras = GetParam().region_ras;
  const HeadSegmentation head = segment_head(*read_ct(ct), options);
  auto expect_parts = [&](const std::vector<std::string>& templates,
                          const std::vector<std::vector<std::string>>& free_at,
                          const std::vector<std::string>& uncut_at)
  {
    SCOPED_TRACE(templates.front() + " and " + templates.back());
    std::vector<Osteotomy> osteotomies;
    for (const std::string& name : templates)
      osteotomies.push_back(osteotomy_from_template(name, "", landmarks, 1));
    const BonePartition partition = cut_bone(head.bone, head.closed_bone, osteotomies);
    for (std::size_t f = 0; f < free_at.size(); ++f)
      for (const std::string& name : free_at[f])
        EXPECT_EQ(nearest_bone(partition.labels, landmarks.at(name)),
                  BonePartition::first_fragment + f)
            << name;
    for (const std::string& name : uncut_at)
      EXPECT_EQ(nearest_bone(partition.labels, landmarks.at(name)), BonePartition::uncut) << name;
  };
  expect_parts({"bsso"}, {{"B", "Pg", "Me"}}, {"ANS", "A", "N", "Or_R", "Go_R", "Go_L"});
  expect_parts({"bsso", "genioplasty"}, {{"B"}, {"Pg", "Me"}}, {"ANS", "Go_R", "Go_L"});
  expect_parts({"bsso", "le-fort-1"}, {{"B", "Pg", "Me"}, {"ANS", "A"}}, {"N", "Go_R", "Go_L"});
  expect_parts({"bsso", "le-fort-3"}, {{"B", "Pg", "Me"}, {"ANS", "Or_R", "Or_L"}},
               {"Go_R", "Go_L"});
}

INSTANTIATE_TEST_SUITE_P(RealHeads, TemplateCuts, ::testing::ValuesIn(real_heads),
                         [](const auto& head) { return std::string(head.param.name); });

} // namespace
} // namespace f2b
