#pragma once

/// Conics and lines of a plane, with rational points. Private to geometry/.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/flat_point.h"
#include "geometry/numbers/real_roots.h"

namespace gnomon::conic {

using event::FlatPoint;

/// A linear function of homogeneous coordinates (w, x, y), up to a positive factor.
using Covector = std::array<Integer, 3>;

/// Lines that turn about a point: (1 - t) start + t end.
struct LinePencil {
  Covector start;
  Covector end;
};

/// Both lines with one common factor, in integers.
LinePencil line_pencil(const std::array<Rational, 3>& start, const std::array<Rational, 3>& end);

/// The line through two points, the left side positive.
Covector line_through(const FlatPoint& from, const FlatPoint& to);

/// A conic, or a straight line.
///
/// The conic is what two pencils draw whose lines meet: the point at t is where those at t cross ([Steiner]). A
/// straight line has one of the coordinates as t.
struct FlatCurve {
  bool is_straight = false;
  std::array<Coefficients, 3> point;   ///< w, x and y at t, of degree 2 or 1, without a common factor
  std::array<Integer, 6> form;         ///< zero on it: of ww, wx, wy, xx, xy, yy; if straight of w, x, y and zeros
  std::vector<LinePencil> parameters;  ///< t of a point: that of the line through it, of each of these

  /// Nothing at infinity.
  std::optional<FlatPoint> at(const Rational& t) const;
};

FlatCurve straight_curve(const Covector& line);

/// The same conic by another parameter, which is infinite at the point whose parameter is `pole` now: a point at t has
/// (pole - 1) t / (pole - t) then.
/// Requires: pole is not 0, nor 1.
FlatCurve with_pole(const FlatCurve& conic, const Rational& pole);

/// A part of a curve, from one t to a greater one, ends included.
struct FlatArc {
  FlatCurve curve;
  Rational from;
  Rational to;
};

/// A closed range of numbers.
struct Range {
  Rational from;
  Rational to;
};

/// The arc of the conic that two pencils draw, or what it degenerates to, as far as it may reach into a square.
/// Parameters: half_width  of the square around the origin; needed where a straight line runs to infinity.
std::vector<FlatArc> arcs(const LinePencil& j, const LinePencil& k, const Range& range, const Rational& half_width);

/// The curve's form at the points of another curve: zero where they meet.
Polynomial form_along(const FlatCurve& curve, const FlatCurve& other);

/// A covector at the points of a curve.
Coefficients along(const Covector& covector, const FlatCurve& curve);

/// The parameter of a curve as a quotient of polynomials in that of another that it meets.
struct ParameterAlong {
  Coefficients numerator;
  Coefficients denominator;
};

ParameterAlong parameter_along(const LinePencil& parameter, const FlatCurve& other);

/// The curve's form at a point, up to a positive factor; its sign.
int side(const FlatCurve& curve, const FlatPoint& point);

/// The coefficients of the curve's form at p + s d, a quadratic function of s, up to one positive factor.
std::array<Rational, 3> form_on_line(const FlatCurve& curve, const FlatPoint& p, const FlatPoint& d);

/// The tangent's direction at t, up to a positive factor. Requires: a point not at infinity.
FlatPoint direction(const FlatCurve& curve, const Rational& t);

/// The Bezier points (w, x, y) between two parameters. Exact.
std::array<std::array<Rational, 3>, 3> bezier_points(const FlatCurve& curve, const Rational& from, const Rational& to);

/// Whether all three of them have weights of one sign, the middle one not so small that the arc is nearly half of a
/// curve.
bool is_short(const FlatCurve& curve, const Rational& from, const Rational& to);

/// +1 if the form is positive on the left of the curve where it passes t.
int positive_side(const FlatCurve& curve, const Rational& t);

}  // namespace gnomon::conic
