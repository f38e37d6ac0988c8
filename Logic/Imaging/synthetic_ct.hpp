#pragma once

#include "Core/geometry/virtual_patient.hpp"
#include "Imaging/ct_image.hpp"

#include <cstdint>

/// Which CT does a scanner make of the virtual patient?
namespace f2b
{

/// What each tissue measures [HU].
struct TissueHounsfield
{
  double air = -1000;
  double fat = -100;
  double muscle = 50;
  double brain = 35;
  double skin = 60;
  double cortical_bone = 1250;
  double trabecular_bone = 500;
  double tooth = 2000;
};

struct SyntheticCtOptions
{
  /// Voxel edges along R, A and S [mm], 0.3 to 5.
  Vec3 spacing_mm = Vec3(1, 1, 1);
  /// Corners of the field of view [mm, RAS]; it ends inside the neck, as real ones do.
  Vec3 lower_ras = Vec3(-106, -122, -142);
  Vec3 upper_ras = Vec3(106, 126, 120);
  TissueHounsfield hounsfield;
  /// Standard deviation of white Gaussian noise [HU].
  double noise_sd_hu = 12;
  /// Seed of the noise and of the streaks; equal seeds give equal images.
  std::uint64_t seed = 1;
  /// Two metal crowns with streaks across lips and cheeks at the occlusal level.
  bool streaks = false;
  /// A padded plastic trough behind the head, which touches it.
  bool head_rest = false;
  /// 0: all processors. The image is the same for every number.
  int threads = 0;
};

/// Voxelises the patient with partial volume over one voxel. The image's direction is the identity
/// (LPS). Throws f2b::Error for options out of range.
CtImage::Pointer synthesize_ct(const VirtualPatient& patient,
                               const SyntheticCtOptions& options = {});

} // namespace f2b
