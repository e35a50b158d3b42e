#pragma once

/// What two flat pieces exchange where blockers may hide something. Private to the libraries.

#include <cstddef>

#include "gnomon/irradiance.h"
#include "gnomon/receiver_mesh.h"
#include "shading/illumination/contour_integral.h"

namespace gnomon::illumination {

/// An exchange area, whose error is proven or an estimate.
struct Exchange {
  shading::Bounded area;
  bool is_proven = true;
  std::size_t evaluations = 0;
};

struct HiddenEffort {
  double tolerance = 0;              ///< of the exchange area
  std::size_t most_evaluations = 0;  ///< of irradiance
};

/// A receiver, and which of the blockers lie under it and hide nothing from it, ascending.
struct RestingPiece {
  const ConvexPolygon& polygon;
  std::vector<std::uint32_t> under = {};
  std::vector<Point3> many_limits = {};  ///< places where irradiance may have them, rounded to nearest
};

/// The exchange area of a divided receiver and the light that it has been divided for.
///
/// `light` is what of the light lies before the receiver, as loops; `irradiance` is that of the whole light at radiance
/// 1 behind the same blockers.
Exchange hidden_exchange(const ReceiverMesh& mesh, const RestingPiece& receiver, const Loops& light,
                         LightIrradiance& irradiance, const HiddenEffort& effort);

}  // namespace gnomon::illumination
