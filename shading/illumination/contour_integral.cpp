#include "shading/illumination/contour_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/numbers/exact_vector.h"
#include "shading/reflection/gauss.h"
#include "shading/reflection/space.h"

namespace gnomon::illumination {
namespace {

using shading::Bounded;
using shading::Vector;
using BoundedVector = Vector3<Bounded>;

struct Edge {
  Point3 from;
  Point3 to;
};

BoundedVector way(const Point3& from, const Point3& to) {
  return {Bounded(to.x) - Bounded(from.x), Bounded(to.y) - Bounded(from.y), Bounded(to.z) - Bounded(from.z)};
}

/// Bound. The logarithm changes by at most the error over what is left of the number; the library's errs by less than
/// 2 u of itself, or near 1 of the number's distance from it.
Bounded log(const Bounded& a) {
  const double least = a.value - a.error;
  if (!(least > 0)) return {0, HUGE_VAL};
  const double value = std::log(a.value);
  return {value, 1.01 * a.error / least + 2 * shading::unit * std::fabs(value)};
}

/// The length of a vector, near 0 too.
/// Bound. It changes by at most the length of the change.
Bounded length(const BoundedVector& a) {
  const double value = std::sqrt(a.x.value * a.x.value + a.y.value * a.y.value + a.z.value * a.z.value);
  const double off = std::sqrt(a.x.error * a.x.error + a.y.error * a.y.error + a.z.error * a.z.error);
  return {value, 1.01 * off + 4 * shading::unit * value};
}

/// x ln(x² + r²) / 2 - x + r atan(x / r), whose slope is ln of the distance; continuous at 0, where it is 0.
Bounded log_distance_integral(const Bounded& x, const Bounded& r) {
  const Bounded squared = x * x + r * r;
  const double most = shading::largest(x) + shading::largest(r);
  if (!(squared.value > 2 * squared.error)) {
    // |x ln| and |r atan| for numbers of at most `most`, which is tiny.
    return {0, most == 0 ? 0 : most * (std::fabs(std::log(most)) + 3)};
  }
  return Bounded(0.5) * x * log(squared) - x + r * atan2(x, r);
}

/// The second integral of ln of the distance, of parallel lines r apart: its second derivative by x is ln(x² + r²) / 2.
Bounded twice_integrated(const Bounded& x, const Bounded& r) {
  const Bounded xx = x * x, rr = r * r, squared = xx + rr;
  if (!(squared.value > 2 * squared.error)) {
    const double most = shading::largest(x) + shading::largest(r);
    return {0, most == 0 ? 0 : most * most * (std::fabs(std::log(most)) + 3)};
  }
  return Bounded(0.25) * (xx - rr) * log(squared) - Bounded(0.75) * xx + r * x * atan2(x, r);
}

/// Distances of edges in doubles, for bounds.
class EdgeDistance {
 public:
  EdgeDistance(const Edge& first, const Edge& second)
      : p_(step(second.from, first.from)), d_(step(first.from, first.to)), e_(step(second.from, second.to)) {}

  double length_of_first() const { return 1.01 * std::sqrt(dot(d_, d_)); }

  /// At most the distance of the points from s to t of the first edge, which may reach beyond its ends, from the other.
  double least(double s, double t) const {
    double found = std::min({from_second(s), from_second(t), to_first(0, s, t), to_first(1, s, t)});
    const double dd = dot(d_, d_), de = dot(d_, e_), ee = dot(e_, e_), pd = dot(p_, d_), pe = dot(p_, e_);
    const double below = dd * ee - de * de;
    if (below > 1e-10 * dd * ee) {
      const double at = (de * pe - ee * pd) / below, on = (dd * pe - de * pd) / below;
      if (at >= s && at <= t && on >= 0 && on <= 1) found = std::min(found, apart(at, on));
    }
    return found;
  }
  double most(double s, double t) const {
    double found = 0;
    for (const double at : {s, t}) {
      const Vector a = p_ + at * d_, b = a - e_;
      found = std::max({found, dot(a, a), dot(b, b)});
    }
    return 1.01 * std::sqrt(found) + 0x1p-50 * (sum_norm(p_) + sum_norm(d_) + sum_norm(e_));
  }

 private:
  /// At most the distance of two points of the lines, and little less.
  double apart(double s, double t) const {
    const Vector b = p_ + s * d_ - t * e_;
    const double slack = 0x1p-48 * (sum_norm(p_) + std::fabs(s) * sum_norm(d_) + std::fabs(t) * sum_norm(e_));
    return std::max(0.0, 0.999 * std::sqrt(dot(b, b)) - slack);
  }
  double from_second(double s) const {
    const Vector a = p_ + s * d_;
    return apart(s, std::clamp(dot(a, e_) / dot(e_, e_), 0.0, 1.0));
  }
  double to_first(double on, double s, double t) const {
    const Vector end = p_ - on * e_;
    return apart(std::clamp(-dot(end, d_) / dot(d_, d_), s, t), on);
  }

  Vector p_, d_, e_;
};

bool are_parallel(const Edge& first, const Edge& second) {
  const Vector d = step(first.from, first.to), e = step(second.from, second.to), c = cross(d, e);
  if (sum_norm(c) > 1e-12 * sum_norm(d) * sum_norm(e)) return false;
  return is_zero(cross(exact(first.to) - exact(first.from), exact(second.to) - exact(second.from)));
}

bool are_on_one_line(const Edge& first, const Edge& second) {
  const Vector d = step(first.from, first.to), e = step(first.from, second.from), c = cross(d, e);
  if (sum_norm(c) > 1e-12 * sum_norm(d) * sum_norm(e)) return false;
  return is_zero(cross(exact(first.to) - exact(first.from), exact(second.from) - exact(first.from)));
}

/// The double integral of ln |p - q| dp . dq over two edges that are parallel, or nearly so.
/// Bound. Of an edge that runs along a line, the integral of ln of the distance changes at a distance of r from the
/// line at most 2 (ln(2 size / r) + 1) times as fast as the point moves; so within a way of `off` by 2 off (ln(2 size /
/// off)
/// + 2).
Bounded parallel_integral(const Edge& first, const Edge& second) {
  const BoundedVector d = way(first.from, first.to), e = way(second.from, second.to);
  const Bounded size = length(d);
  const BoundedVector along = over(d, size), apart = way(second.from, first.from);
  const Bounded r = are_on_one_line(first, second) ? Bounded(0) : length(cross(apart, along));
  // Places on the first edge's direction, from the second's start.
  const Bounded start = dot(apart, along), end = start + size, far = dot(e, along);
  // The double integral over x from start to end and y from 0 to far of ln of (x - y)² + r², halved.
  const Bounded sum = twice_integrated(end, r) - twice_integrated(start, r) - twice_integrated(end - far, r) +
                      twice_integrated(start - far, r);
  const double off = shading::largest(length(cross(e, along)));
  if (are_parallel(first, second) || off == 0) return sum;
  const double reach = shading::largest(size) + off;
  return widened(sum, 2 * off * (std::log(2 * reach / off) + 2) * shading::largest(length(e)));
}

/// The same over two edges that are not parallel: the inner integral in closed form, the outer one by Gauss's rule.
class SkewIntegral {
 public:
  SkewIntegral(const Edge& first, const Edge& second)
      : distance_(first, second),
        start_(way(second.from, first.from)),
        d_(way(first.from, first.to)),
        size_(length(way(second.from, second.to))),
        along_(over(way(second.from, second.to), size_)),
        weight_(dot(d_, along_)),
        shares_start_(first.from == second.from) {}

  /// Nothing where too many pieces would be needed: of edges that nearly are one line.
  std::optional<Bounded> value(double tolerance) const {
    if (shading::is_exact_zero(weight_)) return 0.0;
    const double share = tolerance / std::max(shading::largest(weight_), 1e-300);
    // Beside a common start everything is known in parts of itself, elsewhere only in parts of the edges.
    const double least_half = shares_start_ ? 0x1p-60 : 0x1p-46;
    Bounded sum = 0.0;
    std::vector<std::array<double, 2>> waiting = {{0, 1}};
    for (int pieces = 0; !waiting.empty(); ++pieces) {
      if (pieces == 4000) return std::nullopt;
      const auto [from, to] = waiting.back();
      waiting.pop_back();
      const double middle = from / 2 + to / 2, half = to / 2 - from / 2;
      const double error = rule_error(middle, half), allowed = share * std::max(half, 0x1p-6);
      if (error <= allowed || half < least_half) {
        const Bounded part = error <= allowed ? rule(middle, half) : Bounded(0, 2 * half * largest_inner());
        sum = widened(sum + part, error <= allowed ? error : 0);
        continue;
      }
      waiting.push_back({middle, to});
      waiting.push_back({from, middle});
    }
    return weight_ * sum;
  }

 private:
  /// The integral of ln of the distance from a point of the first edge along the second.
  Bounded inner(const Bounded& s) const {
    const BoundedVector a = plus(start_, times(s, d_));
    const Bounded h = dot(a, along_), r = length(cross(a, along_));
    return log_distance_integral(size_ - h, r) - log_distance_integral(-h, r);
  }

  Bounded rule(double middle, double half) const {
    const auto& gauss = shading::gauss_rule<Bounded>();
    Bounded part = 0.0;
    for (std::size_t k = 0; k < gauss.node.size(); ++k) {
      const Bounded step = Bounded(half) * gauss.node[k];
      part = part + gauss.weight[k] * (inner(Bounded(middle) + step) + inner(Bounded(middle) - step));
    }
    return Bounded(half) * part;
  }

  /// Bound. As gauss_integral. With complex s of imaginary part y the squared distance is |A|² - y² |d|² + 2 i y A . d
  /// for a real A on the first edge's line: as long as |A| > |y d| it keeps a positive real part and lies between
  /// (|A| - |y d|)² and (|A| + |y d|)², so that its logarithm is at most as large as theirs, and pi / 2 aside.
  double rule_error(double middle, double half) const {
    double error = HUGE_VAL;
    for (const double log_rho : shading::log_ellipses) {
      const double real = half * std::cosh(log_rho), imaginary = half * std::sinh(log_rho);
      const double aside = 1.001 * imaginary * distance_.length_of_first();
      const double least = distance_.least(middle - real, middle + real) - aside;
      if (!(least > 0)) break;
      const double most = distance_.most(middle - real, middle + real) + aside;
      const double ln = std::max(std::fabs(std::log(least)), std::fabs(std::log(most))) + 1.6;
      const double decay = std::exp(-2.0 * shading::gauss_nodes * log_rho) / (1 - std::exp(-2 * log_rho));
      error = std::min(error, 1.01 * 64 / 15 * ln * shading::largest(size_) * decay * half);
    }
    return error;
  }

  /// At least |inner| anywhere on the first edge: ln of distances up to `most`, and near 0 that of a line's points.
  double largest_inner() const {
    const double size = shading::largest(size_), most = distance_.most(0, 1);
    return size * (std::fabs(std::log(most)) + std::fabs(std::log(size)) + 3);
  }

  EdgeDistance distance_;
  BoundedVector start_, d_;
  Bounded size_;
  BoundedVector along_;
  Bounded weight_;
  bool shares_start_;
};

Bounded edge_integral(Edge first, Edge second) {
  if (are_parallel(first, second)) return parallel_integral(first, second);
  double sign = 1;
  if (first.to == second.from || first.to == second.to) {
    std::swap(first.from, first.to);
    sign = -sign;
  }
  if (first.from == second.to) {
    std::swap(second.from, second.to);
    sign = -sign;
  }
  // As small as what is rounded anyway.
  const std::optional<Bounded> value = SkewIntegral(first, second).value(1e-17);
  return Bounded(sign) * (value ? *value : parallel_integral(first, second));
}

bool is_between(const Point3& p, const Edge& edge) {
  if (p == edge.from || p == edge.to || !are_on_one_line(edge, {p, p})) return false;
  return dot(step(edge.from, p), step(edge.from, edge.to)) > 0 && dot(step(edge.to, p), step(edge.to, edge.from)) > 0;
}

/// The edges, divided where a vertex of the others touches them.
std::vector<Edge> divided(std::vector<Edge> edges, const std::vector<Edge>& others) {
  for (const Edge& other : others) {
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (!is_between(other.from, edges[k])) continue;
      edges.push_back({other.from, edges[k].to});
      edges[k].to = other.from;
    }
  }
  return edges;
}

std::vector<Edge> edges_of(const Loops& loops, int power) {
  const auto scaled = [&](const Point3& p) {
    return Point3{std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
  };
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point3& next = loop[(k + 1) % loop.size()];
      if (!(loop[k] == next)) edges.push_back({scaled(loop[k]), scaled(next)});
    }
  }
  return edges;
}

/// The power of two that brings distances near 1, where logarithms are small: a common factor of them adds nothing, as
/// boundaries are closed.
int scale_of(const Loops& first, const Loops& second) {
  double largest = 0;
  for (const auto& a : first) {
    for (const auto& b : second) {
      const Vector v = step(a.front(), b.front()), w = step(a[a.size() / 2], b[b.size() / 2]);
      largest = std::max({largest, sum_norm(v), sum_norm(w)});
    }
  }
  return largest > 0 && std::isfinite(largest) ? -std::ilogb(largest) : 0;
}

}  // namespace

Bounded exchange_area(const Loops& first, const Loops& second) {
  const int power = scale_of(first, second);
  std::vector<Edge> of_first = edges_of(first, power), of_second = edges_of(second, power);
  of_first = divided(std::move(of_first), of_second);
  of_second = divided(std::move(of_second), of_first);
  Bounded sum = 0.0;
  for (const Edge& p : of_first) {
    for (const Edge& q : of_second) {
      sum = sum + edge_integral(p, q);
    }
  }
  const Bounded area = sum / (Bounded(2) * shading::pi(Bounded()));
  return {std::ldexp(area.value, -2 * power), std::ldexp(area.error, -2 * power)};
}

}  // namespace gnomon::illumination
