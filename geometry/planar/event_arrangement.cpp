#include "geometry/planar/event_arrangement.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/event_rays.h"
#include "geometry/planar/orientation.h"
#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

using Point = ExactKernel::Point_2;
using Vector = ExactKernel::Vector_2;
using Number = ExactKernel::FT;
using Curve = NumberedTraits::Curve_2;
using ConstHalfedge = EventArrangement::Halfedge_const_handle;

Point point(const Point2& p) {
  return {p.x, p.y};
}

Point point(const ExactPoint& p) {
  return {Number(p.x), Number(p.y)};
}

Number cross(const Vector& a, const Vector& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A ray that nothing ends, or one half of the light's line.
struct OpenRay {
  Point start;
  Vector way;
  BoundaryName name;
};

/// Segments and rays on their way to become curves.
class CurveList {
 public:
  explicit CurveList(std::vector<BoundaryName>& names) : names_(names) {}

  void add(const Point& start, const Point& end, const BoundaryName& name) {
    curves_.emplace_back(ExactKernel::Segment_2(start, end), static_cast<std::uint32_t>(names_.size()));
    names_.push_back(name);
    reach_to(start);
    reach_to(end);
  }

  void add_open(const Point& start, const Vector& way, const BoundaryName& name) {
    rays_.push_back({start, way, name});
    reach_to(start);
  }

  /// Ends the rays at the frame, and adds it.
  void close() {
    const Number half = half_frame();
    for (const OpenRay& ray : rays_) add(ray.start, frame_point(ray, half), ray.name);
    const Point corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    for (std::size_t k = 0; k < 4; ++k) {
      curves_.emplace_back(ExactKernel::Segment_2(corners[k], corners[(k + 1) % 4]),
                           static_cast<std::uint32_t>(names_.size()));
    }
  }

  const std::vector<Curve>& curves() const { return curves_; }

 private:
  void reach_to(const Point& p) {
    for (const Number& x : {p.x(), p.y()}) {
      const auto [low, high] = CGAL::to_interval(x);
      reach_ = std::max({reach_, -low, high});
    }
  }

  /// Half a side of the frame, a power of 2: lines at distances up to d from the origin that make an angle w meet at
  /// most 2 d / sin w away from it.
  Number half_frame() {
    const double far = 2 * 1.5 * reach_ / std::min(least_sine(), 1.0);
    if (!(far < 0x1p1000)) throw PreconditionError("the event lines meet too far away for doubles");
    return std::ldexp(1.0, std::ilogb(std::max(far, 1.0)) + 2);
  }

  /// A lower bound of the sines between rays that are not parallel.
  double least_sine() {
    std::vector<Vector> ways;
    for (const OpenRay& ray : rays_) {
      const bool flipped = ray.way.y() < 0 || (ray.way.y() == 0 && ray.way.x() < 0);
      ways.push_back(flipped ? -ray.way : ray.way);
    }
    std::ranges::sort(ways, [](const Vector& a, const Vector& b) { return cross(a, b) > 0; });
    double least = 1;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const Vector& next = ways[(i + 1) % ways.size()];
      const Number sine = CGAL::abs(cross(ways[i], next));
      if (sine == 0) continue;
      least = std::min(least, lower_bound(sine) / (1.001 * std::sqrt(upper_bound(ways[i] * ways[i])) *
                                                   std::sqrt(upper_bound(next * next))));
    }
    return least;
  }

  static double lower_bound(const Number& positive) {
    const double low = CGAL::to_interval(positive).first;
    return low > 0 ? low : CGAL::to_interval(positive.exact()).first;
  }

  static double upper_bound(const Number& number) { return CGAL::to_interval(number).second; }

  static Point frame_point(const OpenRay& ray, const Number& half) {
    const auto share = [&](const Number& at, const Number& way) {
      return ((way > 0 ? half : Number(-half)) - at) / way;
    };
    std::optional<Number> least;
    if (ray.way.x() != 0) least = share(ray.start.x(), ray.way.x());
    if (ray.way.y() != 0) {
      const Number other = share(ray.start.y(), ray.way.y());
      if (!least || other < *least) least = other;
    }
    Point end = ray.start + *least * ray.way;
    end.exact();
    return end;
  }

  std::vector<BoundaryName>& names_;
  std::vector<Curve> curves_;
  std::vector<OpenRay> rays_;
  double reach_ = 1;
};

void add_blockers(const Flatland& flatland, CurveList& list) {
  for (std::uint32_t i = 0; i < flatland.blockers().size(); ++i) {
    const auto& [a, b] = flatland.blockers()[i];
    list.add(point(a), point(b), {BoundaryKind::blocker, i, {}, {}, {}});
  }
}

/// Beside a light's line that no blocker meets everything is lit.
void add_light_line(const Flatland& flatland, CurveList& list) {
  if (flatland.has_point_light()) return;
  const auto light = flatland.light();
  const bool is_met = std::ranges::any_of(flatland.blockers(), [&](const BlockerSegment& blocker) {
    return orientation(light[0], light[1], blocker[0]) * orientation(light[0], light[1], blocker[1]) <= 0;
  });
  if (!is_met) return;
  const BoundaryName name{BoundaryKind::light_line, 0, {}, {}, {}};
  const Vector way = point(light[1]) - point(light[0]);
  list.add_open(point(light[0]), way, name);
  list.add_open(point(light[0]), -way, name);
}

void add_rays(const Flatland& flatland, Fineness fineness, CurveList& list) {
  const EventDetail detail = fineness == Fineness::regions ? EventDetail::regions : EventDetail::structure;
  for (const EventRay& ray : event_rays(flatland, detail)) {
    const Point near = point(ray.near_point), far = point(ray.far_point);
    const BoundaryName name{BoundaryKind::event, 0, ray.near, ray.far, ray.contact};
    if (!ray.stop) {
      list.add_open(far, far - near, name);
      continue;
    }
    const auto& [a, b] = flatland.blockers()[*ray.stop];
    const Vector way = far - near, across = point(b) - point(a), to_a = point(a) - far;
    const Number share =
        (to_a.x() * across.y() - to_a.y() * across.x()) / (way.x() * across.y() - way.y() * across.x());
    const Point end = far + share * way;
    end.exact();
    list.add(far, end, name);
  }
}

void add_box(const Box2& box, CurveList& list) {
  const Point2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  constexpr std::uint32_t sides[] = {2, 1, 3, 0};
  for (std::size_t k = 0; k < 4; ++k) {
    list.add(point(corners[k]), point(corners[(k + 1) % 4]), {BoundaryKind::clip_box, sides[k], {}, {}, {}});
  }
}

Vector way_of(ConstHalfedge edge) {
  return edge->target()->point() - edge->source()->point();
}

void keep_least(std::optional<Number>& least, const Number& s) {
  if (s > 0 && (!least || s < *least)) least = s;
}

/// The first place where the ray from `start` along `way` meets an edge.
void shoot(const Point& start, const Vector& way, ConstHalfedge edge, std::optional<Number>& least) {
  const Vector to_source = edge->source()->point() - start, to_target = edge->target()->point() - start;
  const Number at_source = cross(way, to_source), at_target = cross(way, to_target);
  if (at_source == 0) keep_least(least, to_source * way / (way * way));
  if (at_target == 0) keep_least(least, to_target * way / (way * way));
  if ((at_source < 0) == (at_target < 0) || at_source == 0 || at_target == 0) return;
  keep_least(least, cross(to_source, to_target) / (at_target - at_source));
}

void shoot_cycle(const Point& start, const Vector& way, EventArrangement::Ccb_halfedge_const_circulator cycle,
                 ConstHalfedge own, std::optional<Number>& least) {
  auto edge = cycle;
  do {
    if (ConstHalfedge(edge) != own) shoot(start, way, edge, least);
  } while (++edge != cycle);
}

template <class Visit>
void for_each_cycle(EventArrangement::Face_const_handle face, Visit visit) {
  for (auto cycle = face->outer_ccbs_begin(); cycle != face->outer_ccbs_end(); ++cycle) visit(*cycle);
  for (auto cycle = face->inner_ccbs_begin(); cycle != face->inner_ccbs_end(); ++cycle) visit(*cycle);
}

}  // namespace

void build_arrangement(const Flatland& flatland, const PartitionOptions& options, EventArrangement& arrangement,
                       std::vector<BoundaryName>& names) {
  CurveList list(names);
  add_blockers(flatland, list);
  add_light_line(flatland, list);
  add_rays(flatland, options.fineness, list);
  if (options.box) add_box(*options.box, list);
  list.close();
  CGAL::insert(arrangement, list.curves().begin(), list.curves().end());
}

Point inner_point(ConstHalfedge edge) {
  return CGAL::midpoint(edge->source()->point(), edge->target()->point());
}

Point inner_point(EventArrangement::Face_const_handle face) {
  const ConstHalfedge edge = *face->outer_ccbs_begin();
  const Point start = inner_point(edge);
  const Vector way = way_of(edge).perpendicular(CGAL::COUNTERCLOCKWISE);
  std::optional<Number> least;
  for_each_cycle(face, [&](EventArrangement::Ccb_halfedge_const_circulator cycle) {
    shoot_cycle(start, way, cycle, edge, least);
  });
  return start + *least / 2 * way;
}

ExactPoint exact(const Point& point) {
  return {Rational(CGAL::exact(point.x())), Rational(CGAL::exact(point.y()))};
}

Viewpoint viewpoint(const Point& point) {
  const auto x = CGAL::to_interval(point.x()), y = CGAL::to_interval(point.y());
  const Point2 near{x.first / 2 + x.second / 2, y.first / 2 + y.second / 2};
  const double reach = std::max(x.second - x.first, y.second - y.first);
  const double size = std::max(std::fabs(near.x), std::fabs(near.y));
  return {near, reach + 0x1p-52 * size + 0x1p-1000, [point] { return exact(point); }};
}

}  // namespace gnomon::planar
