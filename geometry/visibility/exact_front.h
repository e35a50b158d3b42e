#pragma once

/// A receiver's plane in rational numbers. Private: it speaks of rational numbers.

#include "geometry/visibility/exact_vector.h"
#include "geometry/visibility/receiver_front.h"

namespace gnomon {

/// The plane before which a receiver receives; its normal points to the front.
ExactPlane exact_front(const ReceiverPoint& receiver);

}  // namespace gnomon
