#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/proof/law_trials.h"

namespace gnomon {

/// The table of statements: key, statement, cases, share of premises, status, seconds.
std::string trials_table(const std::vector<LawTrial>& trials);

/// How many of the counted cases had how many regions, and where their points lay.
std::string census_table(const std::vector<LawTrial>& trials);

/// The counterexample of a refuted claim or of a law that failed, as text, and the command that shows the latter again.
///
/// Requires: one of the two.
std::string counterexample_text(const LawTrial& trial, const TrialOptions& options);

/// The case that `counterexample_text` tells, as a scene; nothing where it cannot be one.
const std::optional<laws::Example>& shown_example(const LawTrial& trial);

/// The document of schema gnomon/theorems/1.
nlohmann::ordered_json trials_json(const std::vector<LawTrial>& trials, const TrialOptions& options);

}  // namespace gnomon
