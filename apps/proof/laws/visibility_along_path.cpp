#include "apps/proof/laws/visibility_along_path.h"

#include <algorithm>
#include <span>

#include "apps/proof/laws/definition.h"

namespace gnomon::laws {
namespace {

using Place = std::array<Germ, 3>;  // homogeneous with respect to three points of the light's plane; of a segment two

/// A line of the light's plane, by what a linear function is at the three points; it is not positive on the side kept.
struct Line {
  Place at;
  VisibleEdge edge;

  int side(const Place& p) const { return (at[0] * p[0] + at[1] * p[1] + at[2] * p[2]).sign(); }
};

/// A convex part of the light: corners, each with the line of the edge that leaves it. Of a segment: two corners.
struct Patch {
  std::vector<Place> corners;
  std::vector<Line> edges;
};

Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Place negative(const Place& p) {
  return {-p[0], -p[1], -p[2]};
}

/// The place where lines meet, with a positive weight.
Place crossing(const Line& a, const Line& b) {
  const Place p = cross(a.at, b.at);
  return (p[0] + p[1] + p[2]).sign() < 0 ? negative(p) : p;
}

/// Rational numbers times their common denominator.
std::vector<Integer> whole(std::span<const Rational> numbers) {
  Integer common = 1;
  for (const Rational& r : numbers) common = lcm(common, denominator(r));
  std::vector<Integer> result;
  for (const Rational& r : numbers) result.push_back(numerator(r) * (common / denominator(r)));
  return result;
}

Germ constant(const Integer& value) {
  return Germ({value});
}

/// What a wall is at the light's three points and along the path.
struct VisibleWall {
  std::array<Integer, 3> at_light;
  Germ at_path;
  int front = 0;  ///< side to which the front leads

  int side() const { return at_path.is_zero() ? front : at_path.sign(); }
};

/// The light with its three points of reference.
class Frame {
 public:
  explicit Frame(std::vector<ExactVector> light) : corners_(std::move(light)), is_segment_(corners_.size() == 2) {
    if (is_segment_) {
      whole_.corners = {{constant(1), Germ(), Germ()}, {Germ(), constant(1), Germ()}};
      return;
    }
    reference_ = {corners_[0], corners_[1], third()};
    const ExactPlane plane = plane_through(reference_[0], reference_[1], reference_[2]);
    for (const ExactVector& c : corners_) whole_.corners.push_back(place(c, plane.normal));
    // Vertices inside sides would make lines of no length.
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Line line{cross(whole_.corners[i], whole_.corners[(i + 1) % corners_.size()]), {-1, int(i), int(i)}};
      if (line.side(inner()) > 0) line.at = negative(line.at);
      whole_.edges.push_back(line);
    }
  }

  const Patch& whole() const { return whole_; }
  bool is_segment() const { return is_segment_; }

  VisibleWall seen(const ExactPlane& wall, const Path& path) const {
    std::array<Rational, 5> numbers;
    const std::size_t n = is_segment_ ? 2 : 3;
    for (std::size_t k = 0; k < n; ++k) numbers[k] = wall.height(is_segment_ ? corners_[k] : reference_[k]);
    numbers[3] = wall.height(path.start);
    numbers[4] = dot(wall.normal, path.direction);
    std::vector<Integer> scaled = gnomon::laws::whole(numbers);
    return {{scaled[0], scaled[1], scaled[2]},
            Germ({scaled[3], scaled[4]}),
            path.front ? sign(dot(wall.normal, *path.front)) : 0};
  }

 private:
  /// The first vertex off the line of the first two.
  ExactVector third() const {
    for (std::size_t k = 2; k < corners_.size(); ++k) {
      if (!is_zero(laws::cross(corners_[1] - corners_[0], corners_[k] - corners_[0]))) return corners_[k];
    }
    return corners_.back();
  }

  Place place(const ExactVector& p, const ExactVector& normal) const {
    std::array<Rational, 3> shares;
    for (std::size_t k = 0; k < 3; ++k) {
      const ExactVector &a = reference_[(k + 1) % 3], &b = reference_[(k + 2) % 3];
      shares[k] = dot(laws::cross(a - p, b - p), normal);
    }
    const std::vector<Integer> scaled = gnomon::laws::whole(shares);
    return {constant(scaled[0]), constant(scaled[1]), constant(scaled[2])};
  }

  /// Inside the light: the middle of the points of reference.
  static Place inner() { return {constant(1), constant(1), constant(1)}; }

  std::vector<ExactVector> corners_;
  bool is_segment_;
  std::array<ExactVector, 3> reference_;
  Patch whole_;
};

Patch clipped_segment(const Patch& patch, const Line& line) {
  const int first = line.side(patch.corners[0]), last = line.side(patch.corners[1]);
  if (first <= 0 && last <= 0) return patch;
  if (first >= 0 && last >= 0) return {};
  Place zero{line.at[1], -line.at[0], Germ()};
  if ((zero[0] + zero[1]).sign() < 0) zero = negative(zero);
  Patch result = patch;
  result.corners[first > 0 ? 0 : 1] = zero;
  return result;
}

/// The part of a convex polygon on which the line's function is not positive; empty if it has no area.
Patch clipped_polygon(const Patch& patch, const Line& line) {
  const std::size_t n = patch.corners.size();
  std::vector<int> sides;
  for (const Place& c : patch.corners) sides.push_back(line.side(c));
  if (std::ranges::all_of(sides, [](int s) { return s <= 0; })) return patch;
  if (std::ranges::all_of(sides, [](int s) { return s >= 0; })) return {};
  Patch kept;
  const auto keep = [&](const Place& corner, const Line& edge) {
    kept.corners.push_back(corner);
    kept.edges.push_back(edge);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const int here = sides[i], next = sides[(i + 1) % n];
    if (here < 0 || (here == 0 && next < 0)) {
      keep(patch.corners[i], patch.edges[i]);
    } else if (here == 0 && sides[(i + n - 1) % n] < 0) {
      keep(patch.corners[i], line);
    }
    if (here < 0 && next > 0) keep(crossing(patch.edges[i], line), line);
    if (here > 0 && next < 0) keep(crossing(patch.edges[i], line), patch.edges[i]);
  }
  return kept;
}

bool is_flat(const Walls& walls) {
  return walls[0].normal == walls[1].reversed().normal;
}

/// The name of the edge between two walls.
VisibleEdge edge_between(int of, const Walls& walls, std::size_t i, std::size_t j) {
  if (is_flat(walls) && std::min(i, j) < 2) return {of, int(std::max(i, j)), int(std::max(i, j))};
  return {of, int(std::min(i, j)), int(std::max(i, j))};
}

/// The half-planes that hold what one blocker hides; nothing if it hides nothing.
std::optional<std::vector<Line>> hiding_lines(const Frame& frame, int of, const Walls& walls, const Path& path) {
  std::vector<VisibleWall> seen;
  for (const ExactPlane& wall : walls) seen.push_back(frame.seen(wall, path));
  std::vector<Line> lines;
  const auto own = [&](std::size_t i) {
    const auto& h = seen[i].at_light;
    lines.push_back({{constant(h[0]), constant(h[1]), constant(h[2])}, {of, int(i), int(i)}});
  };
  const auto weight = [](const VisibleWall& w) { return w.at_path; };
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (seen[i].side() < 0) continue;
    // The segments to points above a wall they start on, or above one that all of the light is on, miss the blocker.
    const auto& h = seen[i].at_light;
    if (seen[i].side() > 0 && h[0] == 0 && h[1] == 0 && h[2] == 0) return std::nullopt;
    own(i);
    if (seen[i].side() == 0) continue;
    for (std::size_t j = 0; j < walls.size(); ++j) {
      if (seen[j].side() >= 0) continue;
      // The combination of the two walls that vanishes on the path.
      Germ a = weight(seen[i]), b = weight(seen[j]);
      if (a.is_zero() && b.is_zero()) continue;  // both at the receiver: one wall says what the other does
      Line line{{}, edge_between(of, walls, i, j)};
      for (std::size_t k = 0; k < 3; ++k) {
        line.at[k] = a * constant(seen[j].at_light[k]) - b * constant(h[k]);
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

Patch clipped(const Frame& frame, Patch patch, const std::vector<Line>& lines) {
  for (const Line& line : lines) {
    patch = frame.is_segment() ? clipped_segment(patch, line) : clipped_polygon(patch, line);
    if (patch.corners.empty()) return {};
  }
  return patch;
}

/// What each blocker hides, as lines.
std::vector<std::vector<Line>> hiding(const Frame& frame, const std::vector<Walls>& blockers, const Path& path) {
  std::vector<std::vector<Line>> result;
  for (const Walls& walls : blockers) {
    if (auto lines = hiding_lines(frame, int(&walls - blockers.data()), walls, path)) result.push_back(*lines);
  }
  return result;
}

/// The length or twice the area of a part, with respect to the points of reference.
Jet measure(const Frame& frame, const Patch& patch) {
  std::vector<std::array<Jet, 2>> corners;
  for (const Place& p : patch.corners) {
    const Germ sum = p[0] + p[1] + p[2];
    corners.push_back({quotient(p[1], sum), frame.is_segment() ? Jet{} : quotient(p[2], sum)});
  }
  if (frame.is_segment()) return corners[1][0] - corners[0][0];
  Jet area;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area = area + (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

/// What the blockers from `next` on hide of a part, by inclusion and exclusion.
Jet hidden_measure(const Frame& frame, const Patch& part, const std::vector<std::vector<Line>>& hiding,
                   std::size_t next) {
  Jet sum;
  for (std::size_t i = next; i < hiding.size(); ++i) {
    const Patch hidden = clipped(frame, part, hiding[i]);
    if (hidden.corners.empty()) continue;
    sum = sum + measure(frame, hidden) - hidden_measure(frame, hidden, hiding, i + 1);
  }
  return sum;
}

/// True if the light shows the path its back or its edge.
bool is_unlit_after(const Light& light, const Path& path) {
  const auto* area = std::get_if<AreaLight>(&light);
  if (!area) return false;
  const ExactPlane plane = plane_of(vertices(light));
  int side = plane.side(path.start);
  if (side == 0) side = sign(dot(plane.normal, path.direction));
  if (side == 0 && path.front) side = sign(dot(plane.normal, *path.front));
  return area->two_sided ? side == 0 : side <= 0;
}

/// The part of an edge, as shares of the way from one corner to another, that another part of the light holds.
struct Stretch {
  Rational from = 0;
  Rational to = 1;
  VisibleEdge from_edge;
  VisibleEdge to_edge;
};

Rational number(const Germ& g) {
  return Rational(g[0]);
}

void keep_first(bool is_nearer, const Rational& zero, const VisibleEdge& edge, Rational& place, VisibleEdge& kept) {
  if (is_nearer || (zero == place && edge < kept)) kept = edge;
  if (is_nearer) place = zero;
}

/// Where the edge of `own` between two corners lies in `other`, boundary included; nothing if the two are on one side
/// of a common line, so that the edge bounds both.
std::optional<Stretch> held(const Line* own, const std::array<Place, 2>& ends, const Patch& other) {
  Stretch stretch;
  for (const Line& line : other.edges) {
    std::array<Rational, 2> height;
    for (std::size_t k = 0; k < 2; ++k) {
      const Place& p = ends[k];
      height[k] = number(line.at[0] * p[0] + line.at[1] * p[1] + line.at[2] * p[2]) / number(p[0] + p[1] + p[2]);
    }
    const int at_start = sign(height[0]), at_end = sign(height[1]);
    if (at_start == 0 && at_end == 0) {
      if (!own) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        if (sign(number(line.at[k])) * sign(number(own->at[k])) > 0) return std::nullopt;
      }
      continue;
    }
    if (at_start >= 0 && at_end >= 0) return std::nullopt;
    if (at_start <= 0 && at_end <= 0) continue;
    const Rational zero = height[0] / (height[0] - height[1]);
    // Of several edges that end it in one place the first by name tells.
    if (at_start > 0) keep_first(zero > stretch.from, zero, line.edge, stretch.from, stretch.from_edge);
    if (at_end > 0) keep_first(zero < stretch.to, zero, line.edge, stretch.to, stretch.to_edge);
    if (stretch.from >= stretch.to) return std::nullopt;
  }
  return stretch;
}

/// Appends the pieces of an edge that no other part holds.
void append_pieces(const VisiblePiece& edge, std::vector<Stretch> covered, std::vector<VisiblePiece>& pieces) {
  std::ranges::sort(covered, {}, &Stretch::from);
  Rational reached = 0;
  VisibleEdge from = edge.from;
  for (const Stretch& s : covered) {
    if (s.from > reached) pieces.push_back({edge.edge, from, s.from_edge});
    if (s.to == reached) from = std::min(from, s.to_edge);
    if (s.to <= reached) continue;
    reached = s.to;
    from = s.to_edge;
  }
  if (reached < 1) pieces.push_back({edge.edge, from, edge.to});
}

}  // namespace

Jet visible_share_after(const Light& light, const std::vector<Walls>& blockers, const Path& path) {
  if (is_unlit_after(light, path)) return {};
  return visible_share_after(vertices(light), blockers, path);
}

Jet visible_share_after(const std::vector<ExactVector>& light, const std::vector<Walls>& blockers, const Path& path) {
  const Frame frame(light);
  const Jet hidden = hidden_measure(frame, frame.whole(), hiding(frame, blockers, path), 0);
  const Rational all = measure(frame, frame.whole()).value;
  return Jet{1, 0, 0} - Rational(1 / all) * hidden;
}

std::optional<int> order_at_start(const std::vector<ExactVector>& light, const std::vector<Walls>& blockers,
                                  const Path& path) {
  const Jet after = visible_share_after(light, blockers, path);
  const Jet before = visible_share_after(light, blockers, path.reversed());
  if (after.value != before.value) return 0;
  if (after.slope != -before.slope) return 1;
  if (after.bend != before.bend) return 2;
  return std::nullopt;
}

bool is_lit_after(const Light& light, const std::vector<Walls>& blockers, const Path& path) {
  const Frame frame(vertices(light));
  const auto all = hiding(frame, blockers, path);
  return std::ranges::all_of(all,
                             [&](const auto& lines) { return clipped(frame, frame.whole(), lines).corners.empty(); });
}

std::vector<VisiblePiece> visible_pieces(const AreaLight& light, const std::vector<Walls>& blockers, const Path& path) {
  if (is_unlit_after(light, path)) return {};
  const Frame frame(vertices(light));
  std::vector<Patch> hidden;
  for (const auto& lines : hiding(frame, blockers, {path.start, {}, path.front})) {
    hidden.push_back(clipped(frame, frame.whole(), lines));
    if (hidden.back().corners.empty()) hidden.pop_back();
  }
  std::vector<VisiblePiece> pieces;
  const auto append = [&](const Patch& patch, bool is_light) {
    const std::size_t n = patch.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Line& line = patch.edges[i];
      if (!is_light && line.edge.of < 0) continue;
      std::vector<Stretch> covered;
      for (const Patch& other : hidden) {
        if (&other == &patch) continue;
        const auto stretch = held(is_light ? nullptr : &line, {patch.corners[i], patch.corners[(i + 1) % n]}, other);
        if (stretch) covered.push_back(*stretch);
      }
      append_pieces({line.edge, patch.edges[(i + n - 1) % n].edge, patch.edges[(i + 1) % n].edge}, covered, pieces);
    }
  };
  append(frame.whole(), true);
  for (const Patch& patch : hidden) append(patch, false);
  std::ranges::sort(pieces);
  return pieces;
}

}  // namespace gnomon::laws
