#pragma once

#include <Rendering/plan_scene.hpp>

/// A head of spheres: skin with a nose, bone inside it, the front of the bone moved.
///
/// The prediction is in front of the target on the patient's left (negative R) and behind it on the
/// patient's right, by `miss`.
/// \param radius_mm  of the skin; everything else scales with it
f2b::PlanPictures toy_plan(double radius_mm);
