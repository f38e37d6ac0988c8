#pragma once

#include <string>
#include <vector>

/// What can a picture show?
namespace f2b
{

enum class Subject
{
  FaceBefore,
  FaceTarget,
  FacePredicted,
  FaceOverSkullBefore, ///< the face before, translucent, over the bones at rest
  FaceOverSkull,       ///< the predicted face, translucent, over the planned bones
  SkullBefore,
  SkullPlanned,
  FragmentsBefore, ///< each in its colour, with the cuts
  FragmentsAfter,  ///< with ghosts, arrows and numbers of their movement
  Intervals,       ///< 90 % intervals of the movement at the planned fragments
  DistanceMap,     ///< predicted against target, with lines of 1 and 2 mm
  Reachability,
  Regions,
  TargetDisplacement, ///< on the skin before (the paper's Fig. 8b)
  BoundaryParts,      ///< of the mesh (Fig. 6)
  ContactSurfaces,    ///< before and after the virtual forces (Fig. 9a)
  ContactDistance,    ///< how far the second is from the first, moved rigidly (Fig. 9b)
  Morph,              ///< the face between before and predicted
  CtAxial,            ///< CT slice with outlines of skin, bone and moved fragments
  CtCoronal,
  CtSagittal,
};

/// "face-before", "ct-axial": for the command line, view definitions and keys of texts.
std::string name_of(Subject subject);
const std::vector<Subject>& all_subjects();
/// Throws f2b::Error naming the subjects that there are.
Subject require_subject(const std::string& name);

bool is_ct_slice(Subject subject);

} // namespace f2b
