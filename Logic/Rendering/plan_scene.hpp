#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What does a plan show? The surfaces of one case, checked and made ready for drawing.
///
/// All surfaces in mm, RAS, triangles with outward normals by their corner order.
namespace f2b
{

using Surface = vtkSmartPointer<vtkPolyData>;

/// Point array on `PlanPictures::predicted`: predicted minus target [mm], NaN where not known.
constexpr const char* signed_distance_array = "signed_distance_mm";
/// Optional point array on `PlanPictures::skin`: length or vector of the wished displacement [mm].
constexpr const char* target_displacement_array = "target_displacement_mm";
/// Optional point array on `PlanPictures::predicted`: length of what these cuts leave of the target
/// [mm], NaN where nothing was asked for or computed.
constexpr const char* unreachable_array = "unreachable_mm";
/// Optional point array on `PlanPictures::skin`: FaceRegion.
constexpr const char* region_array = "region";

/// Point array on `ContactPicture::dragged`: length of the registration's misfit [mm].
constexpr const char* misfit_array = "misfit_mm";
/// Cell array on `PlanPictures::boundary`: Core's Boundary.
constexpr const char* boundary_array = "boundary";

/// Half widths of 90 % intervals; not finite where the coordinate was not free.
struct MovementIntervals
{
  std::array<double, 3> translation_mm{}; ///< right, anterior, superior
  std::array<double, 3> rotation_deg{};   ///< pitch, roll, yaw
};

/// The tissue's contact surface on one fragment.
struct ContactPicture
{
  Surface rest;
  Surface dragged; ///< where the virtual forces pull it; with misfit_array
};

struct FragmentPicture
{
  std::string name;
  Surface rest;
  Surface planned; ///< the same bone where the plan puts it; null before there is a plan
  std::array<double, 16> matrix_ras{};         ///< row-major, rest to planned
  std::array<double, 3> reference_point_ras{}; ///< at rest
  std::string movement;                        ///< "11.0 mm forward, 5.0 mm down"
  std::optional<MovementIntervals> intervals;
};

/// The surfaces of a plan as the case holds them.
struct PlanPictures
{
  Surface skin;      ///< rest; required
  Surface target;    ///< same topology as skin; may be null
  Surface predicted; ///< same topology as skin; may be null
  std::vector<FragmentPicture> fragments;
  Surface uncut_bone;                   ///< bone that does not move; required
  Surface cut_planes;                   ///< quads; may be null
  Surface boundary;                     ///< facets of the mesh, with boundary_array; may be null
  std::vector<ContactPicture> contacts; ///< in the fragments' order; may be empty
  vtkSmartPointer<vtkImageData> ct;     ///< Hounsfield units, RAS; may be null
};

/// A copy that is shaded smoothly: with a normal per vertex, vertices and arrays as they are. Null for
/// null.
Surface with_normals(const Surface& surface);

/// The same with normals, checked: safe to draw.
class PlanScene
{
public:
  /// Copies what it changes; the given surfaces stay as they are.
  /// \throws f2b::Error when a surface is missing or empty, a coordinate is not finite, or two
  ///         states of the skin differ in topology
  explicit PlanScene(const PlanPictures& pictures);

  const PlanPictures& pictures() const { return m_pictures; }
  bool has_target() const { return m_pictures.target != nullptr; }
  bool has_predicted() const { return m_pictures.predicted != nullptr; }
  bool has_distance() const;
  bool has_unreachable() const;
  bool has_regions() const; ///< and not all of the skin is FaceRegion::Other

  bool has_target_displacement() const;
  bool has_intervals() const;
  bool has_plan() const; ///< every fragment has its planned place

  /// Every state of the face that there is.
  std::vector<Surface> faces() const;
  /// Uncut bone, fragments at rest and as planned, cut planes.
  std::vector<Surface> bones() const;

private:
  PlanPictures m_pictures;
};

} // namespace f2b
