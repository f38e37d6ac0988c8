#include <Rendering/subject_drawing.hpp>

#include <Core/error.hpp>

namespace f2b
{

std::string missing_for(Subject subject, const PlanScene& scene)
{
  const PlanPictures& pictures = scene.pictures();
  const auto unless = [](bool there, const char* what) { return there ? "" : what; };
  switch (subject)
  {
  case Subject::FaceTarget:
    return unless(scene.has_target(), "target face");
  case Subject::FacePredicted:
  case Subject::Morph:
    return unless(scene.has_predicted(), "predicted face");
  case Subject::FaceOverSkull:
  case Subject::SkullPlanned:
  case Subject::FragmentsAfter:
    return unless(scene.has_plan(), "plan");
  case Subject::Intervals:
    return unless(scene.has_plan() && scene.has_intervals(), "interval of a movement");
  case Subject::DistanceMap:
    return unless(scene.has_distance(), "distance between prediction and target");
  case Subject::Reachability:
    return unless(scene.has_unreachable(), "reachability");
  case Subject::Regions:
    return unless(scene.has_regions(), "region of the face");
  case Subject::TargetDisplacement:
    return unless(scene.has_target_displacement(), "target face");
  case Subject::BoundaryParts:
    return unless(pictures.boundary != nullptr, "mesh");
  case Subject::ContactSurfaces:
  case Subject::ContactDistance:
    return unless(!pictures.contacts.empty(), "contact surface of virtual-force");
  case Subject::CtAxial:
  case Subject::CtCoronal:
  case Subject::CtSagittal:
    return unless(pictures.ct != nullptr, "CT");
  default:
    return {};
  }
}

void require_shown(Subject subject, const PlanScene& scene)
{
  const std::string missing = missing_for(subject, scene);
  if (!missing.empty())
  {
    throw Error("'" + name_of(subject) + "'", "the case has no " + missing,
                "do the steps before, or show something else");
  }
}

SubjectDrawing subject_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                               const SubjectOptions& options)
{
  require_shown(subject, scene);
  switch (subject)
  {
  case Subject::FaceBefore:
  case Subject::FaceTarget:
  case Subject::FacePredicted:
  case Subject::FaceOverSkullBefore:
  case Subject::FaceOverSkull:
  case Subject::Morph:
    return face_drawing(subject, scene, texts, options);
  case Subject::SkullBefore:
  case Subject::SkullPlanned:
  case Subject::FragmentsBefore:
  case Subject::FragmentsAfter:
  case Subject::Intervals:
    return bone_drawing(subject, scene, texts);
  case Subject::DistanceMap:
  case Subject::Reachability:
  case Subject::Regions:
  case Subject::TargetDisplacement:
    return map_drawing(subject, scene, texts);
  case Subject::BoundaryParts:
  case Subject::ContactSurfaces:
  case Subject::ContactDistance:
    return mesh_drawing(subject, scene, texts);
  default:
    return slice_drawing(subject, scene, texts, options);
  }
}

} // namespace f2b
