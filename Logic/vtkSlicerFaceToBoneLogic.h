#ifndef __vtkSlicerFaceToBoneLogic_h
#define __vtkSlicerFaceToBoneLogic_h

#include "vtkSlicerFaceToBoneModuleLogicExport.h"

#include <vtkSlicerModuleLogic.h>

#include <memory>
#include <string>
#include <vector>

class vtkMRMLFaceToBonePlanNode;
namespace f2b
{
struct CaseOutlook;
}

/// \brief Plans on nodes: one method per step, no mathematics.
///
/// A plan node names its case folder, its osteotomy and its target; every step reads what these
/// nodes say, works on files of the folder, and brings the nodes up to the new files. The folder's
/// `case.mrml` is written in the same change as the files, so scene and files agree whenever the
/// program is killed. A step that fails leaves folder and nodes as they were but for the plan's
/// status: code and one sentence.
///
/// `Start` works in a thread of its own: the host calls `ProcessEvents` from its event loop, some
/// ten times a second, until it says that nothing is running. All other methods are for the thread
/// that owns the scene. One step runs at a time.
class VTK_SLICER_FACETOBONE_MODULE_LOGIC_EXPORT vtkSlicerFaceToBoneLogic
    : public vtkSlicerModuleLogic
{
public:
  static vtkSlicerFaceToBoneLogic* New();
  vtkTypeMacro(vtkSlicerFaceToBoneLogic, vtkSlicerModuleLogic);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    StepFinishedEvent = 21750 ///< call data: the plan node; its status says how it ended
  };

  /// A new plan with a new osteotomy and target, at the defaults of the case file.
  vtkMRMLFaceToBonePlanNode* AddPlan(const std::string& name);
  /// The plan that a case file (JSON) asks for, without a folder yet. Null and GetErrorText where
  /// the file cannot be used.
  vtkMRMLFaceToBonePlanNode* AddPlanFromFile(const std::string& fileName);
  /// The plan of a case folder with its nodes. Null and GetErrorText where it is none.
  vtkMRMLFaceToBonePlanNode* OpenCase(const std::string& folder);

  /// Adds `case.mrml` to a change of a case folder that is about to be committed, for programs that
  /// do their steps without nodes: a CommitHook on nodes of its own, for any thread. Throws Error.
  static void WriteCaseScene(const f2b::CaseOutlook& files);

  /// Each does one step of a plan and returns whether it was done. Settings and what was edited on
  /// nodes (cut planes, landmarks, a target's displacements) go into the case first.
  bool Segment(vtkMRMLFaceToBonePlanNode* plan); ///< begins the folder
  bool Cut(vtkMRMLFaceToBonePlanNode* plan);
  bool Mesh(vtkMRMLFaceToBonePlanNode* plan);
  bool Target(vtkMRMLFaceToBonePlanNode* plan);
  bool Suggest(vtkMRMLFaceToBonePlanNode* plan);
  bool Plan(vtkMRMLFaceToBonePlanNode* plan);
  bool Predict(vtkMRMLFaceToBonePlanNode* plan);
  bool Report(vtkMRMLFaceToBonePlanNode* plan);
  /// Segment to Report, all or none.
  bool Run(vtkMRMLFaceToBonePlanNode* plan);
  /// The forward problem of the plan's stated movement for another engine, in the folder or a file
  /// outside; changes nothing else.
  /// \param format  calculix, febio or vtu
  bool Export(vtkMRMLFaceToBonePlanNode* plan, const std::string& format,
              const std::string& fileName, bool splitPrisms, int increments);

  /// Step number of Run, beside the plan node's own.
  static constexpr int RunStep = 100;
  bool Do(vtkMRMLFaceToBonePlanNode* plan, int step);

  /// Begins a step in a thread; false where one is running or cannot be begun (see the status).
  bool Start(vtkMRMLFaceToBonePlanNode* plan, int step);
  /// Tells progress, publishes what is done, invokes StepFinishedEvent. Whether a step runs still.
  bool ProcessEvents();
  bool IsRunning();
  /// The running step ends soon, with status code 4.
  void Cancel();

  /// Gives a plan what it lacks: an osteotomy with one fragment, a target.
  void CompletePlan(vtkMRMLFaceToBonePlanNode* plan);
  /// Shows face and fragments by the plan's selected method, and hides those by the other.
  void ShowSelectedMethod(vtkMRMLFaceToBonePlanNode* plan);
  /// Names that an osteotomy's fragments may have as their template.
  static std::vector<std::string> GetTemplateNames();

  /// Marks steps as stale whose settings the nodes now state otherwise than the folder's case.json.
  void UpdateStepStatuses(vtkMRMLFaceToBonePlanNode* plan);
  /// A target skin to sculpt on: the reference skin with zero `displacement` and `weight` 1. Does
  /// nothing where there is one.
  bool AddTargetSkin(vtkMRMLFaceToBonePlanNode* plan);

  /// Whether nodes get the data of their files; the command line does without.
  vtkSetMacro(ReadData, bool);
  vtkGetMacro(ReadData, bool);
  /// Where settings come from, for messages: a file's name, or words.
  vtkSetMacro(SettingsSource, std::string);
  vtkGetMacro(SettingsSource, std::string);
  /// Of the last method that has no plan to keep them on.
  vtkGetMacro(ErrorCode, int);
  vtkGetMacro(ErrorText, std::string);

protected:
  vtkSlicerFaceToBoneLogic();
  ~vtkSlicerFaceToBoneLogic() override;

  void RegisterNodes() override;

private:
  vtkSlicerFaceToBoneLogic(const vtkSlicerFaceToBoneLogic&) = delete;
  void operator=(const vtkSlicerFaceToBoneLogic&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;

  bool ReadData = true;
  std::string SettingsSource = "the plan";
  int ErrorCode = 0;
  std::string ErrorText;
};

#endif
