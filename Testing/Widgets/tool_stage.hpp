#pragma once

#include "Widgets/random_events.hpp"

#include "vtkFaceToBoneToolRepresentation.h"
#include "vtkFaceToBoneToolWidget.h"

#include <Rendering/offscreen_display.hpp>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <random>
#include <string>

/// A window without a screen whose mouse and keys are ours.
namespace f2b::testing
{

/// One display for a test program; it must outlive every window.
inline OffscreenDisplay& shared_display()
{
  static OffscreenDisplay display;
  return display;
}

class ToolStage
{
public:
  /// Looks at a surface from the front of the patient.
  explicit ToolStage(vtkPolyData* surface)
  {
    shared_display();
    window->SetOffScreenRendering(1);
    window->SetShowWindow(false);
    window->SetSize(400, 400);
    window->AddRenderer(renderer);
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(nullptr); // the camera stays where it is
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0, 400, 0);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 0, 1);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(50);
    renderer->ResetCameraClippingRange();
    window->Render();
  }

  void use(vtkFaceToBoneToolWidget* tool)
  {
    tool->SetInteractor(interactor);
    tool->SetDefaultRenderer(renderer);
    tool->SetEnabled(1);
  }

  /// The pixel of a point [mm, RAS].
  std::array<int, 2> pixel(double r, double a, double s)
  {
    renderer->SetWorldPoint(r, a, s, 1);
    renderer->WorldToDisplay();
    const double* p = renderer->GetDisplayPoint();
    return {static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1]))};
  }

  void send(unsigned long event, std::array<int, 2> at, bool control = false, bool shift = false,
            const char* key = nullptr)
  {
    interactor->SetEventInformation(at[0], at[1], control, shift, 0, 0, key);
    interactor->InvokeEvent(event);
  }
  void press(std::array<int, 2> at, bool control = false, bool shift = false)
  {
    send(vtkCommand::LeftButtonPressEvent, at, control, shift);
  }
  void move(std::array<int, 2> at) { send(vtkCommand::MouseMoveEvent, at); }
  void release(std::array<int, 2> at) { send(vtkCommand::LeftButtonReleaseEvent, at); }
  void key(const char* symbol)
  {
    send(vtkCommand::KeyPressEvent, {200, 200}, false, false, symbol);
  }
  /// Press, some moves on a line, release.
  void drag(std::array<int, 2> from, std::array<int, 2> to, bool control = false,
            bool shift = false)
  {
    press(from, control, shift);
    for (int k = 1; k <= 4; ++k)
      move({from[0] + k * (to[0] - from[0]) / 4, from[1] + k * (to[1] - from[1]) / 4});
    release(to);
  }

  /// One event of any kind, anywhere in the window and a little beside it; every second one at one of
  /// the places that can be taken hold of, where there are some.
  void random_event(std::mt19937& random, const std::vector<std::array<int, 2>>& handles = {})
  {
    static constexpr std::array events{vtkCommand::MouseMoveEvent,
                                       vtkCommand::MouseMoveEvent,
                                       vtkCommand::MouseMoveEvent,
                                       vtkCommand::LeftButtonPressEvent,
                                       vtkCommand::LeftButtonReleaseEvent,
                                       vtkCommand::LeftButtonDoubleClickEvent,
                                       vtkCommand::RightButtonPressEvent,
                                       vtkCommand::RightButtonReleaseEvent,
                                       vtkCommand::MouseWheelForwardEvent,
                                       vtkCommand::MouseWheelBackwardEvent,
                                       vtkCommand::LeaveEvent,
                                       vtkCommand::KeyPressEvent};
    static constexpr std::array keys{"Escape",     "bracketleft", "bracketright", "braceleft",
                                     "braceright", "Return",      "BackSpace",    "Delete",
                                     "x",          "Tab"};
    std::array<int, 2> at{int(random() % 440) - 20, int(random() % 440) - 20};
    if (!handles.empty() && random() % 2 == 0)
      at = handles[random() % handles.size()];
    send(events[random() % events.size()], at, random() % 4 == 0, random() % 4 == 0,
         keys[random() % keys.size()]);
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
};

/// How many events of one kind an object has sent.
class EventCounter
{
public:
  EventCounter(vtkObject* object, unsigned long event)
  {
    object->AddObserver(event, this, &EventCounter::count_one);
  }
  int count = 0;

private:
  void count_one(vtkObject*, unsigned long, void*) { ++count; }
};

} // namespace f2b::testing
