#pragma once

#include <sys/types.h>

#include <string>

namespace gnomon::viz {

/// An X server without a screen (Xvfb), which ends with this object, and with the process at the latest.
class VirtualDisplay {
 public:
  /// Throws: std::runtime_error saying why there is none: Xvfb is not installed, or does not start.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// What DISPLAY has to be, for instance ":99".
  const std::string& name() const { return name_; }

 private:
  pid_t server_ = -1;
  std::string name_;
};

}  // namespace gnomon::viz
