#include "apps/proof/laws/law_lists.h"

#include <algorithm>

#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/meeting.h"
#include "apps/proof/laws/search_cases.h"

namespace gnomon::laws {
namespace {

/// For each point, the blockers that have a point in the triangle between it and the light: by the definition, in
/// rational numbers.
std::vector<std::vector<std::uint32_t>> needed_occluders(const SearchCase& drawn) {
  std::vector<Walls> blockers;
  for (const ConvexBlocker& blocker : drawn.blockers) blockers.push_back(walls(blocker));
  std::vector<std::vector<std::uint32_t>> needed;
  for (const Point3& p : drawn.points) {
    const std::vector<ExactVector> triangle{exact(p), exact(drawn.light.start), exact(drawn.light.end)};
    needed.emplace_back();
    for (std::uint32_t b = 0; b < blockers.size(); ++b) {
      if (meet(triangle, blockers[b])) needed.back().push_back(b);
    }
  }
  return needed;
}

bool any_needed(const std::vector<std::vector<std::uint32_t>>& needed) {
  return std::ranges::any_of(needed, [](const auto& of_point) { return !of_point.empty(); });
}

std::string told(const LinearSearch& search, std::size_t point) {
  return std::string(name(search.strategy)) + "=" + std::to_string(search.parts) + ", point " + std::to_string(point);
}

Verdict check_none_missed(const SearchCase& drawn, const Subject& subject) {
  const auto needed = needed_occluders(drawn);
  if (!any_needed(needed)) return premise_fails();
  for (const LinearSearch& search : searches()) {
    const FoundOccluders found = subject.found_occluders(drawn.light, drawn.blockers, search, drawn.points);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] && !std::ranges::includes(*found[i], needed[i])) {
        return verdict(false, told(search, i) + ": a blocker in the triangle is missed");
      }
    }
  }
  return {};
}

Verdict check_same_answers(const SearchCase& drawn, const Subject& subject) {
  std::vector<Visibility> first;
  for (const LinearSearch& search : searches()) {
    auto seen = subject.searched_visibility(drawn.light, drawn.blockers, search, drawn.points, drawn.normal);
    if (first.empty()) first = seen;
    const auto differs = std::ranges::mismatch(first, seen).in1 - first.begin();
    if (first != seen) return verdict(false, told(search, std::size_t(differs) / 2) + ": another answer");
  }
  return {};
}

Verdict check_counts(const SearchCase& drawn, const Subject& subject) {
  const auto needed = needed_occluders(drawn);
  if (!any_needed(needed)) return premise_fails();
  FoundOccluders one_section;
  for (const LinearSearch& search : searches()) {
    const FoundOccluders found = subject.found_occluders(drawn.light, drawn.blockers, search, drawn.points);
    const bool is_buffer = search.strategy == OccluderSearch::light_buffer;
    if (is_buffer && search.parts == 1) one_section = found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) continue;
      const std::size_t count = found[i]->size();
      if (count < needed[i].size() || count > drawn.blockers.size()) {
        return verdict(false, told(search, i) + ": fewer than needed or more than there are");
      }
      if (is_buffer && count > one_section[i]->size()) {
        return verdict(false, told(search, i) + ": more than in one section");
      }
    }
  }
  return {};
}

}  // namespace

std::vector<Law> search_laws() {
  return {
      law({"LL1", "own", "No search misses a blocker that has a point in the triangle between point and light."},
          search_cases, check_none_missed),
      law({"LL2", "own", "All searches lead to the same answers, to the last bit."}, search_cases, check_same_answers),
      law({"LL3", "own",
           "A search finds at least the blockers needed and at most all; a light buffer finds no more than one of a "
           "single section."},
          search_cases, check_counts),
  };
}

}  // namespace gnomon::laws
