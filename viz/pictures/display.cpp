#include "viz/pictures/display.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <memory>

#include "gnomon/picture.h"

namespace gnomon::viz {
namespace {

struct CloseDisplay {
  void operator()(::Display* display) const { XCloseDisplay(display); }
};

/// What VTK would miss there; empty if it can draw.
std::string trouble_with(const char* name) {
  if (name == nullptr || *name == '\0') return "DISPLAY is not set";
  const std::unique_ptr<::Display, CloseDisplay> display(XOpenDisplay(name));
  if (!display) return "nothing answers at DISPLAY=" + std::string(name);
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (XQueryExtension(display.get(), "GLX", &opcode, &event, &error) != 0) return {};
  return "DISPLAY=" + std::string(name) + " knows no OpenGL";
}

[[noreturn]] void fail(const std::string& why) {
  throw NoDisplayError("no display to draw a PNG on: " + why +
                       "; install the Debian packages xvfb and libgl1-mesa-dri (apt-get install xvfb libgl1-mesa-dri), "
                       "and a virtual one is started by itself; .svg, .gltf and .html need none");
}

}  // namespace

Display::Display() {
  const std::string trouble = trouble_with(std::getenv("DISPLAY"));
  if (trouble.empty()) return;
  try {
    virtual_.emplace();
  } catch (const std::runtime_error& error) {
    fail(trouble + ", and " + error.what());
  }
  if (const char* name = std::getenv("DISPLAY")) before_ = name;
  ::setenv("DISPLAY", virtual_->name().c_str(), 1);
  if (const std::string still = trouble_with(virtual_->name().c_str()); !still.empty()) {
    restore();
    fail(still);
  }
}

Display::~Display() {
  restore();
}

void Display::restore() {
  if (!virtual_) return;
  before_ ? ::setenv("DISPLAY", before_->c_str(), 1) : ::unsetenv("DISPLAY");
}

}  // namespace gnomon::viz
