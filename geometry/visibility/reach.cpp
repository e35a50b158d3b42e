#include "geometry/visibility/reach.h"

#include <algorithm>
#include <vector>

#include "geometry/numbers/orientation.h"

namespace gnomon {
namespace {

struct Plane {
  const Point3& a;
  const Point3& b;
  const Point3& c;

  /// +1 on the side from which a, b, c run counterclockwise.
  int side(const Point3& p) const { return exact_orientation(a, b, c, p); }
};

/// True if all points lie on that side of the plane, or on it where that counts.
bool all_beyond(const Plane& plane, int side, std::span<const Point3> points, int least) {
  return std::all_of(points.begin(), points.end(), [&](const Point3& q) { return side * plane.side(q) >= least; });
}

struct MayHide {
  const Point3& p;
  std::span<const Point3> light;

  bool operator()(const ConvexPolygon& polygon) const {
    const auto corner = [&](std::size_t k) -> const Point3& {
      return polygon.points()[polygon.corners()[k == polygon.corners().size() ? 0 : k]];
    };
    const Plane plane{corner(0), corner(1), corner(2)};
    const int side = plane.side(p);
    if (side == 0) return true;
    if (all_beyond(plane, side, light, 0)) return false;
    for (std::size_t k = 0; k < polygon.corners().size(); ++k) {
      // Seen from where the polygon runs counterclockwise, its inside is on the negative side of this plane.
      if (all_beyond({p, corner(k), corner(k + 1)}, side, light, 1)) return false;
    }
    return true;
  }

  bool operator()(const ConvexSolid& solid) const {
    std::vector<int> sides;
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      const auto corner = [&](std::size_t i) -> const Point3& { return solid.points()[facet.loop[i]]; };
      const Plane plane{corner(0), corner(1), corner(2)};
      sides.push_back(plane.side(p));
      if (sides.back() > 0 && all_beyond(plane, 1, light, 0)) return false;
    }
    for (const ConvexSolid::Edge& edge : solid.edges()) {
      if (sides[edge.left] * sides[edge.right] >= 0) continue;
      // The facet in front runs counterclockwise seen from p, so its inside is on the negative side of this plane.
      const Plane plane{p, solid.points()[edge.from], solid.points()[edge.to]};
      if (all_beyond(plane, sides[edge.left], light, 1)) return false;
    }
    return true;
  }
};

}  // namespace

bool may_hide(const ConvexBlocker& blocker, const Point3& p, std::span<const Point3> light) {
  return std::visit(MayHide{p, light}, blocker);
}

}  // namespace gnomon
