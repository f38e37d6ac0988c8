#ifndef vtkFaceToBoneToolRepresentation_h
#define vtkFaceToBoneToolRepresentation_h

#include <vtkSmartPointer.h>
#include <vtkWidgetRepresentation.h>

#include <array>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkTextActor;

/// What do all of our 3D tools draw with?
///
/// A list of actors that the subclass makes, a line of text at the cursor, and the geometry between
/// display [pixels from the bottom left] and world [mm, RAS].
class vtkFaceToBoneToolRepresentation : public vtkWidgetRepresentation
{
public:
  using Point = std::array<double, 3>;
  struct Ray
  {
    Point Origin{};
    Point Direction{}; ///< unit
  };

  vtkTypeMacro(vtkFaceToBoneToolRepresentation,
               vtkWidgetRepresentation) void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The line of sight through a pixel. Needs a renderer.
  Ray GetRay(double x, double y);
  /// Where the line of sight through a pixel comes as near to the viewer as a world point is.
  Point WorldAtDepthOf(const Point& world, double x, double y);
  Point ToDisplay(const Point& world);
  double MillimetresPerPixel(const Point& world);

  /// The text at the cursor; empty: none.
  std::string GetReadout() const;

  void BuildRepresentation() override {}
  void GetActors(vtkPropCollection* props) override;
  void GetActors2D(vtkPropCollection* props) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;

protected:
  vtkFaceToBoneToolRepresentation();
  ~vtkFaceToBoneToolRepresentation() override;

  /// A new actor that shows a surface or lines; lines are drawn in front of surfaces they lie on.
  vtkActor* AddActor(vtkPolyData* shown, const Point& colour, double lineWidth = 2);
  void SetReadout(const std::string& text, double x, double y);
  static void SetPolyline(vtkPolyData* data, const std::vector<Point>& points, bool closed);
  static void SetPoints(vtkPolyData* data, const std::vector<Point>& points);
  /// Distance of a pixel from a piece of a line on the screen.
  static double PixelsFromPiece(const Point& a, const Point& b, double x, double y);
  /// Balls that can be taken hold of: dark, and one that is chosen.
  vtkActor* MakeBalls(vtkPolyData* balls, vtkPolyData* chosen);

private:
  vtkFaceToBoneToolRepresentation(const vtkFaceToBoneToolRepresentation&) = delete;
  void operator=(const vtkFaceToBoneToolRepresentation&) = delete;

  std::vector<vtkSmartPointer<vtkActor>> Actors;
  vtkSmartPointer<vtkTextActor> Readout;
};

#endif
