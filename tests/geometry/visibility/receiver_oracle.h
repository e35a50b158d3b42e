#pragma once

#include "apps/proof/laws/visibility_cases.h"
#include "geometry/numbers/kernel.h"
#include "geometry/visibility/receiver_front.h"
#include "gnomon/names.h"

namespace gnomon::test_support {

/// What a receiver's point ought to receive, by the definition.
struct ExpectedReceived {
  Region region = Region::lit;
  Rational fraction;  ///< up to 2^-1500; of lights that are not flat nothing
  Rational before;
};

/// The limit from the front, as the definition says it: what the point sees when it is moved along the normal by so
/// little that no share of the light can tell (2^-4000 of the normal), of what of the light lies before the plane.
ExpectedReceived expected_received(const laws::VisibilityCase& drawn, const ReceiverPoint& receiver);

/// A normal or a facet for the point of a case: often at right angles to planes of the case, or in them.
ReceiverPoint draw_receiver(const laws::VisibilityCase& drawn);

}  // namespace gnomon::test_support
