#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/proof/report/timings.h"

namespace gnomon::report {

/// What points of a floor, in the penumbra of a square of side 2 that is 1 above it, receive of a tube (10 long) or a
/// lamp (10 by 2), 6 above it, or reflect of it to an eye by a lobe of exponent 50; the same of a tube that nothing
/// hides, exponent 64. Light and blocker are those of [PA90]'s scene.
///
/// Tasks, with PEER = "penumbra_tube", "penumbra_tube_lobe", "penumbra_lamp_lobe", "open_tube_lobe":
/// "PEER" is gnomon's answer with its bound, the size 1. "PEER_at_256", "PEER_at_1000", "PEER_at_10000" is what points
/// on the light take for an rms of 1/256, 1/1000, 1/10000 of the largest value: the size is their number, between those
/// tried on logarithmic scales. In penumbrae rays of Embree in packets of eight look whether they are hidden: regular
/// points for irradiance, stratified ones, new for each place, for lobes; nobody has to look in the open. Missing where
/// the most points tried were not enough.
/// Truth: gnomon's values; their bounds are below 1e-9 of the largest, or nothing is told.
std::vector<Timing> reflection_peers(Effort effort);

}  // namespace gnomon::report
