#pragma once

/// Colours for a quantity, and the round numbers of its scale.

#include <vector>

#include "viz/vtk/palette.h"

namespace gnomon::viz {

/// The colour of a share of a scale, from 0, dark blue, through green to 1, pale yellow; beyond them that of the end.
///
/// Definition: lightness of Ottosson's OKLab runs evenly from 0.25 to 0.95, so that equal steps look equal and a copy
/// in
///             grey keeps the order; hue runs evenly from 290 to 105 degrees; every colour can be shown.
Color colour_of_share(double share);

/// A scale from 0 to a round number, in round steps.
struct RoundScale {
  double step = 1;
  int steps = 1;  ///< 4 to 8; 1 of a scale for 0, or for less than has round parts

  double top() const { return step * steps; }
};

/// The smallest such scale, of steps 1, 2 or 5 times a power of ten, that holds the value.
/// Requires: the value is finite and not negative.
RoundScale round_scale(double largest);

}  // namespace gnomon::viz
