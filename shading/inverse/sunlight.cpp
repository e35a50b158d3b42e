#include "gnomon/sunlight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"
#include "gnomon/errors.h"
#include "shading/inverse/sun_circle.h"

namespace gnomon {
namespace {

using inverse::SunCircle, inverse::SunCrossing, inverse::SunNormal;
using shading::Bounded, shading::Precise;

constexpr int bits = 200;

/// One side of a facet's cone: the plane through the eye and an edge, between its ends in one order whatever the facet,
/// so that neighbours have the same moments to the bit.
struct ConeSide {
  Point3 from, to;
  std::uint32_t edge = 0;
};

/// A flat convex piece of a blocker that may hide the sun.
struct SunFacet {
  std::vector<Point3> corners;
  std::vector<ConeSide> sides;
  std::uint32_t blocker = 0;
  bool is_of_solid = false;  ///< then it hides only what lies behind it: the others hide the rest
};

/// Where a moment comes from, so that it can be worked out again.
struct Moment {
  Bounded angle;
  SunEventName name;
  const ConeSide* side = nullptr;  ///< none for the horizon, the receiver and midnight
  bool is_rise = false;

  bool is_same(const Moment& other) const {
    return angle.value == other.angle.value && angle.error == other.angle.error;
  }
};

/// Hour angles from -π to π.
struct Span {
  Moment from, to;
};

using Spans = std::vector<Span>;

bool is_before(const Point3& a, const Point3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

ConeSide cone_side(const Point3& a, const Point3& b, std::uint32_t edge) {
  return is_before(b, a) ? ConeSide{b, a, edge} : ConeSide{a, b, edge};
}

void add_polygon(std::vector<SunFacet>& facets, const ConvexPolygon& polygon, std::uint32_t blocker) {
  SunFacet facet;
  facet.blocker = blocker;
  const auto corners = polygon.corners();
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    const Point3& a = polygon.points()[corners[k]];
    const Point3& b = polygon.points()[corners[(k + 1) % corners.size()]];
    facet.corners.push_back(a);
    facet.sides.push_back(cone_side(a, b, polygon.side_edge(k)));
  }
  facets.push_back(std::move(facet));
}

std::uint32_t edge_between(const ConvexSolid& solid, std::uint32_t a, std::uint32_t b) {
  const auto found = std::ranges::find_if(
      solid.edges(), [&](const ConvexSolid::Edge& e) { return e.from == std::min(a, b) && e.to == std::max(a, b); });
  return static_cast<std::uint32_t>(found - solid.edges().begin());
}

void add_solid(std::vector<SunFacet>& facets, const ConvexSolid& solid, std::uint32_t blocker) {
  for (const ConvexSolid::Facet& given : solid.facets()) {
    SunFacet facet;
    facet.blocker = blocker;
    facet.is_of_solid = true;
    const auto& loop = given.loop;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::uint32_t a = loop[k], b = loop[(k + 1) % loop.size()];
      facet.corners.push_back(solid.points()[a]);
      facet.sides.push_back(cone_side(solid.points()[a], solid.points()[b], edge_between(solid, a, b)));
    }
    facets.push_back(std::move(facet));
  }
}

Moment midnight(double angle) {
  Moment moment;
  moment.angle = {angle, 2 * shading::unit * std::fabs(angle)};
  moment.name.kind = SunEventName::Kind::midnight;
  return moment;
}

/// The part of spans within another; `other` has one, or two about midnight.
Spans common(const Spans& spans, const Spans& other) {
  Spans result;
  for (const Span& a : spans) {
    for (const Span& b : other) {
      const Moment& from = a.from.angle.value < b.from.angle.value ? b.from : a.from;
      const Moment& to = a.to.angle.value < b.to.angle.value ? a.to : b.to;
      if (from.angle.value < to.angle.value) result.push_back({from, to});
    }
  }
  return result;
}

}  // namespace

/// What is worked out once a day.
struct DaySunlight::Content {
  std::vector<SunFacet> facets;
  std::vector<ClosedSurface> enclosures;
  SunDay day;
  SunCircle<Bounded> sun;
  std::array<double, 3> pole{};  ///< of length 1, rounded
  double sine = 0;               ///< of the declination

  Content(const Obstacles& obstacles, const SunDay& of_day) : day(of_day), sun(of_day) {
    for (std::uint32_t b = 0; b < obstacles.blockers.size(); ++b) {
      const ConvexBlocker& blocker = obstacles.blockers[b];
      if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) add_polygon(facets, *polygon, b);
      if (const auto* solid = std::get_if<ConvexSolid>(&blocker)) add_solid(facets, *solid, b);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      pole[k] = sun.cos_latitude.value * sun.north[k].value + sun.sin_latitude.value * sun.up[k].value;
    }
    sine = sun.sin_declination.value;
  }

  /// The moments of a normal, in intervals where doubles do not decide.
  template <class MakeNormal>
  SunCrossing<Bounded> crossing(const MakeNormal& make_normal) const {
    SunCrossing<Bounded> result = sun_crossing<Bounded>(sun, make_normal(Bounded(0.0)));
    constexpr double good_enough = 1e-9;
    const bool is_certain = result.kind != SunCrossing<Bounded>::Kind::undecided &&
                            (result.kind != SunCrossing<Bounded>::Kind::twice ||
                             (result.rise.error < good_enough && result.set.error < good_enough));
    return is_certain ? result : precise_crossing(make_normal);
  }

  template <class MakeNormal>
  SunCrossing<Bounded> precise_crossing(const MakeNormal& make_normal) const {
    const Precise::Bits more(bits);
    const SunCrossing<Precise> precise = sun_crossing<Precise>(SunCircle<Precise>(day), make_normal(Precise(0.0)));
    SunCrossing<Bounded> result;
    result.kind = static_cast<SunCrossing<Bounded>::Kind>(precise.kind);
    if (precise.kind == SunCrossing<Precise>::Kind::undecided) {
      // For all that can be said it touches the plane, and is on one side but for a moment, or runs in it.
      using Kind = SunCrossing<Bounded>::Kind;
      result.kind = precise.mean_side == 1 ? Kind::always : precise.mean_side == -1 ? Kind::never : Kind::along;
    }
    result.rise = shading::bounded(precise.rise);
    result.set = shading::bounded(precise.set);
    return result;
  }

  /// The spans in which the sun is on the positive side of a plane, or, with `sign` -1, on the negative one.
  template <class MakeNormal>
  Spans spans(const MakeNormal& make_normal, int sign, const SunEventName& name, const ConeSide* side) const {
    const SunCrossing<Bounded> found = crossing(make_normal);
    const Moment first = midnight(-std::numbers::pi), last = midnight(std::numbers::pi);
    // What grazes is hidden, and no light on what faces elsewhere.
    if (found.kind == SunCrossing<Bounded>::Kind::along) return side != nullptr ? Spans{{first, last}} : Spans{};
    if (found.kind != SunCrossing<Bounded>::Kind::twice) {
      const bool is_there = (found.kind == SunCrossing<Bounded>::Kind::always) == (sign > 0);
      return is_there ? Spans{{first, last}} : Spans{};
    }
    Moment rise{found.rise, name, side, true}, set{found.set, name, side, false};
    if (sign < 0) std::swap(rise, set);
    if (rise.angle.value <= set.angle.value) return {{rise, set}};
    return {{first, set}, {rise, last}};
  }

  Spans side_spans(const Point3& eye, const ConeSide& side, int sign, const SunEventName& name) const {
    const auto normal = [&](auto kind) {
      using Number = decltype(kind);
      return inverse::crossed(inverse::between<Number>(eye, side.from), inverse::between<Number>(eye, side.to));
    };
    return spans(normal, sign, name, &side);
  }

  bool is_out_of_reach(const Point3& eye, const SunFacet& facet) const;
  Spans hidden_by(const Point3& eye, const SunFacet& facet, Spans times) const;
  Spans sun_times(const SunPoint& point) const;
};

/// Bound. Heights and lengths of doubles err by less than 1e-14 of the distance's size, beside what is rounded off
/// differences of coordinates, which are right to u of themselves.
bool DaySunlight::Content::is_out_of_reach(const Point3& eye, const SunFacet& facet) const {
  bool all_below = true, all_near_pole = true;
  for (const Point3& corner : facet.corners) {
    const Vector3<double> d = step(eye, corner);
    const double height = d.x * sun.up[0].value + d.y * sun.up[1].value + d.z * sun.up[2].value;
    const double along = d.x * pole[0] + d.y * pole[1] + d.z * pole[2], size = sum_norm(d);
    const double length = std::sqrt(dot(d, d)), margin = 1e-13 * size;
    all_below = all_below && height < -margin;
    // The directions within a circle about a pole are a convex cone.
    all_near_pole = all_near_pole && (sine >= 0 ? along - sine * length > margin : along - sine * length < -margin);
    if (!all_below && !all_near_pole) return false;
  }
  return true;
}

Spans DaySunlight::Content::hidden_by(const Point3& eye, const SunFacet& facet, Spans times) const {
  const auto& c = facet.corners;
  const int front = exact_orientation(c[0], c[1], c[2], eye);
  if (front == 0 || (facet.is_of_solid && front > 0)) return {};
  for (std::size_t k = 0; k < facet.sides.size() && !times.empty(); ++k) {
    const ConeSide& side = facet.sides[k];
    // The third corner tells on which side of the plane the facet lies.
    const bool is_turned = is_before(c[(k + 1) % c.size()], c[k]);
    const int sign = is_turned ? front : -front;
    times = common(times, side_spans(eye, side, sign, {SunEventName::Kind::shadow, facet.blocker, side.edge}));
  }
  return times;
}

Spans DaySunlight::Content::sun_times(const SunPoint& point) const {
  const auto up = [&](auto kind) { return inverse::numbers_of<decltype(kind)>(day.up); };
  Spans times = spans(up, 1, {SunEventName::Kind::horizon, 0, 0}, nullptr);
  if (!point.normal) return times;
  const auto normal = [&](auto kind) { return inverse::numbers_of<decltype(kind)>(*point.normal); };
  return common(times, spans(normal, 1, {SunEventName::Kind::receiver, 0, 0}, nullptr));
}

namespace {

SunEvent event_of(const Moment& moment) {
  constexpr double hours = 12 / std::numbers::pi;
  const double hour = 12 + moment.angle.value * hours;
  const double error = moment.angle.error * hours * 1.01 + 4 * shading::unit * (std::fabs(hour) + 12);
  return {hour, moment.name.kind == SunEventName::Kind::midnight ? 0 : error, moment.name};
}

/// Takes dark spans away from sunlit ones. Between two dark spans that end and begin at one moment, as far as bounds
/// tell, there is no light.
class SunTimes {
 public:
  SunTimes(Spans sunlit, Spans dark) : sunlit_(std::move(sunlit)), dark_(std::move(dark)) {
    std::ranges::sort(dark_, {}, [](const Span& span) { return span.from.angle.value; });
  }

  SunlitDay day() {
    for (const Span& span : sunlit_) add(span);
    for (const SunInterval& interval : result_.intervals) {
      result_.hours += interval.end.hour - interval.start.hour;
      result_.error_bound += interval.end.error_bound + interval.start.error_bound + 0x1p-47;
    }
    return result_;
  }

 private:
  void add(const Span& span) {
    Moment from = span.from;
    for (const Span& dark : dark_) {
      if (dark.to.angle.value <= from.angle.value) continue;
      if (dark.from.angle.value >= span.to.angle.value) break;
      if (dark.from.angle.value > from.angle.value) add_interval(from, dark.from);
      from = dark.to;
    }
    if (from.angle.value < span.to.angle.value) add_interval(from, span.to);
  }

  void add_interval(const Moment& from, const Moment& to) {
    const double least = from.angle.error + to.angle.error;
    if (to.angle.value - from.angle.value > 1.01 * least) {
      result_.intervals.push_back({event_of(from), event_of(to)});
    } else if (!from.is_same(to)) {
      result_.tied = true;
    }
  }

  Spans sunlit_, dark_;
  SunlitDay result_;
};

void require_angles(const SunDay& day) {
  const bool is_good = std::fabs(day.latitude) <= 90 && std::fabs(day.declination) <= 23.44;
  if (!is_good) throw PreconditionError("latitudes go from -90 to 90 degrees, declinations from -23.44 to 23.44");
  if (day.up == Point3{} || day.north == Point3{} || dot(exact(day.up), exact(day.north)) != 0) {
    throw PreconditionError("north has to be at right angles to the way up");
  }
}

}  // namespace

double declination_of_day(std::uint32_t day) {
  return 23.44 * std::sin(2 * std::numbers::pi * (284.0 + day) / 365);
}

DaySunlight::DaySunlight(Obstacles obstacles, const SunDay& day) {
  require_angles(day);
  content_ = std::make_shared<const Content>(obstacles, day);
}

SunlitDay DaySunlight::at(const SunPoint& point) const {
  const Spans sunlit = content_->sun_times(point);
  Spans dark;
  for (const SunFacet& facet : content_->facets) {
    if (sunlit.empty()) break;
    if (content_->is_out_of_reach(point.point, facet)) continue;
    std::ranges::move(content_->hidden_by(point.point, facet, sunlit), std::back_inserter(dark));
  }
  return SunTimes(sunlit, std::move(dark)).day();
}

}  // namespace gnomon
