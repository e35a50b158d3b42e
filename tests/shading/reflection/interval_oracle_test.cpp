#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfi.hpp>
#include <optional>
#include <vector>

#include "gnomon/reflection.h"
#include "tests/shading/reflection/drawn_views.h"

// The closed forms once more, in intervals of 256 bits from the exact ends on, written anew: no code is shared with
// what they judge. Where an interval does not tell a sign the case is passed over.

namespace gnomon {
namespace {

using namespace test_support;

/// 77 digits.
using Interval =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<77>, boost::multiprecision::et_off>;

struct Direction {
  Interval x, y, z;
};

Direction direction_of(const Point3& p) {
  return {p.x, p.y, p.z};
}

Direction operator-(const Direction& a, const Direction& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Direction scaled_by(const Interval& s, const Direction& a) {
  return {s * a.x, s * a.y, s * a.z};
}

Direction plus(const Direction& a, const Direction& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Interval scalar(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Direction vectorial(const Direction& a, const Direction& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Direction of_length_one(const Direction& a) {
  return scaled_by(1 / sqrt(scalar(a, a)), a);
}

/// Nothing if it is not certain.
std::optional<bool> is_positive(const Interval& a) {
  if (lower(a) > 0) return true;
  if (upper(a) < 0) return false;
  return std::nullopt;
}

/// The angle of (x, y), y positive.
Interval angle_of(const Interval& x, const Interval& y) {
  const Interval half_turn = acos(Interval(-1));
  return half_turn / 2 - atan(x / y);
}

using Corners = std::vector<Direction>;

/// What of a polygon, or of a line of two corners, lies before a plane.
std::optional<Corners> before(const Corners& corners, const Direction& w) {
  Corners result;
  const std::size_t n = corners.size(), sides = n == 2 ? 1 : n;
  std::vector<bool> is_kept;
  for (const Direction& corner : corners) {
    const auto sign = is_positive(scalar(w, corner));
    if (!sign) return std::nullopt;
    is_kept.push_back(*sign);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (is_kept[k]) result.push_back(corners[k]);
    const std::size_t next = (k + 1) % n;
    if (k >= sides || is_kept[k] == is_kept[next]) continue;
    const Interval from = scalar(w, corners[k]), to = scalar(w, corners[next]);
    result.push_back(plus(corners[k], scaled_by(from / (from - to), corners[next] - corners[k])));
  }
  return result;
}

/// An arc between two directions, and w as it sees it.
struct Seen {
  Direction axis;
  Interval angle, a, b, slope_a, slope_b, square;

  Seen(const Direction& from, const Direction& to, const Direction& w) {
    const Direction u = of_length_one(from), v = of_length_one(to), m = vectorial(u, v);
    const Interval sine = sqrt(scalar(m, m));
    axis = scaled_by(1 / sine, m);
    angle = angle_of(scalar(u, v), sine);
    a = scalar(w, u), b = scalar(w, v);
    slope_a = -scalar(w, vectorial(axis, u)), slope_b = -scalar(w, vectorial(axis, v));
    square = 1 - scalar(w, axis) * scalar(w, axis);
  }

  /// k D_k = s_b b^(k-1) - s_a a^(k-1) + (k-1) c² D_(k-2).
  Interval moment(int k) const {
    if (k == 0) return angle;
    if (k == 1) return slope_b - slope_a;
    return (slope_b * pow(b, k - 1) - slope_a * pow(a, k - 1) + (k - 1) * square * moment(k - 2)) / k;
  }
};

/// The signed solid angle of a triangle of directions.
Interval solid_angle(const Direction& p, const Direction& q, const Direction& r) {
  const Direction u = of_length_one(p), v = of_length_one(q), w = of_length_one(r);
  const Interval volume = scalar(u, vectorial(v, w)), rest = 1 + scalar(u, v) + scalar(v, w) + scalar(w, u);
  return 2 * atan(volume / rest);
}

struct Surface {
  Direction normal, mirror;

  explicit Surface(const View& view) : normal(of_length_one(direction_of(view.normal))) {
    const Direction eye = of_length_one(direction_of(view.to_eye));
    mirror = scaled_by(2 * scalar(normal, eye), normal) - eye;
  }
};

/// Of a line: k D_n / h, and with the cosine in N's parts along and across the mirrored eye's in the plane.
std::optional<Interval> line_lobe(const Corners& ends, const Surface& surface, bool has_cosine, int n) {
  const auto above = before(ends, surface.normal);
  if (!above) return std::nullopt;
  if (above->empty()) return Interval(0);
  const auto kept = before(*above, surface.mirror);
  if (!kept) return std::nullopt;
  if (kept->empty()) return Interval(0);
  const Direction along = (*kept)[1] - (*kept)[0], across = vectorial((*kept)[0], along);
  const Interval distance = sqrt(scalar(across, across) / scalar(along, along));
  const Seen seen((*kept)[0], (*kept)[1], surface.mirror);
  if (!has_cosine) return seen.moment(n) / distance;
  const Direction in_plane = surface.mirror - scaled_by(scalar(surface.mirror, seen.axis), seen.axis);
  const Interval p = scalar(surface.normal, in_plane) / seen.square;
  const Interval q = scalar(surface.normal, vectorial(seen.axis, surface.mirror)) / seen.square;
  return (p * seen.moment(n + 1) - q * (pow(seen.b, n + 1) - pow(seen.a, n + 1)) / (n + 1)) / distance;
}

/// Of a polygon: (k+1) tau^k = (k-1) tau^(k-2) + the sum of (w . m) D_(k-1).
std::optional<Interval> polygon_lobe(const Corners& corners, const Surface& surface, int n) {
  const auto above = before(corners, surface.normal);
  const auto kept = above && !above->empty() ? before(*above, surface.mirror) : above;
  if (!kept) return std::nullopt;
  if (kept->size() < 3) return Interval(0);
  std::vector<Seen> sides;
  Interval tau = 0;
  for (std::size_t k = 0; k < kept->size(); ++k) {
    sides.emplace_back((*kept)[k], (*kept)[(k + 1) % kept->size()], surface.mirror);
    if (n % 2 == 0 && k > 1) tau += solid_angle((*kept)[0], (*kept)[k - 1], (*kept)[k]);
  }
  for (int k = n % 2 == 0 ? 2 : 1; k <= n; k += 2) {
    Interval sum = (k - 1) * tau;
    for (const Seen& side : sides) sum += scalar(surface.mirror, side.axis) * side.moment(k - 1);
    tau = sum / (k + 1);
  }
  return tau;
}

void expect_inside(const Interval& exact, const Irradiance& got, int round) {
  ASSERT_LE(upper(Interval(abs(exact - got.value))), got.error_bound) << round;
  ASSERT_LE(upper(exact) - lower(exact), 1e-40);
}

View drawn_visibility(Dice& dice, const Point3& towards) {
  View view{{0, 0, 0}, added(drawn_vector(dice), 1, towards), {}};
  view.to_eye = dice.once_in(3) ? drawn_vector(dice) : added(mirrored(towards, view.normal), 0.4, drawn_vector(dice));
  return view;
}

TEST(ReflectionIntervals, HoldWhatIsReflectedOfLines) {
  Dice dice(91);
  int compared = 0;
  for (int round = 0; compared < (GNOMON_LONG ? 10000 : 500); ++round) {
    const LinearLight light{added({0, 0, 2}, 1.5, drawn_vector(dice)), added({0, 0, 2}, 1.5, drawn_vector(dice))};
    const View view = drawn_visibility(dice, light.start);
    const int n = dice.draw(1, 40);
    if (product(view.normal, view.to_eye) <= 0) continue;
    const Corners ends = {direction_of(light.start), direction_of(light.end)};
    LightReflection tube(light, PreparedObstacles({}));
    for (const ReflectionModel model : {ReflectionModel::phong, ReflectionModel::phong_classic}) {
      const auto exact = line_lobe(ends, Surface(view), model == ReflectionModel::phong, n);
      if (!exact) continue;
      expect_inside(*exact, tube.at(view, model, n).lobe, round);
      if (HasFatalFailure()) return;
      ++compared;
    }
  }
}

TEST(ReflectionIntervals, HoldWhatIsReflectedOfPolygons) {
  Dice dice(92);
  int compared = 0;
  for (int round = 0; compared < (GNOMON_LONG ? 10000 : 500); ++round) {
    std::vector<Point3> corners;
    for (int k = 0; k < 3; ++k) corners.push_back(added({0, 0, 2}, 1.5, drawn_vector(dice)));
    const View view = drawn_visibility(dice, corners[0]);
    const int n = dice.draw(1, 30);
    if (product(view.normal, view.to_eye) <= 0 || ConvexPolygon::defect(corners)) continue;
    Corners seen;
    for (const Point3& corner : corners) seen.push_back(direction_of(corner));
    const auto turn = is_positive(scalar(seen[0], vectorial(seen[1], seen[2])));
    if (!turn) continue;
    if (!*turn) std::swap(seen[1], seen[2]);
    const auto exact = polygon_lobe(seen, Surface(view), n);
    if (!exact) continue;
    LightReflection lamp(AreaLight{ConvexPolygon::from_points(corners), true}, PreparedObstacles({}));
    expect_inside(*exact, lamp.at(view, ReflectionModel::phong_classic, n).lobe, round);
    if (HasFatalFailure()) return;
    ++compared;
  }
}

}  // namespace
}  // namespace gnomon
