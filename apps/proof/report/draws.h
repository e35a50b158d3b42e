#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace gnomon::report {

/// Random numbers that are the same on every system for the same seed.
class Draws {
 public:
  explicit Draws(std::size_t seed) : engine_(static_cast<std::mt19937::result_type>(seed)) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }

  /// Requires: n is positive.
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937 engine_;
};

}  // namespace gnomon::report
