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
/// Control points and, between them, the shortest way along the surface (f2b::surface_path). A free
/// line, as templates place it in front of the bone, has straight pieces instead.
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
  /// The bone of another curve, which is not read again; the curve is begun anew.
  void ShareSurface(const vtkFaceToBoneCurveRepresentation& other);
  bool HasSurface() const { return this->Bone != nullptr; }
  /// Points of a free line move in the picture's plane.
  void SetFree(bool free);
  vtkGetMacro(Free, bool);
  void SetColour(const Point& colour);
  /// Said beside a point under the cursor.
  void SetName(const std::string& name) { this->Name = name; }
  /// A single point is drawn as a big ball of this colour.
  void SetBall(const Point& colour);
  /// Without handles a line is only looked at.
  void SetHandlesShown(bool shown);
  /// The bone under a pixel.
  std::optional<f2b::SurfacePlace> PlaceAt(double x, double y);
  /// Where a control point goes that is dragged to a pixel.
  std::optional<f2b::SurfacePlace> PlaceFor(int index, double x, double y);

  int GetNumberOfControlPoints() const;
  Point GetControlPoint(int index) const;
  std::vector<Point> GetControlPoints() const;
  /// Another line through these points, or through the bone's nearest ones.
  void SetControlPoints(const std::vector<Point>& points, bool closed);
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
  void Shift(const Point& by); ///< of a free line [mm]

  /// What the line is, to go back to.
  struct State;
  std::shared_ptr<const State> Remember() const;
  void GoBack(const State& state);

  /// The control point under a pixel, or None.
  int ControlPointAt(double x, double y);
  /// Is the line itself under a pixel?
  bool LineAt(double x, double y);
  /// \return whether it looks different now
  bool HighlightOnly(int index);
  /// Length at the cursor.
  void ShowLength(double x, double y);
  /// The name at the cursor, where a point is highlighted.
  void ShowName(double x, double y);
  /// At the cursor: why no point is added there.
  void ShowRefusal(double x, double y);
  /// Into the bone, as a mean over the control points; unit.
  Point GetInwards() const;
  Point NearestOnBone(const Point& point) const;
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

  std::shared_ptr<const Surface> Bone;
  std::vector<f2b::SurfacePlace> Places;
  std::vector<std::vector<Point>> Legs; ///< leg i leads from point i to the next
  bool Closed = false, Free = false, HandlesShown = true;
  int Highlighted = None;
  vtkSmartPointer<vtkPolyData> Line, Points, Chosen;
  vtkActor *LineActor = nullptr, *BallActor = nullptr;
  std::string Name;
};

#endif
