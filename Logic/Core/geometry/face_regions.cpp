#include "Core/geometry/face_regions.hpp"

#include "Core/geometry/patient_axes.hpp"

#include <algorithm>
#include <cmath>

namespace f2b
{
namespace
{

struct RegionNames
{
  const char* key;
  const char* name;
};
constexpr std::array<RegionNames, face_region_count> region_names{{{"other", "rest of the head"},
                                                                   {"forehead", "forehead"},
                                                                   {"orbit_right", "right orbit"},
                                                                   {"orbit_left", "left orbit"},
                                                                   {"nose", "nose"},
                                                                   {"cheek_right", "right cheek"},
                                                                   {"cheek_left", "left cheek"},
                                                                   {"upper_lip", "upper lip"},
                                                                   {"lower_lip", "lower lip"},
                                                                   {"chin", "chin"},
                                                                   {"jaw_right", "right jaw"},
                                                                   {"jaw_left", "left jaw"},
                                                                   {"neck", "neck"}}};

const char* const needed_landmarks[] = {"N", "Or_R", "Or_L", "Zy_R", "Zy_L", "ANS",  "PNS",
                                        "A", "U1",   "B",    "Pg",   "Me",   "Go_R", "Go_L"};

/// Widths below are those of an adult whose orbitalia are this far apart; others scale with them.
constexpr double adult_orbitalia_mm = 66;

/// The straight line through two points, level beyond its ends.
double between(double at, double from, double value_from, double to, double value_to)
{
  const double share = to == from ? 0 : std::clamp((at - from) / (to - from), 0.0, 1.0);
  return value_from + share * (value_to - value_from);
}

/// The borders of the regions: x to the patient's right, y forward, z up, from N.
class Borders
{
public:
  explicit Borders(const Landmarks& landmarks);
  FaceRegion region_at(const Vec3& point_ras) const;

private:
  Vec3 local(const Vec3& p) const
  {
    const Vec3 d = p - m_nasion;
    return {d.dot(m_axes.right), d.dot(m_axes.forward), d.dot(m_axes.up)};
  }
  Vec3 at(const char* name) const { return local(landmark_at(m_landmarks, name)); }
  Vec3 middle(const std::string& pair) const
  {
    return local(0.5 *
                 (landmark_at(m_landmarks, pair + "_R") + landmark_at(m_landmarks, pair + "_L")));
  }
  double half_width(const std::string& pair) const
  {
    return 0.5 * (landmark_at(m_landmarks, pair + "_R") - landmark_at(m_landmarks, pair + "_L"))
                     .dot(m_axes.right);
  }
  bool has(const std::string& name) const { return m_landmarks.count(name) > 0; }
  void place_mouth();
  double midline(double z) const;
  double lower_border(double y) const;
  bool on_nose(double across, const Vec3& q) const;
  FaceRegion of_the_middle(double across, double z) const;
  FaceRegion of_the_side(bool right, const Vec3& q) const;

  const Landmarks& m_landmarks;
  PatientAxes m_axes;
  Vec3 m_nasion;
  double m_scale; ///< of the adult's widths
  Vec3 m_orbitale, m_zygion, m_gonion, m_subspinale, m_fold, m_pogonion, m_menton, m_subnasale;
  double m_brow, m_stomion, m_mouth, m_orbit, m_below_chin;
};

Borders::Borders(const Landmarks& landmarks)
    : m_landmarks(landmarks), m_axes(patient_axes(landmarks)),
      m_nasion(landmark_at(landmarks, "N")), m_scale(2 * half_width("Or") / adult_orbitalia_mm),
      m_orbitale(middle("Or")), m_zygion(middle("Zy")), m_gonion(middle("Go")),
      m_subspinale(at("A")), m_fold(at("B")), m_pogonion(at("Pg")), m_menton(at("Me")),
      m_subnasale(has("sn") ? at("sn") : at("A"))
{
  m_brow = -0.3 * m_orbitale.z(); // the orbit is 1.3 times as high as N lies over Or
  m_orbit = 0.5 * (half_width("Or") + half_width("Zy")); // its lateral rim
  m_below_chin = has("Me'") ? at("Me'").z() - 2 : m_menton.z() - 8;
  place_mouth();
}

/// The line between the lips: from the skin's landmarks, else just above the incisors' tips.
void Borders::place_mouth()
{
  m_stomion = has("ls") && has("li") ? 0.5 * (at("ls").z() + at("li").z()) : at("U1").z() + 2;
  m_mouth = has("ch_R") && has("ch_L") ? half_width("ch") : 25 * m_scale;
}

/// Follows a chin that deviates.
double Borders::midline(double z) const
{
  return z > m_subspinale.z()
             ? between(z, m_subspinale.z(), m_subspinale.x(), 0, 0)
             : between(z, m_pogonion.z(), m_pogonion.x(), m_subspinale.z(), m_subspinale.x());
}

/// Where the face ends below: the mandible's lower border, with the soft tissue that hangs on it.
double Borders::lower_border(double y) const
{
  return between(y, m_gonion.y(), m_gonion.z() - 4, m_menton.y(), m_below_chin);
}

bool Borders::on_nose(double across, const Vec3& q) const
{
  if (q.z() > 0)
    return false;
  // wide alae stand out from the cheek, which lies well behind the nose's base there
  const bool stands_out =
      q.z() < m_subnasale.z() + 18 * m_scale && q.y() > m_subnasale.y() - 7 * m_scale;
  const double ala = (stands_out ? 25 : 18) * m_scale, root = 9 * m_scale;
  if (across > between(q.z(), m_subnasale.z() + 6, ala, 0, root))
    return false;
  const bool hanging_tip = q.y() > m_subnasale.y() + 4 && q.z() > m_subnasale.z() - 8;
  return q.z() > m_subnasale.z() || hanging_tip;
}

/// Lips and chin, if the point lies in the middle third; else Other.
FaceRegion Borders::of_the_middle(double across, double z) const
{
  const double corner = m_mouth + 4, ala = 18 * m_scale, chin = 24 * m_scale;
  if (z > m_subnasale.z())
    return FaceRegion::Other;
  if (z > m_stomion)
    return across < between(z, m_stomion, corner, m_subnasale.z(), ala) ? FaceRegion::UpperLip
                                                                        : FaceRegion::Other;
  if (z > m_fold.z())
    return across < between(z, m_fold.z(), chin, m_stomion, corner) ? FaceRegion::LowerLip
                                                                    : FaceRegion::Other;
  return across < chin ? FaceRegion::Chin : FaceRegion::Other;
}

/// Cheek and jaw part along the line from the mouth to below the zygomatic arch: behind the cheek
/// the jaw's ramus reaches higher.
FaceRegion Borders::of_the_side(bool right, const Vec3& q) const
{
  const double arch =
      between(q.y(), m_zygion.y(), m_zygion.z() + 8, m_orbitale.y(), m_orbitale.z());
  if (q.z() > arch)
    return FaceRegion::Other; // the temple
  const double jaw = between(q.y(), m_zygion.y(), m_zygion.z() - 12, m_fold.y(), m_stomion);
  if (q.z() > jaw)
    return right ? FaceRegion::CheekRight : FaceRegion::CheekLeft;
  return right ? FaceRegion::JawRight : FaceRegion::JawLeft;
}

FaceRegion Borders::region_at(const Vec3& point_ras) const
{
  const Vec3 q = local(point_ras);
  if (q.z() < lower_border(q.y()))
    return FaceRegion::Neck;
  if (q.y() < m_zygion.y() - 20) // ears, scalp and nape
    return FaceRegion::Other;
  const double x = q.x() - midline(q.z()), across = std::abs(x);
  const bool glabella = q.z() > 0 && across < 10 * m_scale;
  if (q.z() > m_brow || glabella)
    return q.z() < m_brow + 50 * m_scale && across < m_orbit + 6 ? FaceRegion::Forehead
                                                                 : FaceRegion::Other;
  if (on_nose(across, q))
    return FaceRegion::Nose;
  if (q.z() > m_orbitale.z() && across < m_orbit)
    return x > 0 ? FaceRegion::OrbitRight : FaceRegion::OrbitLeft;
  const FaceRegion middle = of_the_middle(across, q.z());
  return middle != FaceRegion::Other ? middle : of_the_side(x > 0, q);
}

} // namespace

std::array<FaceRegion, face_region_count> all_face_regions()
{
  std::array<FaceRegion, face_region_count> all{};
  for (std::size_t r = 0; r < all.size(); ++r)
    all[r] = static_cast<FaceRegion>(r);
  return all;
}

std::string key_of(FaceRegion region)
{
  return region_names[static_cast<std::size_t>(region)].key;
}

std::string name_of(FaceRegion region)
{
  return region_names[static_cast<std::size_t>(region)].name;
}

std::optional<FaceRegion> face_region_of(double value)
{
  if (!(value >= 0 && value < static_cast<double>(face_region_count)) || value != std::floor(value))
    return std::nullopt;
  return static_cast<FaceRegion>(static_cast<int>(value));
}

std::vector<std::string> missing_for_face_regions(const Landmarks& landmarks)
{
  std::vector<std::string> missing;
  for (const char* name : needed_landmarks)
    if (landmarks.count(name) == 0)
      missing.push_back(name);
  return missing;
}

std::vector<FaceRegion> face_regions(const std::vector<Vec3>& skin, const Landmarks& landmarks)
{
  std::vector<FaceRegion> regions(skin.size(), FaceRegion::Other);
  if (!missing_for_face_regions(landmarks).empty())
    return regions;
  const Borders borders(landmarks);
  for (std::size_t v = 0; v < skin.size(); ++v)
    regions[v] = borders.region_at(skin[v]);
  return regions;
}

} // namespace f2b
