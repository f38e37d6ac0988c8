#include "Case/patient_frame_json.hpp"

#include "Case/case_session.hpp"
#include "Case/fragment_json.hpp"
#include "Core/geometry/patient_frame.hpp"

namespace f2b
{

using nlohmann::json;

void add_patient_frame(json& plan, const Landmarks& landmarks)
{
  const std::optional<PatientFrame> frame = patient_frame(landmarks);
  if (!frame)
  {
    plan["patient_frame"] = {{"missing_landmarks", missing_for_patient_frame(landmarks)},
                             {"note", "movements are told in the scanner's axes alone"}};
    return;
  }
  plan["patient_frame"] = {{"origin_ras", to_json(frame->origin)},
                           {"right_ras", to_json(frame->right)},
                           {"anterior_ras", to_json(frame->anterior)},
                           {"superior_ras", to_json(frame->superior)},
                           {"horizontal", "Frankfort: middles of the pairs Po and Or"},
                           {"sagittal", "through N, across the pairs Or and Zy"}};
  const Mat3 to_patient = frame->from_scanner();
  for (json& method : plan.at("methods"))
    for (json& fragment : method.at("fragments"))
    {
      const RigidMotion motion = motion_from(fragment);
      const json told =
          motion_json("", {to_patient * motion.rotation * to_patient.transpose(),
                           to_patient * motion.translation, frame->point(motion.reference_point)});
      fragment["in_patient_frame"] = {{"translation_mm", told.at("translation_mm")},
                                      {"rotation_deg", told.at("rotation_deg")}};
    }
}

} // namespace f2b
