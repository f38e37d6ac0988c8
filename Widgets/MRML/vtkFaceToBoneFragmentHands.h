#ifndef vtkFaceToBoneFragmentHands_h
#define vtkFaceToBoneFragmentHands_h

#include "vtkFaceToBoneWatches.h"

#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkFaceToBoneFragmentWidget;
class vtkMRMLFaceToBonePlanNode;
class vtkMRMLLinearTransformNode;
class vtkMRMLScene;
class vtkRenderer;
class vtkRenderWindowInteractor;

/// How are a plan's fragments moved by hand in a view of its host?
///
/// Keeps arrows and rings (vtkFaceToBoneFragmentWidget) on each fragment that the plan has moved. While
/// they are shown, the fragments of the plan's selected method lie under transforms of ours in place of
/// the plan's, whose files in the case folder are results. When a drag ends, the places of all fragments
/// become the plan's stated movements, which the verb Predict gives the face of. Locked coordinates and
/// bounds of the osteotomy hold. The face of the stated movements is shown where it has been predicted,
/// and the plan's is not. Stopping brings the planned places and face back and removes our transforms;
/// the stated movements stay.
///
/// Invokes InteractionEvent when a fragment has moved, EndInteractionEvent when it is let go,
/// ModifiedEvent when what can be done now has changed.
class vtkFaceToBoneFragmentHands : public vtkObject
{
public:
  static vtkFaceToBoneFragmentHands* New();
  vtkTypeMacro(vtkFaceToBoneFragmentHands, vtkObject) void PrintSelf(ostream& os,
                                                                     vtkIndent indent) override;

  /// right, anterior, superior [mm], pitch, roll, yaw [degrees]
  using Coordinates = std::array<double, 6>;

  /// Where the fragments are moved; null: nowhere.
  void SetView(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  /// Another plan than before ends the moving.
  void SetPlan(vtkMRMLFaceToBonePlanNode* plan);

  /// \return false where it cannot; GetObstacle says why
  bool Start();
  void Stop();
  bool IsMoving() { return this->Moving; }
  /// Why no fragment can be moved now; empty: one can.
  std::string GetObstacle();
  /// Forgets the stated movements: every fragment is where the plan has it.
  void Reset();

  int GetNumberOfFragments() { return static_cast<int>(this->Hands.size()); }
  vtkFaceToBoneFragmentWidget* GetTool(int n);

  vtkFaceToBoneFragmentHands(const vtkFaceToBoneFragmentHands&) = delete;
  void operator=(const vtkFaceToBoneFragmentHands&) = delete;

protected:
  vtkFaceToBoneFragmentHands() = default;
  ~vtkFaceToBoneFragmentHands() override;

private:
  struct Hand
  {
    std::string Fragment;
    vtkSmartPointer<vtkFaceToBoneFragmentWidget> Tool;
    vtkWeakPointer<vtkMRMLLinearTransformNode> Transform; ///< ours
  };

  std::vector<std::string> Movable();
  Coordinates Wanted(const std::string& fragment);
  Hand Take(const std::string& fragment);
  void PutBack(const Hand& hand);
  void Apply(const Hand& hand);
  void TakeRules(const Hand& hand);
  void Update();
  void ShowFaces();
  void LetGo();
  void StateAll();

  void OnTool(vtkObject* tool, unsigned long event, void*);
  void OnPlanChanged();
  void OnNodeRemoved(vtkObject*, unsigned long, void* node);
  void OnSceneClosed();

  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkMRMLFaceToBonePlanNode> Plan;
  vtkWeakPointer<vtkMRMLScene> Scene;
  vtkFaceToBoneWatches SceneWatches, PlanWatches;
  std::vector<Hand> Hands;
  int Method = 0;
  bool Moving = false, Writing = false;
  vtkObject* Going = nullptr; ///< the node that is being removed from the scene
};

#endif
