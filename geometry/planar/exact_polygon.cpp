#include "geometry/planar/exact_polygon.h"

#include <utility>

#include "geometry/planar/light_line.h"

namespace gnomon::planar {
namespace {

/// The half-plane left of a side: a x + b y + c >= 0.
struct HalfPlane {
  Rational a;
  Rational b;
  Rational c;
  SideName name;

  explicit HalfPlane(const PieceSide& side)
      : a(Rational(side.from.y) - Rational(side.to.y)),
        b(Rational(side.to.x) - Rational(side.from.x)),
        c(Rational(side.from.x) * Rational(side.to.y) - Rational(side.from.y) * Rational(side.to.x)),
        name(side.name) {}

  Rational height(const ExactPoint& p) const { return a * p.x + b * p.y + c; }
};

void add(ExactPolygon& polygon, ExactPoint vertex, const SideName& side) {
  polygon.vertices.push_back(std::move(vertex));
  polygon.sides.push_back(side);
}

ExactPoint crossing(const ExactPoint& p, const Rational& height_p, const ExactPoint& q, const Rational& height_q) {
  const Rational t = height_p / (height_p - height_q);
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

/// The part of a polygon in a half-plane; may have no interior. A side on the half-plane's line takes its name.
ExactPolygon clipped(const ExactPolygon& polygon, const HalfPlane& half_plane) {
  const std::size_t size = polygon.vertices.size();
  std::vector<Rational> heights;
  for (const ExactPoint& vertex : polygon.vertices) heights.push_back(half_plane.height(vertex));
  ExactPolygon result;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t next = (k + 1) % size;
    const ExactPoint &p = polygon.vertices[k], &q = polygon.vertices[next];
    const int at_p = CGAL::sign(heights[k]), at_q = CGAL::sign(heights[next]);
    if (at_p >= 0) add(result, p, at_p == 0 && at_q <= 0 ? half_plane.name : polygon.sides[k]);
    if (at_p * at_q >= 0) continue;
    add(result, crossing(p, heights[k], q, heights[next]), at_p > 0 ? half_plane.name : polygon.sides[k]);
  }
  return result;
}

ExactPolygon polygon_of(const Box2& box) {
  const auto side = [](std::uint32_t number) { return SideName{SideKind::clip_box, {}, {}, number}; };
  const ExactPoint min = exact(box.min);
  const ExactPoint max = exact(box.max);
  return {{min, {max.x, min.y}, max, {min.x, max.y}}, {side(2), side(1), side(3), side(0)}};
}

bool is_on_blocker_line(const PieceSide& side) {
  return side.name.kind == SideKind::blocker || side.name.kind == SideKind::blocker_line;
}

/// True if the boundary runs straight on from side k - 1 to side k.
bool runs_straight_into(const ConvexPiece& piece, std::size_t k) {
  return k > 0 && is_on_blocker_line(piece.sides[k - 1]) && is_on_blocker_line(piece.sides[k]);
}

/// Sign of the position of `point` along a line that runs from p to q, as seen from `origin`.
int ahead(const ExactPoint& origin, const ExactPoint& point, const ExactPoint& p, const ExactPoint& q) {
  const Rational along = (point.x - origin.x) * (q.x - p.x) + (point.y - origin.y) * (q.y - p.y);
  return CGAL::sign(along);
}

/// Names what lies beyond a straight corner by the side after it, `name`, and makes the corner a vertex if it is inside
/// the polygon's side that is named by the side before it, `before`.
void split_at(ExactPolygon& polygon, const ExactPoint& corner, const SideName& before, const SideName& name) {
  for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
    if (polygon.sides[k] != before) continue;
    const ExactPoint p = polygon.vertices[k];
    const ExactPoint q = polygon.vertices[(k + 1) % polygon.vertices.size()];
    if (ahead(p, corner, p, q) <= 0) {
      polygon.sides[k] = name;
    } else if (ahead(corner, q, p, q) > 0) {
      const auto at = static_cast<std::ptrdiff_t>(k) + 1;
      polygon.vertices.insert(polygon.vertices.begin() + at, corner);
      polygon.sides.insert(polygon.sides.begin() + at, name);
    }
    return;
  }
}

}  // namespace

ExactPolygon clipped(const Pair& pair, const ConvexPiece& piece, const Box2& box) {
  ExactPolygon polygon = polygon_of(box);
  for (std::size_t k = 0; k < piece.sides.size(); ++k) {
    if (!runs_straight_into(piece, k)) polygon = clipped(polygon, HalfPlane(piece.sides[k]));
  }
  if (twice_area(polygon) == 0) return {};
  for (std::size_t k = 1; k < piece.sides.size(); ++k) {
    if (!runs_straight_into(piece, k)) continue;
    const ExactPoint corner = exact(pair.blocker_end(piece.corners[k - 1].blocker_end.value()));
    split_at(polygon, corner, piece.sides[k - 1].name, piece.sides[k].name);
  }
  return polygon;
}

std::optional<std::array<ExactPoint, 2>> clipped_line(const Point2& from, const Point2& to, const Box2& box) {
  const ExactPoint start = exact(from);
  const ExactPoint end = exact(to);
  const ExactPoint step{end.x - start.x, end.y - start.y};
  std::optional<Rational> first, last;  // the line inside the box: start + t step for first <= t <= last
  const auto cut = [&](const Rational& at, const Rational& slope, const Rational& min, const Rational& max) {
    if (slope == 0) return at >= min && at <= max;
    const Rational to_min = (min - at) / slope, to_max = (max - at) / slope;
    const Rational &enter = slope > 0 ? to_min : to_max, &leave = slope > 0 ? to_max : to_min;
    if (!first || enter > *first) first = enter;
    if (!last || leave < *last) last = leave;
    return true;
  };
  const ExactPoint min = exact(box.min), max = exact(box.max);
  if (!cut(start.x, step.x, min.x, max.x) || !cut(start.y, step.y, min.y, max.y)) return std::nullopt;
  if (*first >= *last) return std::nullopt;
  const auto point = [&](const Rational& t) { return ExactPoint{start.x + t * step.x, start.y + t * step.y}; };
  return std::array{point(*first), point(*last)};
}

Rational twice_area(const ExactPolygon& polygon) {
  Rational sum = 0;
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const ExactPoint& p = polygon.vertices[k];
    const ExactPoint& q = polygon.vertices[(k + 1) % polygon.vertices.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

}  // namespace gnomon::planar
