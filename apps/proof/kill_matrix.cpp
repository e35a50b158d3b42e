#include "apps/proof/kill_matrix.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/gnomon/console.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/text.h"
#include "geometry/parallel.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;
using laws::Domain;
using laws::Law;
using laws::Mutant;
using Cell = KillMatrix::Cell;

constexpr std::uint32_t most_cases = 1000;
constexpr std::uint32_t cases_to_see_what_is_asked = 20;

bool asks(const Law& law, laws::Part part) {
  const auto asked = std::make_shared<std::atomic<bool>>(false);
  const auto subject = laws::with_part_watched(part, [=] { *asked = true; });
  law.run(Domain::random, {1, cases_to_see_what_is_asked, subject});
  return *asked;
}

Cell cell(const Law& law, const Mutant& mutant, std::uint64_t seed) {
  if (!asks(law, mutant.part)) return {};
  Cell result{true, std::nullopt};
  std::uint32_t drawn = 0;
  for (const Domain domain : {Domain::random, Domain::near_degenerate}) {
    const laws::Outcome outcome = law.run(domain, {seed, most_cases, mutant.subject});
    drawn += outcome.cases;
    if (outcome.counterexample) return {true, drawn};
  }
  return result;
}

std::size_t index_of(const KillMatrix& matrix, const std::string& key) {
  return std::size_t(std::ranges::find(matrix.laws, key) - matrix.laws.begin());
}

bool is_caught(const KillMatrix& matrix, std::size_t mutant, const std::string& key) {
  const std::size_t law = index_of(matrix, key);
  return law < matrix.laws.size() && matrix.cells[mutant][law].caught;
}

}  // namespace

KillMatrix kill_matrix(const std::vector<Law>& laws, std::uint64_t seed, const Effort& effort) {
  KillMatrix matrix{{}, laws::all_mutants(), {}};
  for (const Law& law : laws) matrix.laws.push_back(law.key);
  matrix.cells.assign(matrix.mutants.size(), std::vector<Cell>(laws.size()));
  const std::size_t cells = matrix.mutants.size() * laws.size();
  Progress progress("mutants tried", cells,
                    effort.shows_progress ? Progress::Visibility::automatic : Progress::Visibility::hidden);
  for_all(cells, thread_count(effort.threads), [&](std::size_t i, std::size_t) {
    const std::size_t mutant = i / laws.size(), law = i % laws.size();
    matrix.cells[mutant][law] = cell(laws[law], matrix.mutants[mutant], seed);
    progress.step();
  });
  return matrix;
}

std::vector<std::string> survivors(const KillMatrix& matrix) {
  std::vector<std::string> names;
  for (std::size_t m = 0; m < matrix.mutants.size(); ++m) {
    const Mutant& mutant = matrix.mutants[m];
    const auto missed = [&](const std::string& key) { return !is_caught(matrix, m, key); };
    if (std::ranges::any_of(mutant.caught_by, missed)) names.push_back(mutant.name);
  }
  return names;
}

std::string matrix_text(const KillMatrix& matrix) {
  std::vector<TextRow> rows{{"mutant", "mistake", "caught by a law at its n-th case; - not caught"}};
  for (std::size_t m = 0; m < matrix.mutants.size(); ++m) {
    std::string caught;
    for (std::size_t l = 0; l < matrix.laws.size(); ++l) {
      const Cell& found = matrix.cells[m][l];
      if (!found.asks) continue;
      caught +=
          (caught.empty() ? "" : "  ") + matrix.laws[l] + ' ' + (found.caught ? std::to_string(*found.caught) : "-");
    }
    rows.push_back({matrix.mutants[m].name, matrix.mutants[m].does, caught});
  }
  return aligned(rows, 0);
}

Json matrix_json(const KillMatrix& matrix) {
  Json document{{"schema", "gnomon/mutants/1"}, {"most_cases", most_cases}, {"mutants", Json::array()}};
  for (std::size_t m = 0; m < matrix.mutants.size(); ++m) {
    Json laws = Json::object();
    for (std::size_t l = 0; l < matrix.laws.size(); ++l) {
      const Cell& found = matrix.cells[m][l];
      if (found.asks) laws[matrix.laws[l]] = found.caught ? Json(*found.caught) : Json(nullptr);
    }
    const Mutant& mutant = matrix.mutants[m];
    document["mutants"].push_back(
        {{"name", mutant.name}, {"does", mutant.does}, {"caught_by", mutant.caught_by}, {"laws", laws}});
  }
  return document;
}

}  // namespace gnomon
