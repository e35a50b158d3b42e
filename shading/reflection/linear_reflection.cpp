#include "shading/reflection/linear_reflection.h"

#include <algorithm>

#include "shading/reflection/emission.h"
#include "shading/reflection/linear_forms.h"

namespace gnomon::shading {
namespace {

/// How the light shines, in numbers of one level.
template <class Number>
struct Shining {
  int exponent = 0;
  std::optional<Number> flaps;  ///< their tangent

  explicit Shining(const Emission& emission) : exponent(emission.exponent) {
    if (emission.flaps) flaps = tangent_of<Number>(*emission.flaps);
  }
};

/// Adds to a sum what `part(seen, shine)` makes of what flaps leave of a stretch.
template <class Number, class Part>
void add_between_flaps(Number& sum, const Stretch<Number>& stretch, const Shining<Number>& shining, const Part& part) {
  BetweenFlaps<Number> kept{BetweenFlaps<Number>::Left::part, stretch, 0};
  if (shining.flaps) kept = between_flaps(stretch, *shining.flaps);
  if (kept.left == BetweenFlaps<Number>::Left::crumb) sum = widened(sum, kept.crumb);
  if (kept.left != BetweenFlaps<Number>::Left::part) return;
  const StretchArc<Number> seen(kept.stretch);
  sum = sum + part(seen, Shine<Number>(shining.exponent, kept.stretch, seen.arc));
}

/// Returns the distance of the light's line.
template <class Number>
double add_received(Integrals<Number>& sums, const Stretch<Number>& stretch, const Directions<Number>& view,
                    const Shining<Number>& shining) {
  const auto diffuse = [&](const StretchArc<Number>& seen, const Shine<Number>& shine) {
    return linear_diffuse(seen, view.normal, shine);
  };
  const StretchArc<Number> all(stretch);
  if (shining.flaps) {
    add_between_flaps(sums.received, stretch, shining, diffuse);
  } else {
    sums.received = sums.received + diffuse(all, Shine<Number>(shining.exponent, stretch, all.arc));
  }
  sums.received_peak += middle(all.arc.angle) / middle(all.distance);
  return middle(all.distance);
}

template <class Number>
void add_lobe(Integrals<Number>& sums, const Stretch<Number>& stretch, const Directions<Number>& view, const Lobe& lobe,
              const Shining<Number>& shining) {
  add_between_flaps(sums.lobe, stretch, shining, [&](const StretchArc<Number>& seen, const Shine<Number>& shine) {
    return linear_lobe(seen, view, lobe, shine);
  });
}

template <class Number>
void set_lobe_peak(Integrals<Number>& sums, const Lobe& lobe, double distance) {
  sums.lobe_peak = std::fmin(sums.received_peak, lobe_peak(lobe.exponent, std::numbers::pi) / distance);
}

/// A difference of doubles, rounded.
Vector3<Bounded> rounded_difference(const Point3& a, const Point3& b, int size) {
  const Vector d = scaled({a.x - b.x, a.y - b.y, a.z - b.z}, -size);
  return {{d.x, unit * std::fabs(d.x)}, {d.y, unit * std::fabs(d.y)}, {d.z, unit * std::fabs(d.z)}};
}

int size_of(const Point3& a, const Point3& b) {
  return exponent(Vector{a.x - b.x, a.y - b.y, a.z - b.z});
}

/// Adds a stretch of the fast level; false if that does not decide.
bool add_stretch(Integrals<Bounded>& sums, Stretch<Bounded> stretch, const Directions<Bounded>& view, const Lobe& lobe,
                 const Shining<Bounded>& shining) {
  const Cut horizon = cut_before(stretch, view.normal);
  if (horizon == Cut::uncertain) return false;
  if (horizon == Cut::nothing_left) return true;
  const double distance = add_received(sums, stretch, view, shining);
  const Cut mirror = lobe.is_about_halfway() ? Cut::done : cut_before(stretch, view.mirror);
  if (mirror == Cut::uncertain) return false;
  if (mirror == Cut::done) add_lobe(sums, stretch, view, lobe, shining);
  set_lobe_peak(sums, lobe, distance);
  return true;
}

/// What is visible of a light, cut exactly.
struct ExactParts {
  std::vector<Stretch<Rational>> above_horizon;
  std::vector<Stretch<Rational>> before_mirror;  ///< for lobes about R, else as above
  bool is_end_on = false;
  bool holds_point = false;
  int size = 0;  ///< lengths are divided by 2^size
};

Vector3<Rational> rational_vector(const ExactVector& v) {
  return {v.x, v.y, v.z};
}

ExactVector exact_vector(const Vector3<Rational>& v) {
  return {v.x, v.y, v.z};
}

bool is_null(const Vector3<Rational>& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

/// The binary exponent of the nearest end, which integrals fall with; but the farthest must not overflow.
int nearest_exponent(const std::vector<Stretch<Rational>>& parts) {
  int nearest = std::numeric_limits<int>::max(), farthest = std::numeric_limits<int>::min();
  for (const Stretch<Rational>& part : parts) {
    for (const Vector3<Rational>& end : {part.from, plus(part.from, part.along)}) {
      const ExactVector v = exact_vector(end);
      if (is_zero(v)) continue;
      const int size = exponent(Vector{nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)});
      nearest = std::min(nearest, size);
      farthest = std::max(farthest, size);
    }
  }
  return farthest == std::numeric_limits<int>::min() ? 0 : std::max(nearest, farthest - 900);
}

Rational two_to(int exponent) {
  const int half = exponent / 2;
  return Rational(std::scalbn(1.0, half)) * Rational(std::scalbn(1.0, exponent - half));
}

void divide(std::vector<Stretch<Rational>>& parts, const Rational& by) {
  const Rational factor = 1 / by;
  for (Stretch<Rational>& part : parts) part = {times(factor, part.from), times(factor, part.along)};
}

ExactParts exact_parts(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                       const ReflectionQuery& query) {
  const Vector3<Rational> start = rational_vector(exact(light.start) - exact(query.point));
  const Vector3<Rational> along = rational_vector(exact(light.end) - exact(light.start));
  const Vector3<Rational> normal = rational_vector(exact(query.normal)), mirror = rational_vector(exact_mirror(query));
  ExactParts parts;
  parts.is_end_on = is_null(cross(start, along));
  for (const std::array<Rational, 2>& interval : intervals) {
    Stretch<Rational> part{plus(start, times(interval[0], along)), times(Rational(interval[1] - interval[0]), along)};
    if (cut_before(part, normal) != Cut::done) continue;
    parts.above_horizon.push_back(part);
    parts.holds_point |= parts.is_end_on && dot(part.from, plus(part.from, part.along)) <= 0;
    if (query.lobe.is_about_halfway() || cut_before(part, mirror) == Cut::done) parts.before_mirror.push_back(part);
  }
  parts.size = nearest_exponent(parts.above_horizon);
  const Rational by = two_to(parts.size);
  divide(parts.above_horizon, by);
  divide(parts.before_mirror, by);
  return parts;
}

template <class Number>
Stretch<Number> in_numbers(const Stretch<Rational>& part) {
  return {vector_of<Number>(exact_vector(part.from)), vector_of<Number>(exact_vector(part.along))};
}

template <class Number>
Integrals<Number> across(const ExactParts& parts, const Directions<Number>& view, const Lobe& lobe,
                         const Emission& emission) {
  const Shining<Number> shining(emission);
  Integrals<Number> sums;
  double distance = 1;
  for (const Stretch<Rational>& part : parts.above_horizon) {
    distance = add_received(sums, in_numbers<Number>(part), view, shining);
  }
  for (const Stretch<Rational>& part : parts.before_mirror) {
    add_lobe(sums, in_numbers<Number>(part), view, lobe, shining);
  }
  set_lobe_peak(sums, lobe, distance);
  return sums;
}

/// One direction u, and 1 / r² along it.
template <class Number>
Integrals<Number> end_on(const ExactParts& parts, const Directions<Number>& view, const Lobe& lobe) {
  Integrals<Number> sums;
  for (const Stretch<Rational>& part : parts.above_horizon) {
    const Stretch<Number> s = in_numbers<Number>(part);
    const Number a = norm(s.from), b = norm(plus(s.from, s.along));
    const bool comes_nearer = dot(part.from, part.along) < 0;
    const Number weight = comes_nearer ? norm(s.along) / (b * a) : norm(s.along) / (a * b);
    const Vector3<Number> u = over(s.from, a);
    sums.received = sums.received + weight * dot(view.normal, u);
    sums.lobe = sums.lobe + weight * lobe_value(lobe, view, u);
    sums.received_peak += middle(weight);
  }
  sums.lobe_peak = sums.received_peak;
  return sums;
}

}  // namespace

std::optional<Reflection> linear_reflection(const LinearLight& light, const VisibleLinearLight& seen,
                                            const ReflectionQuery& query) {
  if (!is_shone_at(light, query.point)) return Reflection{};
  const int size = std::max(size_of(light.start, query.point), size_of(light.end, light.start));
  const Vector3<Bounded> start = rounded_difference(light.start, query.point, size);
  const Vector3<Bounded> along = rounded_difference(light.end, light.start, size);
  const Directions<Bounded> view = directions<Bounded>(query.normal, query.to_eye);
  const Shining<Bounded> shining(light.emission);
  Integrals<Bounded> sums;
  for (const VisibleStretch& stretch : seen.visible) {
    const Bounded from(stretch.from.share, stretch.from.error), to(stretch.to.share, stretch.to.error);
    const Stretch<Bounded> part{plus(start, times(from, along)), times(to - from, along)};
    if (!add_stretch(sums, part, view, query.lobe, shining)) return std::nullopt;
  }
  if (!is_narrow(sums)) return std::nullopt;
  return reflection(sums, size);
}

Reflection linear_reflection(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                             const ReflectionQuery& query) {
  if (!is_shone_at(light, query.point)) return {};
  const ExactParts parts = exact_parts(light, intervals, query);
  const bool shines_ahead = light.emission.exponent == 0 && !light.emission.flaps;
  if (parts.is_end_on && !parts.holds_point && !shines_ahead) return {};
  if (parts.holds_point) return {{HUGE_VAL, HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};
  const auto ask = [&]<class Number>(const Number&) {
    const Directions<Number> view = directions<Number>(query.normal, query.to_eye);
    return parts.is_end_on ? end_on(parts, view, query.lobe) : across(parts, view, query.lobe, light.emission);
  };
  return with_rising_precision(ask, parts.size);
}

}  // namespace gnomon::shading
