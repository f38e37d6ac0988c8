#ifndef vtkFaceToBonePlaneRepresentation_h
#define vtkFaceToBonePlaneRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

#include <memory>

class vtkProperty;
namespace f2b
{
struct BoundedPlane;
struct LineOfSight;
} // namespace f2b

/// How does a cut look that can be taken hold of?
///
/// A translucent rectangle, as thick as the saw's kerf, with an outline; a ball in the middle, one at
/// the middle of each edge, and an arrow along the normal. Between them it lets the mouse through: to
/// the camera, and to cuts behind.
class vtkFaceToBonePlaneRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBonePlaneRepresentation* New();
  vtkTypeMacro(vtkFaceToBonePlaneRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  /// What can be taken hold of.
  enum Handle
  {
    None,
    Face,   ///< outline or arrow's line: shifts along the normal
    Centre, ///< shifts in the picture's plane
    Normal, ///< tilts
    EdgeU0, ///< the edge at -u: its distance from the other one
    EdgeU1,
    EdgeV0,
    EdgeV1,
  };

  void SetPlane(const f2b::BoundedPlane& plane);
  const f2b::BoundedPlane& GetPlane() const { return *this->Plane; }
  void SetKerf(double mm);
  vtkGetMacro(Kerf, double);
  void SetColour(const Point& colour);
  /// Without handles a cut is only looked at, and drawn fainter.
  void SetHandlesShown(bool shown);

  /// The handle under a pixel.
  Handle HandleAt(double x, double y);
  /// \return whether it looks different now
  bool HighlightOnly(Handle handle);
  /// Where a handle is drawn.
  Point HandlePosition(Handle handle) const;
  f2b::LineOfSight LineAt(double x, double y);
  /// Width and depth at the cursor.
  void ShowSize(double x, double y);
  void HideSize() { this->SetReadout("", 0, 0); }

protected:
  vtkFaceToBonePlaneRepresentation();
  ~vtkFaceToBonePlaneRepresentation() override;

private:
  vtkFaceToBonePlaneRepresentation(const vtkFaceToBonePlaneRepresentation&) = delete;
  void operator=(const vtkFaceToBonePlaneRepresentation&) = delete;

  void Draw();

  std::unique_ptr<f2b::BoundedPlane> Plane;
  double Kerf = 1;
  bool HandlesShown = true;
  std::array<vtkProperty*, 2> Coloured{};
  Handle Highlighted = None;
  vtkSmartPointer<vtkPolyData> Slab, Outline, Balls, Chosen, Arrow;
};

#endif
