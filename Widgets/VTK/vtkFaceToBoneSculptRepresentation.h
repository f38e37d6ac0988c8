#ifndef vtkFaceToBoneSculptRepresentation_h
#define vtkFaceToBoneSculptRepresentation_h

#include "vtkFaceToBoneToolRepresentation.h"

#include <memory>
#include <optional>

namespace f2b
{
struct Brush;
class SculptingSession;
struct SurfacePlace;
} // namespace f2b

/// How does the brush look on the skin?
///
/// A circle of the brush's radius, laid on the skin; a fainter one at the mirrored place; radius and
/// displacement in mm beside the cursor. Writes the session's skin into a vtkPolyData that the host
/// shows: points, normals, and point arrays `displacement` [mm, RAS] and `mask`.
class vtkFaceToBoneSculptRepresentation : public vtkFaceToBoneToolRepresentation
{
public:
  static vtkFaceToBoneSculptRepresentation* New();
  vtkTypeMacro(vtkFaceToBoneSculptRepresentation,
               vtkFaceToBoneToolRepresentation) void PrintSelf(ostream& os,
                                                               vtkIndent indent) override;

  static constexpr const char* DisplacementArray = "displacement";
  static constexpr const char* LengthArray =
      "displacement_mm"; ///< along the skin's normal, outward
  static constexpr const char* MaskArray = "mask";

  /// \param session  may be null: nothing is shown
  /// \param shown    the surface with the session's vertices and triangles that follows it; may be null
  void SetSession(std::shared_ptr<f2b::SculptingSession> session, vtkPolyData* shown);
  f2b::SculptingSession* GetSession() const { return this->Session.get(); }
  /// Brings the shown surface up to the session's state.
  void UpdateShown();

  /// The skin under a pixel.
  std::optional<f2b::SurfacePlace> PlaceAt(double x, double y);
  /// Shows the brush under a pixel; nothing where no skin is.
  void ShowBrush(const f2b::Brush& brush, double x, double y);
  /// Shows the brush at a place that is held, with the displacement there.
  void ShowHeldBrush(const f2b::Brush& brush, const Point& place, double x, double y);
  void HideBrush();
  bool IsBrushShown() const;

protected:
  vtkFaceToBoneSculptRepresentation();
  ~vtkFaceToBoneSculptRepresentation() override;

private:
  vtkFaceToBoneSculptRepresentation(const vtkFaceToBoneSculptRepresentation&) = delete;
  void operator=(const vtkFaceToBoneSculptRepresentation&) = delete;

  void DrawCircle(vtkPolyData* data, const f2b::SurfacePlace& place, double radius);
  void ShowAt(const f2b::Brush& brush, const f2b::SurfacePlace& place, double x, double y);

  std::shared_ptr<f2b::SculptingSession> Session;
  long ShownRevision = -1; ///< of the session, that the shown surface is up to
  vtkSmartPointer<vtkPolyData> Shown, Circle, MirrorCircle;
  vtkActor* CircleActor;
  vtkActor* MirrorActor;
};

#endif
