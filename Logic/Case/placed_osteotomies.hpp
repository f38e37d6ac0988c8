#pragma once

#include "Case/case_folder.hpp"
#include "Core/geometry/osteotomy.hpp"

#include <nlohmann/json.hpp>

/// Where did the verb `cut` place the saw?
namespace f2b
{

/// A curve as cut.json keeps it.
nlohmann::json to_json(const SweptCurve& curve);

/// In the order of the fragments. Throws Error where the case has not been cut.
std::vector<Osteotomy> placed_osteotomies(const CaseFolder& folder);

/// The file of one of a fragment's planes, counted from 0.
std::string cut_plane_file(const std::string& fragment, std::size_t plane);
/// The file of one of its curves, by the curve's name.
std::string cut_curve_file(const std::string& fragment, const std::string& curve);
/// The name of a curve that is drawn in a file: a file of cut_curve_file means the curve that it was
/// made for.
std::string curve_name_of(const std::string& fragment, const Path& file);

} // namespace f2b
