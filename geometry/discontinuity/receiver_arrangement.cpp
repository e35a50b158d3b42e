#include "geometry/discontinuity/receiver_arrangement.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/discontinuity/event_point.h"

namespace gnomon::event {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Knows copies of one point as equal without a look at their coordinates, which would have to be exact.
struct SweepKernel : Kernel {
  struct Compare_xy_2 : Kernel::Compare_xy_2 {  // NOLINT(readability-identifier-naming): CGAL asks for it
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return CGAL::identical(p, q) ? CGAL::EQUAL : Kernel::Compare_xy_2::operator()(p, q);
    }
  };
  Compare_xy_2 compare_xy_2_object() const { return {}; }
};

using Traits = CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<SweepKernel>, std::uint32_t>;
using Dcel = CGAL::Arr_extended_dcel<Traits, std::uint32_t, std::uint32_t, std::uint32_t>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Point = Kernel::Point_2;
using Number = Kernel::FT;
using Vector = Kernel::Vector_2;

Number flat_cross(const Vector& a, const Vector& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Equal ends of segments, as copies of one point.
class Ends {
 public:
  const Point& operator()(const FlatPoint& p) {
    const auto [found, is_new] = points_.try_emplace({p.x, p.y});
    if (is_new) found->second = Point(Number(p.x), Number(p.y));
    return found->second;
  }

 private:
  std::map<std::pair<Rational, Rational>, Point> points_;
};

FlatPoint exact_point(const Point& p) {
  return {Rational(CGAL::exact(p.x())), Rational(CGAL::exact(p.y()))};
}

FlatEnclosure enclosure_of(const Point& p) {
  const auto x = CGAL::to_interval(p.x()), y = CGAL::to_interval(p.y());
  return {Interval(x.first, x.second), Interval(y.first, y.second)};
}

/// The nearest place where a ray meets an edge.
class Shot {
 public:
  Shot(const Point& start, const Vector& way) : start_(start), way_(way) {}

  void meet(const Point& p, const Point& q) {
    const Vector to_p = p - start_, to_q = q - start_;
    const Number at_p = flat_cross(way_, to_p), at_q = flat_cross(way_, to_q);
    if (at_p == 0) keep(to_p * way_ / (way_ * way_));
    if (at_q == 0) keep(to_q * way_ / (way_ * way_));
    if (at_p == 0 || at_q == 0 || (at_p < 0) == (at_q < 0)) return;
    keep(flat_cross(to_p, to_q) / (at_q - at_p));
  }

  Point half_way() const { return start_ + *least_ / 2 * way_; }

 private:
  void keep(const Number& s) {
    if (s > 0 && (!least_ || s < *least_)) least_ = s;
  }

  Point start_;
  Vector way_;
  std::optional<Number> least_;
};

double middle(const Interval& x) {
  return x.inf() / 2 + x.sup() / 2;
}

/// The same roughly, from doubles.
class RoughShot {
 public:
  RoughShot(const FlatEnclosure& p, const FlatEnclosure& q)
      : x_((middle(p.x) + middle(q.x)) / 2),
        y_((middle(p.y) + middle(q.y)) / 2),
        along_x_(middle(p.y) - middle(q.y)),
        along_y_(middle(q.x) - middle(p.x)) {}

  void meet(const FlatEnclosure& p, const FlatEnclosure& q) {
    const double px = middle(p.x) - x_, py = middle(p.y) - y_, qx = middle(q.x) - x_, qy = middle(q.y) - y_;
    const double at_p = along_x_ * py - along_y_ * px, at_q = along_x_ * qy - along_y_ * qx;
    if ((at_p < 0) == (at_q < 0)) return;
    const double s = (px * qy - py * qx) / (at_q - at_p);
    if (s > 0) least_ = std::min(least_, s);
  }

  /// Nothing where rounding lets the ray pass between edges.
  std::optional<FlatEnclosure> half_way() const {
    const double x = x_ + least_ / 2 * along_x_, y = y_ + least_ / 2 * along_y_;
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    return FlatEnclosure{Interval(x), Interval(y)};
  }

 private:
  double x_, y_, along_x_, along_y_;
  double least_ = std::numeric_limits<double>::infinity();
};

/// How often a directed edge winds around p, as it crosses the ray from p along x; nothing where intervals do not tell.
std::optional<int> winding(const FlatEnclosure& p, const FlatEnclosure& s, const FlatEnclosure& t) {
  const auto at_s = certain_sign(s.y - p.y), at_t = certain_sign(t.y - p.y);
  if (!at_s || !at_t || *at_s == 0 || *at_t == 0) return std::nullopt;
  if (*at_s == *at_t) return 0;
  const auto turn = certain_sign((t.x - s.x) * (p.y - s.y) - (t.y - s.y) * (p.x - s.x));
  if (!turn || *turn == 0) return std::nullopt;
  return *turn == *at_t ? *at_t : 0;
}

}  // namespace

struct ReceiverArrangement::Points {
  std::vector<Point> list;
  std::vector<FlatEnclosure> near;
};

struct ReceiverArrangement::Inside {
  Point point;
};

ReceiverArrangement::ReceiverArrangement(ReceiverArrangement&&) noexcept = default;
ReceiverArrangement& ReceiverArrangement::operator=(ReceiverArrangement&&) noexcept = default;
ReceiverArrangement::~ReceiverArrangement() = default;

ReceiverArrangement::ReceiverArrangement(std::span<const FlatSegment> segments) : points_(std::make_unique<Points>()) {
  std::vector<Traits::Curve_2> curves;
  curves.reserve(segments.size());
  Ends ends;
  for (const FlatSegment& s : segments) curves.emplace_back(Kernel::Segment_2(ends(s.start), ends(s.end)), s.name);
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
    v->set_data(static_cast<std::uint32_t>(points_->list.size()));
    points_->list.push_back(v->point());
    points_->near.push_back(enclosure_of(v->point()));
  }
  std::uint32_t count = 0;
  for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
    f->set_data(f->is_unbounded() ? outside : count++);
  }
  faces_.resize(count);
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    e->set_data(2 * number);
    e->twin()->set_data(2 * number + 1);
    Edge edge{e->source()->data(), e->target()->data(), e->face()->data(), e->twin()->face()->data(), {}};
    edge.names.assign(e->curve().data().begin(), e->curve().data().end());
    std::sort(edge.names.begin(), edge.names.end());
    edges_.push_back(std::move(edge));
  }
  for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
    if (f->is_unbounded()) continue;
    const auto add = [&](Arrangement::Ccb_halfedge_const_circulator first) {
      auto& cycle = faces_[f->data()].cycles.emplace_back();
      auto edge = first;
      do {
        cycle.push_back(edge->data());
      } while (++edge != first);
    };
    for (auto c = f->outer_ccbs_begin(); c != f->outer_ccbs_end(); ++c) add(*c);
    for (auto c = f->inner_ccbs_begin(); c != f->inner_ccbs_end(); ++c) add(*c);
  }
}

std::size_t ReceiverArrangement::vertex_count() const {
  return points_->list.size();
}

ReceiverArrangement::Inside ReceiverArrangement::inside(std::uint32_t face) const {
  const auto ends = [&](EdgeUse use) {
    const Edge& edge = edges_[use / 2];
    const Point &p = points_->list[edge.source], &q = points_->list[edge.target];
    return use % 2 == 0 ? std::pair(p, q) : std::pair(q, p);
  };
  const EdgeUse own = faces_[face].cycles[0][0];
  const auto [p, q] = ends(own);
  Shot shot(CGAL::midpoint(p, q), (q - p).perpendicular(CGAL::COUNTERCLOCKWISE));
  for (const auto& cycle : faces_[face].cycles) {
    for (const EdgeUse use : cycle) {
      if (use == own) continue;
      const auto [s, t] = ends(use);
      shot.meet(s, t);
    }
  }
  return {shot.half_way()};
}

/// A point of doubles that certainly lies inside.
std::optional<FlatEnclosure> ReceiverArrangement::rounded_inside(std::uint32_t face) const {
  const CGAL::Protect_FPU_rounding<true> upward;
  const auto ends = [&](EdgeUse use) {
    const Edge& edge = edges_[use / 2];
    const FlatEnclosure &p = points_->near[edge.source], &q = points_->near[edge.target];
    return use % 2 == 0 ? std::pair(p, q) : std::pair(q, p);
  };
  const EdgeUse own = faces_[face].cycles[0][0];
  RoughShot shot(ends(own).first, ends(own).second);
  for (const auto& cycle : faces_[face].cycles) {
    for (const EdgeUse use : cycle) {
      if (use != own) shot.meet(ends(use).first, ends(use).second);
    }
  }
  const std::optional<FlatEnclosure> point = shot.half_way();
  if (!point) return std::nullopt;
  int sum = 0;
  for (const auto& cycle : faces_[face].cycles) {
    for (const EdgeUse use : cycle) {
      const auto part = winding(*point, ends(use).first, ends(use).second);
      if (!part) return std::nullopt;
      sum += *part;
    }
  }
  if (sum != 1) return std::nullopt;
  return point;
}

FlatPoint ReceiverArrangement::inner_point(std::uint32_t face) const {
  if (const auto rounded = rounded_inside(face)) return {Rational(rounded->x.inf()), Rational(rounded->y.inf())};
  return exact_point(inside(face).point);
}

FlatEnclosure ReceiverArrangement::near_inner_point(std::uint32_t face) const {
  if (const auto rounded = rounded_inside(face)) return *rounded;
  return enclosure_of(inside(face).point);
}

FlatPoint ReceiverArrangement::point(std::uint32_t vertex) const {
  return exact_point(points_->list[vertex]);
}

FlatEnclosure ReceiverArrangement::near_point(std::uint32_t vertex) const {
  return points_->near[vertex];
}

}  // namespace gnomon::event
