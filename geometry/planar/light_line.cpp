#include "geometry/planar/light_line.h"

namespace gnomon::planar {

Rational place_along(std::span<const Point2> light, const ExactPoint& point) {
  const ExactPoint start = exact(light[0]), end = exact(light[1]);
  const Rational dx = end.x - start.x, dy = end.y - start.y;
  const Rational along = (point.x - start.x) * dx + (point.y - start.y) * dy;
  return along / (dx * dx + dy * dy);
}

Rational height_over(std::span<const Point2> light, const ExactPoint& point) {
  const ExactPoint start = exact(light[0]), end = exact(light[1]);
  return (end.x - start.x) * (point.y - start.y) - (end.y - start.y) * (point.x - start.x);
}

ExactPoint crossing_point(std::span<const Point2> light, const BlockerSegment& blocker) {
  const ExactPoint a = exact(blocker[0]), b = exact(blocker[1]);
  const Rational at_a = height_over(light, a), at_b = height_over(light, b);
  const Rational share = at_a / (at_a - at_b);
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

Rational crossing_place(std::span<const Point2> light, const BlockerSegment& blocker) {
  return place_along(light, crossing_point(light, blocker));
}

}  // namespace gnomon::planar
