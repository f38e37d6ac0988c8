#ifndef vtkFaceToBoneFragmentRepresentation_h
#define vtkFaceToBoneFragmentRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

namespace f2b
{
struct LineOfSight;
} // namespace f2b

/// How does a fragment look that can be moved by hand?
///
/// At its moved reference point: an arrow for each of right, anterior and superior, and a ring for
/// each of pitch, roll and yaw. Coordinates that are locked are not drawn. The movement is that of
/// reports: translation of the reference point [mm, RAS], R = Rz(yaw) Ry(roll) Rx(pitch) [degrees].
class vtkFaceToBoneFragmentRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBoneFragmentRepresentation* New();
  vtkTypeMacro(vtkFaceToBoneFragmentRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  /// right, anterior, superior [mm], pitch, roll, yaw [degrees]
  using Coordinates = std::array<double, 6>;
  static constexpr int None = -1;

  void SetReferencePoint(const Point& point); ///< at rest
  const Point& GetReferencePoint() const { return this->ReferencePoint; }
  void SetMovement(const Coordinates& movement);
  const Coordinates& GetMovement() const { return this->Movement; }
  void SetLocked(int coordinate, bool locked);
  bool IsLocked(int coordinate) const { return this->Locked[Index(coordinate)]; }
  static constexpr double MostMm = 40, MostDegrees = 45; ///< either way, where no rule says less
  void SetLimits(int coordinate, double least, double most);
  /// The value nearest to a wish that the limits allow.
  double Within(int coordinate, double value) const;

  Point MovedPoint() const;
  /// The axis that a coordinate moves along or turns about, at present.
  Point Axis(int coordinate) const;
  /// A place where a coordinate can be taken hold of.
  Point GripPosition(int coordinate) const;
  /// The coordinate under a pixel, or None.
  int CoordinateAt(double x, double y);
  /// \return whether it looks different now
  bool HighlightOnly(int coordinate);
  f2b::LineOfSight LineAt(double x, double y);
  void ShowMovement(double x, double y);
  void HideMovement() { this->SetReadout("", 0, 0); }
  vtkSetMacro(Size, double); ///< length of the arrows [mm]

  vtkFaceToBoneFragmentRepresentation(const vtkFaceToBoneFragmentRepresentation&) = delete;
  void operator=(const vtkFaceToBoneFragmentRepresentation&) = delete;

protected:
  vtkFaceToBoneFragmentRepresentation();
  ~vtkFaceToBoneFragmentRepresentation() override;

private:
  static std::size_t Index(int coordinate) { return static_cast<std::size_t>(coordinate); }
  std::vector<Point> Line(int coordinate) const;
  void Draw();

  Point ReferencePoint{};
  Coordinates Movement{};
  std::array<bool, 6> Locked{};
  std::array<std::array<double, 2>, 6> Limits{{{-MostMm, MostMm},
                                               {-MostMm, MostMm},
                                               {-MostMm, MostMm},
                                               {-MostDegrees, MostDegrees},
                                               {-MostDegrees, MostDegrees},
                                               {-MostDegrees, MostDegrees}}};
  double Size = 35;
  int Highlighted = None;
  std::array<vtkSmartPointer<vtkPolyData>, 6> Lines;
  std::array<vtkActor*, 6> LineActors{};
};

#endif
