#include "Core/geometry/virtual_patient.hpp"

#include "Core/error.hpp"
#include "Core/geometry/virtual_face.hpp"
#include "Core/geometry/virtual_landmarks.hpp"
#include "Core/geometry/virtual_skull.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace f2b
{
namespace
{

constexpr double brain_case_thickness = 6; ///< mm, as in virtual_skull.cpp
constexpr double sinus_lining = 0.8;       ///< mm

void require_within(const char* name, double value, double least, double most)
{
  if (value >= least && value <= most)
    return;
  std::ostringstream problem, remedy;
  problem << "is " << value << " mm";
  remedy << "choose a value from " << least << " to " << most << " mm";
  throw Error(name, problem.str(), remedy.str());
}

} // namespace

struct VirtualPatient::Anatomy
{
  explicit Anatomy(const MidfaceShift& midface) : skull(midface), face(midface) {}

  VirtualSkull skull;
  VirtualFace face;
};

VirtualPatient::VirtualPatient(const VirtualPatientOptions& options) : m_options(options)
{
  require_within("midface_retrusion_mm", options.midface_retrusion_mm, 0, 10);
  require_within("chin_deviation_mm", options.chin_deviation_mm, -5, 5);
  require_within("least_soft_tissue_mm", options.least_soft_tissue_mm, 1, 8);
  m_anatomy = std::make_unique<Anatomy>(MidfaceShift(options.midface_retrusion_mm));
}

VirtualPatient::~VirtualPatient() = default;
VirtualPatient::VirtualPatient(VirtualPatient&&) noexcept = default;
VirtualPatient& VirtualPatient::operator=(VirtualPatient&&) noexcept = default;

Vec3 VirtualPatient::deviated(const Vec3& point) const
{
  // A shear that grows with the depth below the orbits: invertible, and volume is kept.
  const double t = std::clamp((point.z() + 20) / -90, 0.0, 1.0);
  return point + Vec3(m_options.chin_deviation_mm * t * t * (3 - 2 * t), 0, 0);
}

Vec3 VirtualPatient::straightened(const Vec3& point_ras) const
{
  return 2 * point_ras - deviated(point_ras);
}

TissueDistances VirtualPatient::distances(const Vec3& point_ras) const
{
  const Vec3 p = straightened(point_ras);
  const Anatomy& a = *m_anatomy;
  const VirtualSkull::Distances skull = a.skull.distances(p);
  TissueDistances d;
  d.bone = skull.bone;
  d.teeth = skull.teeth;
  d.brain = skull.vault + brain_case_thickness;
  // Where the bones come too close they carry the skin outwards.
  const double blend = 3;
  d.skin = smooth_union(a.face.skin(p), d.bone - m_options.least_soft_tissue_mm, blend);
  d.muscle = a.face.muscle(p, d.skin);
  d.air = std::max(std::min(a.face.airway(p), skull.sinuses + sinus_lining), -d.bone);
  return d;
}

double VirtualPatient::skin(const Vec3& point_ras) const
{
  return distances(point_ras).skin;
}

double VirtualPatient::bone(const Vec3& point_ras) const
{
  return m_anatomy->skull.distances(straightened(point_ras)).bone;
}

double VirtualPatient::teeth(const Vec3& point_ras) const
{
  return m_anatomy->skull.distances(straightened(point_ras)).teeth;
}

double VirtualPatient::mandible(const Vec3& point_ras) const
{
  return m_anatomy->skull.mandible(straightened(point_ras));
}

double VirtualPatient::brain(const Vec3& point_ras) const
{
  return m_anatomy->skull.vault(straightened(point_ras)) + brain_case_thickness;
}

std::vector<NamedPoint> VirtualPatient::landmarks() const
{
  const LandmarkSurfaces surfaces{[this](const Vec3& p) { return bone(deviated(p)); },
                                  [this](const Vec3& p) { return mandible(deviated(p)); },
                                  [this](const Vec3& p) { return skin(deviated(p)); }};
  std::vector<NamedPoint> points =
      virtual_landmarks(surfaces, MidfaceShift(m_options.midface_retrusion_mm));
  for (NamedPoint& point : points)
    point.point_ras = deviated(point.point_ras);
  return points;
}

Vec3 VirtualPatient::landmark(const std::string& name) const
{
  for (const NamedPoint& point : landmarks())
    if (point.name == name)
      return point.point_ras;
  throw Error("landmark '" + name + "'", "the virtual patient has none of that name",
              "use one of the names that landmarks() lists");
}

} // namespace f2b
