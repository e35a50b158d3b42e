#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gnomon::report {

/// Times of one thing, measured again and again, in seconds.
struct Seconds {
  double median = 0;
  double least = 0;
  double most = 0;
};

/// How thoroughly to measure.
struct Care {
  std::size_t runs = 5;   ///< after one that warms up
  double seconds = 0.02;  ///< that a run takes at least
};

/// The processor time of this thread so far, in seconds.
double thread_seconds();

/// The median, the least and the most.
/// Requires: at least one.
Seconds seconds_of(std::vector<double> runs);

/// Processor time per result. `pass` works out `results` results; a run repeats it until it has taken long enough.
Seconds time_per_result(const std::function<void()>& pass, std::size_t results, const Care& care);

/// By how much the process grows, at its highest, while something is done: in bytes of resident memory.
/// Returns: 0 where the system does not tell.
std::size_t memory_growth(const std::function<void()>& work);

}  // namespace gnomon::report
