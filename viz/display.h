#pragma once

namespace gnomon::viz {

/// Makes sure that VTK can open a window, because it ends the process if it cannot.
///
/// Throws: NoDisplayError, if DISPLAY is not set, names no X server that answers, or one without OpenGL.
void require_display();

}  // namespace gnomon::viz
