#include "shading/illumination/outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/numbers/place_key.h"
#include "geometry/numbers/vector3.h"

namespace gnomon::illumination {
namespace {

using Side = std::pair<PlaceKey, PlaceKey>;

Side side_between(const Point3& a, const Point3& b) {
  return std::minmax(place_key(a), place_key(b));
}

double length(const Vector3<double>& v) {
  return std::hypot(v.x, v.y, v.z);
}

/// The side that a place of the border lies on; of a receiver that was rounded off its plane the nearest one.
std::size_t side_under(const ConvexPolygon& receiver, const ExactVector& p) {
  const auto points = receiver.points();
  const auto end = [&](std::size_t k) -> const Point3& { return points[k % points.size()]; };
  std::size_t nearest = 0;
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ExactVector a = exact(end(k)), b = exact(end(k + 1));
    if (is_zero(cross(b - a, p - a)) && dot(p - a, p - b) <= 0) return k;
    const double away = distance(near_point(p), end(k), end(k + 1));
    if (away < least) least = away, nearest = k;
  }
  return nearest;
}

/// The places of a side, in order from its first end, which is among them, to before its last.
void append_side(std::vector<ExactVector>& ring, const Point3& from, const Point3& to,
                 std::vector<ExactVector> between) {
  const ExactVector a = exact(from), b = exact(to);
  const auto share = [&](const ExactVector& p) -> Rational { return dot(p - a, b - a); };
  std::ranges::sort(between, [&](const ExactVector& p, const ExactVector& q) { return share(p) < share(q); });
  ring.push_back(a);
  for (const ExactVector& p : between) {
    if (p != ring.back() && p != b) ring.push_back(p);
  }
}

}  // namespace

Point3 near_point(const ExactVector& p) {
  return {p.x.convert_to<double>(), p.y.convert_to<double>(), p.z.convert_to<double>()};
}

double extent_of(std::span<const Point3> points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return length(step(low, high));
}

double distance(const Point3& p, const Point3& a, const Point3& b) {
  const Vector3<double> along = step(a, b), way = step(a, p);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(way, along) / square, 0.0, 1.0) : 0;
  return length(way - share * along);
}

bool is_on(const ConvexPolygon& receiver, const Point3& p) {
  const auto points = receiver.points();
  const auto corner = [&](std::size_t k) { return points[receiver.corners()[k]]; };
  const Vector3<double> normal = cross(step(corner(0), corner(1)), step(corner(0), corner(2)));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector3<double> along = step(points[k], points[(k + 1) % points.size()]), way = step(points[k], p);
    if (dot(cross(along, way), normal) < -1e-12 * length(along) * length(way) * length(normal)) return false;
  }
  return true;
}

Outline outline_of(std::span<const ConvexPolygon* const> receivers, std::span<const ReceiverTraces> traces,
                   std::uint8_t highest_order) {
  std::map<Side, std::vector<ExactVector>> between;
  for (std::size_t r = 0; r < receivers.size(); ++r) {
    const auto points = receivers[r]->points();
    for (const ExactVector& p : traces[r].on_border) {
      const std::size_t k = side_under(*receivers[r], p);
      between[side_between(points[k], points[(k + 1) % points.size()])].push_back(p);
    }
  }
  Outline outline;
  for (std::size_t r = 0; r < receivers.size(); ++r) {
    const auto points = receivers[r]->points();
    std::vector<ExactVector>& ring = outline.rings.emplace_back();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point3 &a = points[k], &b = points[(k + 1) % points.size()];
      append_side(ring, a, b, between[side_between(a, b)]);
    }
    for (const Trace& trace : traces[r].traces) {
      if (trace.order <= highest_order) outline.traces.push_back(trace);
    }
  }
  return outline;
}

}  // namespace gnomon::illumination
