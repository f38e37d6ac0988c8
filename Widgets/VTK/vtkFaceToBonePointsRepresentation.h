#ifndef vtkFaceToBonePointsRepresentation_h
#define vtkFaceToBonePointsRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

#include <optional>
#include <string>

class vtkCellPicker;

/// How do points look that are placed on skin and bone?
///
/// A ball a point with its name beside it. As a ruler, two points are joined and told their
/// distance [mm], three the angle at the second [degrees].
class vtkFaceToBonePointsRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBonePointsRepresentation* New();
  vtkTypeMacro(vtkFaceToBonePointsRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  static constexpr int None = -1;

  void SetPoints(const std::vector<Point>& points, const std::vector<std::string>& names = {});
  const std::vector<Point>& GetPoints() const { return this->Points; }
  void SetPoint(int index, const Point& point);
  void SetRuler(bool ruler);
  vtkGetMacro(Ruler, bool);
  void SetColour(const Point& rgb);

  /// "34.2 mm", "81.4 deg"; empty for other counts of points.
  static std::string Measured(const std::vector<Point>& points);

  /// The point under a pixel, or None.
  int PointAt(double x, double y);
  /// The surface under a pixel; surfaces that are less than half opaque are looked through.
  std::optional<Point> SurfaceAt(double x, double y);
  void Highlight(int index);
  void ShowText(const std::string& text, double x, double y) { this->SetReadout(text, x, y); }

  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* props) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;

  vtkFaceToBonePointsRepresentation(const vtkFaceToBonePointsRepresentation&) = delete;
  void operator=(const vtkFaceToBonePointsRepresentation&) = delete;

protected:
  vtkFaceToBonePointsRepresentation();
  ~vtkFaceToBonePointsRepresentation() override;

private:
  void Draw();
  vtkSmartPointer<vtkTextActor> Label(const std::string& text) const;

  std::vector<Point> Points;
  std::vector<std::string> Names;
  bool Ruler = false;
  int Highlighted = None;
  vtkSmartPointer<vtkPolyData> Balls, Held, Line;
  vtkActor *BallActor, *HeldActor, *LineActor;
  std::vector<vtkSmartPointer<vtkTextActor>> Labels;
  std::vector<Point> LabelPlaces;
  vtkSmartPointer<vtkCellPicker> Picker;
};

#endif
