#include "apps/proof/report/measurement.h"

#include <algorithm>
#include <cmath>

namespace gnomon::report {

void Errors::add(double error, double truth) {
  ++results;
  rms += error * error;
  mean += truth;
  largest = std::max(largest, truth);
  if (truth != 0) {
    ++positive_;
    relative_rms += error * error / (truth * truth);
  }
  most = std::max(most, error);
}

void Errors::finish() {
  if (results == 0) return;
  rms = std::sqrt(rms / static_cast<double>(results));
  mean /= static_cast<double>(results);
  if (positive_ > 0) relative_rms = std::sqrt(relative_rms / static_cast<double>(positive_));
}

}  // namespace gnomon::report
