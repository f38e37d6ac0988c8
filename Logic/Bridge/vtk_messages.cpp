#include "Bridge/vtk_messages.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace f2b
{
namespace
{

class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { error = true; }

  bool error = false;
};
vtkStandardNewMacro(Listener);

} // namespace

struct VtkMessages::Implementation
{
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkSmartPointer<Listener> listener = vtkSmartPointer<Listener>::New();
  vtkLogger::Verbosity verbosity_before = vtkLogger::GetCurrentVerbosityCutoff();
};

VtkMessages::VtkMessages() : m_implementation(std::make_unique<Implementation>())
{
  vtkOutputWindow::SetInstance(m_implementation->listener);
  // VTK's macros also log to stderr, whatever the output window does
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages()
{
  vtkLogger::SetStderrVerbosity(m_implementation->verbosity_before);
  vtkOutputWindow::SetInstance(m_implementation->before);
}

bool VtkMessages::error() const
{
  return m_implementation->listener->error;
}

} // namespace f2b
