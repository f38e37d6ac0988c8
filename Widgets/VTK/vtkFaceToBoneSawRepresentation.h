#ifndef vtkFaceToBoneSawRepresentation_h
#define vtkFaceToBoneSawRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

namespace f2b
{
struct LineOfSight;
} // namespace f2b

/// How does a saw look that follows a line, and where does it come from?
///
/// A translucent strip, from in front of the line to the depth that is sawn; an arrow through the
/// line's middle along the saw, with a ball at its outer end (the hand) and one at the depth.
class vtkFaceToBoneSawRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBoneSawRepresentation* New();
  vtkTypeMacro(vtkFaceToBoneSawRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  /// What can be taken hold of.
  enum Handle
  {
    None,
    Hand,  ///< turns the saw about the line's middle
    Depth, ///< how far it goes
  };
  static constexpr double HandAwayMm = 22; ///< of the hand, from the line

  void SetLine(const std::vector<Point>& points, bool closed);
  void SetDirection(const Point& direction); ///< unit, into the bone
  const Point& GetDirection() const { return this->Direction; }
  void SetReach(double leadMm, double depthMm);
  double GetLead() const { return this->LeadMm; }
  double GetDepth() const { return this->DepthMm; }
  void SetColour(const Point& colour);
  /// Without handles a saw is only looked at.
  void SetHandlesShown(bool shown);

  /// Half the way along the line.
  Point GetMiddle() const;
  Point HandlePosition(Handle handle) const;
  Handle HandleAt(double x, double y);
  /// \return whether it looks different now
  bool HighlightOnly(Handle handle);
  f2b::LineOfSight LineAt(double x, double y);
  void ShowDepth(double x, double y);
  void HideDepth() { this->SetReadout("", 0, 0); }

  vtkFaceToBoneSawRepresentation(const vtkFaceToBoneSawRepresentation&) = delete;
  void operator=(const vtkFaceToBoneSawRepresentation&) = delete;

protected:
  vtkFaceToBoneSawRepresentation();
  ~vtkFaceToBoneSawRepresentation() override;

private:
  void Draw();

  std::vector<Point> Points;
  bool Closed = false, HandlesShown = true;
  Point Direction{0, -1, 0};
  double LeadMm = 5, DepthMm = 20;
  Handle Highlighted = None;
  vtkSmartPointer<vtkPolyData> Strip, Arrow, Balls, Chosen;
  vtkActor* StripActor = nullptr;
};

#endif
