#include "Imaging/register_ct.hpp"

#include "Core/error.hpp"
#include "Imaging/mutual_information.hpp"
#include "Imaging/resample_ct.hpp"
#include "Imaging/scanner_artefacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace f2b
{
namespace
{

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double near_bone_mm = 1.5;
constexpr const char* what_it_is = "the registration of the post-operative CT";

std::string number(double value, int digits)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string percent(double share)
{
  return number(100 * share, 0) + " %";
}

bool holds(const BinaryMask& mask, const Vec3& p)
{
  const Vec3 at = (p - mask.lattice.origin) / mask.lattice.spacing;
  const Eigen::Vector3i n = at.array().round().cast<int>();
  return (n.array() >= 0).all() && (n.array() < mask.lattice.size.array()).all() &&
         mask.values[mask.lattice.index(n.x(), n.y(), n.z())] != 0;
}

/// A point in each of an even choice of the mask's samples, off the lattice: on it the
/// interpolation would prefer whole voxels of displacement.
std::vector<Vec3> scattered_points(const BinaryMask& mask, std::size_t at_most)
{
  constexpr std::uint64_t seed = 20;
  std::vector<Vec3> points;
  const double stride =
      std::max(1.0, static_cast<double>(mask.count()) / static_cast<double>(at_most));
  double next = 0;
  std::size_t number_in_mask = 0, sample = 0;
  for (int k = 0; k < mask.lattice.size.z(); ++k)
    for (int j = 0; j < mask.lattice.size.y(); ++j)
      for (int i = 0; i < mask.lattice.size.x(); ++i, ++sample)
      {
        if (!mask.values[sample] || static_cast<double>(number_in_mask++) < next)
          continue;
        next += stride;
        Vec3 offset;
        for (int a = 0; a < 3; ++a)
          offset[a] = std::clamp(standard_noise(seed, 3 * sample + static_cast<std::uint64_t>(a)),
                                 -1.5, 1.5);
        points.push_back(mask.lattice.position(i, j, k) + mask.lattice.spacing / 3 * offset);
      }
  return points;
}

/// Two points of the head that do not depend on how far the CT reaches down: the centre of all
/// bone does, that of the bone not far below its top does not.
struct BoneCenters
{
  Vec3 all = Vec3::Zero(), upper = Vec3::Zero();
};

BoneCenters centers_of(const WholeBone& whole)
{
  constexpr double upper_mm = 80;
  const ScalarGrid& bone = whole.bone;
  BoneCenters centers;
  double count = 0, upper_count = 0, top = 0;
  for (int k = bone.size.z() - 1; k >= 0; --k)
    for (int j = 0; j < bone.size.y(); ++j)
      for (int i = 0; i < bone.size.x(); ++i)
      {
        if (bone.values[bone.index(i, j, k)] >= 0)
          continue;
        const Vec3 p = bone.position(i, j, k);
        top = count == 0 ? p.z() : top;
        ++count;
        centers.all += p;
        if (p.z() < top - upper_mm)
          continue;
        ++upper_count;
        centers.upper += p;
      }
  centers.all /= count;
  centers.upper /= upper_count;
  return centers;
}

std::vector<RigidMotion> starts(const WholeBone& preoperative, const WholeBone& postoperative,
                                const Vec3& center)
{
  const BoneCenters from = centers_of(preoperative), to = centers_of(postoperative);
  std::vector<RigidMotion> all;
  for (const double x : {0.0, -14.0, 14.0})
    for (const double y : {0.0, -14.0, 14.0})
      for (const double z : {0.0, -14.0, 14.0})
      {
        RigidMotion motion;
        motion.reference_point = center;
        motion.rotation = rotation_from({x * degree, y * degree, z * degree});
        all.push_back(motion);
        for (const auto& [a, b] : {std::pair(from.upper, to.upper), std::pair(from.all, to.all)})
        {
          // turned about that centre, which comes to lie on its counterpart
          motion.translation = motion.rotation * (center - a) + b - center;
          all.push_back(motion);
        }
      }
  return all;
}

/// From anywhere to within a millimetre, by surfaces.
SurfaceFit fitted_surface(const WholeBone& preoperative, const BinaryMask& unaltered,
                          const WholeBone& postoperative)
{
  auto counts = [&](const Vec3& p) { return holds(unaltered, p); };
  const auto few = surface_points(preoperative.bone, counts, 500);
  const auto many = surface_points(preoperative.bone, counts, 4000);
  Vec3 center = Vec3::Zero();
  for (const SurfaceSample& p : many)
    center += p.point / static_cast<double>(many.size());
  SurfaceFitOptions coarse;
  coarse.first_scale_mm = 16;
  coarse.last_scale_mm = 2;
  const auto fits = fit_surface_from(starts(preoperative, postoperative, center), few,
                                     postoperative.bone, coarse);
  std::vector<RigidMotion> best;
  for (std::size_t f = 0; f < std::min<std::size_t>(3, fits.size()); ++f)
    best.push_back(fits[f].motion);
  SurfaceFitOptions fine;
  fine.first_scale_mm = 4;
  fine.last_scale_mm = near_bone_mm / 3;
  return fit_surface_from(best, many, postoperative.bone, fine).front();
}

/// Share of points that fall into the post-operative CT's box.
double overlap_of(const std::vector<Vec3>& points, const RigidMotion& motion, const CtImage& ct)
{
  const Box box = extent_ras(ct);
  double inside = 0;
  for (const Vec3& point : points)
  {
    const Vec3 p = motion.apply(point);
    inside += (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all();
  }
  return inside / static_cast<double>(points.size());
}

void judge_bone(const std::vector<SurfaceSample>& surface, const ScalarGrid& postoperative,
                CtRegistration& found)
{
  const Vec3 last = lattice_of(postoperative).last();
  std::vector<double> off;
  for (const SurfaceSample& point : surface)
  {
    const Vec3 p = found.to_postoperative.apply(point.point);
    const bool seen =
        (p.array() >= postoperative.origin.array()).all() && (p.array() <= last.array()).all();
    off.push_back(seen ? std::abs(postoperative.value(p)) : 1e3);
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  found.bone_median_mm = *middle;
  found.bone_within_1_5_mm =
      static_cast<double>(
          std::count_if(off.begin(), off.end(), [](double d) { return d < near_bone_mm; })) /
      static_cast<double>(off.size());
}

void require_overlap(double overlap)
{
  constexpr double least = 0.3;
  if (overlap < least)
    throw Error(what_it_is,
                "only " + percent(overlap) +
                    " of the unaltered bone's surroundings lie in the post-operative CT",
                "give a box or mask of bone that both CTs show, or a CT that shows more of the "
                "head");
}

void require_same_head(const CtRegistration& found)
{
  constexpr double least = 0.6;
  if (found.bone_within_1_5_mm < least)
    throw Error("the post-operative CT",
                "after the best alignment only " + percent(found.bone_within_1_5_mm) +
                    " of the unaltered bone lie within 1.5 mm of its bone (half of it within " +
                    number(found.bone_median_mm, 1) + " mm)",
                "check that it shows the same patient, and that the region for the registration "
                "was not operated on");
}

void require_certain(const CtRegistration& found)
{
  constexpr double most_spread_mm = 1, most_from_surface_mm = 5;
  if (found.from_surface_fit_mm > most_from_surface_mm)
    throw Error(what_it_is,
                "mutual information leads " + number(found.from_surface_fit_mm, 1) +
                    " mm away from where the bones meet",
                "give a box or mask with more bone that the operation left alone",
                ErrorKind::Numerical);
  if (found.spread_mm > most_spread_mm)
    throw Error(
        what_it_is,
        "it does not converge: starts 1.5 mm apart end " + number(found.spread_mm, 1) + " mm apart",
        "give a box or mask with more bone that the operation left alone", ErrorKind::Numerical);
}

} // namespace

CtRegistration register_ct(const CtImage& preoperative_ct, const WholeBone& preoperative,
                           const BinaryMask& unaltered, const CtImage& postoperative_ct,
                           const WholeBone& postoperative, const RegisterCtOptions& options,
                           const Progress& progress)
{
  progress("aligning the bones of the two CTs", 0);
  const SurfaceFit start = fitted_surface(preoperative, unaltered, postoperative);
  const auto surface = surface_points(
      preoperative.bone, [&](const Vec3& p) { return holds(unaltered, p); }, 4000);
  CtRegistration found;
  found.to_postoperative = start.motion;
  const std::vector<Vec3> points = scattered_points(unaltered, options.samples);
  found.samples = points.size();
  found.overlap = overlap_of(points, start.motion, postoperative_ct);
  require_overlap(found.overlap);
  judge_bone(surface, postoperative.bone, found);
  require_same_head(found);

  const MutualInformation information(preoperative_ct, postoperative_ct, points,
                                      {options.spacing_mm, 50});
  constexpr double fine_sigma = 0.7, fine_step = 0.005;
  MutualInformation::Maximum top;
  top.motion = start.motion;
  for (const double sigma : {3.0, 1.5, fine_sigma})
  {
    progress("seeking the greatest mutual information", 0.5 - 0.1 * sigma);
    top = information.climb(top.motion, sigma, sigma == fine_sigma ? fine_step : 0.02);
    found.iterations += top.iterations;
  }
  for (int s = 0; s < options.disturbed_starts; ++s)
  {
    progress("trying it from disturbed starts", 0.6 + 0.4 * s / options.disturbed_starts);
    const double sign = s % 2 == 0 ? 1 : -1;
    const Vec3 along = sign * Vec3(1, s % 3 == 1 ? -1 : 1, 1).normalized();
    auto again = information.climb(top.motion.followed_by(1.5 * degree * along, 1.5 * along),
                                   fine_sigma, fine_step);
    found.iterations += again.iterations;
    found.spread_mm =
        std::max(found.spread_mm, largest_difference(top.motion, again.motion, surface));
    found.spread_deg = std::max(found.spread_deg, angle_between(top.motion, again.motion) / degree);
    if (again.value > top.value)
      top = again;
  }
  found.to_postoperative = top.motion;
  found.mutual_information = top.value;
  found.from_surface_fit_mm = largest_difference(top.motion, start.motion, surface);
  found.from_surface_fit_deg = angle_between(top.motion, start.motion) / degree;
  judge_bone(surface, postoperative.bone, found);
  require_same_head(found);
  require_certain(found);
  progress("registered", 1);
  return found;
}

} // namespace f2b
