#ifndef vtkFaceToBoneWatches_h
#define vtkFaceToBoneWatches_h

#include <vtkObject.h>
#include <vtkWeakPointer.h>

#include <vector>

/// Observers of one tool on objects that may be gone before it.
///
/// Not to be cleared within an event that one of the objects sends: a VTK of 9.1 loses its place in
/// the list of observers where that event is nested in another of the same object.
class vtkFaceToBoneWatches
{
public:
  vtkFaceToBoneWatches() = default;
  ~vtkFaceToBoneWatches() { this->Clear(); }
  vtkFaceToBoneWatches(const vtkFaceToBoneWatches&) = delete;
  void operator=(const vtkFaceToBoneWatches&) = delete;

  /// \param watched   null: nothing
  /// \param callback  a method of the observer
  template <class Observer, class Callback>
  void Add(vtkObject* watched, unsigned long event, Observer* observer, Callback callback)
  {
    if (watched)
      this->Watches.push_back({watched, watched->AddObserver(event, observer, callback)});
  }
  void Clear()
  {
    for (const Watch& watch : this->Watches)
      if (watch.Watched)
        watch.Watched->RemoveObserver(watch.Tag);
    this->Watches.clear();
  }

private:
  struct Watch
  {
    vtkWeakPointer<vtkObject> Watched;
    unsigned long Tag;
  };
  std::vector<Watch> Watches;
};

#endif
