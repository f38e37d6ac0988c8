#pragma once

#include "Core/material/yeoh.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <array>
#include <string>

namespace f2b
{

/// The law of each tissue, indexed by Tissue.
struct MaterialSet
{
  std::string name;
  std::array<Yeoh, tissue_count> laws;

  const Yeoh& of(Tissue tissue) const { return laws[static_cast<std::size_t>(tissue)]; }
};

} // namespace f2b
