#include "viz/display.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "viz/picture.h"

namespace gnomon::viz {
namespace {

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};

[[noreturn]] void fail(const std::string& why) {
  throw NoDisplayError("no display" + why +
                       ": run under `xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" gnomon render ...` "
                       "(Debian packages xvfb, xauth, libgl1-mesa-dri)");
}

}  // namespace

void require_display() {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') fail("");
  const std::unique_ptr<Display, CloseDisplay> display(XOpenDisplay(name));
  if (!display) fail(" (nothing answers at DISPLAY=" + std::string(name) + ")");
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (XQueryExtension(display.get(), "GLX", &opcode, &event, &error) == 0) {
    fail(" (DISPLAY=" + std::string(name) + " knows no OpenGL)");
  }
}

}  // namespace gnomon::viz
