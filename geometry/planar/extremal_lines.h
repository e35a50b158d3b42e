#pragma once

#include <array>

#include "geometry/contact.h"
#include "geometry/indices.h"
#include "geometry/planar/pair.h"

namespace gnomon::planar {

/// The line through one end of the blocker that touches the light, named by input elements alone.
struct ExtremalLine {
  Contact contact;
  BlockerVertex blocker_end;
  LightVertex light_end;

  friend bool operator==(const ExtremalLine&, const ExtremalLine&) = default;
};

/// The extremal lines of a pair in standard position: separating at the blocker's ends 0 and 1 ("Min b" in [P93]),
/// then supporting at its ends 0 and 1 ("Max b").
///
/// Requires:   pair_position(pair) == Position::standard.
/// Degenerate: a line that holds the whole light (a point light, or an end of the blocker on the light's line) is both
///             separating and supporting and is listed with each contact, named by light end 0.
/// Exactness:  signs of orientation determinants of input points; nothing is constructed.
/// Throws:     PreconditionError.
/// After:      [P93] §4.2.2.1.
std::array<ExtremalLine, 4> extremal_lines(const Pair& pair);

}  // namespace gnomon::planar
