#include "geometry/discontinuity/closing_arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/conics/near_curve.h"
#include "geometry/discontinuity/closing_triples.h"
#include "geometry/discontinuity/open_lines.h"
#include "geometry/discontinuity/silhouette_edges.h"

// l(t): the point of one of three edges, the base, at the share t of its length. The planes through l(t) and either of
// the other two, j and k, meet the receiver's plane in lines that turn about points as t grows, and p(t), where the two
// cross, is what sees all three in line at l(t). The line meets j between its ends a and b where |l(t), k, a| and
// |l(t), k, b|, linear functions of t, differ in sign.

namespace gnomon::event {
namespace {

bool is_on(const ReceiverPlane& plane, const Place& p) {
  return !plane.is_certainly_off(p.near) && plane.plane().height(p.exact) == 0;
}

/// The ranges of 0 <= t <= 1 on which the product of two functions is not positive, each linear between its values at
/// 0 and 1.
std::vector<conic::Range> ranges_of_difference(const std::array<Rational, 2>& u, const std::array<Rational, 2>& w) {
  std::vector<Rational> ends{Rational(0), Rational(1)};
  for (const auto* f : {&u, &w}) {
    if ((*f)[0].sign() * (*f)[1].sign() < 0) ends.emplace_back((*f)[0] / ((*f)[0] - (*f)[1]));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<conic::Range> found;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    if (ends[k] == ends[k + 1]) continue;
    const Rational t = (ends[k] + ends[k + 1]) / 2;
    const auto sign = [&](const std::array<Rational, 2>& f) { return Rational(f[0] + t * (f[1] - f[0])).sign(); };
    if (sign(u) * sign(w) <= 0) found.push_back({ends[k], ends[k + 1]});
  }
  return found;
}

std::vector<conic::Range> common_ranges(std::span<const conic::Range> a, std::span<const conic::Range> b) {
  std::vector<conic::Range> found;
  for (const conic::Range& p : a) {
    for (const conic::Range& q : b) {
      conic::Range both{std::max(p.from, q.from), std::min(p.to, q.to)};
      if (both.from < both.to) found.push_back(std::move(both));
    }
  }
  return found;
}

/// A box around all triangles.
struct FaceBox {
  NearRange x;
  NearRange y;
};

/// Of a square around the origin with the box well inside.
Rational half_width_of(const FaceBox& box) {
  double most = 1;
  for (const double c : {box.x.from, box.x.to, box.y.from, box.y.to}) most = std::max(most, std::fabs(c));
  return Rational(2 * most);
}

/// Traces triples on a receiver's plane.
class TripleTracer {
 public:
  TripleTracer(const std::vector<SilhouetteEdge>& edges, const OpenLines& open, const ReceiverPlane& plane,
               const FaceBox& box)
      : edges_(edges), open_(open), plane_(plane), box_(box), half_width_(half_width_of(box)) {
    origin_ = plane.spatial(FlatPoint{0, 0});
    along_x_ = plane.spatial(FlatPoint{1, 0}) - origin_;
    along_y_ = plane.spatial(FlatPoint{0, 1}) - origin_;
  }

  /// The parts that lines reach which may come through.
  std::vector<conic::FlatArc> traces(const EdgeTriple& triple) const {
    std::vector<conic::FlatArc> found;
    bool is_general = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const SilhouetteEdge &i = edges_[triple[k]], &j = edges_[triple[(k + 1) % 3]],
                           &other = edges_[triple[(k + 2) % 3]];
      if (!are_coplanar(i, j)) continue;
      is_general = false;
      append_trace_of_coplanar(i, j, other, found);
    }
    if (!is_general) return found;
    std::array<const SilhouetteEdge*, 3> edges{&edges_[triple[0]], &edges_[triple[1]], &edges_[triple[2]]};
    // At the foot of a base on the plane the lines would be told by a point alone.
    for (std::size_t k = 1; k < 3 && !edges[0]->is_of_light && touches_plane(*edges[0]); ++k) {
      std::swap(edges[0], edges[k]);
    }
    append_arcs(edges, found);
    return found;
  }

 private:
  bool touches_plane(const SilhouetteEdge& e) const { return is_on(plane_, e.a) || is_on(plane_, e.b); }

  static Rational volume(const ExactVector& p, const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    return dot(cross(a - p, b - p), c - p);
  }

  static bool are_coplanar(const SilhouetteEdge& i, const SilhouetteEdge& j) {
    const auto near = certain_sign(dot(cross(i.b.near - i.a.near, j.a.near - i.a.near), j.b.near - i.a.near));
    if (near) return *near == 0;
    return volume(i.a.exact, i.b.exact, j.a.exact, j.b.exact) == 0;
  }

  /// The trace of the plane through three points.
  std::array<Rational, 3> trace(const ExactVector& p, const ExactVector& a, const ExactVector& b) const {
    const ExactVector normal = cross(a - p, b - p);
    return {dot(normal, origin_ - p), dot(normal, along_x_), dot(normal, along_y_)};
  }

  conic::LinePencil pencil(const SilhouetteEdge& base, const SilhouetteEdge& edge) const {
    return conic::line_pencil(trace(base.a.exact, edge.a.exact, edge.b.exact),
                              trace(base.b.exact, edge.a.exact, edge.b.exact));
  }

  void append_arcs(const std::array<const SilhouetteEdge*, 3>& edges, std::vector<conic::FlatArc>& found) const {
    const std::vector<NearRange> open = open_.ranges(edges);
    if (open.empty()) return;
    const SilhouetteEdge &base = *edges[0], &j = *edges[1], &k = *edges[2];
    const auto sides = [&](const SilhouetteEdge& edge, const ExactVector& x) -> std::array<Rational, 2> {
      return {volume(base.a.exact, edge.a.exact, edge.b.exact, x), volume(base.b.exact, edge.a.exact, edge.b.exact, x)};
    };
    const auto meets_j = ranges_of_difference(sides(k, j.a.exact), sides(k, j.b.exact));
    const auto meets_k = ranges_of_difference(sides(j, k.a.exact), sides(j, k.b.exact));
    std::vector<conic::Range> exact_open;
    for (const NearRange& r : open) exact_open.push_back({Rational(r.from), Rational(r.to)});
    const auto ranges = common_ranges(common_ranges(meets_j, meets_k), exact_open);
    if (ranges.empty()) return;
    const conic::LinePencil of_j = pencil(base, j), of_k = pencil(base, k);
    for (const conic::Range& range : ranges) {
      for (conic::FlatArc& arc : conic::arcs(of_j, of_k, range, half_width_)) found.push_back(std::move(arc));
    }
  }

  /// The lines in the edges' common plane are traced with wedges (coplanar_pairs). Left are those through the point
  /// where the two cross.
  void append_trace_of_coplanar(const SilhouetteEdge& i, const SilhouetteEdge& j, const SilhouetteEdge& other,
                                std::vector<conic::FlatArc>& found) const {
    const ExactVector &a = i.a.exact, &b = i.b.exact, &c = j.a.exact, &d = j.b.exact;
    // Share of the way from a to b at which j's line is met, by areas in the plane of the two.
    const ExactVector of_a = cross(c - a, d - a), of_b = cross(c - b, d - b);
    if (is_zero(of_a) || is_zero(of_b) || dot(of_a, of_b) >= 0) return;
    const ExactVector difference = of_a - of_b;
    const Rational share = dot(of_a, difference) / dot(difference, difference);
    const ExactVector meeting = a + share * (b - a);
    if (dot(c - meeting, d - meeting) >= 0) return;  // at an end of j, or beyond
    // If neither parts the other's ends, that goes through the point, or all three lie in one plane.
    const SilhouetteEdge* parting = !are_coplanar(i, other) ? &i : !are_coplanar(j, other) ? &j : nullptr;
    if (parting == nullptr) return;
    const std::array<Rational, 3> line = trace(meeting, other.a.exact, other.b.exact);
    if (line[1] == 0 && line[2] == 0) return;
    conic::FlatCurve curve = conic::straight_curve(conic::line_pencil(line, line).start);
    const NearRange& range = curve.parameters.front().start[1] != 0 ? box_.x : box_.y;
    for (const NearRange& r : open_.ranges({&other, &i, &j}, *parting, curve, range)) {
      found.push_back({curve, Rational(r.from), Rational(r.to)});
    }
  }

  const std::vector<SilhouetteEdge>& edges_;
  const OpenLines& open_;
  const ReceiverPlane& plane_;
  FaceBox box_;
  Rational half_width_;
  ExactVector origin_, along_x_, along_y_;
};

/// The Bezier points (w, x, y) of an arc, with positive weights at its ends. The height of its points above a line,
/// times their weights, has those of the three as Bernstein coefficients; no weight is zero, as it does not reach
/// infinity.
struct ArcHull {
  std::array<std::array<Rational, 3>, 3> exact;
  std::array<std::array<Interval, 3>, 3> near;

  explicit ArcHull(const conic::FlatArc& arc) : exact(conic::bezier_points(arc.curve, arc.from, arc.to)) {
    const bool turns = exact[0][0] < 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (turns) exact[k][c] = -exact[k][c];
        near[k][c] = conic::enclosure(exact[k][c]);
      }
    }
  }
};

/// A triangle of the face on the receiver's plane.
class FlatTriangle {
 public:
  FlatTriangle(const FacePiece& piece, const ReceiverPlane& plane) {
    for (std::size_t k = 0; k < 3; ++k) corners_[k] = plane.flat(piece[k]);
    const FlatPoint &a = corners_[0], &b = corners_[1], &c = corners_[2];
    const bool turns = Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) < 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const FlatPoint &from = corners_[k], &to = corners_[(k + 1) % 3];
      sides_[k].exact = turns ? conic::line_through(to, from) : conic::line_through(from, to);
      long most = 0;
      for (const Integer& x : sides_[k].exact) most = std::max(most, exponent_of(x));
      for (std::size_t i = 0; i < 3; ++i) sides_[k].near[i] = scaled(sides_[k].exact[i], most);
    }
  }

  /// False only if the arc lies beyond one side, of which it may have single points.
  bool may_meet(const ArcHull& arc) const {
    return std::none_of(sides_.begin(), sides_.end(), [&](const Side& side) { return is_beyond(arc, side); });
  }

  std::span<const FlatPoint> corners() const { return corners_; }

 private:
  struct Side {
    conic::Covector exact;  ///< positive inside
    std::array<Interval, 3> near;
  };

  static bool is_beyond(const ArcHull& arc, const Side& side) {
    bool is_on = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = arc.near[k];
      auto sign = certain_sign(side.near[0] * p[0] + side.near[1] * p[1] + side.near[2] * p[2]);
      if (!sign) {
        Rational height = 0;
        for (std::size_t c = 0; c < 3; ++c) height += side.exact[c] * arc.exact[k][c];
        sign = height.sign();
      }
      if (*sign > 0) return false;
      is_on = is_on && *sign == 0;
    }
    return !is_on;
  }

  std::array<FlatPoint, 3> corners_;
  std::array<Side, 3> sides_;
};

std::vector<FlatEnclosure> boxes_around(std::span<const FlatTriangle> triangles) {
  std::vector<FlatEnclosure> boxes;
  for (const FlatTriangle& t : triangles) {
    const FlatPoint &a = t.corners()[0], &b = t.corners()[1], &c = t.corners()[2];
    const auto span = [](const Rational& p, const Rational& q, const Rational& r) {
      return Interval(CGAL::to_interval(std::min({p, q, r})).first, CGAL::to_interval(std::max({p, q, r})).second);
    };
    boxes.push_back({span(a.x, b.x, c.x), span(a.y, b.y, c.y)});
  }
  return boxes;
}

FaceBox box_around(std::span<const FlatEnclosure> boxes) {
  FaceBox box{{boxes.front().x.inf(), boxes.front().x.sup()}, {boxes.front().y.inf(), boxes.front().y.sup()}};
  for (const FlatEnclosure& b : boxes) {
    box.x = {std::min(box.x.from, b.x.inf()), std::max(box.x.to, b.x.sup())};
    box.y = {std::min(box.y.from, b.y.inf()), std::max(box.y.to, b.y.sup())};
  }
  return box;
}

std::vector<Place> corners_of(std::span<const FacePiece> pieces) {
  std::vector<ExactVector> points;
  for (const FacePiece& piece : pieces) points.insert(points.end(), piece.begin(), piece.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Place> corners;
  for (ExactVector& p : points) corners.emplace_back(std::move(p));
  return corners;
}

/// Only points on an edge's line see an edge in the receiver's plane in line with others.
std::vector<SilhouetteEdge> edges_off_plane(std::vector<SilhouetteEdge> edges, const ReceiverPlane& plane) {
  std::erase_if(edges, [&](const SilhouetteEdge& e) { return is_on(plane, e.a) && is_on(plane, e.b); });
  return edges;
}

}  // namespace

ClosingArcs closing_arcs(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const FacePiece> pieces,
                         const ReceiverPlane& plane) {
  const CGAL::Protect_FPU_rounding<true> upward;
  const NumberedSilhouettes silhouette_edges(edges_off_plane(event::silhouette_edges(scene, shapes), plane));
  const std::vector<EdgeTriple> triples =
      closing_triples(silhouette_edges, corners_of(pieces), scene.kind == LightKind::linear);
  ClosingArcs found;
  if (triples.empty()) return found;
  std::vector<FlatTriangle> triangles;
  for (const FacePiece& piece : pieces) triangles.emplace_back(piece, plane);
  const std::vector<FlatEnclosure> boxes = boxes_around(triangles);
  const OpenLines open_lines(scene, shapes, plane, boxes);
  const TripleTracer tracer(silhouette_edges.edges, open_lines, plane, box_around(boxes));
  for (const EdgeTriple& triple : triples) {
    std::vector<conic::FlatArc> traces = tracer.traces(triple);
    std::erase_if(traces, [&](const conic::FlatArc& arc) {
      const ArcHull hull(arc);
      return std::none_of(triangles.begin(), triangles.end(), [&](const FlatTriangle& t) { return t.may_meet(hull); });
    });
    if (traces.empty()) continue;
    const auto name = static_cast<std::uint32_t>(found.names.size());
    for (conic::FlatArc& arc : traces) found.arcs.push_back({std::move(arc), name});
    found.names.push_back({silhouette_edges.edges[triple[0]].name, silhouette_edges.edges[triple[1]].name,
                           silhouette_edges.edges[triple[2]].name});
  }
  return found;
}

}  // namespace gnomon::event
