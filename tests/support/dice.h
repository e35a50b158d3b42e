#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include <rapidcheck.h>

namespace gnomon::test_support {

/// What a test draws, from a seed: its own, or one that RapidCheck draws and prints.
class Dice {
 public:
  Dice() : engine_(*rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()))) {}
  explicit Dice(std::uint32_t seed) : engine_(seed) {}

  int draw(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
  }
  bool once_in(int n) { return draw(0, n - 1) == 0; }

  template <class Range>
  const auto& one_of(const Range& range) {
    return range[static_cast<std::size_t>(draw(0, static_cast<int>(range.size()) - 1))];
  }

 private:
  std::mt19937 engine_;
};

}  // namespace gnomon::test_support
