#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/proof/law_trials.h"
#include "apps/proof/laws/mutants.h"

namespace gnomon {

/// Which law catches which mutant.
struct KillMatrix {
  /// What a law makes of a mutant.
  struct Cell {
    bool asks = false;                    ///< the law asks the broken function
    std::optional<std::uint32_t> caught;  ///< cases drawn until the mistake showed
  };

  std::vector<std::string> laws;  ///< keys
  std::vector<laws::Mutant> mutants;
  std::vector<std::vector<Cell>> cells;  ///< of every mutant, for every law
};

/// Tries every law on every mutant of a function that it asks, for at most 1,000 cases of either domain, random ones
/// first.
///
/// Returns: the same on any number of threads.
KillMatrix kill_matrix(const std::vector<laws::Law>& laws, std::uint64_t seed, const Effort& effort);

/// The mutants that no law catches, or that one of those meant to catch them does not; names.
std::vector<std::string> survivors(const KillMatrix& matrix);

/// The matrix as text: a line for each mutant and each law that asks what it breaks.
std::string matrix_text(const KillMatrix& matrix);

/// The document of schema gnomon/mutants/1.
nlohmann::ordered_json matrix_json(const KillMatrix& matrix);

}  // namespace gnomon
