#include "qSlicerFaceToBoneModuleWidget.h"
#include "ui_qSlicerFaceToBoneModuleWidget.h"

#include "qFaceToBoneBrushPanel.h"
#include "qSlicerFaceToBoneTools.h"
#include "vtkFaceToBoneFragmentHands.h"
#include "vtkFaceToBoneSkinSculpting.h"

#include <vtkMRMLFaceToBoneOsteotomyNode.h>
#include <vtkMRMLFaceToBonePlanNode.h>
#include <vtkMRMLFaceToBoneTargetNode.h>
#include <vtkSlicerFaceToBoneLogic.h>

#include <vtkMRMLNode.h>
#include <vtkMRMLScene.h>
#include <vtkMRMLVolumeNode.h>

#include <QFileDialog>
#include <QTimer>

#include <array>
#include <cmath>

namespace
{

using PlanNode = vtkMRMLFaceToBonePlanNode;
using OsteotomyNode = vtkMRMLFaceToBoneOsteotomyNode;
using TargetNode = vtkMRMLFaceToBoneTargetNode;

/// How often the running step is asked how far it is [ms].
constexpr int PollingInterval = 100;

/// A step's button and the line below that says how it stands.
struct StepControls
{
  int Step;
  QPushButton* Button;
  QLabel* Status;
};

QString TextOfStatus(int status)
{
  switch (status)
  {
  case PlanNode::Current:
    return qSlicerFaceToBoneModuleWidget::tr("Done.");
  case PlanNode::Stale:
    return qSlicerFaceToBoneModuleWidget::tr("Out of date: something it rests on was changed.");
  default:
    return qSlicerFaceToBoneModuleWidget::tr("Not done yet.");
  }
}

const char* IdOf(vtkMRMLNode* node)
{
  return node ? node->GetID() : nullptr;
}

} // namespace

class qSlicerFaceToBoneModuleWidgetPrivate : public Ui_qSlicerFaceToBoneModuleWidget
{
  Q_DECLARE_PUBLIC(qSlicerFaceToBoneModuleWidget);

protected:
  qSlicerFaceToBoneModuleWidget* const q_ptr;

public:
  explicit qSlicerFaceToBoneModuleWidgetPrivate(qSlicerFaceToBoneModuleWidget& object)
      : q_ptr(&object)
  {
  }

  vtkSlicerFaceToBoneLogic* logic() const;
  std::array<StepControls, 8> steps() const;
  void connectControls();
  void makeTools();
  void showTools();
  void showInputs();
  void showOptions();
  void showSteps();
  void showMovement();
  void takeOptions();
  void takeCuts();
  void takeTarget();

  PlanNode* Plan = nullptr;
  bool Showing = false; ///< the node is being shown: what the controls say then is no wish
  QTimer* Polling = nullptr;
  qSlicerFaceToBoneTools* Tools = nullptr;
};

vtkSlicerFaceToBoneLogic* qSlicerFaceToBoneModuleWidgetPrivate::logic() const
{
  Q_Q(const qSlicerFaceToBoneModuleWidget);
  return vtkSlicerFaceToBoneLogic::SafeDownCast(q->logic());
}

std::array<StepControls, 8> qSlicerFaceToBoneModuleWidgetPrivate::steps() const
{
  return {{{PlanNode::Segment, this->SegmentButton, this->SegmentStatus},
           {PlanNode::Cut, this->CutButton, this->CutStatus},
           {PlanNode::Mesh, this->MeshButton, this->MeshStatus},
           {PlanNode::Target, this->TargetButton, this->TargetStatus},
           {PlanNode::Suggest, this->SuggestButton, this->SuggestStatus},
           {PlanNode::Plan, this->PlanButton, this->PlanStatus},
           {PlanNode::Predict, this->PredictButton, this->PredictStatus},
           {PlanNode::Report, this->ReportButton, this->ReportStatus}}};
}

void qSlicerFaceToBoneModuleWidgetPrivate::connectControls()
{
  Q_Q(qSlicerFaceToBoneModuleWidget);
  const auto nodeChanged = SIGNAL(currentNodeChanged(vtkMRMLNode*));
  QObject::connect(this->PlanSelector, nodeChanged, q, SLOT(setPlanNode(vtkMRMLNode*)));
  QObject::connect(this->PlanSelector, SIGNAL(nodeAddedByUser(vtkMRMLNode*)), q,
                   SLOT(addPlan(vtkMRMLNode*)));
  QObject::connect(this->VolumeSelector, nodeChanged, q, SLOT(setInputVolume(vtkMRMLNode*)));
  QObject::connect(this->LandmarksSelector, nodeChanged, q, SLOT(setLandmarks(vtkMRMLNode*)));
  QObject::connect(this->OsteotomySelector, nodeChanged, q, SLOT(setOsteotomy(vtkMRMLNode*)));
  QObject::connect(this->TargetSelector, nodeChanged, q, SLOT(setTarget(vtkMRMLNode*)));
  for (QWidget* selector :
       {static_cast<QWidget*>(this->WarpFromSelector), static_cast<QWidget*>(this->WarpToSelector)})
    QObject::connect(selector, nodeChanged, q, SLOT(updatePlanFromWidget()));
  QObject::connect(this->CaseFolderEdit, SIGNAL(currentPathChanged(QString)), q,
                   SLOT(updatePlanFromWidget()));
  for (QDoubleSpinBox* spin : {this->SkinThicknessSpin, this->KerfSpin, this->DensitySpin,
                               this->ReleaseMarginSpin, this->WarpRadiusSpin, this->MaskSpin})
    QObject::connect(spin, SIGNAL(valueChanged(double)), q, SLOT(updatePlanFromWidget()));
  for (QComboBox* combo :
       {this->TemplateCombo, this->MaterialsCombo, this->TargetKindCombo, this->MethodCombo})
    QObject::connect(combo, SIGNAL(currentIndexChanged(int)), q, SLOT(updatePlanFromWidget()));
  QObject::connect(this->OpenCaseButton, SIGNAL(clicked()), q, SLOT(openCase()));
  QObject::connect(this->CancelButton, SIGNAL(clicked()), q, SLOT(cancel()));
  QObject::connect(this->SculptTargetButton, &QPushButton::clicked, q,
                   [this]()
                   {
                     this->logic()->AddTargetSkin(this->Plan);
                     this->Tools->setPlan(this->Plan);
                   });
  QObject::connect(this->Polling, SIGNAL(timeout()), q, SLOT(processLogicEvents()));
}

void qSlicerFaceToBoneModuleWidgetPrivate::makeTools()
{
  Q_Q(qSlicerFaceToBoneModuleWidget);
  auto* panel = new qFaceToBoneBrushPanel;
  panel->setObjectName("BrushPanel");
  this->SculptBoxLayout->insertWidget(0, panel);
  this->Tools = new qSlicerFaceToBoneTools(panel, q);
  vtkFaceToBoneSkinSculpting* tool = this->Tools->sculpting();
  QObject::connect(this->SculptUndoButton, &QPushButton::clicked, q, [tool]() { tool->Undo(); });
  QObject::connect(this->SculptRedoButton, &QPushButton::clicked, q, [tool]() { tool->Redo(); });
  QObject::connect(this->ClearMaskButton, &QPushButton::clicked, q,
                   [tool]() { tool->ClearMask(); });
  QObject::connect(this->InvertMaskButton, &QPushButton::clicked, q,
                   [tool]() { tool->InvertMask(); });
  QObject::connect(this->ColourTargetCheck, &QCheckBox::clicked, q,
                   [tool](bool on) { tool->SetColoured(on); });
  vtkFaceToBoneFragmentHands* hands = this->Tools->hands();
  QObject::connect(this->HandCheck, &QCheckBox::clicked, this->Tools,
                   &qSlicerFaceToBoneTools::moveByHand);
  QObject::connect(this->HandResetButton, &QPushButton::clicked, q, [hands]() { hands->Reset(); });
  QObject::connect(this->Tools, &qSlicerFaceToBoneTools::movementStated, q,
                   [this]() { this->logic()->UpdateStepStatuses(this->Plan); });
  QObject::connect(this->Tools, &qSlicerFaceToBoneTools::changed, q,
                   [this]() { this->showTools(); });
}

// --- Node to controls

void qSlicerFaceToBoneModuleWidgetPrivate::showTools()
{
  vtkFaceToBoneSkinSculpting* tool = this->Tools->sculpting();
  this->SculptUndoButton->setEnabled(tool->CanUndo());
  this->SculptRedoButton->setEnabled(tool->CanRedo());
  for (QWidget* control :
       {static_cast<QWidget*>(this->ClearMaskButton), static_cast<QWidget*>(this->InvertMaskButton),
        static_cast<QWidget*>(this->ColourTargetCheck)})
    control->setEnabled(tool->GetSession() != nullptr);
  this->ColourTargetCheck->setChecked(tool->IsColoured());
  this->SculptStatus->setText(this->Tools->sculptingText());
  vtkFaceToBoneFragmentHands* hands = this->Tools->hands();
  this->HandCheck->setEnabled(hands->IsMoving() || hands->GetObstacle().empty());
  this->HandCheck->setChecked(hands->IsMoving());
  this->HandResetButton->setEnabled(hands->IsMoving());
  this->HandStatus->setText(this->Tools->handsText());
}

void qSlicerFaceToBoneModuleWidgetPrivate::showInputs()
{
  OsteotomyNode* osteotomy = this->Plan->GetOsteotomyNode();
  TargetNode* target = this->Plan->GetTargetNode();
  this->CaseFolderEdit->setCurrentPath(QString::fromStdString(this->Plan->GetCaseFolder()));
  this->VolumeSelector->setCurrentNode(this->Plan->GetInputVolumeNode());
  this->LandmarksSelector->setCurrentNode(this->Plan->GetLandmarksNode());
  this->OsteotomySelector->setCurrentNode(osteotomy);
  this->TargetSelector->setCurrentNode(target);
  this->WarpFromSelector->setCurrentNode(target ? target->GetNodeReference(TargetNode::WarpFromRole)
                                                : nullptr);
  this->WarpToSelector->setCurrentNode(target ? target->GetNodeReference(TargetNode::WarpToRole)
                                              : nullptr);
}

void qSlicerFaceToBoneModuleWidgetPrivate::showOptions()
{
  OsteotomyNode* osteotomy = this->Plan->GetOsteotomyNode();
  TargetNode* target = this->Plan->GetTargetNode();
  this->SkinThicknessSpin->setValue(this->Plan->GetSkinThicknessMm());
  this->DensitySpin->setValue(this->Plan->GetMeshDensity());
  this->ReleaseMarginSpin->setValue(this->Plan->GetReleaseMarginMm());
  const QString materials = QString::fromStdString(this->Plan->GetMaterials());
  if (this->MaterialsCombo->findText(materials) < 0)
    this->MaterialsCombo->addItem(materials);
  this->MaterialsCombo->setCurrentIndex(this->MaterialsCombo->findText(materials));
  this->MethodCombo->setCurrentIndex(this->Plan->GetSelectedMethod());
  const bool has_fragment = osteotomy && osteotomy->GetNumberOfFragments() > 0;
  this->TemplateCombo->setEnabled(has_fragment);
  this->KerfSpin->setEnabled(has_fragment);
  if (has_fragment)
  {
    // the last entry stands for planes of the user's own
    const int known =
        this->TemplateCombo->findText(QString::fromStdString(osteotomy->GetNthFragmentTemplate(0)));
    this->TemplateCombo->setCurrentIndex(known < 0 ? this->TemplateCombo->count() - 1 : known);
    this->KerfSpin->setValue(osteotomy->GetNthFragmentKerfMm(0));
  }
  if (target)
  {
    this->TargetKindCombo->setCurrentIndex(target->GetKind());
    this->WarpRadiusSpin->setValue(target->GetWarpRadiusMm());
    this->MaskSpin->setValue(target->GetMaskMm());
  }
}

void qSlicerFaceToBoneModuleWidgetPrivate::showSteps()
{
  const bool running = this->logic() && this->logic()->IsRunning();
  for (const StepControls& step : this->steps())
  {
    step.Button->setEnabled(this->Plan && !running);
    step.Status->setText(this->Plan ? TextOfStatus(this->Plan->GetStepStatus(step.Step))
                                    : QString());
  }
  this->SculptTargetButton->setEnabled(this->Plan && !running);
  this->CancelButton->setEnabled(running);
  this->ProgressBar->setVisible(running);
  this->StatusLabel->setText(this->Plan ? QString::fromStdString(this->Plan->GetStatusText())
                                        : QString());
}

/// One row a fragment: its six coordinates and half the width of their 90 % intervals.
void qSlicerFaceToBoneModuleWidgetPrivate::showMovement()
{
  const int method = this->Plan->GetSelectedMethod();
  const std::vector<std::string> fragments = this->Plan->GetMovementFragments(method);
  this->MovementTable->setColumnCount(OsteotomyNode::Coordinate_Last);
  this->MovementTable->setRowCount(static_cast<int>(fragments.size()));
  QStringList rows, columns;
  for (int c = 0; c < OsteotomyNode::Coordinate_Last; ++c)
    columns << QString(OsteotomyNode::GetCoordinateAsString(c)) +
                   (c < OsteotomyNode::Pitch ? " [mm]" : QString::fromUtf8(" [\u00b0]"));
  for (int f = 0; f < this->MovementTable->rowCount(); ++f)
  {
    const std::string& fragment = fragments[static_cast<std::size_t>(f)];
    rows << QString::fromStdString(fragment);
    double movement[6] = {}, interval[2] = {};
    this->Plan->GetMovement(method, fragment, movement);
    for (int c = 0; c < OsteotomyNode::Coordinate_Last; ++c)
    {
      QString text = QString::number(movement[c], 'f', 1);
      if (this->Plan->GetMovementInterval(method, fragment, c, interval))
        text += QString::fromUtf8(" \u00b1 ") +
                QString::number(0.5 * (interval[1] - interval[0]), 'f', 1);
      this->MovementTable->setItem(f, c, new QTableWidgetItem(text));
    }
  }
  this->MovementTable->setHorizontalHeaderLabels(columns);
  this->MovementTable->setVerticalHeaderLabels(rows);
  QStringList sentences;
  const double error = this->Plan->GetFigure(
      std::string(PlanNode::GetSelectedMethodAsString(method)) + "/skin_error_mm/mean");
  if (!std::isnan(error))
    sentences << qSlicerFaceToBoneModuleWidget::tr("Mean distance of the predicted face from the "
                                                   "target: %1 mm.")
                     .arg(error, 0, 'f', 2);
  for (const auto& list :
       {this->Plan->GetFindings(), this->Plan->GetWarnings(), this->Plan->GetSuggestions()})
    for (const std::string& sentence : list)
      sentences << QString::fromStdString(sentence);
  this->FindingsLabel->setText(sentences.join("\n"));
}

// --- Controls to node

void qSlicerFaceToBoneModuleWidgetPrivate::takeOptions()
{
  MRMLNodeModifyBlocker blocker(this->Plan);
  this->Plan->SetCaseFolder(this->CaseFolderEdit->currentPath().toStdString());
  this->Plan->SetSkinThicknessMm(this->SkinThicknessSpin->value());
  this->Plan->SetMeshDensity(this->DensitySpin->value());
  this->Plan->SetReleaseMarginMm(this->ReleaseMarginSpin->value());
  this->Plan->SetMaterials(this->MaterialsCombo->currentText().toStdString());
  this->Plan->SetSelectedMethod(this->MethodCombo->currentIndex());
}

void qSlicerFaceToBoneModuleWidgetPrivate::takeCuts()
{
  OsteotomyNode* osteotomy = this->Plan->GetOsteotomyNode();
  if (!osteotomy || osteotomy->GetNumberOfFragments() == 0)
    return;
  MRMLNodeModifyBlocker blocker(osteotomy);
  osteotomy->SetNthFragmentKerfMm(0, this->KerfSpin->value());
  const bool is_template = this->TemplateCombo->currentIndex() < this->TemplateCombo->count() - 1;
  const std::string chosen =
      is_template ? this->TemplateCombo->currentText().toStdString() : std::string();
  if (chosen == osteotomy->GetNthFragmentTemplate(0))
    return;
  osteotomy->SetNthFragmentTemplate(0, chosen);
  if (is_template) // those of an earlier cut would be taken for edits of this one
  {
    osteotomy->RemoveNthFragmentPlaneNodeIDs(0);
    osteotomy->RemoveNthFragmentCurveNodeIDs(0);
  }
}

void qSlicerFaceToBoneModuleWidgetPrivate::takeTarget()
{
  TargetNode* target = this->Plan->GetTargetNode();
  if (!target)
    return;
  MRMLNodeModifyBlocker blocker(target);
  target->SetKind(this->TargetKindCombo->currentIndex());
  target->SetWarpRadiusMm(this->WarpRadiusSpin->value());
  target->SetMaskMm(this->MaskSpin->value());
  target->SetNodeReferenceID(TargetNode::WarpFromRole, IdOf(this->WarpFromSelector->currentNode()));
  target->SetNodeReferenceID(TargetNode::WarpToRole, IdOf(this->WarpToSelector->currentNode()));
}

// --- Panel

qSlicerFaceToBoneModuleWidget::qSlicerFaceToBoneModuleWidget(QWidget* parent)
    : Superclass(parent), d_ptr(new qSlicerFaceToBoneModuleWidgetPrivate(*this))
{
}

qSlicerFaceToBoneModuleWidget::~qSlicerFaceToBoneModuleWidget() = default;

void qSlicerFaceToBoneModuleWidget::setup()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  d->setupUi(this);
  this->Superclass::setup();
  d->Polling = new QTimer(this);
  d->Polling->setInterval(PollingInterval);
  for (const std::string& name : vtkSlicerFaceToBoneLogic::GetTemplateNames())
    d->TemplateCombo->addItem(QString::fromStdString(name));
  d->TemplateCombo->addItem(tr("planes of my own"));
  d->makeTools();
  d->connectControls();
  for (const StepControls& step : d->steps())
    QObject::connect(step.Button, &QPushButton::clicked, this,
                     [this, step]() { this->startStep(step.Step); });
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::enter()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  this->Superclass::enter();
  if (d->Tools)
    d->Tools->findView();
  if (!d->Plan && this->mrmlScene())
    this->setPlanNode(this->mrmlScene()->GetFirstNodeByClass("vtkMRMLFaceToBonePlanNode"));
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::exit()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (d->Tools)
    d->Tools->stop(); // the mouse is another module's now
  this->Superclass::exit();
}

bool qSlicerFaceToBoneModuleWidget::setEditedNode(vtkMRMLNode* node, QString, QString)
{
  if (!PlanNode::SafeDownCast(node))
    return false;
  this->setPlanNode(node);
  return true;
}

void qSlicerFaceToBoneModuleWidget::setMRMLScene(vtkMRMLScene* scene)
{
  this->qvtkReconnect(this->mrmlScene(), scene, vtkMRMLScene::EndCloseEvent, this,
                      SLOT(onSceneEndClose()));
  this->Superclass::setMRMLScene(scene);
}

void qSlicerFaceToBoneModuleWidget::onSceneEndClose()
{
  this->setPlanNode(nullptr);
}

void qSlicerFaceToBoneModuleWidget::setPlanNode(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  PlanNode* plan = PlanNode::SafeDownCast(node);
  if (plan == d->Plan || d->Showing)
    return;
  this->qvtkReconnect(d->Plan, plan, vtkCommand::ModifiedEvent, this, SLOT(updateWidgetFromMRML()));
  this->qvtkReconnect(d->Plan, plan, PlanNode::ProgressEvent, this, SLOT(updateProgress()));
  d->Plan = plan;
  if (d->logic())
    d->logic()->UpdateStepStatuses(plan);
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::addPlan(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (PlanNode* plan = PlanNode::SafeDownCast(node))
    d->logic()->CompletePlan(plan);
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::updateWidgetFromMRML()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (!d->Polling || d->Showing) // before setup, or within itself
    return;
  d->Showing = true;
  d->PlanSelector->setCurrentNode(d->Plan);
  if (d->Plan)
  {
    d->showInputs();
    d->showOptions();
    d->showMovement();
  }
  d->Tools->setLogic(d->logic());
  d->Tools->setPlan(d->Plan);
  d->showTools();
  d->showSteps();
  d->Showing = false;
}

void qSlicerFaceToBoneModuleWidget::updateProgress()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (!d->Plan)
    return;
  d->ProgressBar->setValue(static_cast<int>(1000 * d->Plan->GetProgress()));
  d->ProgressBar->setFormat(QString::fromStdString(d->Plan->GetProgressText()));
}

void qSlicerFaceToBoneModuleWidget::updatePlanFromWidget()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (!d->Plan || d->Showing)
    return;
  {
    MRMLNodeModifyBlocker blocker(d->Plan);
    d->takeOptions();
    d->takeCuts();
    d->takeTarget();
    d->logic()->UpdateStepStatuses(d->Plan);
    d->logic()->ShowSelectedMethod(d->Plan);
  }
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::setInputVolume(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (d->Plan && !d->Showing)
    d->Plan->SetInputVolumeNodeID(IdOf(node));
}

void qSlicerFaceToBoneModuleWidget::setLandmarks(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (d->Plan && !d->Showing)
    d->Plan->SetLandmarksNodeID(IdOf(node));
}

void qSlicerFaceToBoneModuleWidget::setOsteotomy(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (!d->Plan || !node || d->Showing)
    return;
  d->Plan->SetOsteotomyNodeID(node->GetID());
  d->logic()->CompletePlan(d->Plan);
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::setTarget(vtkMRMLNode* node)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (!d->Plan || !node || d->Showing)
    return;
  d->Plan->SetTargetNodeID(node->GetID());
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::openCase()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Case folder"));
  if (folder.isEmpty())
    return;
  if (PlanNode* plan = d->logic()->OpenCase(folder.toStdString()))
    this->setPlanNode(plan);
  else
    d->StatusLabel->setText(QString::fromStdString(d->logic()->GetErrorText()));
}

void qSlicerFaceToBoneModuleWidget::startStep(int step)
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  // pictures are drawn in the thread that draws the views
  if (d->Plan && step == PlanNode::Report)
    d->logic()->Do(d->Plan, step);
  else if (d->Plan && d->logic()->Start(d->Plan, step))
    d->Polling->start();
  this->updateWidgetFromMRML();
}

void qSlicerFaceToBoneModuleWidget::cancel()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  d->logic()->Cancel();
}

void qSlicerFaceToBoneModuleWidget::processLogicEvents()
{
  Q_D(qSlicerFaceToBoneModuleWidget);
  if (d->logic()->ProcessEvents())
    return;
  d->Polling->stop();
  this->updateWidgetFromMRML();
}
