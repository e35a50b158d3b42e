#pragma once

/// Which blockers matter to a receiver's point. Private to this folder.

#include <cstdint>
#include <vector>

#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/receiver_front.h"

namespace gnomon::viewpoint {

/// Keeps of the blockers found those that reach before the receiver's plane and do not lie under the point.
///
/// Returns:   false if one of these holds the point: then the limit from the front is left to the exact level.
/// Exactness: signs.
bool keep_before(const ReceiverPoint& receiver, const BlockerSet::Content& blockers, std::vector<std::uint32_t>& found);

}  // namespace gnomon::viewpoint
