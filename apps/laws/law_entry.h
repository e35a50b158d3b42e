#pragma once

#include <exception>
#include <string>
#include <utility>

#include <rapidcheck.h>

#include "apps/laws/law.h"

namespace gnomon::laws {

/// What a checker says of one case.
struct Verdict {
  enum class Kind { premise_fails, holds, fails };
  Kind kind = Kind::holds;
  std::string reason = {};  ///< of a failure
};

inline Verdict premise_fails() {
  return {Verdict::Kind::premise_fails};
}

/// The case keeps the law if `claim` is true, else it breaks it for the reason given.
inline Verdict verdict(bool claim, std::string_view reason) {
  return claim ? Verdict{} : Verdict{Verdict::Kind::fails, std::string(reason)};
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

/// A smaller case that breaks the law too, and why it does, found by taking the first smaller one again and again.
template <class Case>
std::string shrunk(rc::Shrinkable<Case> worst, Checker<Case> check, const Subject& subject) {
  Verdict why = guarded(check, worst.value(), subject);
  int left = 2000;
  for (bool smaller = true; smaller && left > 0;) {
    smaller = false;
    rc::Seq<rc::Shrinkable<Case>> candidates = worst.shrinks();
    for (auto candidate = candidates.next(); candidate && left-- > 0; candidate = candidates.next()) {
      Verdict found = guarded(check, candidate->value(), subject);
      if (found.kind != Verdict::Kind::fails) continue;
      worst = *candidate;
      why = std::move(found);
      smaller = true;
      break;
    }
  }
  return why.reason + "\n" + description(worst.value());
}

/// The stream of cases of one law in one domain: the same for the same seed, on every machine.
inline rc::Random stream(const std::string& key, Domain domain, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : key + std::string(name(domain))) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  return rc::Random(rc::Random::Key{seed, hash, 0, 0});
}

/// Runs one law: see Law::run.
template <class Case>
Outcome outcome(const rc::Gen<Case>& cases, Checker<Case> check, rc::Random random, const Parameters& parameters) {
  constexpr std::uint32_t most_draws_per_case = 20;
  Outcome result;
  while (result.premise_held < parameters.cases && result.cases < most_draws_per_case * parameters.cases) {
    const rc::Shrinkable<Case> drawn = cases(random.split());
    const Verdict found = guarded(check, drawn.value(), parameters.subject);
    ++result.cases;
    if (found.kind != Verdict::Kind::premise_fails) ++result.premise_held;
    if (found.kind != Verdict::Kind::fails) continue;
    result.counterexample = shrunk(drawn, check, parameters.subject);
    break;
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
            return outcome<Case>(cases(domain), check, stream(key, domain, parameters.seed), parameters);
          }};
}

}  // namespace gnomon::laws
