#include "Logic/Core/slab_mesh.hpp"
#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/mesh_file.hpp>

#include <cmath>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

TEST(MeshFile, ComesBackExactly)
{
  const TemporaryFolder folder;
  MixedMesh mesh = testing::make_slab({});
  mesh.fragments = {"mid face", "chin"};
  write_mesh(folder / "m.vtu", mesh, {{"displacement", mesh.X}});
  const MixedMesh read = read_mesh(folder / "m.vtu");
  EXPECT_EQ(read.X, mesh.X);
  EXPECT_EQ(read.prisms, mesh.prisms);
  EXPECT_EQ(read.tets, mesh.tets);
  EXPECT_EQ(read.tet_tissue, mesh.tet_tissue);
  EXPECT_EQ(read.node_boundary, mesh.node_boundary);
  EXPECT_EQ(read.node_fragment, mesh.node_fragment);
  EXPECT_EQ(read.fragments, mesh.fragments);
}

TEST(MeshFile, DamagedAndForeignFilesAreRefused)
{
  const TemporaryFolder folder;
  write_mesh(folder / "m.vtu", testing::make_slab({}));
  const std::string whole = test::read_text(folder / "m.vtu");
  for (const std::string& text :
       {std::string(), std::string("junk"), whole.substr(0, whole.size() / 2),
        std::string("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid/></VTKFile>")})
  {
    folder.write("m.vtu", text);
    expect_error([&] { read_mesh(folder / "m.vtu"); }, {"m.vtu", "facetobone mesh"});
  }
  expect_error([&] { read_mesh(folder / "absent.vtu"); }, {"absent.vtu"});
  expect_error([&] { write_mesh("/proc/x.vtu", testing::make_slab({})); },
               {"/proc/x.vtu", "written"});
}

TEST(MeshFile, NumbersThatFitNoMeshAreRefused)
{
  const TemporaryFolder folder;
  using Damage = void (*)(MixedMesh&);
  const std::pair<const char*, Damage> damages[] = {
      {"a corner that is no node", [](MixedMesh& m) { m.tets[0][3] = m.node_count(); }},
      {"a fragment that is none", [](MixedMesh& m) { m.node_fragment[0] = 7; }},
      {"a part of the boundary that is none",
       [](MixedMesh& m) { m.node_boundary[0] = static_cast<Boundary>(9); }},
      {"a tissue that is none", [](MixedMesh& m) { m.tet_tissue[0] = static_cast<Tissue>(3); }},
      {"a node nowhere", [](MixedMesh& m) { m.X[0].x() = std::nan(""); }}};
  for (const auto& [what, damage] : damages)
  {
    SCOPED_TRACE(what);
    MixedMesh mesh = testing::make_slab({});
    damage(mesh);
    write_mesh(folder / "m.vtu", mesh);
    expect_error([&] { read_mesh(folder / "m.vtu"); }, {"m.vtu", "facetobone mesh"});
  }
}

} // namespace
} // namespace f2b
