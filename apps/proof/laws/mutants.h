#pragma once

/// The code under test, broken on purpose: a law is worth nothing unless it can fail.

#include <string>
#include <vector>

#include "apps/proof/laws/subject.h"

namespace gnomon::laws {

/// Which function of the subject a mutant breaks.
enum class Part {
  extremal_planes,
  shadow_volumes,
  convex_hull_shadow_volume,
  visibility,
  discontinuity_surfaces,
  divided_receiver,
  reflection,
  found_occluders,
  searched_visibility,
  tree_regions,
  design_place,
  solved_design,
  planar_extremal_lines,
  planar_regions,
  planar_region_of,
  planar_visible_light,
  planar_partition,
};

/// A subject with one mistake.
struct Mutant {
  std::string name;  ///< as it is asked for: "drop_umbra_half_space"
  std::string does;  ///< the mistake in words
  Part part;
  Subject subject;
  std::vector<std::string> caught_by;  ///< keys of laws, each of which finds a counterexample within 1,000 cases
};

/// Every mutant there is: contacts exchanged, a neighbouring vertex taken, a half-space or side dropped, one turned
/// round, a blocker skipped, a strict comparison in place of one that is not, wrong counts.
std::vector<Mutant> all_mutants();

/// The subject with its function of that part exchanged for one that calls `asked` first.
Subject with_part_watched(Part part, std::function<void()> asked);

}  // namespace gnomon::laws
