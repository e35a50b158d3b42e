#include "shading/illumination/standing_between.h"

#include <algorithm>
#include <array>
#include <variant>

#include "geometry/numbers/orientation.h"

namespace gnomon::illumination {
namespace {

using Triangle = std::array<Point3, 3>;
using Points = std::span<const Point3>;

Points points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return Points(shape.points()); }, blocker);
}

Box3 box_around(Points points) {
  Box3 box{points[0], points[0]};
  for (const Point3& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

Box3 united(const Box3& a, const Box3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

/// Whether a box has something in common with the inside of another.
bool reaches_inside(const Box3& box, const Box3& inside) {
  const auto along = [&](double Point3::*c) { return box.min.*c < inside.max.*c && inside.min.*c < box.max.*c; };
  return along(&Point3::x) && along(&Point3::y) && along(&Point3::z);
}

/// The closed sides of a plane on which points lie.
struct Sides {
  bool is_not_before = true;
  bool is_not_behind = true;

  void add(const Triangle& plane, Points points) {
    for (const Point3& p : points) {
      const int side = exact_orientation(plane[0], plane[1], plane[2], p);
      is_not_before = is_not_before && side <= 0;
      is_not_behind = is_not_behind && side >= 0;
    }
  }
};

bool parts(const Triangle& plane, Points blocker, const Sides& polygons) {
  Sides own;
  own.add(plane, blocker);
  return (own.is_not_before && polygons.is_not_behind) || (own.is_not_behind && polygons.is_not_before);
}

/// Whether some plane of the blocker's parts it from both polygons.
bool is_parted_by_own_plane(const ConvexBlocker& blocker, Points first, Points second) {
  const Points points = points_of(blocker);
  const auto tries = [&](const Triangle& plane) {
    Sides sides;
    sides.add(plane, first);
    sides.add(plane, second);
    return parts(plane, points, sides);
  };
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    const auto corners = polygon->corners();
    return tries({points[corners[0]], points[corners[1]], points[corners[2]]});
  }
  return std::ranges::any_of(std::get<ConvexSolid>(blocker).facets(), [&](const ConvexSolid::Facet& facet) {
    return tries({points[facet.loop[0]], points[facet.loop[1]], points[facet.loop[2]]});
  });
}

/// Planes through an edge of one polygon and a vertex of the other on whose one side both lie.
void append_supporting(Points first, Points second, std::vector<std::pair<Triangle, Sides>>& planes) {
  for (std::size_t k = 0; k < first.size(); ++k) {
    for (const Point3& p : second) {
      const Triangle plane{first[k], first[(k + 1) % first.size()], p};
      Sides sides;
      sides.add(plane, first);
      sides.add(plane, second);
      if (sides.is_not_before != sides.is_not_behind) planes.emplace_back(plane, sides);
    }
  }
}

}  // namespace

StandingBetween::StandingBetween(std::span<const ConvexBlocker> blockers) : blockers_(blockers) {
  std::vector<Box3> boxes;
  for (const ConvexBlocker& blocker : blockers) boxes.push_back(box_around(points_of(blocker)));
  boxes_ = BoxHierarchy(boxes);
}

void StandingBetween::find(const ConvexPolygon& first, const ConvexPolygon& second,
                           std::vector<std::uint32_t>& found) const {
  const Points p = first.points(), q = second.points();
  const Box3 box = united(box_around(p), box_around(q));
  boxes_.search([&](const Box3& other) { return reaches_inside(other, box); }, found);
  if (found.empty()) return;
  const auto lies_behind = [&](const ConvexPolygon& polygon, Points points) {
    const auto c = polygon.corners();
    const auto at = [&](std::size_t k) { return polygon.points()[c[k]]; };
    return std::ranges::all_of(points, [&](const Point3& x) { return exact_orientation(at(0), at(1), at(2), x) <= 0; });
  };
  std::erase_if(found, [&](std::uint32_t b) {
    const Points points = points_of(blockers_[b]);
    return lies_behind(first, points) || lies_behind(second, points) || is_parted_by_own_plane(blockers_[b], p, q);
  });
  if (found.empty()) return;
  std::vector<std::pair<Triangle, Sides>> planes;
  append_supporting(p, q, planes);
  append_supporting(q, p, planes);
  std::erase_if(found, [&](std::uint32_t b) {
    const Points points = points_of(blockers_[b]);
    return std::ranges::any_of(planes, [&](const auto& plane) { return parts(plane.first, points, plane.second); });
  });
  std::ranges::sort(found);
}

}  // namespace gnomon::illumination
