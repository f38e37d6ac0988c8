#pragma once

#include "Core/inverse/face_model.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>

class vtkStaticCellLocator;

/// Where is a surface of any vertices nearest to the face?
namespace f2b
{

/// A face scan, or a mesh sculpted elsewhere, in the case's frame.
class ScanSurface
{
public:
  /// \param surface  triangles, RAS [mm]
  explicit ScanSurface(vtkPolyData* surface);

  struct Foot
  {
    Vec3 point;  ///< of the scan [mm]
    Vec3 normal; ///< of its triangle, unit
    bool is_on_border;
  };
  /// May be called from several threads.
  Foot nearest(const Vec3& point) const;

private:
  vtkSmartPointer<vtkPolyData> m_surface;
  TriangleMesh m_mesh; ///< the same
  vtkSmartPointer<vtkStaticCellLocator> m_locator;
  std::vector<std::array<char, 3>> m_border; ///< per triangle: whether edge i, i + 1 is a border
};

/// The nearest place of a scan for vertices of a reference skin at rest [mm]; see SkinTarget.
std::function<NearestTarget(std::size_t, const Vec3&)>
nearest_on_scan(std::shared_ptr<const ScanSurface> scan, const std::vector<Vec3>& rest);

/// A target that the reference skin is to lie on, wherever along it.
///
/// A vertex counts if the scan lies within reach of its place at rest, faces about the same way
/// there (60 degrees) and does not end there.
/// \param rest     positions of the reference skin's vertices [mm]
/// \param normals  outward unit normals of these
SkinTarget target_on_scan(const std::shared_ptr<const ScanSurface>& scan,
                          const std::vector<Vec3>& rest, const std::vector<Vec3>& normals,
                          double reach_mm);

} // namespace f2b
