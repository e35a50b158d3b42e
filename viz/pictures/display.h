#pragma once

#include <optional>
#include <string>

#include "viz/pictures/virtual_display.h"

namespace gnomon::viz {

/// A display on which VTK can open a window, because VTK ends the process if it cannot: the one that DISPLAY names or,
/// if that has no OpenGL or is not there, a virtual one. While the object of a virtual one lives, DISPLAY names it.
class Display {
 public:
  /// Throws: NoDisplayError telling what to install.
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

 private:
  /// Lets DISPLAY be what it was.
  void restore();

  std::optional<VirtualDisplay> virtual_;
  std::optional<std::string> before_;  ///< DISPLAY, where a virtual one has taken its place
};

}  // namespace gnomon::viz
