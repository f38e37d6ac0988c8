#ifndef vtkFaceToBoneToolWidget_h
#define vtkFaceToBoneToolWidget_h

#include <vtkAbstractWidget.h>

#include <functional>
#include <map>

/// How does a tool turn events into actions? A table: state x event -> action.
///
/// A subclass fills the table in its constructor with `On` and shows it in its header. An action
/// returns whether the event was the tool's: then nobody else sees it (the camera stays), and the
/// view is drawn anew. An event without an entry goes on to others, but for what belongs to a press that
/// was the tool's: its release, and the double click that it is part of. To others they would be a click.
/// A double click without an entry is a press.
class vtkFaceToBoneToolWidget : public vtkAbstractWidget
{
public:
  vtkTypeMacro(vtkFaceToBoneToolWidget,
               vtkAbstractWidget) void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    Start = 0, ///< state of every tool that does nothing; subclasses number theirs from 1
  };
  vtkGetMacro(WidgetState, int);

  /// Switching a tool off in the middle of something cancels it.
  void SetEnabled(int enabling) override;

protected:
  vtkFaceToBoneToolWidget();
  ~vtkFaceToBoneToolWidget() override;

  using Action = std::function<bool()>;
  void On(int state, unsigned long event, Action action);
  /// What a key does, by its symbol ("Escape"), in a state.
  void OnKey(int state, const std::string& symbol, Action action);

  /// Ends what is going on without a result.
  virtual void Cancel() {}

  int GetX() const;
  int GetY() const;
  bool IsControlDown() const;
  bool IsShiftDown() const;

  int WidgetState = Start;

private:
  vtkFaceToBoneToolWidget(const vtkFaceToBoneToolWidget&) = delete;
  void operator=(const vtkFaceToBoneToolWidget&) = delete;

  template <unsigned long Event>
  void Listen();
  void Dispatch(unsigned long event);
  const Action* Find(unsigned long event) const;
  bool IsOwed(unsigned long event);

  std::map<std::pair<int, unsigned long>, Action> Actions;
  std::map<std::pair<int, std::string>, Action> KeyActions;
  bool LeftIsOurs = false, RightIsOurs = false; ///< buttons that were pressed for the tool
};

#endif
