#ifndef vtkFaceToBoneSkinSculpting_h
#define vtkFaceToBoneSkinSculpting_h

#include "vtkFaceToBoneWatches.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <functional>
#include <memory>
#include <string>

class vtkFaceToBoneSculptWidget;
class vtkMRMLMarkupsNode;
class vtkMRMLModelNode;
class vtkMRMLScene;
class vtkPolyData;
class vtkRenderer;
class vtkRenderWindowInteractor;
namespace f2b
{
struct Brush;
struct SymmetryPlane;
class SculptingSession;
} // namespace f2b

/// How is the face of a scene's model node sculpted in a view of its host?
///
/// Keeps a brush (vtkFaceToBoneSculptWidget) on the view, and writes each of its moves to the target
/// node: points, normals, point arrays `displacement` [mm, RAS], `displacement_mm` and `mask`. The
/// strokes have an undo of their own; the scene's is left alone. Views, nodes and the scene may go at
/// any time, also in the middle of a stroke: what goes with them is the brush.
///
/// Invokes InteractionEvent when the face has changed, EndInteractionEvent when a stroke is done or
/// undone, ModifiedEvent when the brush, or what can be done now, has changed.
class vtkFaceToBoneSkinSculpting : public vtkObject
{
public:
  static vtkFaceToBoneSkinSculpting* New();
  vtkTypeMacro(vtkFaceToBoneSkinSculpting, vtkObject) void PrintSelf(ostream& os,
                                                                     vtkIndent indent) override;

  /// Where the brush works; null: nowhere.
  void SetView(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);

  /// What it works on: the same vertices twice, as they are and as they should be. Null: on nothing.
  /// Other nodes than before end the sculpting.
  void SetNodes(vtkMRMLModelNode* reference, vtkMRMLModelNode* target);
  /// The points that say where the middle of the face is; without enough of them, the face itself.
  void SetLandmarks(vtkMRMLMarkupsNode* landmarks);
  vtkMRMLModelNode* GetTargetNode();

  /// Shows target instead of reference and takes the brush in hand.
  /// \return false where it cannot; GetObstacle says why
  bool Start();
  /// A stroke that is going on is taken back.
  void Stop();
  bool IsSculpting();
  /// Why the face cannot be sculpted now; empty: it can.
  std::string GetObstacle();

  /// \param symmetric  both sides of the face alike; the brush's own plane does not count
  void SetBrush(const f2b::Brush& brush, bool symmetric);
  /// As it is now, after keys and wheel.
  const f2b::Brush& GetBrush();

  bool CanUndo();
  bool CanRedo();
  bool Undo();
  bool Redo();
  void ClearMask();
  void InvertMask();
  /// The target coloured by how far it has moved along its normal, within 10 mm either way.
  void SetColoured(bool coloured);
  bool IsColoured();

  /// For hosts that do more with it; null before Start.
  f2b::SculptingSession* GetSession() { return this->Session.get(); }
  vtkFaceToBoneSculptWidget* GetTool() { return this->Tool; }

  vtkFaceToBoneSkinSculpting(const vtkFaceToBoneSkinSculpting&) = delete;
  void operator=(const vtkFaceToBoneSkinSculpting&) = delete;

protected:
  vtkFaceToBoneSkinSculpting();
  ~vtkFaceToBoneSkinSculpting() override;

private:
  void WatchScene();
  void WatchNodes();
  void Forget();
  bool Load();
  bool ShowsSession(vtkPolyData* surface);
  bool RestsOn(vtkMRMLModelNode& reference);
  std::string NodesObstacle();
  bool Change(const std::function<bool(f2b::SculptingSession&)>& change);
  void ApplySymmetry();
  void ShowTarget();
  void TellSettled();

  void OnTool(vtkObject*, unsigned long event, void*);
  void OnTargetChanged();
  void OnReferenceChanged();
  void OnLandmarksChanged();
  void OnNodeRemoved(vtkObject*, unsigned long, void* node);
  void OnSceneClosed();

  vtkNew<vtkFaceToBoneSculptWidget> Tool;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkMRMLModelNode> Reference, Target;
  vtkWeakPointer<vtkMRMLMarkupsNode> Landmarks;
  vtkWeakPointer<vtkMRMLScene> Scene;
  vtkFaceToBoneWatches SceneWatches, NodeWatches;
  std::shared_ptr<f2b::SculptingSession> Session;
  vtkSmartPointer<vtkPolyData> Shown; ///< of the target, that the brush writes to
  bool Symmetric = false;
  std::unique_ptr<f2b::SymmetryPlane> OfFace; ///< where landmarks do not say it
  bool Telling = false;                       ///< the brush is set by us: no news
  std::string Obstacle;
};

#endif
