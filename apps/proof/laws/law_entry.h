#pragma once

#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/law.h"

namespace gnomon::laws {

/// What a checker says of one case.
struct Verdict {
  enum class Kind {
    premise_fails,
    holds,
    fails,
    refutes,  ///< of a refuted claim: the claim is false of this case, and the subject knows
  };
  Kind kind = Kind::holds;
  std::string reason = {};  ///< of a failure or a refutation
};

inline Verdict premise_fails() {
  return {Verdict::Kind::premise_fails};
}

/// The case keeps the law if `claim` is true, else it breaks it for the reason given.
inline Verdict verdict(bool claim, std::string_view reason) {
  return claim ? Verdict{} : Verdict{Verdict::Kind::fails, std::string(reason)};
}

inline Verdict refutes(std::string_view reason) {
  return {Verdict::Kind::refutes, std::string(reason)};
}

/// Decides one case of a law. What it is handed beside the case is what it may doubt.
template <class Case>
using Checker = Verdict (*)(const Case&, const Subject&);

/// The checker's verdict; an exception of the subject breaks the law as a wrong answer does.
template <class Case>
Verdict guarded(Checker<Case> check, const Case& drawn, const Subject& subject) {
  try {
    return check(drawn, subject);
  } catch (const std::exception& error) {
    return {Verdict::Kind::fails, std::string("exception: ") + error.what()};
  }
}

/// The reason, and the case from which it can be built again.
template <class Case>
std::string told(const Verdict& why, const Case& drawn) {
  return why.reason + "\n" + description(drawn);
}

/// The case as a scene, if its kind of case has an `example`.
template <class Case>
std::optional<Example> example_of(const Case& drawn) {
  if constexpr (requires { example(drawn); }) {
    return example(drawn);
  } else {
    return std::nullopt;
  }
}

/// Counts the regions of a case, if its kind of case has `count_regions`.
template <class Case>
void count_case(const Case& drawn, Census& census) {
  if constexpr (requires { count_regions(drawn, census); }) {
    ++census.cases;
    count_regions(drawn, census);
  }
}

/// RapidCheck keeps what it draws from in variables that all threads share: they draw one at a time, and check at once.
inline std::mutex& drawing() {
  static std::mutex mutex;
  return mutex;
}

/// What a shrinkable case holds. It is drawn anew every time it is asked for.
template <class Case>
Case value_of(const rc::Shrinkable<Case>& drawn) {
  const std::lock_guard lock(drawing());
  return drawn.value();
}

/// The next of the smaller cases, or nothing.
template <class Case>
std::optional<rc::Shrinkable<Case>> next_of(rc::Seq<rc::Shrinkable<Case>>& candidates) {
  const std::lock_guard lock(drawing());
  auto next = candidates.next();
  return next ? std::optional(*next) : std::nullopt;
}

template <class Case>
rc::Seq<rc::Shrinkable<Case>> shrinks_of(const rc::Shrinkable<Case>& drawn) {
  const std::lock_guard lock(drawing());
  return drawn.shrinks();
}

/// Tells a smaller case that breaks the law too, and why it does, found by taking the first smaller one again and
/// again.
template <class Case>
void tell_shrunk(rc::Shrinkable<Case> worst, Checker<Case> check, const Subject& subject, Outcome& outcome) {
  Verdict why = guarded(check, value_of(worst), subject);
  int left = 2000;
  for (bool smaller = true; smaller && left > 0;) {
    smaller = false;
    rc::Seq<rc::Shrinkable<Case>> candidates = shrinks_of(worst);
    for (auto candidate = next_of(candidates); candidate && left-- > 0; candidate = next_of(candidates)) {
      Verdict found = guarded(check, value_of(*candidate), subject);
      if (found.kind != Verdict::Kind::fails) continue;
      worst = *candidate;
      why = std::move(found);
      smaller = true;
      break;
    }
  }
  const Case smallest = value_of(worst);
  outcome.counterexample = told(why, smallest);
  outcome.example = example_of(smallest);
}

/// A stream of cases of one law in one domain: the same for the same seed, on every machine.
inline rc::Random stream(const std::string& key, Domain domain, std::uint64_t seed, std::uint64_t number) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : key + std::string(name(domain))) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  return rc::Random(rc::Random::Key{seed, hash, number, 0});
}

/// Counts a case, and keeps the first that refutes a claim.
template <class Case>
void count_verdict(const Verdict& found, const Case& drawn, Outcome& outcome) {
  ++outcome.cases;
  if (found.kind != Verdict::Kind::premise_fails) ++outcome.premise_held;
  if (found.kind != Verdict::Kind::refutes || ++outcome.refuting > 1) return;
  outcome.refutation = told(found, drawn);
  outcome.example = example_of(drawn);
}

/// Runs one law: see Law::run.
template <class Case>
Outcome outcome(const rc::Gen<Case>& cases, Checker<Case> check, rc::Random random, const Parameters& parameters) {
  constexpr std::uint32_t most_draws_per_case = 20;
  Outcome result;
  while (result.premise_held < parameters.cases && result.cases < most_draws_per_case * parameters.cases) {
    const rc::Shrinkable<Case> shrinkable = cases(random.split());
    const Case drawn = value_of(shrinkable);
    const Verdict found = guarded(check, drawn, parameters.subject);
    count_verdict(found, drawn, result);
    if (parameters.counts_regions) count_case(drawn, result.census);
    if (found.kind != Verdict::Kind::fails) continue;
    tell_shrunk(shrinkable, check, parameters.subject, result);
    break;
  }
  return result;
}

/// Runs the cases known to refute a claim: see Law::known.
template <class Case>
Outcome known_outcome(const std::vector<Case>& known, Checker<Case> check, const Subject& subject) {
  Outcome result;
  for (const Case& one : known) {
    const Verdict found = guarded(check, one, subject);
    count_verdict(found, one, result);
    if (found.kind == Verdict::Kind::fails) result.counterexample = told(found, one);
  }
  return result;
}

/// The words of a law.
struct Statement {
  std::string key;
  std::string source;
  std::string text;
};

/// One entry of a list of laws: its words, where its cases come from, and what decides a case.
///
/// Requires: `cases(Domain)` returns rc::Gen<Case>, and `description(Case)` is found beside Case.
template <class Case, class Cases>
Law law(Statement statement, Cases cases, Checker<Case> check) {
  const std::string key = statement.key;
  return {key, std::move(statement.source), std::move(statement.text),
          [key, cases, check](Domain domain, const Parameters& parameters) {
            const rc::Random random = stream(key, domain, parameters.seed, parameters.stream);
            return outcome<Case>(cases(domain), check, random, parameters);
          }};
}

/// The entry of a claim that is false: its words, the cases known to refute it, and where more are searched for. The
/// checker says `refutes` of a case of which the claim is false, and `fails` where the subject contradicts the
/// definition.
template <class Case, class Cases>
Law refuted_claim(Statement claim, std::vector<Case> known, Cases cases, Checker<Case> check) {
  Law entry = law(std::move(claim), cases, check);
  entry.standing = Standing::refuted;
  entry.known = [known = std::move(known), check](const Subject& subject) {
    return known_outcome(known, check, subject);
  };
  return entry;
}

}  // namespace gnomon::laws
