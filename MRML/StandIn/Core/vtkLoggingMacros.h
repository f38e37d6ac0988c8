#pragma once

#include <vtkObject.h>
#include <vtkOutputWindow.h>

/// A message that is neither a warning nor an error: goes to VTK's output window.
#ifndef vtkInfoMacro
#define vtkInfoMacro(x)                                                                            \
  {                                                                                                \
    std::ostringstream infoText;                                                                   \
    infoText << this->GetClassName() << ": " x << "\n";                                            \
    vtkOutputWindow::GetInstance()->DisplayText(infoText.str().c_str());                           \
  }
#endif
