#include "Bridge/print_file.hpp"

#include <array>
#include <cstdint>
#include <cstdio>

namespace f2b
{
namespace
{

Vec3 flipped(const Vec3& p)
{
  return {-p.x(), -p.y(), p.z()};
}

void add_point(std::string& text, const char* word, const Vec3& p, int decimals)
{
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), "%s %.*f %.*f %.*f\n", word, decimals, p.x(), decimals,
                p.y(), decimals, p.z());
  text += line.data();
}

template <class Value>
void add_bytes(std::string& bytes, Value value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

std::string stl_text(const TriangleMesh& surface)
{
  std::string text = "solid FaceToBone SPACE=LPS\n";
  text.reserve(300 * surface.triangles.size());
  for (const Triangle& triangle : surface.triangles)
  {
    std::array<Vec3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = flipped(surface.points[static_cast<std::size_t>(triangle[i])]);
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double length = normal.norm();
    add_point(text, "facet normal", length > 0 ? Vec3(normal / length) : Vec3::Zero(), 6);
    text += "outer loop\n";
    for (const Vec3& p : corner)
      add_point(text, "vertex", p, 9);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid FaceToBone\n";
}

std::string ply_bytes(const TriangleMesh& surface)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment SPACE=LPS\nelement vertex " +
                      std::to_string(surface.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(surface.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : surface.points)
    for (const double coordinate : flipped(p))
      add_bytes(bytes, coordinate);
  for (const Triangle& triangle : surface.triangles)
  {
    add_bytes(bytes, std::uint8_t{3});
    for (const int corner : triangle)
      add_bytes(bytes, static_cast<std::int32_t>(corner));
  }
  return bytes;
}

} // namespace f2b
