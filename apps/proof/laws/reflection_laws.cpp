#include "apps/proof/laws/law_lists.h"

#include <cmath>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/reflection_cases.h"

namespace gnomon::laws {
namespace {

/// What is certain of a number.
struct Enclosed {
  double low = 0, high = 0;

  Enclosed() = default;
  Enclosed(double least, double most) : low(least), high(most) {}
  Enclosed(const Irradiance& e)  // NOLINT: a number with its bound
      : low(e.value - e.error_bound * (1 + 0x1p-50)), high(e.value + e.error_bound * (1 + 0x1p-50)) {}
};

/// Sums and products are widened by what they may round.
Enclosed widened_by_rounding(double low, double high) {
  const double slack = 0x1p-50 * std::fmax(std::fabs(low), std::fabs(high));
  return {low - slack, high + slack};
}

Enclosed operator+(const Enclosed& a, const Enclosed& b) {
  return widened_by_rounding(a.low + b.low, a.high + b.high);
}

Enclosed operator*(double s, const Enclosed& a) {
  return widened_by_rounding(s * a.low, s * a.high);
}

bool may_be_equal(const Enclosed& a, const Enclosed& b) {
  return a.low <= b.high && b.low <= a.high;
}

bool may_be_at_most(const Enclosed& a, const Enclosed& b) {
  return a.low <= b.high;
}

struct Seen {
  Enclosed received, lobe;
};

/// Nothing where the point lies on the light, or nothing reaches the eye.
std::optional<Seen> seen(const Subject& subject, const ReflectionCase& drawn, const Light& light,
                         const gnomon::View& view, int exponent) {
  const Reflection r = subject.reflection(light, {drawn.blockers, {}}, view, drawn.model, exponent);
  if (!(r.received.error_bound < HUGE_VAL) || !(r.lobe.error_bound < HUGE_VAL)) return std::nullopt;
  return Seen{r.received, r.lobe};
}

std::optional<Seen> seen(const Subject& subject, const ReflectionCase& drawn) {
  const std::optional<Seen> all = seen(subject, drawn, drawn.light, drawn.view, drawn.exponent);
  if (!all || all->received.high <= 0) return std::nullopt;
  return all;
}

bool may_be_equal(const Seen& a, const Seen& b) {
  return may_be_equal(a.received, b.received) && may_be_equal(a.lobe, b.lobe);
}

Point3 between(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/// A light in two: a line at a place that is a double, a polygon along the diagonal from its first corner.
std::optional<std::array<Light, 2>> parts_of(const ReflectionCase& drawn) {
  const std::vector<Point3> p = corners_of(drawn.light);
  if (p.size() == 2) {
    const Point3 cut = between(p[0], p[1], drawn.share);
    return std::array<Light, 2>{with_points(drawn.light, {p[0], cut}), with_points(drawn.light, {cut, p[1]})};
  }
  if (p.size() < 4) return std::nullopt;
  return std::array<Light, 2>{with_points(drawn.light, {p[0], p[1], p[2]}),
                              with_points(drawn.light, {p[0], p[2], p[3]})};
}

Verdict check_parts(const ReflectionCase& drawn, const Subject& subject) {
  const auto whole = seen(subject, drawn);
  const auto parts = parts_of(drawn);
  if (!whole || !parts) return premise_fails();
  const auto a = seen(subject, drawn, (*parts)[0], drawn.view, drawn.exponent);
  const auto b = seen(subject, drawn, (*parts)[1], drawn.view, drawn.exponent);
  if (!a || !b) return premise_fails();
  return verdict(may_be_equal(*whole, {a->received + b->received, a->lobe + b->lobe}), "two parts are not the whole");
}

Verdict check_order(const ReflectionCase& drawn, const Subject& subject) {
  const auto whole = seen(subject, drawn);
  if (!whole) return premise_fails();
  std::vector<Point3> points = corners_of(drawn.light);
  std::rotate(points.begin(), points.begin() + 1, points.end());
  const auto other = seen(subject, drawn, with_points(drawn.light, points), drawn.view, drawn.exponent);
  return verdict(other && may_be_equal(*whole, *other), "another first vertex gives something else");
}

Verdict check_turn(const ReflectionCase& drawn, const Subject& subject) {
  const auto whole = seen(subject, drawn);
  if (!whole) return premise_fails();
  const auto turned = [](const Point3& p) { return Point3{p.y, -p.z, -p.x}; };
  std::vector<Point3> points = corners_of(drawn.light);
  for (Point3& p : points) p = turned(p);
  const gnomon::View view{turned(drawn.view.point), turned(drawn.view.normal), turned(drawn.view.to_eye)};
  const auto other = seen(subject, drawn, with_points(drawn.light, points), view, drawn.exponent);
  return verdict(other && may_be_equal(*whole, *other), "turned, it gives something else");
}

Verdict check_scale(const ReflectionCase& drawn, const Subject& subject) {
  const auto whole = seen(subject, drawn);
  if (!whole) return premise_fails();
  const auto larger = [](const Point3& p) { return Point3{64 * p.x, 64 * p.y, 64 * p.z}; };
  std::vector<Point3> points = corners_of(drawn.light);
  const double falls = points.size() == 2 ? 64 : 1;
  for (Point3& p : points) p = larger(p);
  const gnomon::View view{larger(drawn.view.point), drawn.view.normal, drawn.view.to_eye};
  const auto other = seen(subject, drawn, with_points(drawn.light, points), view, drawn.exponent);
  return verdict(other && may_be_equal(*whole, {falls * other->received, falls * other->lobe}),
                 "64 times as large, it gives something else");
}

bool is_brdf(const ReflectionCase& drawn) {
  return drawn.model == ReflectionModel::phong || drawn.model == ReflectionModel::blinn;
}

/// From a direction to an eye as from the eye's direction to it.
Verdict check_reciprocal(const ReflectionCase& drawn, const Subject& subject) {
  const Point3 first = corners_of(drawn.light)[0], &p = drawn.view.point;
  const Point3 a{first.x - p.x, first.y - p.y, first.z - p.z}, &b = drawn.view.to_eye;
  if (!is_brdf(drawn) || a == Point3{}) return premise_fails();
  const auto from_to = [&](const Point3& light, const Point3& eye) {
    const DirectionalLight sun{{-light.x, -light.y, -light.z}};
    return subject.reflection(sun, {}, {p, drawn.view.normal, eye}, drawn.model, drawn.exponent);
  };
  const Reflection there = from_to(a, b), back = from_to(b, a);
  if (there.received.value <= 0 || back.received.value <= 0) return premise_fails();
  // lobe / cosine of each, compared without dividing; none of the factors is above 1.
  const double difference = std::fabs(back.received.value * there.lobe.value - there.received.value * back.lobe.value);
  const double bound =
      there.lobe.error_bound + back.lobe.error_bound + back.received.error_bound + there.received.error_bound + 0x1p-50;
  return verdict(difference <= 1.01 * bound, "light and eye may not change places");
}

Verdict check_energy(const ReflectionCase& drawn, const Subject& subject) {
  const auto whole = seen(subject, drawn);
  if (!whole || !is_brdf(drawn)) return premise_fails();
  return verdict(may_be_at_most(whole->lobe, whole->received), "the lobe weighs more than what is received");
}

/// Sharper lobes about R hold less, and their integrals are logarithmically convex in the exponent.
Verdict check_exponents(const ReflectionCase& drawn, const Subject& subject) {
  if (drawn.exponent == 0 || !seen(subject, drawn)) return premise_fails();
  const auto with = [&](int n) { return seen(subject, drawn, drawn.light, drawn.view, n); };
  const auto below = with(drawn.exponent - 1), at = with(drawn.exponent), above = with(drawn.exponent + 1);
  if (!below || !at || !above) return premise_fails();
  if (!may_be_at_most(at->lobe, below->lobe) || !may_be_at_most(above->lobe, at->lobe)) {
    return verdict(false, "a sharper lobe holds more");
  }
  const double square = std::fmax(at->lobe.low, 0) * std::fmax(at->lobe.low, 0);
  return verdict(square <= (1 + 0x1p-40) * below->lobe.high * above->lobe.high, "not logarithmically convex");
}

rc::Gen<ReflectionCase> mirrored_lobes(Domain domain) {
  return rc::gen::map(reflection_cases(domain), [](ReflectionCase drawn) {
    drawn.model = ReflectionModel::phong_classic;
    return drawn;
  });
}

/// A board between the point and the light.
rc::Gen<ReflectionCase> cases_behind_boards(Domain domain) {
  return rc::gen::map(reflection_cases(domain), [](ReflectionCase drawn) {
    const std::vector<Point3> points = corners_of(drawn.light);
    const Point3 &p = drawn.view.point, a = between(p, points[0], 0.5), b = between(p, points[1], 0.5);
    const double size = std::fmax(std::fabs(a.x - b.x), std::fmax(std::fabs(a.y - b.y), std::fabs(a.z - b.z)));
    const std::vector<Point3> board = {a, b, {b.x + size, b.y + size, b.z}};
    if (!ConvexPolygon::defect(board)) drawn.blockers.push_back(ConvexPolygon::from_points(board));
    return drawn;
  });
}

Verdict check_blockers(const ReflectionCase& drawn, const Subject& subject) {
  ReflectionCase open = drawn;
  open.blockers.clear();
  const auto all = seen(subject, open);
  if (drawn.blockers.empty() || !all) return premise_fails();
  const auto behind = seen(subject, drawn, drawn.light, drawn.view, drawn.exponent);
  return verdict(behind && may_be_at_most(behind->received, all->received) && may_be_at_most(behind->lobe, all->lobe),
                 "a blocker brings light");
}

}  // namespace

std::vector<Law> reflection_laws() {
  return {
      law({"H1", "own", "What a surface reflects of a light is the sum of what it reflects of its parts."},
          reflection_cases, check_parts),
      law({"H2", "own", "It does not matter which vertex of a light is its first."}, reflection_cases, check_order),
      law({"H3", "own", "Turning the whole scene changes nothing."}, reflection_cases, check_turn),
      law({"H4", "own", "With all lengths s times as large a linear light gives 1/s, an area light the same."},
          reflection_cases, check_scale),
      law({"H5", "[LW94]", "In the models phong and blinn light and eye may change places."}, reflection_cases,
          check_reciprocal),
      law({"H6", "[LW94]", "In these models the lobe without its norm weighs no more than what is received."},
          reflection_cases, check_energy),
      law({"H7", "[Arvo95]",
           "The integral of (R . L)^n falls with n, and its square is at most the product of its neighbours'."},
          mirrored_lobes, check_exponents),
      law({"H8", "own", "One blocker more brings no light."}, cases_behind_boards, check_blockers),
  };
}

}  // namespace gnomon::laws
