#include "Imaging/voxel_buffer.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace f2b
{
namespace
{

constexpr itk::SizeValueType fewest_voxels = 16;

template <class Voxel>
void convert(const std::vector<char>& raw, const std::string& name, short* voxels)
{
  const auto* from = reinterpret_cast<const Voxel*>(raw.data());
  const std::size_t count = raw.size() / sizeof(Voxel);
  for (std::size_t v = 0; v < count; ++v)
  {
    const double value = static_cast<double>(from[v]);
    if (!std::isfinite(value))
      throw Error(name, "voxel " + std::to_string(v) + " is " + std::to_string(value),
                  "export the CT again in Hounsfield units");
    voxels[v] = static_cast<short>(std::lround(std::clamp(value, -32768.0, 32767.0)));
  }
}

template <class Range>
std::string joined(const Range& values)
{
  std::ostringstream out;
  for (unsigned a = 0; a < 3; ++a)
    out << (a ? " x " : "") << values[a];
  return out.str();
}

} // namespace

void require_hounsfield_type(const itk::ImageIOBase& io, const std::string& name)
{
  if (io.GetNumberOfComponents() != 1)
    throw Error(name,
                "is a colour or vector image with " + std::to_string(io.GetNumberOfComponents()) +
                    " values per voxel",
                "give a CT in Hounsfield units");
  const auto type = io.GetComponentType();
  if (type == itk::IOComponentEnum::UCHAR || type == itk::IOComponentEnum::CHAR)
    throw Error(name, "holds 8-bit voxels (" + io.GetComponentTypeAsString(type) + ")",
                "give a CT in Hounsfield units with 16 bits or more");
}

void read_voxels(itk::ImageIOBase& io, const std::string& name, short* voxels)
{
  std::vector<char> raw(io.GetImageSizeInBytes());
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a)
    region.SetSize(a, io.GetDimensions(a));
  io.SetIORegion(region);
  io.Read(raw.data());
  switch (io.GetComponentType())
  {
  case itk::IOComponentEnum::SHORT:
    return convert<short>(raw, name, voxels);
  case itk::IOComponentEnum::USHORT:
    return convert<unsigned short>(raw, name, voxels);
  case itk::IOComponentEnum::INT:
    return convert<int>(raw, name, voxels);
  case itk::IOComponentEnum::UINT:
    return convert<unsigned int>(raw, name, voxels);
  case itk::IOComponentEnum::FLOAT:
    return convert<float>(raw, name, voxels);
  case itk::IOComponentEnum::DOUBLE:
    return convert<double>(raw, name, voxels);
  default:
    throw Error(name, "holds voxels of type " + io.GetComponentTypeAsString(io.GetComponentType()),
                "give a CT with 16-bit, 32-bit or float voxels");
  }
}

void require_spacing(const double* spacing, const std::string& name)
{
  for (int a = 0; a < 3; ++a)
    if (!(std::isfinite(spacing[a]) && spacing[a] > 0.0))
    {
      std::ostringstream value;
      value << "spacing along axis " << a + 1 << " is " << spacing[a] << " mm";
      throw Error(name, value.str(), "correct the spacing in the header; it must be positive");
    }
}

CtImage::Pointer make_image(const CtImage::SizeType& size, const CtImage::SpacingType& spacing,
                            const CtImage::PointType& origin,
                            const CtImage::DirectionType& direction, const std::string& name)
{
  require_spacing(spacing.GetDataPointer(), name);
  if (*std::min_element(size.begin(), size.end()) < fewest_voxels)
    throw Error(name, "is " + joined(size) + " voxels, a single slice or too few of them",
                "give a CT volume with at least 16 slices");
  const auto product = direction.GetTranspose() * direction.GetVnlMatrix();
  double worst = 0.0;
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 3; ++column)
    {
      const double error = std::abs(product(row, column) - (row == column ? 1.0 : 0.0));
      worst = std::isfinite(error) ? std::max(worst, error) : error;
    }
  if (!(worst < 1e-3))
    throw Error(name, "axes are not at right angles (off by " + std::to_string(worst) + ")",
                "resample the CT to a rectangular lattice");
  auto ct = CtImage::New();
  ct->SetRegions(size);
  ct->SetSpacing(spacing);
  ct->SetOrigin(origin);
  ct->SetDirection(direction);
  ct->Allocate();
  return ct;
}

std::string first_line(const std::string& message)
{
  std::istringstream in(message);
  std::string line;
  while (std::getline(in, line))
  {
    const std::size_t text = line.find("): ");
    if (line.find("ERROR") != std::string::npos && text != std::string::npos)
      line = line.substr(text + 3);
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      return line;
  }
  return "unknown reason";
}

} // namespace f2b
