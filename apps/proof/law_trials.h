#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "apps/proof/laws/law.h"

namespace gnomon {

/// What is to be tried of every law.
struct TrialOptions {
  std::uint32_t cases = 1000;  ///< in which the premise holds: half of them random, half nearly degenerate
  std::uint64_t seed = 1;
  laws::Subject subject = {};
  std::string mutant = {};  ///< the name of the mistake that the subject has; empty: none
};

enum class LawStatus {
  holds,           ///< in every case
  refuted,         ///< a false claim, and its counterexamples refute it
  counterexample,  ///< a law failed
  not_refuted,     ///< a false claim that its counterexamples do not refute
};

/// The status as scripts read it.
std::string_view name(LawStatus status);

/// What the trial of one law showed.
struct LawTrial {
  laws::Law law;
  laws::Outcome outcome;  ///< of all cases; with the counterexample found first, if any
  laws::Outcome known;    ///< of a refuted claim: of the cases that are known to refute it
  LawStatus status = LawStatus::holds;
  std::uint32_t cases_to_failure = 0;  ///< so many asked for, with the same seed, show the counterexample again
  double seconds = 0;                  ///< processor time

  bool failed() const { return status == LawStatus::counterexample || status == LawStatus::not_refuted; }
};

/// Tries the laws, in order. The regions of the first 500 cases of either domain are counted.
///
/// Returns: the same for the same options, on any number of threads, but for the seconds.
std::vector<LawTrial> law_trials(const std::vector<laws::Law>& laws, const TrialOptions& options, const Effort& effort);

}  // namespace gnomon
