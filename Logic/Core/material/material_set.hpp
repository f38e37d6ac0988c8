#pragma once

#include "Core/material/law.hpp"
#include "Core/mesh/mixed_mesh.hpp"

#include <array>
#include <string>

namespace f2b
{

/// `skin`, `fat` or `muscle`.
inline const char* name_of(Tissue tissue)
{
  return tissue == Tissue::Skin ? "skin" : tissue == Tissue::Fat ? "fat" : "muscle";
}

/// The law of each tissue, indexed by Tissue.
struct MaterialSet
{
  std::string name;
  std::array<Law, tissue_count> laws;

  const Law& of(Tissue tissue) const { return laws[static_cast<std::size_t>(tissue)]; }
};

} // namespace f2b
