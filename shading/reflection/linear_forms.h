#pragma once

/// What a stretch of a linear light gives, for numbers of either level. Private to the libraries.

#include "shading/reflection/lobe.h"
#include "shading/reflection/lobe_table.h"

namespace gnomon::shading {

/// A part of a linear light, relative to the point: from one end on along a way of its own, which a short part needs.
template <class Number>
struct Stretch {
  Vector3<Number> from;
  Vector3<Number> along;
};

inline int certain_sign(const Rational& a) {
  return a.sign();
}

enum class Cut { nothing_left, done, uncertain };

/// Leaves of a stretch what lies on an axis' side.
template <class Number>
Cut cut_before(Stretch<Number>& stretch, const Vector3<Number>& axis) {
  const Number a = dot(axis, stretch.from);
  const Number slope = dot(axis, stretch.along);
  const Number b = a + slope;
  const int from = certain_sign(a), to = certain_sign(b);
  if (from == 2 || to == 2) return Cut::uncertain;
  if (from <= 0 && to <= 0) return Cut::nothing_left;
  if (from < 0) {
    const Number share = -a / slope;
    const Vector3<Number> skipped = times(share, stretch.along);
    stretch.from = plus(stretch.from, skipped);
    const Number kept = b / slope;
    stretch.along = times(kept, stretch.along);
  } else if (to < 0) {
    const Number kept = -a / slope;
    stretch.along = times(kept, stretch.along);
  }
  return Cut::done;
}

/// A stretch as an arc of directions.
template <class Number>
struct StretchArc {
  Arc<Number> arc;
  Number distance;         ///< of the light's line, h
  Vector3<Number> change;  ///< from the first unit vector to the last

  /// Requires: a stretch that is not seen end-on.
  /// v - u is (D - u D . (A + B) / (|A| + |B|)) / |B|, which keeps the digits of a short D.
  explicit StretchArc(const Stretch<Number>& s) {
    const Vector3<Number> to = plus(s.from, s.along);
    const Vector3<Number> axis = cross(s.from, s.along);
    const Number axis_length = norm(axis), from_length = norm(s.from), to_length = norm(to);
    const Vector3<Number> u = over(s.from, from_length);
    arc = {u, over(to, to_length), over(axis, axis_length), atan2(axis_length, dot(s.from, to))};
    distance = axis_length / norm(s.along);
    const Number share = dot(s.along, plus(s.from, to)) / (from_length + to_length);
    change = over(minus(s.along, times(share, u)), to_length);
  }
};

/// The integral of w . u along an arc from what its unit vectors change by.
template <class Number>
Number cosine_moment(const StretchArc<Number>& seen, const Vector3<Number>& w) {
  return dot(cross(seen.arc.axis, w), seen.change);
}

/// cos^m(beta) of the light's emission along one of its arcs: beta is the angle from the foot of the perpendicular.
template <class Number>
struct Shine {
  int exponent = 0;
  Vector3<Number> foot;  ///< the direction to it; of use only where m > 0

  Shine(int m, const Stretch<Number>& stretch, const Arc<Number>& arc) : exponent(m) {
    if (m > 0) foot = cross(unit_of(stretch.along), arc.axis);
  }
  Number at(const Vector3<Number>& u) const { return power(dot(foot, u), exponent); }
};

/// The integral of (w . u)^n (N . u) in closed form: with w_p the part of w in the arc's plane and c its length, N is
/// p w_p + q m x w_p there, and (w . u)^n (m x w) . u is the slope of -(w . u)^(n+1) / (n+1).
template <class Number>
Number cosine_weighted_moment(const Arc<Number>& arc, const Vector3<Number>& w, const Vector3<Number>& normal, int n) {
  const ArcAxis<Number> axis = arc_axis(arc, w);
  const Number out_of_plane = dot(w, arc.axis);
  const Number p = (dot(normal, w) - dot(normal, arc.axis) * out_of_plane) / axis.square;
  const Number q = dot(normal, cross(arc.axis, w)) / axis.square;
  const Number rise = (power(axis.end, n + 1) - power(axis.start, n + 1)) / Number(n + 1.0);
  return p * quick_moment(axis, n + 1) - q * rise;
}

/// The integral of (w . u)^n (N . u) (f . u), for f in the arc's plane: N is p w_p + q m x w_p there and f alike, x = w
/// . u, y = (m x w) . u, y² = c² - x².
template <class Number>
Number twice_weighted_moment(const Arc<Number>& arc, const Vector3<Number>& w, const Vector3<Number>& normal,
                             const Vector3<Number>& f, int n) {
  const ArcAxis<Number> axis = arc_axis(arc, w);
  const Vector3<Number> across = cross(arc.axis, w), in_plane = minus(w, times(dot(w, arc.axis), arc.axis));
  const Number p1 = dot(normal, in_plane) / axis.square, q1 = dot(normal, across) / axis.square;
  const Number p2 = dot(f, in_plane) / axis.square, q2 = dot(f, across) / axis.square;
  ArcMoments<Number> moments(axis, n % 2);
  while (moments.order() < n) moments.step();
  const Number low = moments.value();
  moments.step();
  const Number rise = (power(axis.end, n + 2) - power(axis.start, n + 2)) / Number(n + 2.0);
  return p1 * p2 * moments.value() - (p1 * q2 + p2 * q1) * rise + q1 * q2 * (axis.square * low - moments.value());
}

/// True where closed forms lose the relative accuracy that Gauss's rule keeps.
inline bool is_short(double angle, int exponent) {
  return exponent > 0 && std::sqrt(exponent) * angle < 0.2;
}

/// Irradiance of a stretch above the horizon: alike in every direction k (m x N) . (v - u) / h, and with cos^m the
/// moment of f weighted by the cosine.
/// After: [PA90] §3; [P93] §3.2.2 for m = 1.
template <class Number>
Number linear_diffuse(const StretchArc<Number>& seen, const Vector3<Number>& normal, const Shine<Number>& shine) {
  const int m = shine.exponent;
  if (m == 0) return cosine_moment(seen, normal) / seen.distance;
  const auto by_gauss = [&] {
    const CentredArc<Number> centred(seen.arc);
    const double angle = middle(seen.arc.angle);
    const InPlane cosine(centred, normal), foot(centred, shine.foot);
    const auto value = [&](const Number& s) { return dot(normal, centred.at(s)) * shine.at(centred.at(s)); };
    const auto most = [&](const Ellipse& e) { return 1.01 * cosine.most(e) * std::pow(foot.most(e), m); };
    return gauss_integral(centred.half, GaussEffort{1e-12 * angle, 400}, value, most) / seen.distance;
  };
  if (is_short(middle(seen.arc.angle), m)) return by_gauss();
  const Number closed = cosine_weighted_moment(seen.arc, shine.foot, normal, m) / seen.distance;
  const double peak = middle(seen.arc.angle) / middle(seen.distance);
  return bounded(closed).error <= 1e-12 * peak ? closed : narrower(closed, by_gauss());
}

/// By Gauss's rule, for every lobe.
template <class Number>
Number lobe_by_gauss(const Arc<Number>& arc, const Directions<Number>& view, const Lobe& lobe,
                     const Shine<Number>& shine) {
  const CentredArc<Number> centred(arc);
  const GaussEffort effort{1e-12 * lobe_peak(lobe.exponent, middle(arc.angle)), 400};
  const LobeBound lobe_bound(lobe, view, centred);
  if (shine.exponent == 0) {
    const auto value = [&](const Number& s) { return lobe_value(lobe, view, centred.at(s)); };
    return gauss_integral(centred.half, effort, value, lobe_bound);
  }
  const InPlane foot(centred, shine.foot);
  const auto value = [&](const Number& s) {
    const Vector3<Number> u = centred.at(s);
    return lobe_value(lobe, view, u) * shine.at(u);
  };
  const auto most = [&](const Ellipse& e) { return 1.01 * lobe_bound(e) * std::pow(foot.most(e), shine.exponent); };
  return gauss_integral(centred.half, effort, value, most);
}

/// True if there is a closed form: of lobes about the mirrored eye with cos beta at most once, or of no exponent.
inline bool has_closed_form(const Lobe& lobe, int emission) {
  return !lobe.is_about_halfway() && (emission <= 1 || lobe.exponent == 0);
}

/// In closed form, of a lobe about the mirrored eye.
template <class Number>
Number mirror_lobe(const StretchArc<Number>& seen, const Directions<Number>& view, const Lobe& lobe,
                   const Shine<Number>& shine) {
  const int n = lobe.exponent, m = shine.exponent;
  if (m > 0 && n == 0) {
    return lobe.has_cosine() ? cosine_weighted_moment(seen.arc, shine.foot, view.normal, m)
                             : quick_moment(arc_axis(seen.arc, shine.foot), m);
  }
  if (m > 0) {
    return lobe.has_cosine() ? twice_weighted_moment(seen.arc, view.mirror, view.normal, shine.foot, n)
                             : cosine_weighted_moment(seen.arc, view.mirror, shine.foot, n);
  }
  if (n == 0) return lobe.has_cosine() ? cosine_moment(seen, view.normal) : seen.arc.angle;
  if (lobe.has_cosine()) return cosine_weighted_moment(seen.arc, view.mirror, view.normal, n);
  return n == 1 ? cosine_moment(seen, view.mirror) : quick_moment(arc_axis(seen.arc, view.mirror), n);
}

/// The lobe's part of a stretch that lies above the horizon and, for lobes about R, where R . u >= 0. Short arcs keep
/// relative accuracy by Gauss's rule only; where the closed form has no good bound that is tried as well.
template <class Number>
Number linear_lobe(const StretchArc<Number>& seen, const Directions<Number>& view, const Lobe& lobe,
                   const Shine<Number>& shine) {
  const auto by_gauss = [&] { return lobe_by_gauss(seen.arc, view, lobe, shine) / seen.distance; };
  const double angle = middle(seen.arc.angle), peak = lobe_peak(lobe.exponent, angle);
  // Next to R's plane Gauss's rule cannot tell on which side of it a lobe without exponent is.
  const bool is_step = lobe.exponent == 0 && !lobe.is_about_halfway();
  if (!has_closed_form(lobe, shine.exponent) || (is_short(angle, lobe.exponent) && !is_step)) return by_gauss();
  const Number closed = mirror_lobe(seen, view, lobe, shine) / seen.distance;
  if (bounded(closed).error <= 1e-12 * peak / middle(seen.distance)) return closed;
  return is_step ? closed : narrower(closed, by_gauss());
}

/// Of a light seen end-on from `near` to `far`, lengths along the unit vector u: one direction, and the integral of
/// 1 / r² is (far - near) / (near far).
template <class Number>
Number end_on_weight(const Number& near, const Number& far) {
  return (far - near) / (near * far);
}

}  // namespace gnomon::shading
