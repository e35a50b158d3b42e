#include "apps/proof/law_trials.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <limits>
#include <utility>

#include "apps/gnomon/console.h"
#include "apps/gnomon/point_batches.h"
#include "geometry/parallel.h"

namespace gnomon {
namespace {

using laws::Domain;
using laws::Law;
using laws::Outcome;

/// A piece of a law's cases is a stream of its own, so that pieces may be run in any order, and the cases of the first
/// pieces are the same however many are asked for.
constexpr std::uint32_t cases_per_piece = 100;
constexpr std::uint32_t counted_pieces = 5;

constexpr std::array domains{Domain::random, Domain::near_degenerate};

struct Piece {
  std::size_t law = 0;
  std::size_t domain = 0;
  std::uint32_t number = 0;
  std::uint32_t cases = 0;
  Outcome outcome = {};
  double seconds = 0;
};

std::vector<Piece> pieces(std::size_t laws, std::uint32_t cases) {
  std::vector<Piece> all;
  const std::array shares{cases - cases / 2, cases / 2};
  for (std::size_t law = 0; law < laws; ++law) {
    for (std::size_t domain = 0; domain < domains.size(); ++domain) {
      std::uint32_t number = 0;
      for (std::uint32_t left = shares[domain]; left > 0; ++number) {
        const std::uint32_t some = std::min(left, cases_per_piece);
        all.push_back({law, domain, number, some});
        left -= some;
      }
    }
  }
  return all;
}

/// Processor time of this thread: what others do meanwhile does not count.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void run(Piece& piece, const Law& law, const TrialOptions& options) {
  const double start = thread_seconds();
  piece.outcome = law.run(domains[piece.domain],
                          {options.seed, piece.cases, options.subject, piece.number, piece.number < counted_pieces});
  piece.seconds = thread_seconds() - start;
}

void add(Outcome& sum, const Outcome& more) {
  sum.cases += more.cases;
  sum.premise_held += more.premise_held;
  sum.refuting += more.refuting;
  sum.census += more.census;
  if (!sum.counterexample && more.counterexample) {
    sum.counterexample = more.counterexample;
    sum.example = more.example;
  }
  if (!sum.refutation && more.refutation) sum.refutation = more.refutation;
  if (!sum.example && more.example) sum.example = more.example;
}

/// For every law and domain, the number of the lowest piece that failed.
using FirstFailures = std::vector<std::array<std::atomic<std::uint32_t>, 2>>;

void lower(std::atomic<std::uint32_t>& least, std::uint32_t value) {
  for (std::uint32_t found = least; value < found && !least.compare_exchange_weak(found, value);) {
  }
}

/// What comes after a failure counts for nothing, whether it has been run or not.
void run_pieces(std::vector<Piece>& all, const std::vector<Law>& laws, const TrialOptions& options,
                const Effort& effort, FirstFailures& failures) {
  Progress progress("checking", all.size(),
                    effort.shows_progress ? Progress::Visibility::automatic : Progress::Visibility::hidden);
  const auto run_one = [&](std::size_t i, std::size_t) {
    Piece& piece = all[i];
    auto& first_failure = failures[piece.law][piece.domain];
    if (piece.number < first_failure) {
      run(piece, laws[piece.law], options);
      if (piece.outcome.counterexample) lower(first_failure, piece.number);
    }
    progress.step();
  };
  for_all(all.size(), thread_count(effort.threads), run_one);
}

LawStatus status_of(const LawTrial& trial) {
  if (trial.outcome.counterexample) return LawStatus::counterexample;
  if (trial.law.standing == laws::Standing::holds) return LawStatus::holds;
  return trial.known.refuting == trial.known.cases ? LawStatus::refuted : LawStatus::not_refuted;
}

}  // namespace

std::string_view name(LawStatus status) {
  constexpr std::array<std::string_view, 4> names{"holds", "refuted", "counterexample", "not_refuted"};
  return names[static_cast<std::size_t>(status)];
}

std::vector<LawTrial> law_trials(const std::vector<Law>& laws, const TrialOptions& options, const Effort& effort) {
  std::vector<Piece> all = pieces(laws.size(), options.cases);
  FirstFailures failures(laws.size());
  for (auto& of_law : failures) {
    for (auto& number : of_law) number = std::numeric_limits<std::uint32_t>::max();
  }
  run_pieces(all, laws, options, effort, failures);
  std::vector<LawTrial> trials;
  for (const Law& law : laws) trials.push_back({law, {}, law.known ? law.known(options.subject) : Outcome{}});
  for (const Piece& piece : all) {
    if (piece.number > failures[piece.law][piece.domain]) continue;
    LawTrial& trial = trials[piece.law];
    if (!trial.outcome.counterexample && piece.outcome.counterexample) {
      trial.cases_to_failure = std::min(options.cases, 2 * cases_per_piece * (piece.number + 1));
    }
    add(trial.outcome, piece.outcome);
    trial.seconds += piece.seconds;
  }
  for (LawTrial& trial : trials) trial.status = status_of(trial);
  return trials;
}

}  // namespace gnomon
