#include "viz/vtk/quiet_vtk.h"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkStringOutputWindow.h>

#include <sstream>

namespace gnomon::viz {

QuietVtk::QuietVtk()
    : verbosity_(vtkLogger::GetCurrentVerbosityCutoff()),
      before_(vtkOutputWindow::GetInstance()),
      collected_(vtkSmartPointer<vtkStringOutputWindow>::New()) {
  vtkOutputWindow::SetInstance(collected_);
  // VTK's log repeats on stderr what the output window is told.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

QuietVtk::~QuietVtk() {
  vtkOutputWindow::SetInstance(before_);
}

std::string QuietVtk::words() const {
  std::istringstream text(collected_->GetOutput());
  std::string line;
  for (std::string word; text >> word;) line.append(line.empty() ? "" : " ").append(word);
  return line;
}

}  // namespace gnomon::viz
