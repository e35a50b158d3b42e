#include "gnomon/flatland_receiver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/planar/orientation.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

using planar::EventPointKind;
using planar::IntervalEnd;

/// A visible interval, and the signs of the heights of its ends above the horizon. Signs are decided before the
/// rounding mode is changed: predicates need the usual one.
struct VisibleShare {
  planar::VisibleInterval interval;
  int from = 0;
  int to = 0;
};

/// What of the interval lies between two numbers; all between them for an interval of no numbers.
Interval cut(const Interval& i, double low, double high) {
  return {i.inf() > low ? std::min(i.inf(), high) : low, i.sup() < high ? std::max(i.sup(), low) : high};
}

/// Divides both by a power of two, to a size that squares well, if they have one that is finite.
void divide_by_size(Interval& x, Interval& y) {
  const double size = std::max({-x.inf(), x.sup(), -y.inf(), y.sup()});
  if (!(size > 0 && size < HUGE_VAL)) return;
  const int less = -std::ilogb(size);
  for (const int power : {less / 2, less - less / 2}) {
    x *= Interval(std::scalbn(1.0, power));
    y *= Interval(std::scalbn(1.0, power));
  }
}

/// Looks from a receiver's point along directions to interval ends.
class Hemisphere {
 public:
  Hemisphere(const planar::Flatland& flatland, const PlanarReceiverPoint& receiver)
      : flatland_(flatland), receiver_(receiver) {
    const auto light = flatland.light();
    side_ = planar::orientation(light[0], light[1], receiver.point);
  }

  std::vector<VisibleShare> parts_of(const planar::VisibleLight& seen) const {
    std::vector<VisibleShare> parts;
    for (const auto& interval : seen.intervals) parts.push_back({interval, height(interval.from), height(interval.to)});
    return parts;
  }

  /// The integral of the cosine over a visible interval. Requires: the rounding mode protected.
  Interval integral(const VisibleShare& part) const {
    const auto& [interval, from, to] = part;
    if (from <= 0 && to <= 0) return 0;
    // Along the light the view turns counterclockwise from the light's left side. The horizon has the sines -1 and 1.
    const Interval sine_from = from > 0 ? sine(interval.from) : Interval(-side_);
    const Interval sine_to = to > 0 ? sine(interval.to) : Interval(side_);
    return side_ * (sine_to - sine_from);
  }

 private:
  /// The sign of the height of the direction to an end above the horizon, exactly.
  int height(const IntervalEnd& end) const {
    const Point2 horizon{receiver_.normal.y, -receiver_.normal.x};
    if (end.name.kind != EventPointKind::crossing) return planar::turn({0, 0}, horizon, receiver_.point, target(end));
    const auto& [a, b] = flatland_.blockers()[end.name.element];
    const Rational at_a = height_over_light(a), at_b = height_over_light(b);
    const Rational share = at_a / (at_a - at_b);
    const Rational x = Rational(a.x) + share * (Rational(b.x) - Rational(a.x)) - Rational(receiver_.point.x);
    const Rational y = Rational(a.y) + share * (Rational(b.y) - Rational(a.y)) - Rational(receiver_.point.y);
    return CGAL::sign(Rational(Rational(receiver_.normal.x) * x + Rational(receiver_.normal.y) * y));
  }

  Rational height_over_light(const Point2& p) const {
    const auto light = flatland_.light();
    return (Rational(light[1].x) - Rational(light[0].x)) * (Rational(p.y) - Rational(light[0].y)) -
           (Rational(light[1].y) - Rational(light[0].y)) * (Rational(p.x) - Rational(light[0].x));
  }

  /// The input point in whose direction an end lies.
  Point2 target(const IntervalEnd& end) const {
    if (end.name.kind == EventPointKind::light_end) return flatland_.light()[end.name.end];
    return flatland_.blockers()[end.name.element][end.name.end];
  }

  /// The sine of the angle from the normal to the direction of an end.
  Interval sine(const IntervalEnd& end) const {
    Interval x, y;
    if (end.name.kind == EventPointKind::crossing) {
      const auto light = flatland_.light();
      const Interval t = Interval(end.t) + Interval(-end.error, end.error);
      x = Interval(light[0].x) + t * (Interval(light[1].x) - Interval(light[0].x));
      y = Interval(light[0].y) + t * (Interval(light[1].y) - Interval(light[0].y));
    } else {
      x = target(end).x, y = target(end).y;
    }
    x -= receiver_.point.x;
    y -= receiver_.point.y;
    Interval nx = receiver_.normal.x, ny = receiver_.normal.y;
    divide_by_size(x, y);
    divide_by_size(nx, ny);
    return cut((nx * y - ny * x) / (sqrt(nx * nx + ny * ny) * sqrt(x * x + y * y)), -1, 1);
  }

  const planar::Flatland& flatland_;
  const PlanarReceiverPoint& receiver_;
  int side_ = 0;
};

}  // namespace

BoundedIrradiance planar_irradiance(const planar::LightVisibility& visibility, const PlanarReceiverPoint& receiver,
                                    double radiance) {
  const Point2& normal = receiver.normal;
  if (visibility.flatland().has_point_light()) throw PreconditionError("flatland irradiance needs a linear light");
  if (!std::isfinite(normal.x) || !std::isfinite(normal.y) || normal == Point2{0, 0} || !std::isfinite(radiance)) {
    throw PreconditionError("flatland irradiance needs a normal and a finite radiance");
  }
  const auto light = visibility.flatland().light();
  if (planar::orientation(light[0], light[1], receiver.point) == 0) return {};
  const planar::VisibleLight seen = visibility.visible_light(receiver.point);
  const Hemisphere hemisphere(visibility.flatland(), receiver);
  const std::vector<VisibleShare> parts = hemisphere.parts_of(seen);
  const Interval::Protector upward;
  Interval sum = 0;
  for (const VisibleShare& part : parts) sum += hemisphere.integral(part);
  sum = cut(sum, 0, 2) * Interval(radiance);
  const double value = sum.inf() / 2 + sum.sup() / 2;
  // Rounded upward, as the mode is protected; one step more for the rounding of `value` itself.
  return {value, std::nextafter(std::max(sum.sup() - value, value - sum.inf()), HUGE_VAL)};
}

}  // namespace gnomon
