#pragma once

#include "vtkMRML.h"

#include <vtkNew.h>
#include <vtkObject.h>

#include <map>
#include <vector>

class vtkCallbackCommand;
class vtkFloatArray;
class vtkIntArray;

#ifndef vtkObjectPointer
#define vtkObjectPointer(pointer) (reinterpret_cast<vtkObject**>((pointer)))
#endif

/// Which objects does an owner hold and observe, all through one callback command?
class VTK_MRML_EXPORT vtkObserverManager : public vtkObject
{
public:
  static vtkObserverManager* New();
  vtkTypeMacro(vtkObserverManager, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets a counted pointer without observing what it points to.
  void SetObject(vtkObject** nodePtr, vtkObject* node);

  /// Sets a counted pointer and observes ModifiedEvent.
  void SetAndObserveObject(vtkObject** nodePtr, vtkObject* node, float priority = 0.0,
                           bool logWarningIfSameObservationExists = true);

  /// Sets a counted pointer and observes these events.
  void SetAndObserveObjectEvents(vtkObject** nodePtr, vtkObject* node, vtkIntArray* events,
                                 vtkFloatArray* priorities = nullptr,
                                 bool logWarningIfSameObservationExists = true);

  /// Observes ModifiedEvent of an object that somebody else holds.
  void ObserveObject(vtkObject* node, float priority = 0.0);

  /// Observes these events of an object that somebody else holds, besides those observed already.
  void AddObjectEvents(vtkObject* nodePtr, vtkIntArray* events,
                       vtkFloatArray* priorities = nullptr);

  void RemoveObjectEvents(vtkObject* nodePtr);

  /// How often the event is observed; any event where it is 0.
  int GetObservationsCount(vtkObject* nodePtr, unsigned long event = 0);

  vtkGetObjectMacro(Owner, vtkObject);
  void AssignOwner(vtkObject* owner) { this->Owner = owner; }
  vtkObject* GetObserver();
  vtkCallbackCommand* GetCallbackCommand() { return this->CallbackCommand; }

protected:
  vtkObserverManager();
  ~vtkObserverManager() override;
  vtkObserverManager(const vtkObserverManager&) = delete;
  void operator=(const vtkObserverManager&) = delete;

private:
  struct Observation
  {
    unsigned long Event;
    unsigned long Tag;
  };

  vtkObject* Owner = nullptr; ///< not counted: the owner holds this
  vtkNew<vtkCallbackCommand> CallbackCommand;
  std::map<vtkObject*, std::vector<Observation>> Observations;
};
