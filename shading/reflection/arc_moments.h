#pragma once

/// Integrals of powers along arcs of great circles. Private to the libraries.

#include <cstddef>
#include <span>
#include <vector>

#include "shading/reflection/space.h"

namespace gnomon::shading {

/// An arc of a great circle, less than half a turn.
/// Orientation: counterclockwise from `start` to `end` about `axis`; all are unit vectors.
template <class Number>
struct Arc {
  Vector3<Number> start;
  Vector3<Number> end;
  Vector3<Number> axis;
  Number angle;
};

/// A direction w as an arc sees it.
template <class Number>
struct ArcAxis {
  Number start, end;              ///< w . u at the ends
  Number start_slope, end_slope;  ///< -w . (m x u) there: the slope against the turn
  Number square;                  ///< squared length of w in the arc's plane, |m x w|²
  Number angle;
};

template <class Number>
ArcAxis<Number> arc_axis(const Arc<Number>& arc, const Vector3<Number>& w) {
  const Vector3<Number> across = cross(arc.axis, w);
  return {dot(w, arc.start),    dot(w, arc.end),     dot(across, arc.start),
          dot(across, arc.end), dot(across, across), arc.angle};
}

/// The moments D_k of an arc about a direction, for k = first, first + 2, ... one after the other.
///
/// Definition: D_k is the integral of (w . u)^k along the arc; k D_k = s_b b^(k-1) - s_a a^(k-1) + (k-1) c² D_(k-2).
/// Exactness:  that of the numbers; an error shrinks by (k-1) c² / k < 1 at each step.
/// After:      Gradshteyn and Ryzhik 2.510; [Arvo95] §4.
template <class Number>
class ArcMoments {
 public:
  /// Requires: first is 0 or 1.
  ArcMoments(const ArcAxis<Number>& axis, int first)
      : start_square_(axis.start * axis.start),
        end_square_(axis.end * axis.end),
        square_(axis.square),
        order_(first),
        value_(first == 0 ? axis.angle : axis.end_slope - axis.start_slope),
        start_(axis.start_slope * (first == 0 ? axis.start : start_square_)),
        end_(axis.end_slope * (first == 0 ? axis.end : end_square_)) {}

  int order() const { return order_; }
  const Number& value() const { return value_; }

  /// On to the order after the next.
  void step() {
    order_ += 2;
    value_ = folded(order_ - 1.0, square_, value_, end_ - start_, order_);
    start_ = start_ * start_square_;
    end_ = end_ * end_square_;
  }

 private:
  Number start_square_, end_square_, square_;
  int order_;
  Number value_, start_, end_;
};

/// D_k alone.
template <class Number>
Number arc_moment(const ArcAxis<Number>& axis, int k) {
  ArcMoments<Number> moments(axis, k % 2);
  while (moments.order() < k) moments.step();
  return moments.value();
}

}  // namespace gnomon::shading
