#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <Bridge/vtk_surface.hpp>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace f2b
{
namespace
{

using test::expect_error;
using test::TemporaryFolder;

TriangleMesh tetrahedron()
{
  return {{{1, 2, 3}, {11, 2, 3}, {1, 14, 3}, {1, 2, 18.25}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

std::string ply(const std::string& comment, const std::string& first_vertex)
{
  return "ply\nformat ascii 1.0\n" + comment +
         "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         first_vertex + "\n10 0 0\n0 10 0\n3 0 1 2\n";
}

/// The bytes of a number, in the order of the two kinds of binary .ply.
template <class Value>
std::string bytes_of(Value value, bool big_endian)
{
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  const std::uint16_t one = 1;
  if ((*reinterpret_cast<const char*>(&one) == 0) != big_endian)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Two triangles as scanners write them: with colours and with more lists than the corners.
std::string scanned_ply(bool big_endian)
{
  std::string text = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\nobj_info of a scanner\nelement vertex 4\nproperty uchar red\n"
                     "property double x\nproperty float y\nproperty float z\n"
                     "element face 2\nproperty list uchar float texcoord\n"
                     "property list int ushort vertex_index\nend_header\n";
  for (const Vec3& p : tetrahedron().points)
    text += bytes_of(std::uint8_t(200), big_endian) + bytes_of(p.x(), big_endian) +
            bytes_of(static_cast<float>(p.y()), big_endian) +
            bytes_of(static_cast<float>(p.z()), big_endian);
  for (const auto& corners : {std::array{0, 2, 1}, std::array{0, 1, 3}})
  {
    text += bytes_of(std::uint8_t(2), big_endian) + bytes_of(0.5f, big_endian) +
            bytes_of(1.0f, big_endian) + bytes_of(std::int32_t(3), big_endian);
    for (const int corner : corners)
      text += bytes_of(static_cast<std::uint16_t>(corner), big_endian);
  }
  return text;
}

std::string stl(const std::string& header)
{
  return "solid " + header +
         "\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 10 0 0\nvertex 0 10 0\n"
         "endloop\nendfacet\nendsolid\n";
}

TEST(SurfaceFile, VtpComesBackExactlyWithItsArrays)
{
  const TemporaryFolder folder;
  const TriangleMesh mesh = tetrahedron();
  const auto surface = to_polydata(mesh);
  const std::vector<Vec3> moves = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 / 3, -2, 5}};
  add_point_array(surface, "displacement", moves);
  add_point_array(surface, "weight", std::vector<double>{0, 1, 0.5, 0.1});
  write_surface(folder / "s.vtp", surface);
  const auto read = read_surface(folder / "s.vtp");
  EXPECT_EQ(to_triangle_mesh(read).points, mesh.points);
  EXPECT_EQ(to_triangle_mesh(read).triangles, mesh.triangles);
  EXPECT_EQ(point_vectors(read, "displacement"), moves);
  EXPECT_EQ(point_scalars(read, "weight"), (std::vector<double>{0, 1, 0.5, 0.1}));
  EXPECT_EQ(points_of(surface), mesh.points) << "writing changes nothing in memory";
}

TEST(SurfaceFile, PlyForSculptingComesBackWithTheSameVerticesInOrder)
{
  const TemporaryFolder folder;
  const TriangleMesh mesh = tetrahedron();
  write_surface(folder / "s.ply", to_polydata(mesh));
  const TriangleMesh read = to_triangle_mesh(read_surface(folder / "s.ply"));
  ASSERT_EQ(read.points.size(), mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_LT((read.points[v] - mesh.points[v]).norm(), 1e-5);
  EXPECT_EQ(read.triangles, mesh.triangles);
}

TEST(SurfaceFile, VtpIsInLpsAndSaysSo)
{
  const TemporaryFolder folder;
  write_surface(folder / "s.vtp", to_polydata(tetrahedron()));
  std::string text = test::read_text(folder / "s.vtp");
  EXPECT_NE(text.find("SPACE"), std::string::npos);
  // the same file without the word is taken as LPS too
  for (std::size_t at = 0; (at = text.find("SPACE", at)) != std::string::npos;)
    text.replace(at, 5, "OTHER");
  EXPECT_EQ(points_of(read_surface(folder.write("t.vtp", text))), tetrahedron().points);
}

TEST(SurfaceFile, ColoursAreNoVectors)
{
  const TemporaryFolder folder;
  const auto surface = to_polydata(tetrahedron());
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
    colours->InsertNextTuple3(10, 20, 30);
  surface->GetPointData()->AddArray(colours);
  write_surface(folder / "s.vtp", surface);
  EXPECT_EQ(point_vectors(read_surface(folder / "s.vtp"), "RGB").at(2), Vec3(10, 20, 30));
}

TEST(SurfaceFile, PlyObjAndStlAreLpsUnlessTheySayRas)
{
  const TemporaryFolder folder;
  const std::string obj = "v 1 2 3\nv 10 0 0\nv 0 10 0\nf 1 2 3\n";
  const std::pair<std::filesystem::path, Vec3> cases[] = {
      {folder.write("l.ply", ply("", "1 2 3")), {-1, -2, 3}},
      {folder.write("r.ply", ply("comment made by hand\ncomment SPACE=RAS\n", "1 2 3")), {1, 2, 3}},
      {folder.write("l.obj", obj), {-1, -2, 3}},
      {folder.write("l2.obj", "# SPACE=LPS\n" + obj), {-1, -2, 3}},
      {folder.write("r.obj", "# SPACE=RAS\n" + obj), {1, 2, 3}},
      {folder.write("l.stl", stl("skin")), {-1, -2, 3}},
      {folder.write("r.stl", stl("SPACE=RAS")), {1, 2, 3}},
      {folder.write("UPPER.PLY", ply("", "1 2 3")), {-1, -2, 3}}};
  for (const auto& [file, first] : cases)
  {
    const TriangleMesh mesh = to_triangle_mesh(read_surface(file));
    ASSERT_EQ(mesh.points.size(), 3u) << file;
    EXPECT_EQ(mesh.points[0], first) << file;
    EXPECT_EQ(mesh.triangles.size(), 1u) << file;
  }
}

TEST(SurfaceFile, ObjWithNormalsAndTextureKeepsItsVertices)
{
  const TemporaryFolder folder;
  const auto file = folder.write("b.obj", "o skin\nv 1 2 3\nv 10 0 0\nv 0 10 0\nv 5 5 9\n"
                                          "vn 0 0 1\nvn 1 0 0\nvt 0 0\nvt 1 0\nvt 0 1\ns off\n"
                                          "f 1/1/1 2/2/1 3/3/1\nf 2/1/2 4/2/2 3/3/2\n");
  const TriangleMesh mesh = to_triangle_mesh(read_surface(file));
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.triangles.at(1), (Triangle{1, 3, 2}));
}

TEST(SurfaceFile, PolygonsBecomeTriangles)
{
  const TemporaryFolder folder;
  const auto file = folder.write("q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(to_triangle_mesh(read_surface(file)).triangles.size(), 2u);
}

TEST(SurfaceFile, BinaryPlyOfAScannerIsReadInBothByteOrders)
{
  const TemporaryFolder folder;
  for (const bool big_endian : {false, true})
  {
    const auto file = folder.write("scan.ply", "");
    std::ofstream(file, std::ios::binary) << scanned_ply(big_endian);
    const TriangleMesh read = to_triangle_mesh(read_surface(file));
    ASSERT_EQ(read.points.size(), 4u);
    EXPECT_EQ(read.points[3], Vec3(-1, -2, 18.25)) << "LPS in the file";
    const std::vector<Triangle> corners = {{0, 2, 1}, {0, 1, 3}};
    EXPECT_EQ(read.triangles, corners);
  }
}

TEST(SurfaceFile, PlyWithAFaceOfVerticesThatAreNotThereIsRefused)
{
  const TemporaryFolder folder;
  std::string text = ply("", "1 2 3");
  text.replace(text.rfind("3 0 1 2"), 7, "3 0 1 7");
  const auto file = folder.write("s.ply", text);
  expect_error([&] { read_surface(file); }, {file.string(), "face 1", "not there"});
}

TEST(SurfaceFile, NonFiniteVerticesAreRefused)
{
  const TemporaryFolder folder;
  for (const char* value : {"nan 0 0", "0 -nan 0", "0 0 inf"})
  {
    const auto file = folder.write("n.ply", ply("", value));
    expect_error([&] { read_surface(file); }, {file.string(), "not finite"});
    const auto obj =
        folder.write("n.obj", std::string("v ") + value + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_error([&] { read_surface(obj); }, {obj.string()});
  }
  TriangleMesh mesh = tetrahedron();
  mesh.points[2].y() = std::nan("");
  write_surface(folder / "n.vtp", to_polydata(mesh));
  expect_error([&] { read_surface(folder / "n.vtp"); }, {"n.vtp", "not finite"});
}

TEST(SurfaceFile, DamagedFilesAreRefusedInOneLine)
{
  const TemporaryFolder folder;
  write_surface(folder / "s.vtp", to_polydata(tetrahedron()));
  const std::string vtp = test::read_text(folder / "s.vtp");
  const std::pair<std::string, std::string> cases[] = {{"a.vtp", ""},
                                                       {"b.vtp", "junk"},
                                                       {"c.vtp", vtp.substr(0, vtp.size() / 3)},
                                                       {"d.vtp", vtp.substr(0, vtp.size() - 100)},
                                                       {"e.ply", ""},
                                                       {"f.ply", "ply\nformat ascii 1.0\n"},
                                                       {"g.ply", ply("", "1 2 3").substr(0, 160)},
                                                       {"g2.ply", ply("", "1 2 3").substr(0, 178)},
                                                       {"h.obj", ""},
                                                       {"i.obj", "v 1 2 3\nf 1 2 3\n"},
                                                       {"j.stl", ""},
                                                       {"k.stl", stl("x").substr(0, 60)},
                                                       {"l.vtk", "junk"},
                                                       {"m.obj", "v 0 0 0\nv 1 0 0\n"},
                                                       {"n.ply", "junk\n"},
                                                       {"o.ply", ply("elephant 1\n", "1 2 3")},
                                                       {"p.ply", ply("element sky 1\n", "1 2 3")},
                                                       {"q.ply", ply("", "1 2 three")}};
  for (const auto& [name, text] : cases)
  {
    const auto file = folder.write(name, text);
    SCOPED_TRACE(name);
    expect_error([&] { read_surface(file); }, {file.string()});
  }
}

TEST(SurfaceFile, WrongPlacesAreNamed)
{
  const TemporaryFolder folder;
  expect_error([&] { read_surface(folder / "absent.vtp"); }, {"absent.vtp", "no such file"});
  expect_error([&] { read_surface(folder.write("skin.step", "x")); },
               {"skin.step", "'.step'", ".vtp"});
  expect_error([&] { read_surface(folder.path()); }, {folder.path().string(), "no such file"});
  expect_error([] { write_surface("/proc/x.vtp", to_polydata(tetrahedron())); },
               {"/proc/x.vtp", "written"});
}

TEST(SurfaceFile, MissingArrayIsNamed)
{
  expect_error([] { point_scalars(to_polydata(tetrahedron()), "weight"); }, {"weight"});
}

} // namespace
} // namespace f2b
