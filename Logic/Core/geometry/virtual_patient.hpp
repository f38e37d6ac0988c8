#pragma once

#include "Core/geometry/vectors.hpp"

#include <memory>
#include <string>
#include <vector>

/// What does the project's own patient look like, and where are the landmarks?
///
/// A head from closed-form signed-distance shapes, so that every surface is known exactly.
/// World frame RAS [mm]: origin near the centre of the head, +R the patient's right, +A the nose,
/// +S the vertex; the Frankfort plane is S = -20. Distances are negative inside.
namespace f2b
{

struct VirtualPatientOptions
{
  /// How far maxilla, cheek bones, nose and upper lip lie behind their normal place [mm], 0 to 10.
  double midface_retrusion_mm = 6;
  /// Deviation of the chin to the patient's right [mm], -5 to 5; nothing moves above the orbits.
  double chin_deviation_mm = 0;
  /// Least thickness of the soft tissue over bone [mm].
  double least_soft_tissue_mm = 4.5;
};

struct NamedPoint
{
  std::string name;
  Vec3 point_ras;
};

/// Signed distances of one point [mm].
struct TissueDistances
{
  double skin; ///< outside of the head, mouth and nostrils closed; the neck runs on downwards
  double bone; ///< all bones and teeth
  double teeth;
  double muscle; ///< what is soft, inside and not muscle is fat
  double brain;  ///< everything inside the cranial vault
  double air;    ///< nasal cavity, sinuses, throat and windpipe; open at the nostrils
};

class VirtualPatient
{
public:
  /// Throws f2b::Error for options out of range.
  explicit VirtualPatient(const VirtualPatientOptions& options = {});
  ~VirtualPatient();
  VirtualPatient(VirtualPatient&&) noexcept;
  VirtualPatient& operator=(VirtualPatient&&) noexcept;

  /// All distances at once, which shares their common work.
  TissueDistances distances(const Vec3& point_ras) const;
  double skin(const Vec3& point_ras) const;
  double bone(const Vec3& point_ras) const;
  double teeth(const Vec3& point_ras) const;
  double mandible(const Vec3& point_ras) const; ///< with its teeth
  double muscle(const Vec3& point_ras) const { return distances(point_ras).muscle; }
  double brain(const Vec3& point_ras) const;
  double air(const Vec3& point_ras) const { return distances(point_ras).air; }

  /// Anatomical landmarks under their usual names; a prime marks soft tissue ("Pg'").
  std::vector<NamedPoint> landmarks() const;
  /// Throws f2b::Error for an unknown name.
  Vec3 landmark(const std::string& name) const;

  const VirtualPatientOptions& options() const { return m_options; }

private:
  struct Anatomy;
  Vec3 straightened(const Vec3& point_ras) const;
  Vec3 deviated(const Vec3& point) const;

  VirtualPatientOptions m_options;
  std::unique_ptr<const Anatomy> m_anatomy;
};

} // namespace f2b
