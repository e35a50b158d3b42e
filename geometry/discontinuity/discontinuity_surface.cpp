#include "gnomon/discontinuity.h"

#include <algorithm>
#include <optional>

#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/wedge.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

using event::Cone;
using event::EventScene;
using event::Pencil;
using event::Wedge;

/// A place in a wedge: `turn` tells the line, from 0 at a to 1 at b; `depth` grows along each line, away from the
/// light. A projective map: straight lines stay straight.
struct Place {
  Rational turn;
  Rational depth;
};

/// A straight piece of what stops the wedge, or of where it begins.
struct Slope {
  Rational first;
  Rational last;

  Rational at(const Rational& share) const { return first + share * (last - first); }
};

/// What stops a wedge: a convex polygon or segment. One that holds the apex stops all lines in its inside at once.
struct Stopper {
  std::vector<Place> silhouette;
  bool holds_apex = false;
};

class SurfaceBuilder {
 public:
  SurfaceBuilder(const EventScene& scene, const Box3& box) : scene_(scene), box_(box), tracer_(scene) {}

  std::vector<std::vector<Point3>> polygons(const Wedge& wedge) {
    polygons_.clear();
    if (wedge.kind == event::WedgeKind::from_light_place) return {};  // nothing that the lines would begin behind
    Pencil pencil(scene_.points, wedge.apex, wedge.a, wedge.b);
    {
      const CGAL::Protect_FPU_rounding<true> upward;
      if (!tracer_.look_along(pencil, wedge)) return {};
    }
    towards_ = event::receivers_cone(wedge.kind) == Cone::towards;
    corners_[0] = homogeneous(wedge.apex);
    corners_[1] = homogeneous(wedge.a);
    corners_[2] = homogeneous(wedge.b);
    stoppers_.clear();
    for (const auto& obstacle : tracer_.obstacles()) stoppers_.push_back(stopper(pencil, obstacle.polygon));
    for (const event::RayRange& range : tracer_.allowed()) {
      add_range(place(pencil, range.first.node).turn, place(pencil, range.last.node).turn);
    }
    return std::move(polygons_);
  }

 private:
  Quadruple<Rational> homogeneous(event::PointId id) const {
    const auto exact = event::coordinates<ExactReal>(scene_.points[id]);
    Quadruple<Rational> result;
    for (std::size_t k = 0; k < 4; ++k) result[k] = rational(exact[k]);
    return result;
  }

  bool is_from_infinity() const { return corners_[0][3] == 0; }

  Place place(const Pencil& pencil, event::NodeId node) const {
    const auto e = pencil.exact(node);
    const Rational y = rational(e[1]), z = rational(e[2]), sum = y + z;
    const Rational depth = rational(e[0]) / sum;
    return {z / sum, towards_ ? Rational(-depth) : depth};
  }

  Stopper stopper(const Pencil& pencil, const std::vector<event::NodeId>& polygon) const {
    Stopper result;
    for (const event::NodeId node : polygon) {
      if (!pencil.is_apex(node)) result.silhouette.push_back(place(pencil, node));
    }
    result.holds_apex = result.silhouette.size() < polygon.size();
    return result;
  }

  /// The least depth at which a stopper meets a line; nothing if it does not.
  static std::optional<Rational> depth_at(const std::vector<Place>& silhouette, const Rational& turn) {
    std::optional<Rational> least;
    const auto keep = [&](const Rational& depth) {
      if (!least || depth < *least) least = depth;
    };
    for (std::size_t i = 0; i < silhouette.size(); ++i) {
      const Place &p = silhouette[i], &q = silhouette[(i + 1) % silhouette.size()];
      if (p.turn == turn) keep(p.depth);
      if ((p.turn < turn) == (q.turn < turn) || p.turn == turn || q.turn == turn) continue;
      keep(p.depth + Rational((turn - p.turn) / (q.turn - p.turn)) * (q.depth - p.depth));
    }
    return least;
  }

  void add_range(const Rational& first, const Rational& last) {
    std::vector<Rational> turns{first, last};
    for (const Stopper& s : stoppers_) {
      for (const Place& p : s.silhouette) {
        if (p.turn > first && p.turn < last) turns.push_back(p.turn);
      }
    }
    std::sort(turns.begin(), turns.end());
    turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) add_cell(turns[i], turns[i + 1]);
  }

  /// Between two lines stoppers have straight edges; the least of them stops the wedge, piece by piece.
  void add_cell(const Rational& first, const Rational& last) {
    std::vector<Slope> slopes;
    const Rational middle = (first + last) / 2;
    for (const Stopper& s : stoppers_) {
      if (!depth_at(s.silhouette, middle)) continue;
      if (s.holds_apex) return;
      const auto at_first = depth_at(s.silhouette, first), at_last = depth_at(s.silhouette, last);
      if (at_first && at_last) slopes.push_back({*at_first, *at_last});
    }
    Rational share = 0;
    while (share < 1) {
      const Slope* least = nullptr;
      for (const Slope& s : slopes) {
        if (!least) least = &s;
        const Rational here = s.at(share), best = least->at(share);
        if (here < best || (here == best && s.last - s.first < least->last - least->first)) least = &s;
      }
      const Rational next = least ? next_change(slopes, *least, share) : Rational(1);
      const auto turn = [&](const Rational& at) -> Rational { return first + at * (last - first); };
      if (least) {
        add_piece({turn(share), least->at(share)}, {turn(next), least->at(next)});
      } else {
        add_open_piece(turn(share), turn(next));
      }
      share = next;
    }
  }

  static Rational next_change(const std::vector<Slope>& slopes, const Slope& least, const Rational& share) {
    Rational next = 1;
    if (least.first != least.last) {
      // Where it passes the line of the edge, in front of which it blocks.
      const Rational at = least.first / (least.first - least.last);
      if (at > share && at < next) next = at;
    }
    for (const Slope& s : slopes) {
      const Rational steeper = (least.last - least.first) - (s.last - s.first);
      if (steeper <= 0) continue;
      const Rational at = (s.first - least.first) / steeper;
      if (at > share && at < next) next = at;
    }
    return next;
  }

  Quadruple<Rational> point(const Rational& turn, const Rational& depth) const {
    const Rational x = towards_ ? Rational(-depth) : depth;
    Quadruple<Rational> result;
    for (std::size_t k = 0; k < 4; ++k) {
      result[k] = x * corners_[0][k] + (1 - turn) * corners_[1][k] + turn * corners_[2][k];
    }
    if (result[3] < 0) {
      for (Rational& c : result) c = -c;
    }
    return result;
  }

  void add_piece(const Place& p, const Place& q) {
    if (towards_) {
      // A blocker before the edge, or on it.
      if (p.depth <= 0 && q.depth <= 0) return;
      return add_clipped({point(p.turn, 0), point(q.turn, 0), point(q.turn, q.depth), point(p.turn, p.depth)});
    }
    add_clipped({corners_[0], point(q.turn, q.depth), point(p.turn, p.depth)});
  }

  void add_open_piece(const Rational& p, const Rational& q) {
    if (!towards_) {
      const Quadruple<Rational> far_p = away(p), far_q = away(q);
      return add_clipped({corners_[0], far_q, far_p});
    }
    if (is_from_infinity()) {
      const auto& v = corners_[0];
      return add_clipped({point(p, 0), point(q, 0), {-v[0], -v[1], -v[2], Rational(0)}});
    }
    add_clipped({point(p, 0), point(q, 0), point(q, 1), point(p, 1)});
  }

  /// The direction from the edge to the apex, and on.
  Quadruple<Rational> away(const Rational& turn) const {
    Quadruple<Rational> result;
    for (std::size_t k = 0; k < 4; ++k) {
      result[k] = corners_[0][k] - ((1 - turn) * corners_[1][k] + turn * corners_[2][k]);
    }
    return result;
  }

  void add_clipped(std::vector<Quadruple<Rational>> polygon) {
    const double low[] = {box_.min.x, box_.min.y, box_.min.z}, high[] = {box_.max.x, box_.max.y, box_.max.z};
    for (std::size_t k = 0; k < 3; ++k) {
      clip(polygon, k, Rational(1), Rational(low[k]));
      clip(polygon, k, Rational(-1), Rational(-high[k]));
    }
    std::vector<Point3> rounded;
    for (const Quadruple<Rational>& p : polygon) {
      if (p[3] == 0) return;
      const Point3 point{nearest_double(Rational(p[0] / p[3])), nearest_double(Rational(p[1] / p[3])),
                         nearest_double(Rational(p[2] / p[3]))};
      if (rounded.empty() || !(rounded.back() == point)) rounded.push_back(point);
    }
    if (rounded.size() > 1 && rounded.front() == rounded.back()) rounded.pop_back();
    if (rounded.size() > 2) polygons_.push_back(std::move(rounded));
  }

  /// Keeps what has sign * coordinate >= bound.
  static void clip(std::vector<Quadruple<Rational>>& polygon, std::size_t axis, const Rational& sign,
                   const Rational& bound) {
    std::vector<Quadruple<Rational>> kept;
    const auto height = [&](const Quadruple<Rational>& p) -> Rational { return sign * p[axis] - bound * p[3]; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Rational at_p = height(p), at_q = height(q);
      if (at_p >= 0) kept.push_back(p);
      if (at_p.sign() * at_q.sign() >= 0) continue;
      const Rational up = abs(at_p), down = abs(at_q);
      Quadruple<Rational> cut;
      for (std::size_t k = 0; k < 4; ++k) cut[k] = down * p[k] + up * q[k];
      kept.push_back(cut);
    }
    polygon.swap(kept);
  }

  const EventScene& scene_;
  Box3 box_;
  event::WedgeTracer tracer_;
  bool towards_ = true;
  std::array<Quadruple<Rational>, 3> corners_;
  std::vector<Stopper> stoppers_;
  std::vector<std::vector<Point3>> polygons_;
};

}  // namespace

std::vector<DiscontinuitySurface> discontinuity_surfaces(const Light& light, std::span<const ConvexBlocker> blockers,
                                                         std::span<const ConvexPolygon> receivers, const Box3& box) {
  const CGAL::Protect_FPU_rounding<true> upward;
  EventScene scene(light, blockers, receivers);
  SurfaceBuilder builder(scene, box);
  std::vector<DiscontinuitySurface> surfaces;
  event::for_each_wedge(scene, [&](const Wedge& wedge) {
    auto polygons = builder.polygons(wedge);
    if (!polygons.empty()) surfaces.push_back({event::event_name(scene, wedge), std::move(polygons)});
  });
  return surfaces;
}

}  // namespace gnomon
