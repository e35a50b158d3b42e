#pragma once

/// Where a receiver is brightest. Private to the libraries.

#include "shading/illumination/refinement.h"

namespace gnomon::illumination {

/// A place that no other seen around it surpasses, climbing from one: a sixteenth of a thousandth of the receiver's
/// width near a maximum where irradiance is smooth. It need not be the only one.
Probe brightest_place(const ConvexPolygon& receiver, const Probe& from, LightsTogether& lights, std::size_t worker);

}  // namespace gnomon::illumination
