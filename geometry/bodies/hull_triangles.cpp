#include "geometry/bodies/hull_triangles.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/orientation.h"

namespace gnomon {
namespace {

using FaceId = std::uint32_t;
constexpr FaceId no_face = std::numeric_limits<FaceId>::max();

struct HullFace {
  HullTriangle corners;
  std::array<FaceId, 3> neighbours;  ///< across the edge from corner i to corner i + 1
  std::vector<std::uint32_t> above;  ///< points to come that wait here: each strictly outside of this face
  bool dead = false;
};

/// An edge between a face that a point sees and one that it does not see.
struct HorizonEdge {
  std::uint32_t from;
  std::uint32_t to;
  FaceId beyond;  ///< the face that is not seen
};

/// The numbers below n in an order that looks like chance and is the same everywhere.
std::vector<std::uint32_t> scattered(std::size_t n) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::uint64_t state = 1;
  for (std::size_t i = n; i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[i - 1], order[(state >> 33) % i]);
  }
  return order;
}

/// Adds one point after another. A face is replaced only if the new point lies strictly outside of its plane, so a new
/// triangle never has its corners on one line: its old edge bounds a face that went, whose plane misses the point.
class GrowingHull {
 public:
  explicit GrowingHull(std::span<const Point3> points)
      : points_(points), order_(scattered(points.size())), face_at_(points.size(), no_face) {
    filter_.include(points);
    filter_.close();
    waiting_at_.assign(points.size(), no_face);
  }

  std::vector<HullTriangle> triangles() {
    if (!start()) return {};
    for (const std::uint32_t p : order_) {
      if (waiting_at_[p] != no_face) add(p);
    }
    std::vector<HullTriangle> result;
    for (const HullFace& face : faces_) {
      if (!face.dead) result.push_back(face.corners);
    }
    return result;
  }

 private:
  int side(const HullTriangle& t, std::uint32_t p) const {
    return filter_(points_[t[0]], points_[t[1]], points_[t[2]], points_[p]);
  }

  bool collinear(std::uint32_t p, std::uint32_t q, std::uint32_t r) const {
    return CGAL::collinear(to_cgal(points_[p]), to_cgal(points_[q]), to_cgal(points_[r]));
  }

  /// Makes the first tetrahedron there is; false if all points are coplanar.
  bool start() {
    if (order_.size() < 4) return false;
    std::size_t third = 2;
    while (third < order_.size() && collinear(order_[0], order_[1], order_[third])) ++third;
    if (third == order_.size()) return false;
    HullTriangle base{order_[0], order_[1], order_[third]};
    std::size_t fourth = third + 1;
    // Points before the third are on a line of the base.
    while (fourth < order_.size() && side(base, order_[fourth]) == 0) ++fourth;
    if (fourth == order_.size()) return false;
    const std::uint32_t top = order_[fourth];
    if (side(base, top) > 0) std::swap(base[1], base[2]);
    const auto [a, b, c] = base;
    faces_ = {{{a, b, c}, {1, 2, 3}, {}},
              {{b, a, top}, {0, 3, 2}, {}},
              {{c, b, top}, {0, 1, 3}, {}},
              {{a, c, top}, {0, 2, 1}, {}}};
    for (const std::uint32_t p : order_) wait_at_one_of(p, 0);
    return true;
  }

  /// Lets the point wait at the first face, from that one on, that it is strictly outside of; if there is none, the
  /// point is inside for good.
  void wait_at_one_of(std::uint32_t p, FaceId first) {
    waiting_at_[p] = no_face;
    for (FaceId f = first; f < faces_.size(); ++f) {
      if (side(faces_[f].corners, p) <= 0) continue;
      waiting_at_[p] = f;
      faces_[f].above.push_back(p);
      return;
    }
  }

  /// What waited at a seen face and is still outside is strictly outside of a new face: on its way to a point of the
  /// seen face it cannot enter through an old one, for all of the old hull lies below the seen face.
  void add(std::uint32_t p) {
    const std::vector<FaceId> seen = seen_faces(p);
    const std::vector<HorizonEdge> horizon = horizon_of(seen);
    const FaceId first = static_cast<FaceId>(faces_.size());
    for (const HorizonEdge& edge : horizon) {
      face_at_[edge.from] = static_cast<FaceId>(faces_.size());
      faces_.push_back({{edge.from, edge.to, p}, {edge.beyond, no_face, no_face}, {}});
    }
    for (FaceId f = first; f < faces_.size(); ++f) link(f);
    for (const FaceId f : seen) {
      const std::vector<std::uint32_t> waiting = std::exchange(faces_[f].above, {});
      for (const std::uint32_t q : waiting) {
        if (q != p) wait_at_one_of(q, first);
      }
    }
  }

  void link(FaceId f) {
    HullFace& face = faces_[f];
    const auto [from, to, top] = face.corners;
    const FaceId next = face_at_[to];
    face.neighbours[1] = next;
    faces_[next].neighbours[2] = f;
    HullFace& beyond = faces_[face.neighbours[0]];
    for (std::size_t i = 0; i < 3; ++i) {
      if (beyond.corners[i] == to && beyond.corners[(i + 1) % 3] == from) beyond.neighbours[i] = f;
    }
  }

  /// All faces that the point is strictly outside of, marked dead.
  std::vector<FaceId> seen_faces(std::uint32_t p) {
    std::vector<FaceId> seen{waiting_at_[p]};
    faces_[seen[0]].dead = true;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (const FaceId f : faces_[seen[i]].neighbours) {
        if (faces_[f].dead || side(faces_[f].corners, p) <= 0) continue;
        faces_[f].dead = true;
        seen.push_back(f);
      }
    }
    return seen;
  }

  std::vector<HorizonEdge> horizon_of(const std::vector<FaceId>& seen) const {
    std::vector<HorizonEdge> horizon;
    for (const FaceId f : seen) {
      const HullFace& face = faces_[f];
      for (std::size_t i = 0; i < 3; ++i) {
        if (faces_[face.neighbours[i]].dead) continue;
        horizon.push_back({face.corners[i], face.corners[(i + 1) % 3], face.neighbours[i]});
      }
    }
    return horizon;
  }

  std::span<const Point3> points_;
  std::vector<std::uint32_t> order_;
  OrientationFilter filter_;
  std::vector<HullFace> faces_;
  std::vector<FaceId> face_at_;     ///< the newest face whose first corner is that point
  std::vector<FaceId> waiting_at_;  ///< of a point to come
};

}  // namespace

std::vector<HullTriangle> hull_triangles(std::span<const Point3> points) {
  return GrowingHull(points).triangles();
}

}  // namespace gnomon
