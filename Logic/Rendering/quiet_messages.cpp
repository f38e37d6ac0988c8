#include <Rendering/quiet_messages.hpp>

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <mutex>

namespace f2b
{

namespace
{

class CollectingOutput : public vtkOutputWindow
{
public:
  static CollectingOutput* New();

  void DisplayText(const char*) override {}

  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_first_error.empty() && text)
    {
      m_first_error = text;
    }
  }

  std::string first_error() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_first_error;
  }

private:
  mutable std::mutex m_mutex;
  std::string m_first_error;
};

vtkStandardNewMacro(CollectingOutput);

} // namespace

struct QuietMessages::Implementation
{
  vtkSmartPointer<vtkOutputWindow> previous;
  vtkSmartPointer<CollectingOutput> collecting;
  vtkLogger::Verbosity previous_verbosity = vtkLogger::GetCurrentVerbosityCutoff();
};

QuietMessages::QuietMessages() : m_implementation(std::make_unique<Implementation>())
{
  m_implementation->previous = vtkOutputWindow::GetInstance();
  m_implementation->collecting = vtkSmartPointer<CollectingOutput>::New();
  vtkOutputWindow::SetInstance(m_implementation->collecting);
  // VTK's macros also log each message to stderr, whatever the output window does.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

QuietMessages::~QuietMessages()
{
  vtkLogger::SetStderrVerbosity(m_implementation->previous_verbosity);
  vtkOutputWindow::SetInstance(m_implementation->previous);
}

std::string QuietMessages::first_error() const
{
  std::string text = m_implementation->collecting->first_error();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace f2b
