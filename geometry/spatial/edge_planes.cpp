#include "geometry/spatial/edge_planes.h"

#include <algorithm>
#include <optional>

#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

/// What a corner of one body asks of a plane through an edge of the other, as the plane turns about the edge from the
/// facet on its left to the facet on its right.
enum class Demand {
  nothing,
  at_least,  ///< the plane has turned at least until it touches the corner
  at_most,   ///< the plane has turned at most until it touches the corner
  never,     ///< no plane but perhaps a facet's separates
  on_line    ///< nothing, and the corner defines no plane with the edge
};

/// How a corner of the other body lies to a plane through an edge.
enum class Touch { none, touches, on_line };

/// The lowest index of the vertices that touch a plane through the edge from p to q. One inside a side touches if the
/// side lies in the plane, but not on the edge's line.
std::uint32_t lowest_touching(const Body& body, const std::vector<Touch>& touches, const Point3& p, const Point3& q) {
  std::uint32_t lowest = Body::none;
  for (std::uint32_t k = 0; k < touches.size(); ++k) {
    if (touches[k] == Touch::touches) lowest = std::min(lowest, body.index[k]);
  }
  for (const Body::Edge& side : body.edges) {
    if (touches[side.from] == Touch::none || touches[side.to] == Touch::none) continue;
    for (std::uint32_t i = side.first_inside; i < side.last_inside; ++i) {
      const auto& [index, point] = body.inside[i];
      if (index < lowest && !CGAL::collinear(to_cgal(p), to_cgal(q), to_cgal(point))) lowest = index;
    }
  }
  return lowest;
}

/// One body with its edges, and the other that planes through the edges are to separate from it.
class Separation {
 public:
  Separation(const BodyPair& pair, const Body& edges, const Body& corners)
      : pair_(pair), body_(edges), other_(corners) {}

  /// The separating planes through one edge, with `body` on the negative side. `vertex_index` is unset in their names.
  std::vector<HalfSpace> planes(const Body::Edge& edge) const {
    std::optional<std::uint32_t> least;
    std::optional<std::uint32_t> most;
    std::vector<Demand> demands(other_.corners.size());
    for (std::uint32_t k = 0; k < demands.size(); ++k) {
      demands[k] = demand(edge, k);
      if (demands[k] == Demand::never) return {};
      if (demands[k] == Demand::at_least && (!least || turn(edge, *least, k) > 0)) least = k;
      if (demands[k] == Demand::at_most && (!most || turn(edge, *most, k) < 0)) most = k;
    }
    if (least && most && turn(edge, *least, *most) > 0) return {};
    std::vector<HalfSpace> result;
    if (least) result.push_back(plane(edge, *least, demands, +1));
    if (most && !(least && turn(edge, *least, *most) == 0)) result.push_back(plane(edge, *most, demands, -1));
    return result;
  }

 private:
  const Point3& from(const Body::Edge& edge) const { return body_.corners[edge.from]; }
  const Point3& to(const Body::Edge& edge) const { return body_.corners[edge.to]; }

  /// Orientation of the edge and two corners. Of two that ask for `at_least` (of two that ask for `at_most`) b asks for
  /// more if it is positive (negative); a plane fits between at least a and at most b unless it is positive.
  int turn(const Body::Edge& edge, std::uint32_t a, std::uint32_t b) const {
    return a == b ? 0 : pair_.orientation(from(edge), to(edge), other_.corners[a], other_.corners[b]);
  }

  int facet_side(std::uint32_t facet, std::uint32_t k) const {
    if (&other_ == &pair_.light) return pair_.facet_side(facet, k);
    return pair_.orientation(body_.facet_point(facet, 0), body_.facet_point(facet, 1), body_.facet_point(facet, 2),
                             other_.corners[k]);
  }

  Demand demand(const Body::Edge& edge, std::uint32_t k) const {
    const int left = facet_side(edge.left, k);
    if (body_.flat) {
      return left > 0 ? Demand::at_most : left < 0 ? Demand::at_least : demand_in_plane(edge, k);
    }
    const int right = facet_side(edge.right, k);
    if (left >= 0 && right >= 0) return left == 0 && right == 0 ? Demand::on_line : Demand::nothing;
    if (left < 0 && right > 0) return Demand::at_least;
    if (left > 0 && right < 0) return Demand::at_most;
    return Demand::never;
  }

  /// Of a corner in the plane of a flat body: it lies beyond the edge, on its line, or on the body's side of it.
  Demand demand_in_plane(const Body::Edge& edge, std::uint32_t k) const {
    std::uint32_t off = 0;
    while (facet_side(edge.left, off) == 0) ++off;
    const int corner = turn(edge, off, k);
    if (corner == 0) return Demand::on_line;
    const std::uint32_t next = (edge.to + 1) % static_cast<std::uint32_t>(body_.corners.size());
    const int inner = pair_.orientation(from(edge), to(edge), other_.corners[off], body_.corners[next]);
    return corner == inner ? Demand::never : Demand::nothing;
  }

  HalfSpace plane(const Body::Edge& edge, std::uint32_t corner, const std::vector<Demand>& demands, int way) const {
    std::vector<Touch> touches(demands.size(), Touch::none);
    for (std::uint32_t k = 0; k < demands.size(); ++k) {
      if (demands[k] == Demand::on_line) {
        touches[k] = Touch::on_line;
      } else if (turn(edge, corner, k) == 0) {
        touches[k] = Touch::touches;
      }
    }
    HalfSpace result;
    if (edge.name != Body::none) result.name.edge_index = edge.name;
    result.name.vertex_index = lowest_touching(other_, touches, from(edge), to(edge));
    result.plane = {from(edge), to(edge), other_.corners[corner]};
    if (way > 0) std::swap(result.plane[0], result.plane[1]);
    result.third_is_direction = other_.at_infinity;
    return result;
  }

  const BodyPair& pair_;
  const Body& body_;
  const Body& other_;
};

HalfSpace reversed(HalfSpace half_space) {
  std::swap(half_space.plane[0], half_space.plane[1]);
  return half_space;
}

/// Number of blocker corners on a plane.
std::size_t touched(const BodyPair& pair, const HalfSpace& half_space) {
  const auto& plane = half_space.plane;
  const auto lies_on_it = [&](const Point3& corner) {
    return pair.orientation(plane[0], plane[1], plane[2], corner) == 0;
  };
  return static_cast<std::size_t>(std::count_if(pair.blocker.corners.begin(), pair.blocker.corners.end(), lies_on_it));
}

/// The planes that hold a linear light and touch the blocker: at most two.
std::vector<HalfSpace> tangent_planes(const BodyPair& pair) {
  const Point3& p = pair.light.corners[0];
  const Point3& q = pair.light.corners[1];
  const std::vector<Point3>& corners = pair.blocker.corners;
  std::vector<HalfSpace> result;
  for (const int way : {+1, -1}) {
    const auto side = [&](std::uint32_t a, std::uint32_t b) {
      return way * pair.orientation(p, q, corners[a], corners[b]);
    };
    const auto is_off_line = [&](std::uint32_t a) {
      for (std::uint32_t b = 0; b < corners.size(); ++b) {
        if (side(a, b) != 0) return true;
      }
      return false;
    };
    std::uint32_t extreme = 0;
    while (extreme < corners.size() && !is_off_line(extreme)) ++extreme;
    if (extreme == corners.size()) return {};
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      if (side(extreme, k) < 0) extreme = k;
    }
    bool is_tangent = true;
    for (std::uint32_t k = 0; k < corners.size(); ++k) is_tangent = is_tangent && side(extreme, k) >= 0;
    if (!is_tangent) continue;
    HalfSpace plane;
    plane.name = {FacetKind::separating_light_plane, 0, static_cast<std::int32_t>(pair.blocker.index[extreme])};
    plane.plane = {p, q, corners[extreme]};
    if (way > 0) std::swap(plane.plane[0], plane.plane[1]);
    result.push_back(plane);
  }
  return result;
}

}  // namespace

std::vector<HalfSpace> separating_blocker_planes(const BodyPair& pair) {
  const Separation separation(pair, pair.blocker, pair.light);
  std::vector<HalfSpace> result;
  for (const Body::Edge& edge : pair.blocker.edges) {
    for (HalfSpace& plane : separation.planes(edge)) {
      plane.name.kind = FacetKind::separating_blocker_plane;
      result.push_back(plane);
    }
  }
  return result;
}

std::vector<HalfSpace> separating_light_planes(const BodyPair& pair) {
  std::vector<HalfSpace> candidates;
  if (pair.light.edges.size() == 1) {
    candidates = tangent_planes(pair);
  } else {
    const Separation separation(pair, pair.light, pair.blocker);
    for (const Body::Edge& edge : pair.light.edges) {
      for (const HalfSpace& plane : separation.planes(edge)) {
        candidates.push_back(reversed(plane));
        candidates.back().name.kind = FacetKind::separating_light_plane;
      }
    }
  }
  std::erase_if(candidates, [&](const HalfSpace& plane) { return touched(pair, plane) != 1; });
  return candidates;
}

std::vector<HalfSpace> supporting_blocker_planes(const BodyPair& pair, const std::vector<std::uint32_t>& corners) {
  const auto highest = [&](std::uint32_t facet) {
    int side = -1;
    for (const std::uint32_t j : corners) side = std::max(side, pair.facet_side(facet, j));
    return side;
  };
  std::vector<int> seen(pair.blocker.facets.size());
  for (std::uint32_t f = 0; f < seen.size(); ++f) seen[f] = highest(f);
  std::vector<HalfSpace> result;
  for (const Body::Edge& edge : pair.blocker.edges) {
    if (std::max(seen[edge.left], seen[edge.right]) <= 0 || std::min(seen[edge.left], seen[edge.right]) >= 0) continue;
    const bool left = seen[edge.left] > 0;
    const Point3& u = pair.blocker.corners[left ? edge.from : edge.to];
    const Point3& v = pair.blocker.corners[left ? edge.to : edge.from];
    const std::uint32_t facet = left ? edge.left : edge.right;
    std::uint32_t extreme = Body::none;
    for (const std::uint32_t j : corners) {
      if (pair.facet_side(facet, j) <= 0) continue;
      if (extreme == Body::none || pair.orientation(u, v, pair.light.corners[extreme], pair.light.corners[j]) > 0) {
        extreme = j;
      }
    }
    std::vector<Touch> touches(pair.light.corners.size(), Touch::none);
    for (std::uint32_t j = 0; j < touches.size(); ++j) {
      const bool lies_on_plane =
          j == extreme || pair.orientation(u, v, pair.light.corners[extreme], pair.light.corners[j]) == 0;
      if (lies_on_plane) touches[j] = pair.facet_side(facet, j) != 0 ? Touch::touches : Touch::on_line;
    }
    const std::uint32_t lowest = lowest_touching(pair.light, touches, u, v);
    result.push_back(
        {{FacetKind::supporting_blocker_plane, static_cast<std::int32_t>(edge.name), static_cast<std::int32_t>(lowest)},
         {u, v, pair.light.corners[extreme]},
         pair.light.at_infinity});
  }
  return result;
}

}  // namespace gnomon
