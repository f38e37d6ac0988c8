#pragma once

#include <array>

/// Which fixed sentences and which style does every report carry? All in one place.
namespace f2b::report_texts
{

constexpr const char* not_a_device = "Research software, not a medical device.";

constexpr const char* not_a_device_detail =
    "Nothing in this report may be used to diagnose or to treat a patient.";

constexpr std::array<const char*, 6> limitations{
    "Clinically an accuracy of 0.5 mm is asked for. The paper that this method follows states "
    "errors of 0 to 3 mm.",
    "Lips and nose outside the cuts are the least certain part of a predicted face.",
    "Brain, airway, blood vessels and nerves are not modelled; neither are swelling, growth, "
    "relapse and muscle activity.",
    "Contact nodes next to a cut are released; what happens in that margin is approximate.",
    "Tissue stiffness is taken from the literature, not measured on this patient.",
    "The figures that we publish for this program rest on synthetic truth: simulated operations, "
    "not operated patients."};

constexpr const char* convention =
    "Movement of a fragment: x' = R (x - c) + c + t about its reference point c, with "
    "R = Rz(yaw) Ry(roll) Rx(pitch), right-handed about +R (right), +A (anterior), +S (superior). "
    "Coronal rotation (roll) is seen from in front of the patient, sagittal rotation (pitch) from "
    "the patient's right, axial rotation (yaw) from above; a positive angle is counter-clockwise "
    "as seen so.";

constexpr const char* error_definition =
    "Absolute distances at corresponding vertices of the reference skin, area-weighted, between "
    "the face re-predicted with the found bone movement and the target. Signed mean: negative "
    "where the prediction lies behind the target. Load residual: what the virtual forces "
    "themselves leave.";

constexpr const char* reach_note =
    "rigid-fit. Asked for and left: 90th percentile, by area and the target's weight, of the "
    "length "
    "of the target displacement and of its part that the best movement of these fragments does not "
    "give. Skin error: over all skin of the region that was computed.";

/// Dark on light, one column, system fonts only; tables and pictures do not break across pages.
extern const char* const style;

} // namespace f2b::report_texts
