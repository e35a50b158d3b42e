#pragma once

#include <vector>

#include "apps/proof/laws/law.h"
#include "apps/proof/laws/mutants.h"

namespace gnomon::laws {

/// The laws of one light and one blocker, of any kind and in any position, and of concave blockers.
std::vector<Law> any_position_laws();

/// D1 to D10: where lights and blockers may stand for wanted shadows.
std::vector<Law> design_laws();

/// What is said of that but is false: X4.
std::vector<Law> design_claims();

/// Mistakes in that; all_mutants() has them too.
std::vector<Mutant> design_mutants();

/// E6: how many discontinuities a pair has.
std::vector<Law> event_count_laws();

/// E2 to E6: the order of discontinuities in space, and how many there are.
std::vector<Law> event_laws();

/// Mistakes in discontinuities and in what they divide; all_mutants() has them too.
std::vector<Mutant> event_mutants();

/// What is said of the plane but is false: F3 to F5.
std::vector<Law> flatland_claims();

/// The laws of one light and many blockers in the plane: Q1 to Q6.
std::vector<Law> flatland_laws();

/// The laws of one light and one segment blocker in the plane: P1 to P10.
std::vector<Law> planar_laws();

/// E1, E7 and M5: the discontinuities that a receiver shows.
std::vector<Law> receiver_laws();

/// What is said of reflection but is false: G1 to G9.
std::vector<Law> reflection_claims();

/// The laws of what surfaces reflect: H1 to H8.
std::vector<Law> reflection_laws();

/// Mistakes in what is reflected; all_mutants() has them too.
std::vector<Mutant> reflection_mutants();

/// LL1 to LL3: how blockers are found that may hide a linear light.
std::vector<Law> search_laws();

/// Mistakes in that; all_mutants() has them too.
std::vector<Mutant> search_mutants();

/// ST1: shadow trees.
std::vector<Law> tree_laws();

/// Mistakes in them; all_mutants() has them too.
std::vector<Mutant> tree_mutants();

/// The laws about many blockers in space.
std::vector<Law> visibility_laws();

/// What is said of space but is false: F1, F2, F6 and F7.
std::vector<Law> spatial_claims();

/// The laws of one light and one blocker in space: S1 to S14.
std::vector<Law> spatial_laws();

/// T1 to T9: three edges in line.
std::vector<Law> triple_edge_laws();

}  // namespace gnomon::laws
