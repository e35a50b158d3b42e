#include "tests/shading/illumination/factor_oracles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gnomon::factors {
namespace {

using Long = long double;

struct Rule {
  std::vector<Long> node;  ///< on [0, 1]
  std::vector<Long> weight;
};

/// By Newton's method on Legendre's polynomial.
Rule gauss_rule(int n) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    Long x = std::cos(std::numbers::pi_v<Long> * (i + 0.75L) / (n + 0.5L)), slope = 1;
    for (int step = 0; step < 50; ++step) {
      Long p = 1, before = 0;
      for (int k = 0; k < n; ++k) {
        const Long next = ((2 * k + 1) * x * p - k * before) / (k + 1);
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.node.push_back((1 - x) / 2);
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

using Vec = std::array<Long, 3>;

Vec vec(const Point3& p) {
  return {p.x, p.y, p.z};
}
Vec minus(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Long dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A point of a triangle with the share of area it stands for, times the normal.
struct Sample {
  Vec point;
  Vec area;
};

std::vector<Sample> samples(const ConvexPolygon& triangle, const Rule& rule) {
  const auto p = triangle.points();
  const Vec a = vec(p[0]), u = minus(vec(p[1]), a), v = minus(vec(p[2]), a), n = cross(u, v);
  std::vector<Sample> found;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    for (std::size_t j = 0; j < rule.node.size(); ++j) {
      const Long r = rule.node[i], s = r * (1 - rule.node[j]), t = r * rule.node[j];
      const Long w = rule.weight[i] * rule.weight[j] * r;
      Sample sample{};
      for (std::size_t k = 0; k < 3; ++k) {
        sample.point[k] = a[k] + s * u[k] + t * v[k];
        sample.area[k] = w * n[k];
      }
      found.push_back(sample);
    }
  }
  return found;
}

/// Irradiance over pi of a level rectangle at height h above a level receiver at the origin, of radiance 1: the sum of
/// four corners.
Long level_rectangle(Long x0, Long x1, Long y0, Long y1, Long h) {
  const auto corner = [h](Long x, Long y) {
    const Long a = std::hypot(x, h), b = std::hypot(y, h);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * std::numbers::pi_v<Long>);
  };
  if (x1 <= x0 || y1 <= y0) return 0;
  return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
}

/// Where the shadows of a blocker's two sides at height z cross the borders 0 and 1 of the lid, within [0, 1].
std::vector<Long> breaks(Long low, Long high, Long z) {
  std::vector<Long> found = {0, 1};
  for (const Long side : {low, high}) {
    for (const Long border : {0.0L, 1.0L}) {
      const Long at = (side - z * border) / (1 - z);
      if (at > 0 && at < 1) found.push_back(at);
    }
  }
  std::ranges::sort(found);
  return found;
}

Point3 along_axes(int axis, double side, double u, double v) {
  std::array<double, 3> c{};
  c[static_cast<std::size_t>(axis)] = side;
  c[static_cast<std::size_t>((axis + 1) % 3)] = u;
  c[static_cast<std::size_t>((axis + 2) % 3)] = v;
  return {c[0], c[1], c[2]};
}

/// A rectangle across an axis whose front looks up that axis, or down.
ConvexPolygon across_axis(int axis, double side, std::array<double, 2> u, std::array<double, 2> v, bool up) {
  std::vector<Point3> ring = {along_axes(axis, side, u[0], v[0]), along_axes(axis, side, u[1], v[0]),
                              along_axes(axis, side, u[1], v[1]), along_axes(axis, side, u[0], v[1])};
  if (!up) std::ranges::reverse(ring);
  return ConvexPolygon::from_points(ring);
}

}  // namespace

ConvexPolygon rectangle_at(double x0, double y0, double x1, double y1, double z, Facing facing) {
  return across_axis(2, z, {x0, x1}, {y0, y1}, facing == Facing::up);
}

ConvexPolygon parallelogram(const Point3& corner, const Point3& first, const Point3& second) {
  const Point3 far{first.x + second.x - corner.x, first.y + second.y - corner.y, first.z + second.z - corner.z};
  return ConvexPolygon::from_points({corner, first, far, second});
}

ConvexPolygon turned_to(const ConvexPolygon& polygon, int axis, bool up) {
  const auto p = polygon.points();
  const Vec n = cross(minus(vec(p[1]), vec(p[0])), minus(vec(p[2]), vec(p[0])));
  std::vector<Point3> ring(p.begin(), p.end());
  if ((n[static_cast<std::size_t>(axis)] > 0) != up) std::ranges::reverse(ring);
  return ConvexPolygon::from_points(ring);
}

double double_area_integral(const ConvexPolygon& first, const ConvexPolygon& second) {
  static const Rule rule = gauss_rule(14);
  const std::vector<Sample> p = samples(first, rule), q = samples(second, rule);
  Long sum = 0;
  for (const Sample& a : p) {
    for (const Sample& b : q) {
      const Vec r = minus(b.point, a.point);
      const Long rr = dot(r, r);
      sum -= dot(a.area, r) * dot(b.area, r) / (std::numbers::pi_v<Long> * rr * rr);
    }
  }
  return static_cast<double>(sum);
}

double behind_rectangle(double x0, double x1, double y0, double y1, double z) {
  static const Rule rule = gauss_rule(28);
  const std::vector<Long> xs = breaks(x0, x1, z), ys = breaks(y0, y1, z);
  Long sum = 0;
  const auto seen = [&](Long x, Long y) {
    const auto shadow = [&](Long side, Long p) { return std::clamp(p + (side - p) / Long(z), 0.0L, 1.0L); };
    return level_rectangle(-x, 1 - x, -y, 1 - y, 1) -
           level_rectangle(shadow(x0, x) - x, shadow(x1, x) - x, shadow(y0, y) - y, shadow(y1, y) - y, 1);
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      const Long w = xs[i + 1] - xs[i], h = ys[j + 1] - ys[j];
      for (std::size_t a = 0; a < rule.node.size(); ++a) {
        for (std::size_t b = 0; b < rule.node.size(); ++b) {
          sum += w * h * rule.weight[a] * rule.weight[b] * seen(xs[i] + w * rule.node[a], ys[j] + h * rule.node[b]);
        }
      }
    }
  }
  return static_cast<double>(sum);
}

std::vector<ViewSurface> cube_walls(int n) {
  std::vector<ViewSurface> walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 1.0}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto at = [n](int k) { return static_cast<double>(k) / n; };
          walls.push_back({across_axis(axis, side, {at(i), at(i + 1)}, {at(j), at(j + 1)}, side == 0)});
        }
      }
    }
  }
  return walls;
}

void add_box(std::vector<ViewSurface>& surfaces, std::vector<ConvexBlocker>& blockers, const Point3& low,
             const Point3& high) {
  const std::array<double, 3> a = {low.x, low.y, low.z}, b = {high.x, high.y, high.z};
  std::vector<Point3> corners;
  for (const double x : {a[0], b[0]}) {
    for (const double y : {a[1], b[1]}) {
      for (const double z : {a[2], b[2]}) corners.push_back({x, y, z});
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool up : {false, true}) {
      surfaces.push_back({across_axis(static_cast<int>(axis), up ? b[axis] : a[axis], {a[u], b[u]}, {a[v], b[v]}, up)});
    }
  }
  blockers.emplace_back(ConvexSolid::hull_of(corners));
}

std::pair<std::vector<ViewSurface>, std::vector<ConvexBlocker>> l_shaped_room() {
  std::vector<ViewSurface> walls;
  for (const bool is_floor : {true, false}) {
    const double z = is_floor ? 0 : 1;
    const Facing facing = is_floor ? Facing::up : Facing::down;
    walls.push_back({rectangle_at(0, 0, 2, 1, z, facing), rectangle_at(0, 1, 1, 2, z, facing)});
  }
  const auto wall = [](double x0, double y0, double x1, double y1) {
    return ConvexPolygon::from_points({{x0, y0, 0}, {x0, y0, 1}, {x1, y1, 1}, {x1, y1, 0}});
  };
  // Counterclockwise around, seen from above, with the inside on the left.
  const std::array<std::array<double, 2>, 6> ring = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  std::vector<ConvexBlocker> corner;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& p = ring[k];
    const auto& q = ring[(k + 1) % 6];
    walls.push_back({wall(p[0], p[1], q[0], q[1])});
    if (k == 2 || k == 3) corner.emplace_back(wall(p[0], p[1], q[0], q[1]));
  }
  return {walls, corner};
}

}  // namespace gnomon::factors
