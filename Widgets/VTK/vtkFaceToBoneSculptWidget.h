#ifndef vtkFaceToBoneSculptWidget_h
#define vtkFaceToBoneSculptWidget_h

#include "vtkFaceToBoneToolWidget.h"

#include <array>
#include <memory>

class vtkFaceToBoneSculptRepresentation;
namespace f2b
{
struct Brush;
} // namespace f2b

/// How does the mouse sculpt the face?
///
/// | state    | event                        | action                                             |
/// |----------|------------------------------|----------------------------------------------------|
/// | Start    | mouse move                   | the brush follows the skin under the cursor        |
/// | Start    | left press on the skin       | begins a stroke -> Sculpting                       |
/// | Start    | left press beside it         | none: the camera turns                             |
/// | Start    | shift + wheel                | radius                                             |
/// | Start    | control + wheel              | strength                                           |
/// | Start    | keys [ ]                     | radius smaller, larger                             |
/// | Start    | keys { }                     | strength smaller, larger                           |
/// | Start    | leave                        | hides the brush                                    |
/// | Sculpting| mouse move                   | drags the skin, or dabs along the way              |
/// | Sculpting| left release                 | ends the stroke -> Start                           |
/// | Sculpting| key Escape, right press      | takes the stroke back -> Start                     |
///
/// Held while pressing: shift smooths, control inverts Draw and turns Mask into Unmask. Invokes
/// StartInteractionEvent, InteractionEvent (the skin has changed) and EndInteractionEvent for each
/// stroke, and ModifiedEvent when radius or strength have changed.
class vtkFaceToBoneSculptWidget : public vtkFaceToBoneToolWidget
{
public:
  static vtkFaceToBoneSculptWidget* New();
  vtkTypeMacro(vtkFaceToBoneSculptWidget,
               vtkFaceToBoneToolWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Sculpting = Start + 1,
  };

  void SetRepresentation(vtkFaceToBoneSculptRepresentation* representation);
  void CreateDefaultRepresentation() override;
  vtkFaceToBoneSculptRepresentation* GetSculptRepresentation();

  void SetBrush(const f2b::Brush& brush);
  const f2b::Brush& GetBrush() const { return *this->Brush; }

  vtkFaceToBoneSculptWidget(const vtkFaceToBoneSculptWidget&) = delete;
  void operator=(const vtkFaceToBoneSculptWidget&) = delete;

protected:
  vtkFaceToBoneSculptWidget();
  ~vtkFaceToBoneSculptWidget() override;
  void Cancel() override;

private:
  bool Hover();
  bool Leave();
  bool Press();
  bool Move();
  bool Release();
  bool TakeBack();
  bool Wheel(double factor);
  bool ScaleRadius(double factor);
  bool ScaleStrength(double factor);
  void DabUntil(double x, double y);
  void End();

  std::unique_ptr<f2b::Brush> Brush;
  std::unique_ptr<f2b::Brush> Held; ///< of the stroke that is going on
  std::array<double, 3> Grabbed{};  ///< where the stroke began [mm, RAS]
  std::array<double, 2> Last{};     ///< pixel of the last dab
};

#endif
