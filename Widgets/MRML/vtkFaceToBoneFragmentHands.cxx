#include "vtkFaceToBoneFragmentHands.h"

#include "vtkFaceToBoneFragmentRepresentation.h"
#include "vtkFaceToBoneFragmentWidget.h"

#include <Core/geometry/rigid_motion.hpp>

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLLinearTransformNode.h>
#include <vtkMRMLModelDisplayNode.h>
#include <vtkMRMLModelNode.h>
#include <vtkMRMLScene.h>

#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>

vtkStandardNewMacro(vtkFaceToBoneFragmentHands);

namespace
{

using Look = vtkFaceToBoneFragmentRepresentation;
using Osteotomy = vtkMRMLFaceToBoneOsteotomyNode;

constexpr double Degree = 3.14159265358979323846 / 180;

f2b::RigidMotion MotionOf(const std::array<double, 6>& movement, const double reference[3])
{
  f2b::RigidMotion motion;
  motion.rotation = f2b::rotation_from(
      {movement[3] * Degree, movement[4] * Degree, movement[5] * Degree}); // pitch, roll, yaw
  motion.translation = {movement[0], movement[1], movement[2]};
  motion.reference_point = {reference[0], reference[1], reference[2]};
  return motion;
}

} // namespace

vtkFaceToBoneFragmentHands::~vtkFaceToBoneFragmentHands()
{
  this->LetGo();
}

// --- What may come and go

void vtkFaceToBoneFragmentHands::SetView(vtkRenderWindowInteractor* interactor,
                                         vtkRenderer* renderer)
{
  if (!interactor || !renderer)
    interactor = nullptr, renderer = nullptr;
  if (this->Interactor == interactor && this->Renderer == renderer)
    return;
  this->LetGo();
  this->Interactor = interactor;
  this->Renderer = renderer;
  if (this->Moving && !interactor)
    this->Stop();
  this->Update();
}

void vtkFaceToBoneFragmentHands::SetPlan(vtkMRMLFaceToBonePlanNode* plan)
{
  if (this->Plan == plan)
    return;
  this->Stop();
  this->Plan = plan;
  vtkMRMLScene* scene = plan ? plan->GetScene() : nullptr;
  if (scene && scene != this->Scene) // once for each: nodes often go within its own events
  {
    this->Scene = scene;
    this->SceneWatches.Clear();
    this->SceneWatches.Add(scene, vtkMRMLScene::NodeAboutToBeRemovedEvent, this,
                           &vtkFaceToBoneFragmentHands::OnNodeRemoved);
    this->SceneWatches.Add(scene, vtkMRMLScene::StartCloseEvent, this,
                           &vtkFaceToBoneFragmentHands::OnSceneClosed);
  }
  this->PlanWatches.Clear();
  this->PlanWatches.Add(plan, vtkCommand::ModifiedEvent, this,
                        &vtkFaceToBoneFragmentHands::OnPlanChanged);
  this->Modified();
}

void vtkFaceToBoneFragmentHands::OnSceneClosed()
{
  this->SetPlan(nullptr);
}

void vtkFaceToBoneFragmentHands::OnNodeRemoved(vtkObject*, unsigned long, void* node)
{
  auto* removed = static_cast<vtkObject*>(node);
  if (!this->Plan || !removed || this->Going)
    return;
  bool ours = removed == this->Plan->GetOsteotomyNode();
  for (const Hand& hand : this->Hands)
    ours = ours || removed == hand.Transform ||
           removed == this->Plan->GetTransformNode(this->Method, hand.Fragment) ||
           removed == this->Plan->GetFragmentNode(this->Method, hand.Fragment);
  this->Going = removed;
  if (removed == this->Plan)
    this->SetPlan(nullptr);
  else if (ours)
    this->Stop();
  this->Going = nullptr;
}

/// By a step that has published its results, by the user, or by us.
void vtkFaceToBoneFragmentHands::OnPlanChanged()
{
  if (this->Writing || !this->Moving)
    return;
  if (this->Method != this->Plan->GetSelectedMethod())
  {
    this->LetGo();
    this->Method = this->Plan->GetSelectedMethod();
  }
  this->Update();
}

// --- Fragments

/// Those that the selected method has moved, under a transform of their own.
std::vector<std::string> vtkFaceToBoneFragmentHands::Movable()
{
  std::vector<std::string> names;
  double point[3];
  if (!this->Plan)
    return names;
  const int method = this->Moving ? this->Method : this->Plan->GetSelectedMethod();
  for (const std::string& fragment : this->Plan->GetMovementFragments(method))
  {
    vtkMRMLLinearTransformNode* planned = this->Plan->GetTransformNode(method, fragment);
    if (planned && !planned->GetParentTransformNode() &&
        this->Plan->GetFragmentNode(method, fragment) &&
        this->Plan->GetReferencePoint(method, fragment, point))
      names.push_back(fragment);
  }
  return names;
}

/// As stated; as planned where nothing is.
vtkFaceToBoneFragmentHands::Coordinates
vtkFaceToBoneFragmentHands::Wanted(const std::string& fragment)
{
  Coordinates movement{};
  if (!this->Plan->GetStatedMovement(fragment, movement.data()))
    this->Plan->GetMovement(this->Method, fragment, movement.data());
  return movement;
}

/// A tool and a transform for a fragment.
vtkFaceToBoneFragmentHands::Hand vtkFaceToBoneFragmentHands::Take(const std::string& fragment)
{
  Hand hand{fragment, vtkSmartPointer<vtkFaceToBoneFragmentWidget>::New(), nullptr};
  hand.Tool->SetPriority(0.6F); // before a brush, where the two overlap
  hand.Tool->SetInteractor(this->Interactor);
  hand.Tool->SetDefaultRenderer(this->Renderer);
  for (const unsigned long event : {vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent})
    hand.Tool->AddObserver(event, this, &vtkFaceToBoneFragmentHands::OnTool);
  hand.Transform =
      vtkMRMLLinearTransformNode::SafeDownCast(this->Plan->GetScene()->AddNewNodeByClass(
          "vtkMRMLLinearTransformNode", fragment + " by hand"));
  return hand;
}

/// The fragment under the plan's transform again; ours goes.
void vtkFaceToBoneFragmentHands::PutBack(const Hand& hand)
{
  hand.Tool->RemoveAllObservers(); // a drag that is going on counts for nothing
  hand.Tool->SetEnabled(0);
  hand.Tool->Render();
  hand.Tool->SetInteractor(nullptr);
  vtkMRMLScene* scene = hand.Transform ? hand.Transform->GetScene() : nullptr;
  if (!scene || scene->IsClosing()) // all nodes go
    return;
  vtkMRMLModelNode* model =
      this->Plan ? this->Plan->GetFragmentNode(this->Method, hand.Fragment) : nullptr;
  if (model && model->GetParentTransformNode() == hand.Transform)
  {
    vtkMRMLNode* planned = this->Plan->GetTransformNode(this->Method, hand.Fragment);
    model->SetAndObserveTransformNodeID(planned ? planned->GetID() : nullptr);
  }
  if (hand.Transform != this->Going)
    scene->RemoveNode(hand.Transform);
}

/// Where its tool has the fragment.
void vtkFaceToBoneFragmentHands::Apply(const Hand& hand)
{
  vtkMRMLModelNode* model = this->Plan->GetFragmentNode(this->Method, hand.Fragment);
  if (!model || !hand.Transform)
    return;
  const Look* look = hand.Tool->GetFragmentRepresentation();
  const f2b::Mat4 m = MotionOf(look->GetMovement(), look->GetReferencePoint().data()).matrix();
  const vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix->SetElement(row, column, m(row, column));
  hand.Transform->SetMatrixTransformToParent(matrix);
  model->SetAndObserveTransformNodeID(hand.Transform->GetID());
}

void vtkFaceToBoneFragmentHands::TakeRules(const Hand& hand)
{
  Look* look = hand.Tool->GetFragmentRepresentation();
  Osteotomy* osteotomy = this->Plan->GetOsteotomyNode();
  const int n = osteotomy ? osteotomy->GetFragmentIndex(hand.Fragment) : -1;
  for (int k = 0; k < Osteotomy::Coordinate_Last; ++k)
  {
    const double most = k < Osteotomy::Pitch ? Look::MostMm : Look::MostDegrees;
    double bounds[2] = {-most, most};
    if (n >= 0)
      osteotomy->GetNthFragmentBounds(n, k, bounds);
    look->SetLimits(k, std::max(bounds[0], -most), std::min(bounds[1], most));
    look->SetLocked(k, n >= 0 && osteotomy->GetNthFragmentLocked(n, k));
  }
}

/// Arrows and rings where the fragments are wanted; one that is held leads and is left alone.
void vtkFaceToBoneFragmentHands::Update()
{
  if (!this->Moving || !this->Plan || !this->Interactor)
    return;
  const std::vector<std::string> names = this->Movable();
  const bool same =
      std::equal(names.begin(), names.end(), this->Hands.begin(), this->Hands.end(),
                 [](const std::string& name, const Hand& hand) { return name == hand.Fragment; });
  if (!same)
    this->LetGo();
  for (std::size_t h = this->Hands.size(); h < names.size(); ++h)
    this->Hands.push_back(this->Take(names[h]));
  for (const Hand& hand : this->Hands)
  {
    if (hand.Tool->GetWidgetState() != vtkFaceToBoneFragmentWidget::Start)
      continue;
    Look* look = hand.Tool->GetFragmentRepresentation();
    this->TakeRules(hand);
    Look::Point reference{};
    this->Plan->GetReferencePoint(this->Method, hand.Fragment, reference.data());
    look->SetReferencePoint(reference);
    look->SetMovement(this->Wanted(hand.Fragment));
    this->Apply(hand);
    hand.Tool->SetEnabled(1);
    hand.Tool->Render();
  }
  this->ShowFaces();
}

/// Only a face that goes with where the fragments are.
void vtkFaceToBoneFragmentHands::ShowFaces()
{
  using PlanNode = vtkMRMLFaceToBonePlanNode;
  vtkMRMLModelNode* stated = this->Plan->GetStatedPredictionNode();
  const bool predicted = this->Plan->GetStepStatus(PlanNode::Predict) == PlanNode::Current;
  if (stated && stated->GetDisplayNode())
    stated->GetDisplayNode()->SetVisibility(this->Moving && predicted);
  vtkMRMLModelNode* planned = this->Plan->GetPredictionNode(this->Method);
  if (planned && planned->GetDisplayNode())
    planned->GetDisplayNode()->SetVisibility(!this->Moving);
}

void vtkFaceToBoneFragmentHands::LetGo()
{
  std::vector<Hand> hands;
  hands.swap(this->Hands);
  for (const Hand& hand : hands)
    this->PutBack(hand);
}

vtkFaceToBoneFragmentWidget* vtkFaceToBoneFragmentHands::GetTool(int n)
{
  return this->Hands.at(static_cast<std::size_t>(n)).Tool;
}

// --- Moving

std::string vtkFaceToBoneFragmentHands::GetObstacle()
{
  if (!this->Plan)
    return "There is no plan.";
  if (this->Movable().empty())
    return "No fragment has been planned yet: compute the movement first.";
  return this->Interactor ? "" : "There is no 3D view.";
}

bool vtkFaceToBoneFragmentHands::Start()
{
  if (this->Moving)
    return true;
  if (!this->GetObstacle().empty())
    return false;
  this->Method = this->Plan->GetSelectedMethod();
  this->Moving = true;
  this->Update();
  this->Modified();
  return true;
}

void vtkFaceToBoneFragmentHands::Stop()
{
  if (!this->Moving)
    return;
  this->LetGo();
  this->Moving = false;
  if (this->Plan)
    this->ShowFaces();
  this->Modified();
}

void vtkFaceToBoneFragmentHands::Reset()
{
  if (!this->Plan)
    return;
  this->Plan->RemoveStatedMovements();
  if (!this->Moving)
    return;
  this->Update();
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
}

/// What is seen is what Predict is asked for, also of fragments that were not touched.
void vtkFaceToBoneFragmentHands::StateAll()
{
  this->Writing = true;
  {
    const MRMLNodeModifyBlocker blocker(this->Plan);
    for (const Hand& hand : this->Hands)
      this->Plan->SetStatedMovement(hand.Fragment,
                                    hand.Tool->GetFragmentRepresentation()->GetMovement().data());
  }
  this->Writing = false;
}

void vtkFaceToBoneFragmentHands::OnTool(vtkObject* tool, unsigned long event, void*)
{
  if (!this->Plan)
    return;
  for (const Hand& hand : this->Hands)
    if (hand.Tool == tool)
      this->Apply(hand);
  if (event == vtkCommand::EndInteractionEvent)
    this->StateAll();
  this->InvokeEvent(event);
}

void vtkFaceToBoneFragmentHands::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Moving: " << this->Moving << "\n";
  os << indent << "Obstacle: " << this->GetObstacle() << "\n";
}
