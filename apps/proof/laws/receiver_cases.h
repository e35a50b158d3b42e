#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::laws {

/// An area light above a level floor or standing on it, blockers between, and numbers that choose what is looked at.
struct ReceiverCase {
  Light light;
  std::vector<ConvexBlocker> blockers;
  ConvexPolygon floor;
  std::uint32_t choice = 0;
  double share = 0.5;  ///< a place between two others
  Point3 direction;    ///< of a path on the floor
};

std::string description(const ReceiverCase& drawn);
Example example(const ReceiverCase& drawn);
void count_regions(const ReceiverCase& drawn, Census& census);

/// Where blockers are.
enum class Stands { anywhere, on_floor };

/// Scenes of up to `most_blockers`: triangles, boxes and tetrahedra with small whole coordinates, which stand on the
/// floor, pass through it or hang above it, touch each other or the light, have edges parallel to the light's or not.
/// Near degeneracy one ulp off, stretched, or far from the origin with small detail.
rc::Gen<ReceiverCase> receiver_cases(Domain domain, int most_blockers, Stands stands = Stands::anywhere);

}  // namespace gnomon::laws
