#include "tests/geometry/discontinuity/triple_edges.h"

#include <algorithm>
#include <vector>

#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {
namespace {

/// More edges than that are not looked at in pairs.
constexpr std::size_t most_edges = 160;

/// An edge and the convex sets that it belongs to.
struct Line {
  ExactVector a;
  ExactVector b;
  std::vector<ShapeId> shapes;  ///< empty for an edge of the light
};

bool share_shape(const Line& p, const Line& q) {
  return std::any_of(p.shapes.begin(), p.shapes.end(),
                     [&](ShapeId s) { return std::find(q.shapes.begin(), q.shapes.end(), s) != q.shapes.end(); });
}

class CrossingTest {
 public:
  explicit CrossingTest(std::span<const ExactVector> face) : face_(face) {}

  bool may_cross(const Line& p, const Line& q) const {
    if (p.shapes.empty() && q.shapes.empty()) return false;
    return !share_shape(p, q) && !lies_beside(p, q) && !lies_beside(q, p);
  }

  /// True if q lies on one closed side of each plane through a point of the face and p.
  bool lies_beside(const Line& p, const Line& q) const {
    bool above = false, below = false;
    for (const ExactVector& e : face_) {
      const ExactVector normal = cross(p.a - e, p.b - e);
      for (const ExactVector* end : {&q.a, &q.b}) {
        const int side = dot(normal, *end - e).sign();
        above = above || side > 0;
        below = below || side < 0;
        if (above && below) return false;
      }
    }
    return true;
  }

  /// The side on which both ends of q lie of all planes through the face and p; 0 if there is none.
  int side(const Line& p, const ExactVector& q) const {
    bool above = true, below = true;
    for (const ExactVector& e : face_) {
      const int s = dot(cross(p.a - e, p.b - e), q - e).sign();
      above = above && s >= 0;
      below = below && s <= 0;
    }
    return above == below ? 0 : above ? 1 : -1;
  }

 private:
  std::span<const ExactVector> face_;
};

ExactVector place(const EventPoint& p) {
  return p.exact ? affine(*p.exact) : exact(p.input);
}

std::vector<Line> light_lines(const EventScene& scene) {
  std::vector<Line> lines;
  for (const LightEdge& e : scene.light_edges) {
    lines.push_back({exact(scene.points[e.a].input), exact(scene.points[e.b].input), {}});
  }
  return lines;
}

/// True if the edge is beside the light, seen from every point of the face.
bool is_beside_light(const CrossingTest& test, const std::vector<Line>& light, const Line& edge) {
  for (std::size_t k = 0; k < light.size(); ++k) {
    const ExactVector& other = light[(k + 1) % light.size()].b;
    const int inside = test.side(light[k], other);
    if (inside == 0 || light.size() < 3) continue;
    if (test.side(light[k], edge.a) == -inside && test.side(light[k], edge.b) == -inside) return true;
  }
  return false;
}

}  // namespace

bool may_have_triple_edges(const EventScene& scene, std::span<const ShapeId> shapes,
                           std::span<const ExactVector> face) {
  const CrossingTest test(face);
  const std::vector<Line> light = light_lines(scene);
  std::vector<Line> lines = light;
  for (const LightEdge& e : scene.cut_edges) {
    lines.push_back({place(scene.points[e.a]), place(scene.points[e.b]), {}});
  }
  std::vector<EdgeId> ids;
  for (const ShapeId s : shapes) {
    for (const ShapeEdge& e : scene.shapes[s].edges) {
      if (scene.edges[e.edge].may_be_seen) ids.push_back(e.edge);
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const EdgeId id : ids) {
    const BlockerEdge& edge = scene.edges[id];
    Line line{exact(scene.points[edge.a].input), exact(scene.points[edge.b].input), {}};
    for (const FaceAtEdge& f : edge.faces) line.shapes.push_back(f.shape);
    if (!is_beside_light(test, light, line)) lines.push_back(std::move(line));
    if (lines.size() > most_edges) return true;
  }
  const std::size_t n = lines.size();
  std::vector<std::vector<std::size_t>> crossed(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (test.may_cross(lines[i], lines[j])) crossed[i].push_back(j);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t j : crossed[i]) {
      for (const std::size_t k : crossed[j]) {
        if (std::find(crossed[i].begin(), crossed[i].end(), k) != crossed[i].end()) return true;
      }
    }
  }
  return false;
}

}  // namespace gnomon::event
