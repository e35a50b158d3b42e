#pragma once

#include <string>

namespace gnomon {

/// A rational number: correctly rounded to the nearest double, and exactly, as text ("3/2").
struct ExactNumber {
  double nearest = 0;
  std::string exact = "0";
};

}  // namespace gnomon
