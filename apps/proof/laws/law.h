#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/subject.h"

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

/// What the theory says of a statement.
enum class Standing {
  holds,    ///< it is true of every case
  refuted,  ///< it has been said, but is false: there are counterexamples
};

/// How a law is run.
struct Parameters {
  std::uint64_t seed = 1;
  std::uint32_t cases = 1000;   ///< cases in which the premise has to hold before a law is believed
  Subject subject = {};         ///< what is put to the test
  std::uint64_t stream = 0;     ///< which of the independent streams of cases of one seed
  bool counts_regions = false;  ///< fill Outcome::census
};

/// What running a law showed.
struct Outcome {
  std::uint32_t cases = 0;         ///< cases drawn
  std::uint32_t premise_held = 0;  ///< cases to which the law applied
  std::uint32_t refuting = 0;      ///< of a refuted claim: cases of which it is false
  /// A case that breaks the law; of a refuted claim, one in which the subject contradicts the definition.
  std::optional<std::string> counterexample;
  std::optional<std::string> refutation;  ///< of a refuted claim: the first case of which it is false
  std::optional<Example> example;  ///< the counterexample, or else the refutation, if it can be written as a scene
  Census census;

  /// Share of the cases to which the law applied; 0 if none was drawn.
  double premise_share() const { return cases == 0 ? 0 : static_cast<double>(premise_held) / cases; }
};

/// One numbered statement of the theory, and how it is put to the test.
struct Law {
  std::string key;        ///< "S4"; "S6_any" is S6 of pairs in any position
  std::string source;     ///< "[CF91] Theorem 2"
  std::string statement;  ///< one sentence; of a refuted claim, the claim

  /// Draws cases until the premise held in as many as asked (or in too few of 20 times as many), or one failed.
  /// The outcome depends on the arguments alone. A failing case is shrunk before it is told.
  std::function<Outcome(Domain, const Parameters&)> run;

  Standing standing = Standing::holds;

  /// Of a refuted claim: runs the cases that are known to refute it. Each one does if Outcome::refuting is
  /// Outcome::cases.
  std::function<Outcome(const Subject&)> known = {};
};

/// Every law there is, those of the plane first.
std::vector<Law> all_laws();

/// The keys of all numbered statements of the theory, in its order.
std::vector<std::string> all_keys();

}  // namespace gnomon::laws
