#pragma once

/// Moments of several arcs about one direction. Private to the libraries.

#include <vector>

#include "shading/reflection/arc_moments.h"

namespace gnomon::shading {

/// What the moments of an area light ask of arcs m_i, u_i -> v_i about a direction w.
template <class Number>
struct ArcSums {
  std::vector<Number>
      sums;  ///< for k = order, order - 2, ... down to 1 or 2, the least first: sum of (w . m_i) D_(k-1)
  std::vector<Number> last;  ///< D_(order+1) of each arc
};

/// Requires: order >= 0; closing arcs are not among these.
template <class Number>
ArcSums<Number> arc_sums(const std::vector<Arc<Number>>& arcs, const Vector3<Number>& w, int order) {
  ArcSums<Number> result{std::vector<Number>(static_cast<std::size_t>((order + 1) / 2)), {}};
  for (const Arc<Number>& arc : arcs) {
    const Number height = dot(w, arc.axis);
    ArcMoments<Number> moments(arc_axis(arc, w), (order + 1) % 2);
    for (Number& sum : result.sums) {
      sum = sum + height * moments.value();
      moments.step();
    }
    result.last.push_back(moments.value());
  }
  return result;
}

/// The same by the same recurrence, two arcs at a time, in the two halves of a register.
ArcSums<Bounded> arc_sums(const std::vector<Arc<Bounded>>& arcs, const Vector3<Bounded>& w, int order);

}  // namespace gnomon::shading
