#pragma once

#include "Core/mesh/mixed_mesh.hpp"

#include <filesystem>

/// How is the mixed mesh kept? `.vtu`, LPS in the file as in Slicer.
///
/// Cells: prisms as VTK_WEDGE with the face first, then tetrahedra as VTK_TETRA. Cell array
/// `tissue` (0 skin, 1 fat, 2 muscle); point arrays `boundary` (values of Boundary) and `fragment`
/// (-1: none); field data `fragments`: their names.
namespace f2b
{

/// \param displacements  optional vectors per node to store with the mesh, by name [mm, RAS]
void write_mesh(const std::filesystem::path& path, const MixedMesh& mesh,
                const std::vector<std::pair<std::string, std::vector<Vec3>>>& displacements = {});
/// Reads what write_mesh wrote; throws Error on anything else.
MixedMesh read_mesh(const std::filesystem::path& path);
/// The vectors per node of that name, as write_mesh stored them; empty where there are none.
std::vector<Vec3> read_node_vectors(const std::filesystem::path& path, const std::string& name);

} // namespace f2b
