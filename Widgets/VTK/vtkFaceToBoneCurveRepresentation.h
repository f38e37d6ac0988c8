#ifndef vtkFaceToBoneCurveRepresentation_h
#define vtkFaceToBoneCurveRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

#include <memory>
#include <optional>

namespace f2b
{
struct SurfacePlace;
} // namespace f2b

/// How does a line look that is drawn on bone?
///
/// Control points and, between them, the shortest way along the surface (f2b::surface_path).
class vtkFaceToBoneCurveRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBoneCurveRepresentation* New();
  vtkTypeMacro(vtkFaceToBoneCurveRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  static constexpr double SpacingMm = 1.5; ///< of the line's points
  static constexpr int None = -1;

  /// The bone; the curve is begun anew. May be null.
  void SetSurface(vtkPolyData* surface);
  bool HasSurface() const { return this->Bone != nullptr; }
  /// The bone under a pixel.
  std::optional<f2b::SurfacePlace> PlaceAt(double x, double y);

  int GetNumberOfControlPoints() const;
  Point GetControlPoint(int index) const;
  /// Points along the whole line; the first is not repeated where it is closed.
  std::vector<Point> GetCurve() const;
  double GetLength() const; ///< [mm]
  vtkGetMacro(Closed, bool);

  /// \return false, and nothing is added, if no way on the surface leads there
  bool AddControlPoint(const f2b::SurfacePlace& place);
  bool MoveControlPoint(int index, const f2b::SurfacePlace& place);
  void RemoveLastControlPoint();
  bool Close();
  void Open();
  void Clear();

  /// The control point under a pixel, or None.
  int ControlPointAt(double x, double y);
  void Highlight(int index);
  /// Length at the cursor.
  void ShowLength(double x, double y);
  void HideLength() { this->SetReadout("", 0, 0); }

  vtkFaceToBoneCurveRepresentation(const vtkFaceToBoneCurveRepresentation&) = delete;
  void operator=(const vtkFaceToBoneCurveRepresentation&) = delete;

protected:
  vtkFaceToBoneCurveRepresentation();
  ~vtkFaceToBoneCurveRepresentation() override;

private:
  struct Surface;
  std::vector<Point> Leg(const f2b::SurfacePlace& from, const f2b::SurfacePlace& to) const;
  void Draw();

  std::unique_ptr<Surface> Bone;
  std::vector<f2b::SurfacePlace> Places;
  std::vector<std::vector<Point>> Legs; ///< leg i leads from point i to the next
  bool Closed = false;
  int Highlighted = None;
  vtkSmartPointer<vtkPolyData> Line, Points, Chosen;
};

#endif
