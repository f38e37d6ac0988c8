#pragma once

#include "Case/case_session.hpp"
#include "Rendering/report_document.hpp"
#include "Rendering/texts.hpp"

/// From what was a plan made, as sections of a report?
namespace f2b
{

/// \param identity  also tells what may name the patient: the scan's path and the case's notes
ReportSection case_section(const CaseSession& session, bool identity, const Texts& texts);
/// The scanner's frame, the patient's own, and where the landmarks lie.
ReportSection frame_section(const CaseFolder& folder, const nlohmann::json& plan,
                            const Texts& texts);
/// The planes of the cuts.
ReportSection osteotomy_section(const CaseFolder& folder, const Texts& texts);
/// Mesh, laws of the tissues, and how the equilibria were reached.
ReportSection model_section(const CaseSession& session, const nlohmann::json& plan,
                            const Texts& texts);
ReportSection timing_section(const nlohmann::json& plan, const Texts& texts);
/// Programs, libraries, and the SHA-256 of the inputs and of the files that the plan rests on.
ReportSection provenance_section(const CaseSession& session, const nlohmann::json& plan,
                                 const Texts& texts);

} // namespace f2b
