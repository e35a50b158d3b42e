#include "geometry/discontinuity/open_lines.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace gnomon::event {
namespace {

enum class Known : std::uint8_t { closed, open, perhaps };
enum class Meeting : std::uint8_t { none, perhaps, all };

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
  explicit EdgeEnds(const RuledLines& lines) {
    if (!lines.is_share_of_base()) return;
    const Outline &j = *lines.edges()[1], &k = *lines.edges()[2];
    add(lines, j, k);
    add(lines, k, j);
  }

  bool are_missed(const Signs& sign) const {
    for (std::size_t k = 0; k < ends_.size(); k += 2) {
      if (sign(ends_[k]) * sign(ends_[k + 1]) > 0) return true;
    }
    return false;
  }

 private:
  void add(const RuledLines& lines, const Outline& edge, const Outline& other) {
    for (const Place* end : {&edge.a, &edge.b}) {
      ends_.push_back(lines.height_of_base(near_plane(other.a.near, other.b.near, end->near)));
    }
  }

  std::vector<NearPolynomial> ends_;
};

}  // namespace

/// Lines, and what is asked of them. R is the place on the light: q, or where a line meets the light's plane.
class OpenLines::Question {
 public:
  Question(const OpenLines& all, const RuledLines& lines, const EdgeEnds& ends)
      : all_(all), lines_(lines), edge_ends_(ends), shapes_(all.shapes_.size()) {
    if (base().is_of_light) {
      light_weight_ = lines.base_weight();
    } else {
      point_height_ = lines.height_of_point(all.light_plane_);
      base_height_ = lines.height_of_base(all.light_plane_);
      light_weight_ =
          difference(product(point_height_, lines.base_weight()), product(lines.point_weight(), base_height_));
      for (const NearLine& l : all.light_lines_) light_sides_.push_back(lines.side(l));
    }
    for (std::size_t k = 0; k < 3; ++k) add_edge(*lines.edges()[k], edges_[k]);
    for (std::size_t k = 0; k < 3; ++k) crossings_[k] = lines.crossing(edges_[k].line, edges_[(k + 1) % 3].line);
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

  struct Heights {
    NearPolynomial of_point;
    NearPolynomial of_light;
  };
  struct SeenEdge {
    NearLine line;
    std::vector<Heights> hidden;  ///< of the planes of the faces at it
  };
  struct SeenShape {
    std::vector<NearPolynomial> sides;
    std::vector<Heights> heights;  ///< of its facets
  };

  void add_edge(const Outline& edge, SeenEdge& own) {
    own.line = near_line(edge.a.near, edge.b.near);
    for (const Place& face : edge.hidden)
      own.hidden.push_back(heights(near_plane(edge.a.near, edge.b.near, face.near)));
  }

  /// A line in a plane through p and an edge with the shape on one side does not pass through it.
  bool is_own(const NearShape& shape) const {
    return std::any_of(lines_.edges().begin(), lines_.edges().end(), [&](const Outline* e) {
      return std::find(e->shapes.begin(), e->shapes.end(), shape.shape) != e->shapes.end();
    });
  }

  /// Made when it is asked for: few lines come so far.
  const SeenShape& seen_shape(std::uint32_t k) {
    if (shapes_[k]) return *shapes_[k];
    const NearShape& shape = all_.shapes_[k];
    SeenShape& own = shapes_[k].emplace();
    for (const NearLine& l : shape.lines) own.sides.push_back(lines_.side(l));
    for (const Facet& f : shape.facets) own.heights.push_back(heights(f.plane));
    return own;
  }

  /// With the heights h of p and q above the light's plane, R is h(p) q - h(q) p.
  Heights heights(const NearPlane& plane) const {
    const NearPolynomial at_p = lines_.height_of_point(plane), at_q = lines_.height_of_base(plane);
    if (base().is_of_light) return {at_p, at_q};
    return {at_p, difference(product(point_height_, at_q), product(at_p, base_height_))};
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
    Known known = gap(sign);
    for (const auto& ask : {&Question::on_light, &Question::in_order}) {
      const Known more = (this->*ask)(sign, weight);
      if (known == Known::closed || more == Known::closed) return Known::closed;
      if (more == Known::perhaps) known = more;
    }
    const Known through = unstopped(sign, weight, shapes);
    if (through != Known::open) return through;
    return at_ends < 0 || lines_.is_share_of_base() ? known : Known::perhaps;
  }

  bool are_beside_boxes(const Interval& t) const {
    const auto flat = lines_.points(t);
    return flat && std::all_of(all_.boxes_.begin(), all_.boxes_.end(), [&](const FlatEnclosure& box) {
             return conic::are_apart(flat->x, box.x) || conic::are_apart(flat->y, box.y);
           });
  }

  /// The light's corners run counterclockwise seen from its front.
  Known on_light(const Signs& sign, int /*weight*/) const {
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
  Known in_order(const Signs& sign, int weight) const {
    bool is_known = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (lines_.edges()[k]->is_of_light) continue;
      for (const Heights& h : edges_[k].hidden) {
        const int sides = sign(h.of_point) * sign(h.of_light) * weight;
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
      for (const Heights& h : edges_[k].hidden) {
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

  static Meeting meeting(const NearShape& shape, const SeenShape& seen, const Signs& sign, int weight) {
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
      const int heights = sign(seen.heights[f].of_point) * sign(seen.heights[f].of_light) * weight;
      if (heights > 0) continue;
      if (is_known && heights < 0) return Meeting::all;
      most = Meeting::perhaps;
    }
    return most;
  }

  const Outline& base() const { return *lines_.edges()[0]; }

  const OpenLines& all_;
  const RuledLines& lines_;
  NearPolynomial point_height_{};
  NearPolynomial base_height_{};
  NearPolynomial light_weight_{};
  std::vector<NearPolynomial> light_sides_;
  const EdgeEnds& edge_ends_;
  std::array<SeenEdge, 3> edges_;
  std::array<NearPolynomial, 3> crossings_{};
  std::vector<std::optional<SeenShape>> shapes_;  ///< as all shapes are numbered
};

OpenLines::OpenLines(const EventScene& scene, std::span<const ShapeId> shapes, std::vector<FlatEnclosure> boxes)
    : scene_(scene), boxes_(std::move(boxes)) {
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

std::vector<NearRange> OpenLines::ranges(const RuledLines& lines, const NearRange& all) const {
  // Where a linear light touches a blocker's edge, another blocker's edge may be the base.
  if (scene_.kind != LightKind::area && !lines.edges()[0]->is_of_light) return {all};
  const EdgeEnds ends(lines);
  if (ends.are_missed({Interval(all.from), Interval(all.to)})) return {};
  return Question(*this, lines, ends).ranges(all);
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
