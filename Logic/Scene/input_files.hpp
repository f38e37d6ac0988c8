#pragma once

#include "Scene/scene_settings.hpp"

#include <filesystem>

/// Which files does a case begin with, where a user chose nodes instead?
namespace f2b
{

/// Lets the plan name files for its input volume, landmarks and warp where it names nodes alone: a
/// node's own file if that holds what the node does, else one written beside the case folder, in
/// `FOLDER-input`. Throws Error where a node cannot be written.
void write_input_nodes(const CaseNodes& nodes, const std::filesystem::path& folder);
/// The warp's points alone.
void write_warp_nodes(const CaseNodes& nodes, const std::filesystem::path& folder);

/// Until it is given one, a target node states a file that it does not have.
void drop_empty_target(nlohmann::json& document);

} // namespace f2b
