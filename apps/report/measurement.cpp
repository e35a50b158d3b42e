#include "apps/report/measurement.h"

#include <algorithm>
#include <cmath>

namespace gnomon::report {

void Errors::add(double error, double truth) {
  ++results;
  rms += error * error;
  mean += truth;
  most = std::max(most, error);
}

void Errors::finish() {
  if (results == 0) return;
  rms = std::sqrt(rms / static_cast<double>(results));
  mean /= static_cast<double>(results);
}

}  // namespace gnomon::report
