#include "geometry/visibility/light_cut.h"

#include <algorithm>

#include "geometry/numbers/rounding.h"
#include "geometry/visibility/receiver_front.h"

namespace gnomon::viewpoint {
namespace {

const Rational& coordinate_of(const ExactVector& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The share that a part of a flat polygon has of its area.
Rational area_share(const ExactPolygon& part, const ExactPolygon& whole) {
  const ExactVector all = doubled_area(whole);
  const int axis = all.z != 0 ? 2 : all.y != 0 ? 1 : 0;
  return coordinate_of(doubled_area(part), axis) / coordinate_of(all, axis);
}

ExactPolygon part_above(const ExactPolygon& polygon, const ExactPlane& plane) {
  ExactPolygon above;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactVector& a = polygon[k];
    const ExactVector& b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const Rational at_a = plane.height(a), at_b = plane.height(b);
    if (at_a >= 0) above.push_back(a);
    if (at_a.sign() * at_b.sign() < 0) above.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return above;
}

/// In the light's plane the third coordinate is a linear function of the two that are kept, unless they collapse
/// because the light is so small that its normal underflows: then no height is known.
void set_heights(const ExactPolygon& corners, const LightPlane& light, const ExactPlane& receiver, LightCut& cut) {
  const ExactVector normal = doubled_area(corners);
  const int third = 3 - light.u - light.v;
  cut.along_u = cut.along_v = cut.at_origin = HUGE_VAL;
  if (coordinate_of(normal, third) == 0) return;
  const Rational turn = coordinate_of(receiver.normal, third) / coordinate_of(normal, third);
  const auto along = [&](int axis) {
    return nearest_double(Rational(coordinate_of(receiver.normal, axis) - turn * coordinate_of(normal, axis)));
  };
  cut.along_u = along(light.u);
  cut.along_v = along(light.v);
  cut.at_origin = nearest_double(receiver.height(corners[0]));
}

}  // namespace

void cut_light(const LightSide& light, const ReceiverPoint& receiver, LightCut& cut) {
  cut.sides.clear();
  bool before = false;
  bool behind = false;
  for (const Point3& corner : light.corners) {
    const int side = side_of_front(receiver, corner);
    cut.sides.push_back(static_cast<std::int8_t>(side));
    before = before || side > 0;
    behind = behind || side < 0;
  }
  cut.extent = !before ? Extent::none : behind ? Extent::part : Extent::all;
  cut.share = before ? 1 : 0;
  if (cut.extent != Extent::part) return;
  ExactPolygon corners;
  for (const Point3& corner : light.corners) corners.push_back(exact(corner));
  const ExactPlane plane = exact_front(receiver);
  cut.share = nearest_double(area_share(part_above(corners, plane), corners));
  set_heights(corners, light.plane, plane, cut);
}

/// Bound. Numbers, products and two sums are rounded: less than 5 u of the absolute terms.
FlatHeight height_of(const FlatPoint& p, const LightCut& cut) {
  const double u = cut.along_u * p.u;
  const double v = cut.along_v * p.v;
  const double size = std::fabs(u) + std::fabs(v) + std::fabs(cut.at_origin);
  const double moved = 1.01 * (std::fabs(cut.along_u) + std::fabs(cut.along_v)) * p.error;
  return {u + v + cut.at_origin, moved + 6 * unit * size + tiny};
}

/// The mean of h+ along a side is no further off than h at its ends.
/// Bound. Each factor errs by its own rounding, less than 8 u of it, and by what its arguments are off; the quotient by
/// |g|² adds less than 10 u.
void AreaBefore::add(const FlatPoint& p, const FlatPoint& q) {
  const FlatHeight at_p = height_of(p, cut_);
  const FlatHeight at_q = height_of(q, cut_);
  const double off = std::max(at_p.error, at_q.error);
  if (at_p.value <= -off && at_q.value <= -off) return;
  const double high = std::max(at_p.value, at_q.value);
  const double low = std::min(at_p.value, at_q.value);
  const double mean = low >= 0 ? (low + high) / 2 : high <= 0 ? 0 : high * (high / (high - low)) / 2;
  const double mean_error = off + 8 * unit * std::fabs(high);
  const double a = cut_.along_u * (q.v - p.v);
  const double b = cut_.along_v * (q.u - p.u);
  const double flow = a - b;
  const double flow_error = 1.01 * (std::fabs(cut_.along_u) + std::fabs(cut_.along_v)) * (p.error + q.error) +
                            8 * unit * (std::fabs(a) + std::fabs(b)) + tiny;
  const double squared = cut_.along_u * cut_.along_u + cut_.along_v * cut_.along_v;
  const double term = 2 * flow * mean / squared;
  sum_ += term;
  error_ += 2 * (std::fabs(flow) * mean_error + flow_error * mean + flow_error * mean_error) / squared +
            12 * unit * std::fabs(term) + unit * std::fabs(sum_) + tiny;
}

FlatArea AreaBefore::total() const {
  const bool known = error_ < HUGE_VAL && std::fabs(sum_) < HUGE_VAL;
  return {sum_, known ? 1.01 * error_ : HUGE_VAL};
}

}  // namespace gnomon::viewpoint
