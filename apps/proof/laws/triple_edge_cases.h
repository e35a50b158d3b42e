#pragma once

#include <array>
#include <string>

#include <rapidcheck.h>

#include "apps/proof/laws/exact.h"
#include "apps/proof/laws/law.h"
#include "apps/proof/laws/receiver_cases.h"

namespace gnomon::laws {

using Segment = std::array<ExactVector, 2>;

/// Three edges above the plane z = 0, a point of it, and numbers that choose what is looked at.
struct TripleCase {
  std::array<Segment, 3> edges;
  ExactVector start;  ///< on the plane
  ExactVector step;   ///< along it
  Rational share;     ///< of the first edge, strictly between its ends
};

std::string description(const TripleCase& drawn);

/// Edges of small whole coordinates; near degeneracy one ulp off parallel or crossing ones.
rc::Gen<TripleCase> triple_cases(Domain domain);

/// A lamp or a tube above a floor and two or three blockers one above the other, which hide it together: gaps close
/// where three edges are in line. Boards are level, tilted, upright or boxes, some in one plane, so that they cross,
/// touch or share edges. Near degeneracy one ulp off, or far from the origin with small detail.
rc::Gen<ReceiverCase> joint_cases(Domain domain);

}  // namespace gnomon::laws
