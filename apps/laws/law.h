#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/laws/subject.h"

namespace gnomon::laws {

/// Where a law's cases are drawn from.
enum class Domain {
  random,           ///< small integers, so that ties are common
  near_degenerate,  ///< the same bent toward degeneracy: one ulp off, far from the origin, needles, huge ratios of
                    ///< scale
};

/// The domain's name as scripts read it.
constexpr std::string_view name(Domain domain) {
  return domain == Domain::random ? "random" : "near_degenerate";
}

/// How a law is run.
struct Parameters {
  std::uint64_t seed = 1;
  std::uint32_t cases = 1000;  ///< cases in which the premise has to hold before a law is believed
  Subject subject = {};        ///< what is put to the test
};

/// What running a law showed.
struct Outcome {
  std::uint32_t cases = 0;         ///< cases drawn
  std::uint32_t premise_held = 0;  ///< cases to which the law applied
  std::optional<std::string> counterexample;

  /// Share of the cases to which the law applied; 0 if none was drawn.
  double premise_share() const { return cases == 0 ? 0 : static_cast<double>(premise_held) / cases; }
};

/// One numbered statement of the theory, and how it is put to the test.
struct Law {
  std::string key;        ///< "S4"
  std::string source;     ///< "[CF91] Theorem 2"
  std::string statement;  ///< one sentence

  /// Draws cases until the premise held in as many as asked (or in too few of 20 times as many), or one failed.
  /// The outcome depends on the arguments alone. A failing case is shrunk before it is told.
  std::function<Outcome(Domain, const Parameters&)> run;
};

/// Every law there is, those of the plane first.
std::vector<Law> all_laws();

}  // namespace gnomon::laws
