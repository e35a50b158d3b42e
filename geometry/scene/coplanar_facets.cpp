#include "geometry/scene/coplanar_facets.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/place_key.h"
#include "gnomon/convex_polygon.h"

namespace gnomon {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<DirectedEdge> edges_of(const Ring& ring) {
  std::vector<DirectedEdge> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) edges.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  return edges;
}

std::vector<Point3> points_of(std::span<const Point3> points, const Ring& ring) {
  std::vector<Point3> result;
  for (const std::uint32_t v : ring) result.push_back(points[v]);
  return result;
}

/// The ring's polygon if it is convex and exactly flat.
std::optional<ConvexPolygon> flat_polygon(std::span<const Point3> points, const Ring& ring) {
  std::vector<Point3> corners = points_of(points, ring);
  if (ConvexPolygon::defect(corners)) return std::nullopt;
  ConvexPolygon polygon = ConvexPolygon::from_points(std::move(corners));
  return polygon.is_flat() ? std::optional(std::move(polygon)) : std::nullopt;
}

/// The one ring that all edges make once those that run both ways are gone; nothing if that is not one ring.
std::optional<Ring> common_boundary(const std::vector<const Ring*>& rings) {
  std::set<DirectedEdge> left;
  for (const Ring* ring : rings) {
    for (const DirectedEdge& edge : edges_of(*ring)) {
      if (left.erase({edge.second, edge.first}) == 0) left.insert(edge);
    }
  }
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [from, to] : left) {
    if (!next.emplace(from, to).second) return std::nullopt;
  }
  if (next.empty()) return std::nullopt;
  Ring boundary;
  const std::uint32_t start = next.begin()->first;
  for (auto at = next.find(start); at != next.end() && boundary.size() < next.size(); at = next.find(at->second)) {
    if (!boundary.empty() && at->first == start) break;
    boundary.push_back(at->first);
  }
  return boundary.size() == next.size() ? std::optional(std::move(boundary)) : std::nullopt;
}

/// Facets in the making. Of a vertex's numbers the lowest is used.
class Joining {
 public:
  Joining(std::span<const Point3> points, std::span<const Ring> facets) : points_(points), facets_(facets) {
    std::map<PlaceKey, std::uint32_t> known;
    for (const Ring& facet : facets) {
      Ring ring;
      for (const std::uint32_t v : facet) ring.push_back(known.try_emplace(place_key(points[v]), v).first->second);
      add(std::move(ring));
    }
  }

  std::vector<Ring> run() {
    join_whole_walls();
    for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
      for (std::optional<std::uint32_t> grown = piece; grown;) grown = joined_with_a_neighbour(*grown);
    }
    std::vector<Ring> rings;
    for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
      if (pieces_[piece].empty()) continue;
      rings.push_back(is_joined_[piece] ? corners_of(pieces_[piece]) : facets_[piece]);
    }
    return rings;
  }

 private:
  void add(Ring ring) {
    const auto piece = static_cast<std::uint32_t>(pieces_.size());
    const auto polygon = flat_polygon(points_, ring);
    planes_.emplace_back();
    if (polygon) {
      for (std::size_t k = 0; k < 3; ++k) planes_.back().push_back(ring[polygon->corners()[k]]);
    }
    pieces_.push_back(std::move(ring));
    is_joined_.push_back(false);
    if (polygon && std::ranges::none_of(edges_of(pieces_[piece]), [&](const DirectedEdge& edge) {
          return owner_in_wall(edge, piece).has_value();
        })) {
      own_edges(piece);
    } else {
      planes_[piece].clear();
    }
  }

  void own_edges(std::uint32_t piece) {
    for (const DirectedEdge& edge : edges_of(pieces_[piece])) owners_[edge].push_back(piece);
  }

  void disown_edges(std::uint32_t piece) {
    for (const DirectedEdge& edge : edges_of(pieces_[piece])) std::erase(owners_[edge], piece);
  }

  /// The piece in the wall of this one that runs along an edge this way; there is one at most.
  std::optional<std::uint32_t> owner_in_wall(const DirectedEdge& edge, std::uint32_t piece) const {
    const auto owners = owners_.find(edge);
    if (owners == owners_.end()) return std::nullopt;
    const auto found = std::ranges::find_if(owners->second, [&](std::uint32_t o) { return are_one_wall(piece, o); });
    return found == owners->second.end() ? std::nullopt : std::optional(*found);
  }

  ExactVector normal(std::uint32_t piece) const {
    const Ring& corners = planes_[piece];
    const ExactVector origin = exact(points_[corners[0]]);
    return cross(exact(points_[corners[1]]) - origin, exact(points_[corners[2]]) - origin);
  }

  bool are_one_wall(std::uint32_t a, std::uint32_t b) const {
    const auto p = [&](std::size_t k) { return points_[planes_[a][k]]; };
    return std::ranges::all_of(planes_[b],
                               [&](std::uint32_t v) { return exact_orientation(p(0), p(1), p(2), points_[v]) == 0; }) &&
           dot(normal(a), normal(b)) > 0;
  }

  /// The pieces across a piece's edges that are in its plane, each once.
  std::set<std::uint32_t> neighbours(std::uint32_t piece) const {
    std::set<std::uint32_t> found;
    if (planes_[piece].empty()) return found;
    for (const auto& [from, to] : edges_of(pieces_[piece])) {
      if (const auto other = owner_in_wall({to, from}, piece)) found.insert(*other);
    }
    return found;
  }

  /// All that hang together with a piece, itself first.
  std::vector<std::uint32_t> wall_of(std::uint32_t piece, std::vector<bool>& is_known) const {
    std::vector<std::uint32_t> wall{piece};
    is_known[piece] = true;
    for (std::size_t k = 0; k < wall.size(); ++k) {
      for (const std::uint32_t other : neighbours(wall[k])) {
        if (!is_known[other]) wall.push_back(other);
        is_known[other] = true;
      }
    }
    return wall;
  }

  void join_whole_walls() {
    std::vector<bool> is_known(pieces_.size(), false);
    for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
      if (!is_known[piece]) join(wall_of(piece, is_known));
    }
  }

  /// What a piece has become, which may have neighbours to join anew.
  std::optional<std::uint32_t> joined_with_a_neighbour(std::uint32_t piece) {
    for (const std::uint32_t other : neighbours(piece)) {
      if (join({std::min(piece, other), std::max(piece, other)})) return std::min(piece, other);
    }
    return std::nullopt;
  }

  /// Makes the pieces one, called by the first of them, if that is convex.
  bool join(const std::vector<std::uint32_t>& pieces) {
    if (pieces.size() < 2) return false;
    std::vector<const Ring*> rings;
    for (const std::uint32_t piece : pieces) rings.push_back(&pieces_[piece]);
    std::optional<Ring> boundary = common_boundary(rings);
    if (!boundary || !flat_polygon(points_, *boundary)) return false;
    for (const std::uint32_t piece : pieces) {
      disown_edges(piece);
      pieces_[piece].clear();
    }
    pieces_[pieces[0]] = std::move(*boundary);
    is_joined_[pieces[0]] = true;
    own_edges(pieces[0]);
    return true;
  }

  Ring corners_of(const Ring& ring) const {
    const ConvexPolygon polygon = ConvexPolygon::from_points(points_of(points_, ring));
    Ring corners;
    for (const std::uint32_t k : polygon.corners()) corners.push_back(ring[k]);
    return corners;
  }

  std::span<const Point3> points_;
  std::span<const Ring> facets_;
  std::vector<Ring> pieces_;  ///< of the facets' numbers; empty where joined to one before
  std::vector<Ring> planes_;  ///< three corners of each facet; none of one that is joined to none
  std::vector<bool> is_joined_;
  std::map<DirectedEdge, std::vector<std::uint32_t>> owners_;
};

}  // namespace

std::vector<Ring> joined_facets(std::span<const Point3> points, std::span<const Ring> facets) {
  return Joining(points, facets).run();
}

}  // namespace gnomon
