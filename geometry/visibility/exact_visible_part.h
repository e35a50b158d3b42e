#pragma once

/// What is left of a light behind obstacles, as exact polygons and intervals. Private: it speaks of rational numbers.

#include "geometry/visibility/visible_part.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// The visible part of which exact_visibility tells the region and the fraction.
VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const Point3& p);
VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver);

}  // namespace gnomon
