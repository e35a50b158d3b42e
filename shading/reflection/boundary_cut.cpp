#include "shading/reflection/boundary_cut.h"

namespace gnomon::shading {
namespace {

using BoundedVector = Vector3<Bounded>;

/// Bound. The length rounds by less than 3 u of itself, and so do parts of it by 4 u. A vector whose coordinates are
/// off by a small part of its length turns by no more than that part times the root of 3, and a coordinate moves with
/// it.
BoundedVector unit_direction(const VisibleDirection& d) {
  const Vector v = of_size_one(vector(d));
  const double off = d.error * length_above(v), size = length(v);
  if (!(off < 0x1p-10 * size)) return unit_of(BoundedVector{{v.x, off}, {v.y, off}, {v.z, off}});
  const double moved = 2.8 * off / size;
  const auto part = [&](double x) { return Bounded(x / size, moved + 5 * unit * std::fabs(x / size)); };
  return {part(v.x), part(v.y), part(v.z)};
}

Arc<Bounded> arc_between(const BoundedVector& a, const BoundedVector& b, const BoundedVector& axis) {
  return {a, b, axis, atan2(dot(axis, cross(a, b)), dot(a, b))};
}

/// A plane through the point, and the direction along which what is below it is moved onto it.
struct Fold {
  BoundedVector normal;
  BoundedVector lift;
  Bounded rise;  ///< normal . lift
};

/// Up, but not below the light's plane.
Fold horizon_fold(const BoundedVector& normal, const BoundedVector& forward) {
  const Bounded slope = dot(normal, forward);
  if (slope.value >= 0) return {normal, normal, 1.0};
  const BoundedVector lift = minus(normal, times(slope, forward));
  return {normal, lift, dot(normal, lift)};
}

/// Along R, but neither below the horizon nor below the light's plane: with f forward, l = R + a N + b f where b makes
/// l . f = 0 if that would be negative, and a makes l . N = 0 if that would be.
Fold mirror_fold(const Directions<Bounded>& view, const BoundedVector& forward) {
  const BoundedVector& w = view.mirror;
  const Bounded wf = dot(w, forward), nf = dot(view.normal, forward);
  if (wf.value >= 0) return {w, w, 1.0};
  const Bounded rest = view.eye_height - nf * wf;
  const Bounded up = rest.value < 0 ? -rest / (Bounded(1.0) - nf * nf) : Bounded(0.0);
  const Bounded ahead = -wf - up * nf;
  const BoundedVector lift = plus(plus(w, times(up, view.normal)), times(ahead, forward));
  return {w, lift, dot(w, lift)};
}

/// The arcs of a boundary on the positive side of a plane, and shadows of the others.
class Folding {
 public:
  explicit Folding(const Fold& fold) : fold_(fold) {}

  /// False if doubles do not decide.
  bool add(const Arc<Bounded>& arc) {
    const Bounded a = dot(fold_.normal, arc.start), b = dot(fold_.normal, arc.end);
    const int from = certain_sign(a), to = certain_sign(b);
    if (from == 2 || to == 2) return false;
    if (from >= 0 && to >= 0) {
      above.push_back(arc);
      return true;
    }
    if (from <= 0 && to <= 0) return add_shadow(arc.start, a, arc.end, b);
    const BoundedVector cut = unit_of(from > 0 ? minus(times(a, arc.end), times(b, arc.start))
                                               : minus(times(b, arc.start), times(a, arc.end)));
    if (from > 0) {
      above.push_back(arc_between(arc.start, cut, arc.axis));
      return add_shadow(cut, 0.0, arc.end, b);
    }
    above.push_back(arc_between(cut, arc.end, arc.axis));
    return add_shadow(arc.start, a, cut, 0.0);
  }

  std::vector<Arc<Bounded>> above;
  std::vector<Arc<Bounded>> shadows;  ///< on the plane, counterclockwise about its normal or about the opposite

 private:
  bool add_shadow(const BoundedVector& a, const Bounded& a_height, const BoundedVector& b, const Bounded& b_height) {
    if (certain_sign(fold_.rise) != 1) return false;
    const BoundedVector p = unit_of(minus(a, times(a_height / fold_.rise, fold_.lift)));
    const BoundedVector q = unit_of(minus(b, times(b_height / fold_.rise, fold_.lift)));
    const Bounded turn = atan2(dot(fold_.normal, cross(p, q)), dot(p, q));
    if (!(turn.error < 0.01)) return false;
    if (turn.value >= 0) {
      shadows.push_back({p, q, fold_.normal, turn});
    } else {
      shadows.push_back({p, q, opposite(fold_.normal), -turn});
    }
    return true;
  }

  const Fold& fold_;
};

/// What arcs on R's plane turn about R together.
Bounded turn_about(const std::vector<Arc<Bounded>>& shadows, const BoundedVector& w) {
  Bounded sum = 0.0;
  for (const Arc<Bounded>& arc : shadows) {
    const bool is_counterclockwise = dot(arc.axis, w).value > 0;
    sum = is_counterclockwise ? sum + arc.angle : sum - arc.angle;
  }
  return sum;
}

}  // namespace

std::optional<VisibleBoundary<Bounded>> cut_boundary(const VisibleAreaLight& seen, const Directions<Bounded>& view) {
  const BoundedVector forward = unit_direction(seen.forward);
  const Fold horizon = horizon_fold(view.normal, forward), mirror = mirror_fold(view, forward);
  Folding to_horizon(horizon), to_mirror(mirror);
  for (const BoundaryPiece& piece : seen.boundary) {
    const BoundedVector axis = unit_direction(piece.normal);
    if (!to_horizon.add(arc_between(unit_direction(piece.start), unit_direction(piece.end), axis))) return std::nullopt;
  }
  VisibleBoundary<Bounded> result;
  result.above_horizon = std::move(to_horizon.above);
  for (Arc<Bounded>& shadow : to_horizon.shadows) result.above_horizon.push_back(std::move(shadow));
  for (const Arc<Bounded>& arc : result.above_horizon) {
    if (!to_mirror.add(arc)) return std::nullopt;
  }
  result.before_mirror = std::move(to_mirror.above);
  result.closing = turn_about(to_mirror.shadows, view.mirror);
  return result;
}

}  // namespace gnomon::shading
