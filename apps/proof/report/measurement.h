#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/truth.h"

namespace gnomon::report {

/// How far the results of a method are off.
struct Errors {
  std::size_t results = 0;
  double rms = 0;
  double relative_rms = 0;  ///< of the errors over the true values, where these are not 0
  double most = 0;
  double mean = 0;                ///< of the true values
  double largest = 0;             ///< true value
  std::optional<double> bound;    ///< the largest that was claimed; nothing if none was
  std::size_t outside_bound = 0;  ///< results that are farther off than they claim
  std::size_t wrong_regions = 0;

  /// Takes in one more result. Until finish() the root mean squares are sums of squares, and `mean` is a sum.
  void add(double error, double truth);

  /// Turns the sums into means.
  void finish();

 private:
  std::size_t positive_ = 0;  ///< results whose truth is not 0
};

/// What one method took for one task, and how right it was.
struct Measurement {
  std::string task;
  std::string method;
  std::size_t size = 0;     ///< blockers, vertices per polygon: the task says
  std::size_t samples = 0;  ///< points on the light or on the receiver; 0 for a method that samples nothing
  Seconds seconds;          ///< per result
  Errors errors;
  std::size_t bytes = 0;  ///< growth of the process
};

}  // namespace gnomon::report
