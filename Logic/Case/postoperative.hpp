#pragma once

#include "Case/case_session.hpp"
#include "Core/geometry/fragment_movement.hpp"
#include "Core/inverse/skin_error.hpp"
#include "Imaging/postoperative_ct.hpp"
#include "Imaging/register_ct.hpp"

/// What did the operation really do, by a post-operative CT?
namespace f2b
{

/// Where the two CTs are registered; at most one is given. Default: the cranium.
struct PostoperativeOptions
{
  std::optional<Box> box_ras; ///< [mm] in the frame of the pre-operative CT
  Path mask;                  ///< .nrrd labels in that frame; other than 0 counts
  RegisterCtOptions registration;
};

struct PostoperativeFindings
{
  CtRegistration registration;
  std::vector<FragmentMovement> movements; ///< one per fragment, in the order of the cuts
  ScalarGrid skin; ///< signed distance to the post-operative face, in the case's frame [mm]
  /// - `registration`: `matrix_ras` (pre-operative to post-operative points), mutual information,
  ///   overlap and what tells how sure it is;
  /// - `fragments`: as in plan.json, with `surface_rms_mm`, `surface_share`, `doubtful`, and where
  ///   there is a plan `from_plan_mm` (mean over the fragment's surface) and `from_plan_deg`;
  /// - `skin_distance_mm`: per face of the case (`rest`, `target`, `predicted`, `predicted_METHOD`)
  ///   its distance to the nearest point of the post-operative face, as in plan.json's
  ///   `skin_error_mm`, negative where it lies behind;
  /// - `warnings`: sentences.
  nlohmann::json document;
};

/// Registers a post-operative CT to the case's CT, and measures how the fragments moved and how far
/// the case's faces are from the real one.
///
/// Needs a case that is cut; faces that it does not hold are left out.
/// \param ct  any file or folder that read_ct reads
/// Throws Error if the CT cannot be read, shows another head or no overlap, or if the registration
/// or a fit does not converge (Numerical). Nothing is written.
PostoperativeFindings postoperative_findings(const CaseSession& session, const Path& ct,
                                             const PostoperativeOptions& options = {});

/// Distance of a face to the post-operative one at corresponding area weights: closest points, not
/// corresponding ones, so that it is a lower bound of the error.
/// \param points  [mm, RAS]
/// \param area    0 leaves a vertex out [mm^2]
SkinError distance_to_postoperative(const PostoperativeFindings& findings,
                                    const std::vector<Vec3>& points,
                                    const std::vector<double>& area);

/// The CT that would be made of the case's patient after known movements, for tests.
///
/// Bone is parted where the cuts are, but the saw's kerf is not taken away.
/// \param mesh     soft tissue at rest; any mesh of this face
/// \param x        its nodes after the operation [mm]
CtImage::Pointer synthetic_postoperative_ct(const CaseSession& session,
                                            const std::vector<RigidMotion>& motions,
                                            const MixedMesh& mesh, const std::vector<Vec3>& x,
                                            const PostoperativeCtOptions& options = {});

} // namespace f2b
