#include "tests/geometry/discontinuity/side_oracle.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace gnomon::test_support {
namespace {

using Corners = std::vector<ExactVector>;

/// A number a + b e + c e², e positive and smaller than every positive rational.
struct Small {
  std::array<Rational, 3> c{};

  int sign() const {
    for (const Rational& x : c) {
      if (x != 0) return x.sign();
    }
    return 0;
  }
};

Small operator-(const Small& x, const Small& y) {
  return {{x.c[0] - y.c[0], x.c[1] - y.c[1], x.c[2] - y.c[2]}};
}

/// Of numbers without e².
Small operator*(const Small& x, const Small& y) {
  return {{x.c[0] * y.c[0], x.c[0] * y.c[1] + x.c[1] * y.c[0], x.c[1] * y.c[1]}};
}

/// A linear function: n . x + d.
struct Wall {
  ExactVector n;
  Rational d;

  Rational at(const ExactVector& x) const { return dot(n, x) + d; }
};

Wall wall_through(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  const ExactVector n = cross(b - a, c - a);
  return {n, -dot(n, a)};
}

/// A blocker: the points where no wall is positive, and planes that may part what it hides from what it does not.
struct Body {
  std::vector<Wall> walls;
  std::vector<std::array<ExactVector, 2>> edges;
};

void add_sides(const Corners& loop, Body& body) {
  for (std::size_t k = 0; k < loop.size(); ++k) body.edges.push_back({loop[k], loop[(k + 1) % loop.size()]});
}

Corners corners_of(const ConvexPolygon& polygon) {
  Corners corners;
  for (const std::uint32_t k : polygon.corners()) corners.push_back(exact(polygon.points()[k]));
  return corners;
}

Body body_of(const ConvexBlocker& blocker) {
  Body body;
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    const Corners loop = corners_of(*polygon);
    const Wall front = wall_through(loop[0], loop[1], loop[2]);
    body.walls = {front, {Rational(-1) * front.n, -front.d}};
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const ExactVector out = cross(loop[(k + 1) % loop.size()] - loop[k], front.n);
      body.walls.push_back({out, -dot(out, loop[k])});
    }
    add_sides(loop, body);
    return body;
  }
  const auto& solid = std::get<ConvexSolid>(blocker);
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    Corners loop;
    for (const std::uint32_t k : facet.loop) loop.push_back(exact(solid.points()[k]));
    body.walls.push_back(wall_through(loop[0], loop[1], loop[2]));
  }
  for (const ConvexSolid::Edge& e : solid.edges()) {
    body.edges.push_back({exact(solid.points()[e.from]), exact(solid.points()[e.to])});
  }
  return body;
}

/// An end of an interval of places on a segment: above / below, with below > 0.
struct Bound {
  Small above;
  Small below;
};

bool is_less(const Bound& x, const Bound& y) {
  return (y.above * x.below - x.above * y.below).sign() > 0;
}

/// Where on the way from p + e N a point lies, strictly between its ends, that no wall excludes. The function of each
/// wall is `at_start` + place * `rise`.
class Segment {
 public:
  Segment(const ExactVector& p, const ExactVector& normal) : p_(p), normal_(normal) {}

  /// To a point; or, far off, along a way.
  bool meets(const Body& body, const ExactVector& l, bool is_way) const {
    Bound first{{}, one()};
    std::optional<Bound> last;
    if (!is_way) last = Bound{one(), one()};
    bool is_first_open = true, is_last_open = true;
    for (const Wall& wall : body.walls) {
      const Small start{{wall.at(p_), dot(wall.n, normal_), 0}};
      const Small rise = is_way ? Small{{dot(wall.n, l), 0, 0}} : Small{{wall.at(l), 0, 0}} - start;
      const int turns = rise.sign();
      if (turns == 0 && start.sign() > 0) return false;
      if (turns == 0) continue;
      const Small zero;
      const Bound root = turns > 0 ? Bound{zero - start, rise} : Bound{start, zero - rise};
      if (turns > 0 && (!last || is_less(root, *last))) {
        last = root;
        is_last_open = false;
      }
      if (turns < 0 && is_less(first, root)) {
        first = root;
        is_first_open = false;
      }
    }
    if (!last || is_less(first, *last)) return true;
    return !is_less(*last, first) && !is_first_open && !is_last_open;
  }

 private:
  static Small one() { return {{1, 0, 0}}; }

  ExactVector p_;
  ExactVector normal_;
};

/// The corners of a convex piece on one closed side of a plane; none if nothing lies strictly there.
Corners part(const Corners& piece, const std::vector<Rational>& heights, int side) {
  Corners kept;
  const std::size_t n = piece.size();
  bool is_any_inside = false;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n;
    const int s = side * heights[i].sign(), t = side * heights[k].sign();
    is_any_inside = is_any_inside || s > 0;
    if (s >= 0) kept.push_back(piece[i]);
    if (s * t >= 0 || (n == 2 && i == 1)) continue;
    kept.push_back(piece[i] + Rational(heights[i] / (heights[i] - heights[k])) * (piece[k] - piece[i]));
  }
  return is_any_inside ? kept : Corners{};
}

Corners before(const Corners& piece, const Wall& wall) {
  std::vector<Rational> heights;
  for (const ExactVector& v : piece) heights.push_back(wall.at(v));
  return part(piece, heights, 1);
}

/// Splits a piece by planes, so that none cuts any part of it.
std::vector<Corners> cells(Corners piece, const std::vector<Wall>& planes) {
  std::vector<Corners> all{std::move(piece)};
  for (const Wall& plane : planes) {
    for (std::size_t i = all.size(); i-- > 0;) {
      std::vector<Rational> heights;
      for (const ExactVector& v : all[i]) heights.push_back(plane.at(v));
      const auto is = [&](int sign) {
        return std::any_of(heights.begin(), heights.end(), [&](const Rational& h) { return h.sign() == sign; });
      };
      if (!is(1) || !is(-1)) continue;
      all.push_back(part(all[i], heights, -1));
      all[i] = part(all[i], heights, 1);
    }
  }
  return all;
}

ExactVector middle_of(const Corners& piece) {
  ExactVector sum;
  for (const ExactVector& v : piece) sum = sum + v;
  return Rational(1, piece.size()) * sum;
}

/// Looks for a hidden and for a visible piece of what counts of the light.
class Look {
 public:
  Look(std::span<const ConvexBlocker> blockers, const ExactVector& normal, const ExactVector& p)
      : p_(p), segment_(p, normal) {
    for (const ConvexBlocker& blocker : blockers) bodies_.push_back(body_of(blocker));
  }

  Region region(const Corners& piece) {
    look_at(piece, 0);
    return is_any_hidden_ && is_any_seen_ ? Region::penumbra : is_any_hidden_ ? Region::umbra : Region::lit;
  }

  Region region_of_point(const ExactVector& l, bool is_way) const {
    const bool is_hidden =
        std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) { return segment_.meets(body, l, is_way); });
    return is_hidden ? Region::umbra : Region::lit;
  }

 private:
  void look_at(const Corners& piece, std::size_t first) {
    if (is_any_hidden_ && is_any_seen_) return;
    if (first == bodies_.size()) {
      is_any_seen_ = true;
      return;
    }
    for (const Corners& cell : cells(piece, planes_of(bodies_[first]))) {
      if (segment_.meets(bodies_[first], middle_of(cell), false)) {
        is_any_hidden_ = true;
      } else {
        look_at(cell, first + 1);
      }
    }
  }

  std::vector<Wall> planes_of(const Body& body) const {
    std::vector<Wall> planes = body.walls;
    for (const auto& [a, b] : body.edges) planes.push_back(wall_through(p_, a, b));
    return planes;
  }

  ExactVector p_;
  Segment segment_;
  std::vector<Body> bodies_;
  bool is_any_hidden_ = false;
  bool is_any_seen_ = false;
};

}  // namespace

Region region_before_plane(const Light& light, std::span<const ConvexBlocker> blockers, const ExactVector& normal,
                           const ExactVector& p) {
  const Wall plane{normal, -dot(normal, p)};
  Look look(blockers, normal, p);
  if (const auto* point = std::get_if<PointLight>(&light)) {
    const ExactVector l = exact(point->position);
    return plane.at(l) > 0 ? look.region_of_point(l, false) : Region::unlit;
  }
  if (const auto* parallel = std::get_if<DirectionalLight>(&light)) {
    const ExactVector way = Rational(-1) * exact(parallel->direction);
    return dot(normal, way) > 0 ? look.region_of_point(way, true) : Region::unlit;
  }
  Corners whole;
  if (const auto* linear = std::get_if<LinearLight>(&light)) whole = {exact(linear->start), exact(linear->end)};
  if (const auto* area = std::get_if<AreaLight>(&light)) {
    whole = corners_of(area->polygon);
    const int side = wall_through(whole[0], whole[1], whole[2]).at(p).sign();
    if (side == 0 || (side < 0 && !area->two_sided)) return Region::unlit;
  }
  const Corners counts = before(whole, plane);
  return counts.empty() ? Region::unlit : look.region(counts);
}

}  // namespace gnomon::test_support
