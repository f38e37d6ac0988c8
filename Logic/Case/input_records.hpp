#pragma once

#include "Case/case_session.hpp"

/// Which files went into a case, byte for byte?
///
/// A step keeps the SHA-256 of what it read, so that a report tells of those bytes even where a file
/// was changed afterwards. No file is named: a name may hold the patient's.
namespace f2b
{

/// One object each: `input` (scan, landmarks, cut, ...), `files` and `sha256`. A folder's is the
/// SHA-256 of its files' digests, one a line, sorted:
/// `find FOLDER -maxdepth 1 -type f -exec sha256sum {} + | cut -c1-64 | sort | sha256sum`
///
/// Throws Error if a file cannot be read.
nlohmann::json segment_inputs(const CaseSettings& settings);
nlohmann::json cut_inputs(const CaseSettings& settings);
nlohmann::json target_inputs(const CaseSettings& settings);
/// What the plan and the steps before it have read.
nlohmann::json plan_inputs(const CaseSession& session);

} // namespace f2b
