#pragma once

#include "Case/case_folder.hpp"
#include "Core/progress.hpp"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <stdexcept>
#include <string>

class vtkMRMLFaceToBonePlanNode;
class vtkMRMLScene;
class vtkSlicerFaceToBoneLogic;

/// How does a command do its step through the module's logic?
namespace f2b
{

/// What the logic says of a step that failed, with the exit code.
class StepFailure : public std::runtime_error
{
public:
  StepFailure(const std::string& text, int code) : std::runtime_error(text), m_code(code) {}
  int code() const { return m_code; }

private:
  int m_code;
};

/// A scene with one plan, of which nodes get no data: files are for the steps to read.
class CaseClient
{
public:
  explicit CaseClient(Progress progress);
  ~CaseClient();
  CaseClient(const CaseClient&) = delete;
  CaseClient& operator=(const CaseClient&) = delete;

  /// The plan of a case file, for a new case folder. Throws StepFailure.
  vtkMRMLFaceToBonePlanNode* begin(const std::string& case_file, const std::string& folder);
  /// The plan of a case folder. Throws StepFailure.
  vtkMRMLFaceToBonePlanNode* open(const std::string& folder);
  /// The case's scene and all of its data as one file that Slicer opens; the file appears whole or
  /// not at all. Throws Error where it cannot be written.
  /// \param file  ends in .mrb; empty: export.mrb in the case
  void write_bundle(const std::string& folder, const Path& file);
  vtkSlicerFaceToBoneLogic* logic() const { return m_logic; }
  /// Throws StepFailure where a step says that it was not done.
  void require(bool done) const;

private:
  vtkMRMLFaceToBonePlanNode* watched(vtkMRMLFaceToBonePlanNode* plan);

  Progress m_progress;
  vtkNew<vtkMRMLScene> m_scene;
  vtkNew<vtkSlicerFaceToBoneLogic> m_logic;
  vtkNew<vtkCallbackCommand> m_callback;
};

} // namespace f2b
