#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;
class vtkStringOutputWindow;

namespace gnomon::viz {

/// While this object lives, what VTK would print is kept here instead.
class QuietVtk {
 public:
  QuietVtk();
  ~QuietVtk();
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

  /// VTK's words so far on one line; empty if it had none.
  std::string words() const;

 private:
  int verbosity_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<vtkStringOutputWindow> collected_;
};

}  // namespace gnomon::viz
