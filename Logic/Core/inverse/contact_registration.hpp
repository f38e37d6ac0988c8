#pragma once

#include "Core/geometry/rigid_motion.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <optional>

/// How has the tissue moved each fragment's contact surface Gamma_n (paper section 3.1, step 6)?
///
/// The inner surface of the tissue within the cut region at rest is registered rigidly to the
/// deformed one, by all its nodes or, as the paper puts it, by manual landmarks on it (Fig. 9a).
/// Positions in mm, RAS.
namespace f2b
{

/// A point near a fragment's contact surface at rest, by which its movement is to be measured.
struct ContactLandmark
{
  std::string name;
  Vec3 position = Vec3::Zero();
};

/// The rigid motion that best maps some points of the tissue at rest to where they are now.
struct Registration
{
  RigidMotion motion;
  double rms_mm = 0; ///< of what it leaves: the tissue's own deformation
  int points = 0;
};

/// One fragment's movement.
struct FragmentRegistration
{
  Registration surface;                  ///< by all contact nodes
  std::optional<Registration> landmarks; ///< by its landmarks alone, where it has any

  /// By the landmarks where there are any.
  const RigidMotion& motion() const { return landmarks ? landmarks->motion : surface.motion; }
};

/// The contact surfaces of all fragments at rest, with the landmarks' places on them.
///
/// A landmark stands for the point of a contact surface that is nearest to it, and belongs to that
/// surface's fragment. That point rides on the tissue: its deformed place is interpolated from the
/// contact nodes of its facet.
class ContactSurfaces
{
public:
  /// A landmark farther than this from every contact surface says nothing about one [mm].
  static constexpr double farthest_landmark_mm = 10;
  /// Points whose spread (RMS) across the line through them is less fix no rotation [mm].
  static constexpr double least_spread_mm = 0.5;

  /// \param reference_points  per fragment, that its movement is told about
  /// Throws Error where a fragment has under three contact nodes or one or two landmarks, where
  /// either lie on a line, and for a landmark that is nowhere near a contact surface. The mesh
  /// outlives it.
  ContactSurfaces(const MixedMesh& mesh, std::vector<Vec3> reference_points,
                  const std::vector<ContactLandmark>& landmarks);

  /// \param x  positions of the mesh nodes, and what may come after them
  std::vector<FragmentRegistration> register_to(const std::vector<Vec3>& x) const;

private:
  /// A point of a contact surface, as a combination of mesh nodes.
  struct Place
  {
    std::array<int, 3> node{};
    Vec3 weight = Vec3::Unit(0);

    Vec3 in(const std::vector<Vec3>& x) const;
  };
  struct Foot
  {
    Place place;
    int fragment = -1;
    double distance = 0; ///< of the landmark from it
  };

  Foot nearest(const Vec3& point, const std::vector<Triangle>& facets) const;
  void place_landmarks(const std::vector<ContactLandmark>& landmarks);
  void require_determined() const;
  Registration registration(const std::vector<Place>& places, std::size_t fragment,
                            const std::vector<Vec3>& x) const;

  const MixedMesh& m_mesh;
  std::vector<Vec3> m_reference_points;
  std::vector<std::vector<Place>> m_nodes;     ///< per fragment
  std::vector<std::vector<Place>> m_landmarks; ///< per fragment
};

/// What a rigid registration leaves at each contact node: where the tissue has taken it, less where
/// the fragment's motion would; zero at all other nodes (the distance map of Fig. 9c) [mm].
std::vector<Vec3> registration_misfit(const MixedMesh& mesh,
                                      const std::vector<RigidMotion>& motions,
                                      const std::vector<Vec3>& x);

} // namespace f2b
