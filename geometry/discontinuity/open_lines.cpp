#include "geometry/discontinuity/open_lines.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace gnomon::event {
namespace {

enum class Known : std::uint8_t { closed, open, perhaps };
enum class Meeting : std::uint8_t { none, perhaps, all };

/// Closed if either is, open if both are.
Known both(Known a, Known b) {
  if (a == Known::closed || b == Known::closed) return Known::closed;
  return a == Known::open && b == Known::open ? Known::open : Known::perhaps;
}

/// Of polynomials between two parameters.
struct Signs {
  Interval from;
  Interval to;

  int operator()(const NearPolynomial& f) const { return certain_sign(f, from, to); }
};

/// Where lines leave the second and the third edge, if t is a share of the base: an edge's ends lie on both sides of
/// the plane through q and the other edge if q lies between the planes through that edge and either end.
class EdgeEnds {
 public:
  void add(const SilhouetteEdge& base, const SilhouetteEdge& edge, const SilhouetteEdge& other) {
    for (const Place* end : {&edge.a, &edge.b}) {
      const NearPlane plane = near_plane(other.a.near, other.b.near, end->near);
      const Interval at_a = dot(plane.normal, base.a.near) + plane.offset;
      ends_.push_back({at_a, dot(plane.normal, base.b.near) + plane.offset - at_a, Interval(0), Interval(0)});
    }
  }

  bool are_missed(const Signs& sign) const {
    for (std::size_t k = 0; k < ends_.size(); k += 2) {
      if (sign(ends_[k]) * sign(ends_[k + 1]) > 0) return true;
    }
    return false;
  }

 private:
  std::vector<NearPolynomial> ends_;
};

}  // namespace

/// Lines, and what is asked of them. R is the place on the light: q, or where a line meets the light's plane.
class OpenLines::Question {
 public:
  Question(const OpenLines& all, const RuledLines& lines, EdgeEnds ends)
      : all_(all), lines_(lines), edge_ends_(std::move(ends)), shapes_(all.shapes_.size()) {
    if (base().is_of_light) {
      light_weight_ = lines.base_weight();
    } else {
      point_height_ = lines.height_of_point(all.light_plane_);
      base_height_ = lines.height_of_base(all.light_plane_);
      light_weight_ =
          difference(product(point_height_, lines.base_weight()), product(lines.point_weight(), base_height_));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (const NearPlane& face : edge(k).planes) faces_[k].push_back({lines.height_of_point(face), std::nullopt});
      crossings_[k] = lines.crossing(edge(k).line, edge((k + 1) % 3).line);
    }
  }

  std::vector<NearRange> ranges(const NearRange& all) {
    struct Part {
      NearRange range;
      int halvings;
      std::vector<std::uint32_t> shapes;
    };
    std::vector<NearRange> found;
    std::vector<Part> stack{{all, 0, {}}};
    for (std::uint32_t k = 0; k < shapes_.size(); ++k) {
      if (!is_own(all_.shapes_[k])) stack.back().shapes.push_back(k);
    }
    for (int looks = 0; !stack.empty(); ++looks) {
      Part part = std::move(stack.back());
      stack.pop_back();
      auto& [range, halvings, shapes] = part;
      const Known known = lines(Interval(range.from), Interval(range.to), shapes);
      if (known == Known::closed) continue;
      if (known == Known::perhaps && halvings < most_halvings && looks < most_looks) {
        const double middle = range.from / 2 + range.to / 2;
        stack.push_back({{middle, range.to}, halvings + 1, shapes});
        stack.push_back({{range.from, middle}, halvings + 1, std::move(shapes)});
      } else if (!found.empty() && found.back().to == range.from) {
        found.back().to = range.to;
      } else {
        found.push_back(range);
      }
    }
    return found;
  }

 private:
  static constexpr int most_halvings = 12;
  static constexpr int most_looks = 300;

  /// Above a plane; that of R is made when it is asked for, as are sides: few lines come so far.
  struct Heights {
    NearPolynomial of_point;
    std::optional<NearPolynomial> of_light;
  };
  struct SeenShape {
    std::vector<NearPolynomial> sides;
    std::vector<Heights> heights;  ///< of its facets
  };

  /// A line in a plane through p and an edge with the shape on one side does not pass through it.
  bool is_own(const NearShape& shape) const {
    return std::any_of(lines_.edges().begin(), lines_.edges().end(), [&](const SilhouetteEdge* e) {
      return std::find(e->shapes.begin(), e->shapes.end(), shape.shape) != e->shapes.end();
    });
  }

  SeenShape& seen_shape(std::uint32_t k) {
    if (shapes_[k]) return *shapes_[k];
    const NearShape& shape = all_.shapes_[k];
    SeenShape& own = shapes_[k].emplace();
    for (const NearLine& l : shape.lines) own.sides.push_back(lines_.side(l));
    for (const Facet& f : shape.facets) own.heights.push_back({lines_.height_of_point(f.plane), std::nullopt});
    return own;
  }

  /// With the heights h of p and q above the light's plane, R is h(p) q - h(q) p.
  const NearPolynomial& height_of_light(Heights& heights, const NearPlane& plane) const {
    if (!heights.of_light) {
      const NearPolynomial at_q = lines_.height_of_base(plane);
      heights.of_light =
          base().is_of_light ? at_q : difference(product(point_height_, at_q), product(heights.of_point, base_height_));
    }
    return *heights.of_light;
  }

  /// What is known of all lines on a range. Leaves out shapes that none of them meets.
  Known lines(const Interval& from, const Interval& to, std::vector<std::uint32_t>& shapes) {
    if (are_beside_boxes({from.inf(), to.sup()})) return Known::closed;
    const Signs sign{from, to};
    if (edge_ends_.are_missed(sign)) return Known::closed;
    const int at_ends = sign(lines_.base_ends()[0]) * sign(lines_.base_ends()[1]);
    if (at_ends > 0) return Known::closed;
    const int point_weight = sign(lines_.point_weight()), base_weight = sign(lines_.base_weight()),
              light_weight = sign(light_weight_);
    if (point_weight == 0 || base_weight == 0 || light_weight == 0) return Known::perhaps;
    const int weight = point_weight * light_weight;
    const bool is_on_base = at_ends < 0 || lines_.is_share_of_base();
    Known known = is_on_base ? Known::open : Known::perhaps;
    known = both(known, gap(sign));
    if (known != Known::closed) known = both(known, on_light(sign));
    if (known != Known::closed) known = both(known, in_order(sign, weight));
    if (known != Known::closed) known = both(known, unstopped(sign, weight, shapes));
    return known;
  }

  bool are_beside_boxes(const Interval& t) const {
    const auto flat = lines_.points(t);
    return flat && std::all_of(all_.boxes_.begin(), all_.boxes_.end(), [&](const FlatEnclosure& box) {
             return conic::are_apart(flat->x, box.x) || conic::are_apart(flat->y, box.y);
           });
  }

  /// The light's corners run counterclockwise seen from its front.
  Known on_light(const Signs& sign) {
    if (base().is_of_light) return Known::open;
    if (light_sides_.empty()) {
      for (const NearLine& l : all_.light_lines_) light_sides_.push_back(lines_.side(l));
    }
    bool is_left = false, is_right = false, is_known = true;
    for (const NearPolynomial& side : light_sides_) {
      const int at = sign(side);
      is_left = is_left || at > 0;
      is_right = is_right || at < 0;
      is_known = is_known && at != 0;
    }
    return is_left && is_right ? Known::closed : is_known ? Known::open : Known::perhaps;
  }

  /// Each edge between p and R: the line meets the planes of the faces at it there, so p and R lie on both sides.
  Known in_order(const Signs& sign, int weight) {
    bool is_known = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (edge(k).is_of_light) continue;
      for (std::size_t f = 0; f < faces_[k].size(); ++f) {
        Heights& h = faces_[k][f];
        const int sides = sign(h.of_point) * sign(height_of_light(h, edge(k).planes[f])) * weight;
        if (sides > 0) return Known::closed;
        is_known = is_known && sides != 0;
      }
    }
    return is_known ? Known::open : Known::perhaps;
  }

  /// Closed if one edge bounds nothing, as faces at it lie on both sides; or if what the three leave open has a
  /// direction in common, as one turns both ways from one open side to the next.
  Known gap(const Signs& sign) const {
    bool is_known = true;
    std::array<int, 3> hidden{};
    for (std::size_t k = 0; k < 3; ++k) {
      bool is_positive = false, is_negative = false, is_flat = false;
      for (const Heights& h : faces_[k]) {
        const int at = sign(h.of_point);
        is_positive = is_positive || at > 0;
        is_negative = is_negative || at < 0;
        is_flat = is_flat || at == 0;
      }
      if (is_positive && is_negative) return Known::closed;
      hidden[k] = is_flat ? 0 : is_positive ? 1 : is_negative ? -1 : 0;
      is_known = is_known && !is_flat;
    }
    bool is_up = false, is_down = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const int sides = hidden[k] * hidden[(k + 1) % 3];
      if (sides == 0) continue;
      const int turn = sign(crossings_[k]) * sides;
      is_up = is_up || turn > 0;
      is_down = is_down || turn < 0;
      is_known = is_known && turn != 0;
    }
    return is_up && is_down ? Known::closed : is_known ? Known::open : Known::perhaps;
  }

  Known unstopped(const Signs& sign, int weight, std::vector<std::uint32_t>& shapes) {
    std::size_t kept = 0;
    for (const std::uint32_t s : shapes) {
      const Meeting found = meeting(all_.shapes_[s], seen_shape(s), sign, weight);
      if (found == Meeting::all) return Known::closed;
      if (found == Meeting::perhaps) shapes[kept++] = s;
    }
    shapes.resize(kept);
    return shapes.empty() ? Known::open : Known::perhaps;
  }

  Meeting meeting(const NearShape& shape, SeenShape& seen, const Signs& sign, int weight) const {
    std::vector<int> sides;
    for (const NearPolynomial& side : seen.sides) sides.push_back(sign(side));
    Meeting most = Meeting::none;
    for (std::size_t f = 0; f < shape.facets.size(); ++f) {
      bool is_left = false, is_right = false, is_known = true;
      for (const auto& [line, way] : shape.facets[f].lines) {
        const int at = sides[line] * way;
        is_left = is_left || at > 0;
        is_right = is_right || at < 0;
        is_known = is_known && at != 0;
      }
      if (is_left && is_right) continue;
      const int heights =
          sign(seen.heights[f].of_point) * sign(height_of_light(seen.heights[f], shape.facets[f].plane)) * weight;
      if (heights > 0) continue;
      if (is_known && heights < 0) return Meeting::all;
      most = Meeting::perhaps;
    }
    return most;
  }

  const SilhouetteEdge& edge(std::size_t k) const { return *lines_.edges()[k]; }
  const SilhouetteEdge& base() const { return edge(0); }

  const OpenLines& all_;
  const RuledLines& lines_;
  NearPolynomial point_height_{};
  NearPolynomial base_height_{};
  NearPolynomial light_weight_{};
  std::vector<NearPolynomial> light_sides_;
  EdgeEnds edge_ends_;
  std::array<std::vector<Heights>, 3> faces_;  ///< at the edges
  std::array<NearPolynomial, 3> crossings_{};
  std::vector<std::optional<SeenShape>> shapes_;  ///< as all shapes are numbered
};

OpenLines::OpenLines(const EventScene& scene, std::span<const ShapeId> shapes, const ReceiverPlane& plane,
                     std::vector<FlatEnclosure> boxes)
    : scene_(scene), frame_(plane), boxes_(std::move(boxes)) {
  if (scene.kind == LightKind::area) {
    const auto& [a, b, c] = scene.light_plane;
    light_plane_ = near_plane(point(a), point(b), point(c));
    const auto& corners = scene.light_vertices;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      light_lines_.push_back(near_line(point(corners[k].point), point(corners[(k + 1) % corners.size()].point)));
    }
  }
  for (const ShapeId s : shapes) shapes_.push_back(near_shape(s));
}

std::vector<NearRange> OpenLines::ranges(const std::array<const SilhouetteEdge*, 3>& edges) const {
  EdgeEnds ends;
  ends.add(*edges[0], *edges[1], *edges[2]);
  ends.add(*edges[0], *edges[2], *edges[1]);
  if (ends.are_missed({Interval(0), Interval(1)})) return {};
  const RuledLines lines(edges, frame_);
  return Question(*this, lines, ends).ranges({0, 1});
}

std::vector<NearRange> OpenLines::ranges(const std::array<const SilhouetteEdge*, 3>& edges,
                                         const SilhouetteEdge& parting, const conic::FlatCurve& line,
                                         const NearRange& range) const {
  // Where a linear light touches a blocker's edge, another blocker's edge may be the base.
  if (scene_.kind != LightKind::area && !edges[0]->is_of_light) return {range};
  const RuledLines lines(edges, parting, line, frame_);
  return Question(*this, lines, {}).ranges(range);
}

PointEnclosure OpenLines::point(PointId id) const {
  const auto [x, y, z, w] = coordinates<Interval>(scene_.points[id]);
  return {x / w, y / w, z / w};
}

OpenLines::NearShape OpenLines::near_shape(ShapeId shape) const {
  const Shape& s = scene_.shapes[shape];
  NearShape result{shape, {}, {}};
  std::map<std::pair<PointId, PointId>, std::uint32_t> numbers;
  const auto add_facet = [&](const std::vector<PointId>& loop) {
    Facet& facet = result.facets.emplace_back();
    facet.plane = near_plane(point(loop[0]), point(loop[1]), point(loop[2]));
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const PointId a = loop[k], b = loop[(k + 1) % loop.size()];
      const auto [at, is_new] = numbers.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(result.lines.size()));
      if (is_new) result.lines.push_back(near_line(point(std::min(a, b)), point(std::max(a, b))));
      facet.lines.emplace_back(at->second, a < b ? 1 : -1);
    }
  };
  if (s.is_solid) {
    for (const auto& facet : s.facets) add_facet(facet);
  } else {
    add_facet(s.corners);
  }
  return result;
}

}  // namespace gnomon::event
