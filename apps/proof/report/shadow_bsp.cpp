#include "apps/proof/report/shadow_bsp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/vector3.h"

namespace gnomon::report {
namespace {

using BspPoint = Vector3<double>;
constexpr double bsp_tolerance = 1e-9;

struct BspPlane {
  BspPoint normal;  ///< of unit length, outward
  double offset = 0;

  double height(const BspPoint& p) const { return dot(normal, p) - offset; }
};

/// A part of a side of the volume that is put in.
struct BspSide {
  std::vector<BspPoint> corners;
  std::int32_t facet = -1;  ///< -1: of no plane of its own
};

using BspPiece = std::vector<BspSide>;

/// The part below a plane (sign 1) or above it (-1).
std::vector<BspPoint> part_of(const std::vector<BspPoint>& corners, const BspPlane& plane, double sign) {
  std::vector<BspPoint> part;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const BspPoint &p = corners[k], &q = corners[(k + 1) % corners.size()];
    const double at_p = sign * plane.height(p), at_q = sign * plane.height(q);
    if (at_p <= bsp_tolerance) part.push_back(p);
    if ((at_p < -bsp_tolerance && at_q > bsp_tolerance) || (at_p > bsp_tolerance && at_q < -bsp_tolerance)) {
      part.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
  }
  return part;
}

/// The part of a piece below a plane or above it; empty if it has no inside.
BspPiece part_of(const BspPiece& piece, const BspPlane& plane, double sign) {
  BspPiece part;
  bool any_inside = false;
  for (const BspSide& side : piece) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const BspPoint& p : side.corners) {
      least = std::min(least, sign * plane.height(p));
      most = std::max(most, sign * plane.height(p));
    }
    any_inside = any_inside || least < -bsp_tolerance;
    if (least >= -bsp_tolerance) continue;
    part.push_back(most <= bsp_tolerance ? side : BspSide{part_of(side.corners, plane, sign), side.facet});
  }
  return any_inside ? part : BspPiece{};
}

}  // namespace

class ShadowBsp::Work {
 public:
  struct Node {
    BspPlane plane = {};
    std::size_t below = 0, above = 0;  ///< 0: a leaf
    bool is_in = false;                ///< of a leaf
  };

  void add(const VolumeMesh& volume) {
    std::vector<BspPlane> planes;
    const BspPiece piece = piece_of(volume, planes);
    if (!piece.empty()) insert(0, piece, planes);
  }

  std::size_t height(std::size_t node) const {
    const Node& n = nodes[node];
    return n.below == 0 ? 1 : 1 + std::max(height(n.below), height(n.above));
  }

  std::vector<Node> nodes = {{}};

 private:
  /// Triangles as they are; a facet's plane is that of its largest.
  static BspPiece piece_of(const VolumeMesh& volume, std::vector<BspPlane>& planes) {
    planes.resize(volume.facets.size());
    std::vector<double> largest(volume.facets.size(), 0);
    BspPiece piece;
    for (const MeshTriangle& triangle : volume.triangles) {
      std::vector<BspPoint> corners;
      for (const std::uint32_t v : triangle.vertices) {
        corners.push_back({volume.vertices[v].x, volume.vertices[v].y, volume.vertices[v].z});
      }
      const BspPoint normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
      const double size = std::sqrt(dot(normal, normal));
      if (size > largest[triangle.facet]) {
        largest[triangle.facet] = size;
        const BspPoint unit = (1 / size) * normal;
        planes[triangle.facet] = {unit, dot(unit, corners[0])};
      }
      const bool is_own = volume.facets[triangle.facet].kind != FacetKind::clip_box;
      piece.push_back({std::move(corners), is_own ? static_cast<std::int32_t>(triangle.facet) : -1});
    }
    return piece;
  }

  void insert(std::size_t node, const BspPiece& piece, const std::vector<BspPlane>& planes) {
    if (nodes[node].below != 0) {
      const Node n = nodes[node];
      if (const BspPiece below = part_of(piece, n.plane, 1); !below.empty()) insert(n.below, below, planes);
      if (const BspPiece above = part_of(piece, n.plane, -1); !above.empty()) insert(n.above, above, planes);
      return;
    }
    if (nodes[node].is_in) return;
    std::vector<std::int32_t> facets;
    for (const BspSide& side : piece) {
      if (side.facet >= 0 && std::ranges::count(facets, side.facet) == 0) facets.push_back(side.facet);
    }
    for (const std::int32_t facet : facets) {
      const std::size_t below = nodes.size();
      nodes[node] = {planes[static_cast<std::size_t>(facet)], below, below + 1};
      nodes.insert(nodes.end(), 2, Node{});
      node = below;
    }
    nodes[node].is_in = true;
  }
};

ShadowBsp::ShadowBsp() : work_(std::make_unique<Work>()) {}
ShadowBsp::~ShadowBsp() = default;

void ShadowBsp::add(const VolumeMesh& volume) {
  work_->add(volume);
}

std::size_t ShadowBsp::nodes() const {
  return work_->nodes.size();
}

std::size_t ShadowBsp::height() const {
  return work_->height(0);
}

std::size_t ShadowBsp::path(const Point3& p) const {
  std::size_t node = 0, count = 0;
  while (work_->nodes[node].below != 0) {
    const Work::Node& n = work_->nodes[node];
    node = n.plane.height({p.x, p.y, p.z}) <= 0 ? n.below : n.above;
    ++count;
  }
  return count;
}

}  // namespace gnomon::report
