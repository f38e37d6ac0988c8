#include "vtkFaceToBoneSkinSculpting.h"

#include "vtkFaceToBoneSculptRepresentation.h"
#include "vtkFaceToBoneSculptWidget.h"

#include <Bridge/vtk_surface.hpp>
#include <Core/error.hpp>
#include <Core/geometry/bite.hpp>
#include <Core/sculpting/mirror_plane.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <vtkMRMLMarkupsNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

vtkStandardNewMacro(vtkFaceToBoneSkinSculpting);

namespace
{

using Look = vtkFaceToBoneSculptRepresentation;

constexpr double ColouredMm = 10;
/// Slicer's own table; a scene names it without holding it.
constexpr const char* DivergingColorsID = "vtkMRMLColorTableNodeFileDivergingBlueRed.txt";

/// From its array where it has one, as the verb Target reads it; else from its points.
std::vector<f2b::Vec3> DisplacementOf(vtkPolyData* surface, const std::vector<f2b::Vec3>& rest)
{
  std::vector<f2b::Vec3> displacement(rest.size());
  vtkDataArray* array = surface->GetPointData()->GetArray(Look::DisplacementArray);
  const bool stated = array && array->GetNumberOfComponents() == 3 &&
                      array->GetNumberOfTuples() == surface->GetNumberOfPoints();
  for (std::size_t v = 0; v < rest.size(); ++v)
  {
    const auto id = static_cast<vtkIdType>(v);
    stated ? array->GetTuple(id, displacement[v].data())
           : surface->GetPoint(id, displacement[v].data());
    if (!stated)
      displacement[v] -= rest[v];
  }
  return displacement;
}

f2b::Landmarks LandmarksOf(vtkMRMLMarkupsNode* node)
{
  f2b::Landmarks landmarks;
  for (int n = 0; node && n < node->GetNumberOfControlPoints(); ++n)
    if (node->GetNthControlPointPositionStatus(n) == vtkMRMLMarkupsNode::PositionDefined)
    {
      f2b::Vec3& place = landmarks[node->GetNthControlPointLabel(n)];
      node->GetNthControlPointPositionWorld(n, place.data());
    }
  return landmarks;
}

/// None where there are too few landmarks.
std::optional<f2b::SymmetryPlane> SymmetryOf(vtkMRMLMarkupsNode* landmarks)
{
  try
  {
    const f2b::MidSagittalPlane plane = f2b::mid_sagittal_plane(LandmarksOf(landmarks));
    return f2b::SymmetryPlane{plane.point, plane.normal};
  }
  catch (const f2b::Error&)
  {
    return {};
  }
}

f2b::SymmetryPlane SymmetryOf(const f2b::SculptedSkin& skin)
{
  if (const auto found = f2b::mirror_plane({skin.rest(), skin.triangles()}))
    return found->plane;
  f2b::SymmetryPlane symmetry;
  for (const f2b::Vec3& p : skin.rest())
    symmetry.point += p / static_cast<double>(skin.size());
  return symmetry;
}

void SetVisible(vtkMRMLModelNode* model, bool visible)
{
  if (model && model->GetDisplayNode())
    model->GetDisplayNode()->SetVisibility(visible);
}

} // namespace

vtkFaceToBoneSkinSculpting::vtkFaceToBoneSkinSculpting()
{
  for (const unsigned long event :
       {vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent, vtkCommand::ModifiedEvent})
    this->Tool->AddObserver(event, this, &vtkFaceToBoneSkinSculpting::OnTool);
}

vtkFaceToBoneSkinSculpting::~vtkFaceToBoneSkinSculpting()
{
  this->Tool->RemoveAllObservers(); // a stroke that ends now is nobody's news
  this->Forget();
  this->SetView(nullptr, nullptr);
}

// --- What may come and go

/// Once for each scene, as the nodes are often let go of within its own events.
void vtkFaceToBoneSkinSculpting::WatchScene()
{
  vtkMRMLScene* scene = this->Target ? this->Target->GetScene() : nullptr;
  if (!scene || scene == this->Scene)
    return;
  this->Scene = scene;
  this->SceneWatches.Clear();
  this->SceneWatches.Add(scene, vtkMRMLScene::NodeAboutToBeRemovedEvent, this,
                         &vtkFaceToBoneSkinSculpting::OnNodeRemoved);
  this->SceneWatches.Add(scene, vtkMRMLScene::StartCloseEvent, this,
                         &vtkFaceToBoneSkinSculpting::OnSceneClosed);
}

void vtkFaceToBoneSkinSculpting::WatchNodes()
{
  using Self = vtkFaceToBoneSkinSculpting;
  this->NodeWatches.Clear();
  for (const unsigned long event :
       {static_cast<unsigned long>(vtkMRMLModelNode::MeshModifiedEvent),
        static_cast<unsigned long>(vtkMRMLTransformableNode::TransformModifiedEvent)})
  {
    this->NodeWatches.Add(this->Target, event, this, &Self::OnTargetChanged);
    this->NodeWatches.Add(this->Reference, event, this, &Self::OnReferenceChanged);
  }
  this->NodeWatches.Add(this->Landmarks, vtkMRMLMarkupsNode::PointModifiedEvent, this,
                        &Self::OnLandmarksChanged);
}

void vtkFaceToBoneSkinSculpting::SetView(vtkRenderWindowInteractor* interactor,
                                         vtkRenderer* renderer)
{
  if (!interactor || !renderer)
    interactor = nullptr, renderer = nullptr;
  if (this->Interactor == interactor && this->Tool->GetInteractor() == interactor &&
      this->Tool->GetDefaultRenderer() == renderer)
    return;
  const bool sculpting = this->IsSculpting();
  this->Tool->SetEnabled(0);
  this->Tool->SetInteractor(interactor);
  this->Tool->SetDefaultRenderer(renderer);
  this->Interactor = interactor;
  if (sculpting && interactor)
    this->Tool->SetEnabled(1);
  else if (sculpting)
    this->Modified();
}

void vtkFaceToBoneSkinSculpting::SetNodes(vtkMRMLModelNode* reference, vtkMRMLModelNode* target)
{
  if (this->Reference == reference && this->Target == target)
    return;
  this->Forget();
  this->Reference = reference;
  this->Target = target;
  this->WatchScene();
  this->WatchNodes();
  this->Modified();
}

void vtkFaceToBoneSkinSculpting::SetLandmarks(vtkMRMLMarkupsNode* landmarks)
{
  if (this->Landmarks == landmarks)
    return;
  this->Landmarks = landmarks;
  this->WatchNodes();
  this->OnLandmarksChanged();
}

vtkMRMLModelNode* vtkFaceToBoneSkinSculpting::GetTargetNode()
{
  return this->Target;
}

/// The strokes and the brush; the node is as the last of them left it.
void vtkFaceToBoneSkinSculpting::Forget()
{
  this->Tool->SetEnabled(0);
  this->Tool->GetSculptRepresentation()->SetSession(nullptr, nullptr);
  this->Session.reset();
  this->OfFace.reset();
  this->Shown = nullptr;
}

void vtkFaceToBoneSkinSculpting::OnNodeRemoved(vtkObject*, unsigned long, void* node)
{
  auto* removed = static_cast<vtkObject*>(node);
  if (removed && (removed == this->Target || removed == this->Reference))
    this->SetNodes(nullptr, nullptr);
}

void vtkFaceToBoneSkinSculpting::OnSceneClosed()
{
  this->SetNodes(nullptr, nullptr);
}

void vtkFaceToBoneSkinSculpting::OnReferenceChanged()
{
  if (!this->Session || (this->NodesObstacle().empty() && this->RestsOn(*this->Reference)))
    return;
  this->Forget();
  this->Modified();
}

/// Arrays of the skin may change, its vertices may not.
bool vtkFaceToBoneSkinSculpting::RestsOn(vtkMRMLModelNode& reference)
{
  const f2b::TriangleMesh mesh = f2b::to_triangle_mesh(reference.GetPolyData());
  const f2b::SculptedSkin& skin = this->Session->skin();
  return mesh.points == skin.rest() && mesh.triangles == skin.triangles();
}

/// By us, or by another: then the strokes are gone, unless it is the same face in a new surface, as a
/// step publishes it.
void vtkFaceToBoneSkinSculpting::OnTargetChanged()
{
  if (!this->Session)
    return;
  vtkPolyData* surface = this->Target ? this->Target->GetPolyData() : nullptr;
  const bool same_surface = surface && surface == this->Shown;
  const bool usable = this->NodesObstacle().empty();
  if (usable && same_surface && (this->Session->in_stroke() || this->ShowsSession(surface)))
    return;
  if (usable && !this->Session->in_stroke() && this->ShowsSession(surface))
  {
    this->Shown = surface;
    this->Tool->GetSculptRepresentation()->SetSession(this->Session, surface);
    return;
  }
  const bool sculpting = this->IsSculpting();
  this->Forget();
  if (!sculpting || !this->Start())
    this->Modified();
}

/// Whether a surface is the session's face, to what a file keeps of it.
bool vtkFaceToBoneSkinSculpting::ShowsSession(vtkPolyData* surface)
{
  constexpr double same_mm = 1e-4;
  const f2b::SculptedSkin& skin = this->Session->skin();
  if (static_cast<std::size_t>(surface->GetNumberOfPoints()) != skin.size())
    return false;
  const std::vector<f2b::Vec3> displacement = DisplacementOf(surface, skin.rest());
  f2b::Vec3 point;
  for (std::size_t v = 0; v < skin.size(); ++v)
  {
    surface->GetPoint(static_cast<vtkIdType>(v), point.data());
    if ((point - skin.points()[v]).cwiseAbs().maxCoeff() > same_mm ||
        (displacement[v] - skin.displacement()[v]).cwiseAbs().maxCoeff() > same_mm)
      return false;
  }
  return true;
}

// --- Sculpting

std::string vtkFaceToBoneSkinSculpting::GetObstacle()
{
  const std::string obstacle = this->NodesObstacle();
  if (!obstacle.empty())
    return obstacle;
  return this->Interactor ? this->Obstacle : "There is no 3D view.";
}

std::string vtkFaceToBoneSkinSculpting::NodesObstacle()
{
  vtkPolyData* reference = this->Reference ? this->Reference->GetPolyData() : nullptr;
  vtkPolyData* target = this->Target ? this->Target->GetPolyData() : nullptr;
  if (!reference || reference->GetNumberOfPolys() == 0)
    return "There is no skin yet: find the surfaces first.";
  if (!target)
    return "There is no target to sculpt yet.";
  if (reference->GetNumberOfPoints() != target->GetNumberOfPoints())
    return "The target has other vertices than the skin: make a new one to sculpt.";
  if (this->Reference->GetParentTransformNode() || this->Target->GetParentTransformNode())
    return "Skin or target is under a transform: take it out first.";
  return {};
}

bool vtkFaceToBoneSkinSculpting::Load()
{
  if (this->Session && this->Shown && this->Shown == this->Target->GetPolyData())
    return true;
  this->Forget();
  this->Obstacle.clear();
  vtkPolyData* surface = this->Target->GetPolyData();
  try
  {
    f2b::TriangleMesh mesh = f2b::to_triangle_mesh(this->Reference->GetPolyData());
    auto displacement = DisplacementOf(surface, mesh.points);
    this->Session =
        std::make_shared<f2b::SculptingSession>(std::move(mesh), std::move(displacement));
  }
  catch (const f2b::Error& error)
  {
    this->Obstacle = error.what();
    return false;
  }
  this->Shown = surface;
  this->Tool->GetSculptRepresentation()->SetSession(this->Session, surface);
  return true;
}

bool vtkFaceToBoneSkinSculpting::Start()
{
  this->Obstacle.clear();
  if (!this->GetObstacle().empty() || !this->Load())
  {
    this->Stop();
    return false;
  }
  if (this->IsSculpting())
    return true;
  this->ApplySymmetry();
  this->ShowTarget();
  this->Tool->SetEnabled(1);
  this->Modified();
  return this->IsSculpting();
}

void vtkFaceToBoneSkinSculpting::Stop()
{
  if (!this->IsSculpting())
    return;
  this->Tool->SetEnabled(0);
  this->Tool->Render();
  this->Modified();
}

bool vtkFaceToBoneSkinSculpting::IsSculpting()
{
  return this->Tool->GetEnabled() != 0;
}

void vtkFaceToBoneSkinSculpting::ShowTarget()
{
  SetVisible(this->Reference, false);
  SetVisible(this->Target, true);
}

void vtkFaceToBoneSkinSculpting::SetBrush(const f2b::Brush& brush, bool symmetric)
{
  f2b::Brush wanted = brush;
  wanted.symmetry = this->Tool->GetBrush().symmetry;
  const bool turned = symmetric != this->Symmetric;
  this->Symmetric = symmetric;
  this->Telling = true;
  this->Tool->SetBrush(wanted);
  this->Telling = false;
  if (turned)
    this->ApplySymmetry();
}

const f2b::Brush& vtkFaceToBoneSkinSculpting::GetBrush()
{
  return this->Tool->GetBrush();
}

/// By the landmarks; else by the face itself, which is found once as it takes long.
void vtkFaceToBoneSkinSculpting::ApplySymmetry()
{
  f2b::Brush brush = this->Tool->GetBrush();
  brush.symmetry.reset();
  if (this->Symmetric && this->Session)
  {
    brush.symmetry = SymmetryOf(this->Landmarks);
    if (!brush.symmetry && !this->OfFace)
      this->OfFace = std::make_unique<f2b::SymmetryPlane>(SymmetryOf(this->Session->skin()));
    if (!brush.symmetry)
      brush.symmetry = *this->OfFace;
  }
  this->Telling = true;
  this->Tool->SetBrush(brush);
  this->Telling = false;
}

void vtkFaceToBoneSkinSculpting::OnLandmarksChanged()
{
  this->ApplySymmetry();
}

// --- Strokes

void vtkFaceToBoneSkinSculpting::OnTool(vtkObject*, unsigned long event, void*)
{
  if (event == vtkCommand::ModifiedEvent && !this->Telling)
    this->Modified();
  else if (event == vtkCommand::InteractionEvent)
    this->InvokeEvent(vtkCommand::InteractionEvent);
  else if (event == vtkCommand::EndInteractionEvent)
    this->TellSettled();
}

void vtkFaceToBoneSkinSculpting::TellSettled()
{
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  this->Modified(); // there is something to undo
}

bool vtkFaceToBoneSkinSculpting::CanUndo()
{
  return this->Session && this->Session->history().can_undo();
}

bool vtkFaceToBoneSkinSculpting::CanRedo()
{
  return this->Session && this->Session->history().can_redo();
}

bool vtkFaceToBoneSkinSculpting::Undo()
{
  return this->Change([](f2b::SculptingSession& session) { return session.undo(); });
}

bool vtkFaceToBoneSkinSculpting::Redo()
{
  return this->Change([](f2b::SculptingSession& session) { return session.redo(); });
}

void vtkFaceToBoneSkinSculpting::ClearMask()
{
  this->Change(
      [](f2b::SculptingSession& session)
      {
        session.fill_mask(0);
        return true;
      });
}

void vtkFaceToBoneSkinSculpting::InvertMask()
{
  this->Change(
      [](f2b::SculptingSession& session)
      {
        session.invert_mask();
        return true;
      });
}

/// Something that is done at once, and never within a stroke.
bool vtkFaceToBoneSkinSculpting::Change(const std::function<bool(f2b::SculptingSession&)>& change)
{
  if (!this->Session || this->Session->in_stroke() || !change(*this->Session))
    return false;
  this->Tool->GetSculptRepresentation()->UpdateShown();
  this->Tool->Render();
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->TellSettled();
  return true;
}

void vtkFaceToBoneSkinSculpting::SetColoured(bool coloured)
{
  vtkMRMLDisplayNode* display = this->Target ? this->Target->GetDisplayNode() : nullptr;
  if (!display)
    return;
  const MRMLNodeModifyBlocker blocker(display);
  if (coloured)
  {
    display->SetAndObserveColorNodeID(DivergingColorsID);
    display->SetActiveScalarName(Look::LengthArray);
    display->SetScalarRangeFlag(vtkMRMLDisplayNode::UseManualScalarRange);
    display->SetScalarRange(-ColouredMm, ColouredMm);
  }
  display->SetScalarVisibility(coloured);
}

bool vtkFaceToBoneSkinSculpting::IsColoured()
{
  vtkMRMLDisplayNode* display = this->Target ? this->Target->GetDisplayNode() : nullptr;
  const char* name = display ? display->GetActiveScalarName() : nullptr;
  return name && display->GetScalarVisibility() && name == std::string(Look::LengthArray);
}

void vtkFaceToBoneSkinSculpting::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sculpting: " << this->IsSculpting() << "\n";
  os << indent << "Obstacle: " << this->GetObstacle() << "\n";
}
