#pragma once

#include <ostream>
#include <span>

#include "gnomon/point.h"

namespace gnomon::laws {

/// Writes a line "WHAT: {x, y, z} {x, y, z}", for descriptions of cases.
void write(std::ostream& out, const char* what, std::span<const Point3> points);

/// The same in the plane.
void write(std::ostream& out, const char* what, std::span<const Point2> points);

}  // namespace gnomon::laws
