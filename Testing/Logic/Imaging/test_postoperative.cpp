#include "Logic/Imaging/operated_patient.hpp"
#include "expect_error.hpp"

#include <Core/geometry/fragment_movement.hpp>
#include <Imaging/moved_ct.hpp>
#include <Imaging/postoperative_head.hpp>

#include <gtest/gtest.h>

#include <omp.h>

namespace f2b
{
namespace
{

using test::expect_error;
using test::operated_head;
using test::OperatedHead;

const double degree = std::acos(-1.0) / 180;

PostoperativeCtOptions coarse_scan()
{
  PostoperativeCtOptions options;
  options.spacing_mm = Vec3::Constant(2);
  return options;
}

PostoperativeCtOptions resliced(const Vec3& translation, const Vec3& angles_deg)
{
  PostoperativeCtOptions options = coarse_scan();
  options.reslice.reference_point = Vec3(0, 20, 0);
  options.reslice.translation = translation;
  options.reslice.rotation =
      rotation_from({angles_deg.x() * degree, angles_deg.y() * degree, angles_deg.z() * degree});
  return options;
}

double hounsfield(const CtImage& ct, const Vec3& p)
{
  return resample_ct(ct, {p, 1, {1, 1, 1}}).values.front();
}

const WholeBone& whole_before()
{
  static const WholeBone whole = find_whole_bone(*operated_head().before, "before");
  return whole;
}

const BinaryMask& cranium()
{
  static const BinaryMask mask =
      unaltered_cranium(whole_before(), operated_head().partition.labels,
                        {operated_head().patient.landmark("Or_R").z() + 8});
  return mask;
}

RegisterCtOptions quick_registration()
{
  RegisterCtOptions options;
  options.samples = 8000;
  options.disturbed_starts = 1;
  options.spacing_mm = 2;
  return options;
}

TEST(MovedCt, CarriesEveryVoxelAlongWithoutInterpolation)
{
  const CtImage& before = *operated_head().before;
  const RigidMotion motion = resliced({5, -7, 3}, {10, 5, -8}).reslice;
  const CtImage::Pointer moved = moved_ct(before, motion);
  EXPECT_EQ(moved->GetBufferPointer(), before.GetBufferPointer());
  for (const Vec3& p : {Vec3(0, 100, 0), Vec3(30, 60, -40), Vec3(-20, -40, 60)})
    EXPECT_NEAR(hounsfield(*moved, motion.apply(p)), hounsfield(before, p), 0.01);
}

TEST(PostoperativeCt, BoneMovesRigidlyAndTheCraniumStays)
{
  const OperatedHead& head = operated_head();
  PostoperativeCtOptions options = coarse_scan();
  options.noise_sd_hu = 0;
  const CtImage::Pointer after = head.after(options);
  const auto fragment = fragment_surface(head.head.bone, head.partition, 2, 400);
  const auto stays = fragment_surface(head.head.bone, head.partition, 1, 2000);
  double moved = 0, stayed = 0, count = 0;
  for (const SurfaceSample& s : fragment)
    moved += std::abs(hounsfield(*after, head.motion.apply(s.point)) -
                      hounsfield(*head.before, s.point));
  for (const SurfaceSample& s : stays)
    if (s.point.z() > 10)
    {
      stayed += std::abs(hounsfield(*after, s.point) - hounsfield(*head.before, s.point));
      ++count;
    }
  ASSERT_GT(count, 100);
  EXPECT_LT(moved / static_cast<double>(fragment.size()), 120) << "HU, at an edge of 1000 HU";
  EXPECT_LT(stayed / count, 1) << "HU";
}

TEST(PostoperativeCt, SkinFollowsTheDisplacement)
{
  const OperatedHead& head = operated_head();
  const CtImage::Pointer after = head.after(coarse_scan());
  SegmentOptions options;
  options.spacing_mm = 1.5;
  options.region_ras = head.head.region_ras;
  const HeadSegmentation seen = segment_head(*after, options);
  // the upper lip lies before the fragment and goes with it
  const Vec3 lip = head.patient.landmark("sn");
  EXPECT_GT(head.head.skin.value(head.motion.apply(lip)), 3) << "outside of the face before";
  EXPECT_NEAR(seen.skin.value(head.motion.apply(lip)), head.head.skin.value(lip), 0.7);
  const Vec3 forehead = head.patient.landmark("N'") + Vec3(0, 0, 35);
  EXPECT_NEAR(seen.skin.value(forehead), head.head.skin.value(forehead), 0.3);
}

TEST(PostoperativeCt, RefusesMovementsThatAreNotOnePerFragment)
{
  const OperatedHead& head = operated_head();
  const std::vector<RigidMotion> none;
  expect_error(
      [&]
      {
        (void)synthesize_postoperative_ct(
            {head.hu, head.head.bone, head.partition, none, head.tets, head.X, head.x});
      },
      {"movements", "1 fragments"});
}

TEST(RegisterCt, FindsAFarReslicedHeadAndHowItsFragmentMoved)
{
  const OperatedHead& head = operated_head();
  const PostoperativeCtOptions scan = resliced({-20, 15, 18}, {12, -9, 10});
  const CtImage::Pointer after = head.after(scan);
  SegmentOptions segment;
  segment.spacing_mm = 1.5;
  segment.region_ras = head.head.region_ras;
  const PostoperativeHead seen = find_postoperative_head(*head.before, whole_before(), cranium(),
                                                         *after, segment, quick_registration());

  const auto bone = surface_points(
      head.head.bone, [](const Vec3&) { return true; }, 3000);
  const RigidMotion& found = seen.registration.to_postoperative;
  EXPECT_LT(largest_difference(found, scan.reslice, bone), 0.3);
  EXPECT_LT(angle_between(found, scan.reslice), 0.3 * degree);
  EXPECT_GT(seen.registration.bone_within_1_5_mm, 0.95);
  EXPECT_GT(seen.registration.mutual_information, 0.3);
  EXPECT_LT(seen.registration.spread_mm, 0.3);

  const auto fragment = fragment_surface(head.head.bone, head.partition, 2);
  RigidMotion rest;
  rest.reference_point = head.motion.reference_point;
  const FragmentMovement movement =
      measure_fragment_movement(fragment, seen.head.bone, rest, "maxilla");
  EXPECT_LT(largest_difference(movement.fit.motion, head.motion, fragment), 0.5);
  EXPECT_LT(angle_between(movement.fit.motion, head.motion), 0.5 * degree);
  EXPECT_FALSE(movement.doubtful());
}

TEST(RegisterCt, ThreadsDoNotDecide)
{
  const OperatedHead& head = operated_head();
  const CtImage::Pointer after = head.after(resliced({3, -5, 4}, {4, -3, 5}));
  const WholeBone whole_after = find_whole_bone(*after, "after");
  RegisterCtOptions options = quick_registration();
  options.samples = 3000;
  options.disturbed_starts = 0;
  std::vector<RigidMotion> found;
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3})
  {
    omp_set_num_threads(threads);
    found.push_back(
        register_ct(*head.before, whole_before(), cranium(), *after, whole_after, options)
            .to_postoperative);
  }
  omp_set_num_threads(before);
  EXPECT_EQ(found[0].matrix(), found[1].matrix());
}

TEST(RegisterCt, AnotherHeadIsNamed)
{
  const OperatedHead& head = operated_head();
  auto other = CtImage::New(); // the same voxels, a smaller head of another shape
  other->Graft(head.before);
  CtImage::SpacingType spacing;
  spacing[0] = 1.8;
  spacing[1] = 1.7;
  spacing[2] = 1.95;
  other->SetSpacing(spacing);
  expect_error(
      [&]
      {
        (void)register_ct(*head.before, whole_before(), cranium(), *other,
                          find_whole_bone(*other, "other"), quick_registration());
      },
      {"same patient", "%"});
}

TEST(RegisterCt, ACtWithoutBoneIsNoHead)
{
  auto soft = CtImage::New();
  soft->SetRegions(CtImage::SizeType{{40, 40, 40}});
  soft->SetSpacing(CtImage::SpacingType(2.0));
  soft->Allocate();
  soft->FillBuffer(40);
  expect_error([&] { (void)find_whole_bone(*soft, "after.nrrd"); }, {"after.nrrd", "0 ml of bone"});
}

TEST(UnalteredRegion, BoxesWithoutFixedBoneAreRefused)
{
  const LabelGrid& parts = operated_head().partition.labels;
  const Vec3 ans = operated_head().patient.landmark("ANS");
  expect_error(
      [&] {
        (void)unaltered_box(whole_before(), parts, {Vec3(0, 0, 5), Vec3(5, 5, 5)});
      },
      {"box", "is empty"});
  expect_error(
      [&] {
        (void)unaltered_box(whole_before(), parts, {Vec3(500, 0, 0), Vec3(600, 9, 9)});
      },
      {"box", "0 ml of bone"});
  expect_error(
      [&] {
        (void)unaltered_box(whole_before(), parts,
                            {ans - Vec3::Constant(8), ans + Vec3::Constant(8)});
      },
      {"away from the fragments"});
  const BinaryMask vault =
      unaltered_box(whole_before(), parts, {Vec3(-90, -110, 30), Vec3(90, 110, 110)});
  EXPECT_GT(vault.count(), 20000U);
}

TEST(UnalteredRegion, TheCraniumKeepsAwayFromJawAndFragment)
{
  const OperatedHead& head = operated_head();
  // without landmarks the vertex tells the height
  const BinaryMask mask = unaltered_cranium(whole_before(), head.partition.labels);
  std::size_t sample = 0;
  for (int k = 0; k < mask.lattice.size.z(); ++k)
    for (int j = 0; j < mask.lattice.size.y(); ++j)
      for (int i = 0; i < mask.lattice.size.x(); ++i, ++sample)
        if (mask.values[sample])
        {
          const Vec3 p = mask.lattice.position(i, j, k);
          EXPECT_GT(head.patient.mandible(p), 0) << p.transpose();
        }
}

} // namespace
} // namespace f2b
