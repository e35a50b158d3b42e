#include "apps/proof/report/plain_walk.h"

#include <algorithm>
#include <span>

namespace gnomon::report {
namespace {

double determinant(const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
  const double qx = q.x - p.x, qy = q.y - p.y, qz = q.z - p.z;
  const double rx = r.x - p.x, ry = r.y - p.y, rz = r.z - p.z;
  const double sx = s.x - p.x, sy = s.y - p.y, sz = s.z - p.z;
  return qx * (ry * sz - rz * sy) + qy * (rz * sx - rx * sz) + qz * (rx * sy - ry * sx);
}

/// Vertices in walking order: forwards, or backwards from vertex 0.
struct Walk {
  std::span<const Point3> points;
  bool reversed;

  std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
  std::uint32_t next(std::uint32_t k) const { return k + 1 == size() ? 0 : k + 1; }
  std::uint32_t previous(std::uint32_t k) const { return k == 0 ? size() - 1 : k - 1; }
  std::uint32_t vertex(std::uint32_t k) const { return reversed && k != 0 ? size() - k : k; }
  std::uint32_t edge(std::uint32_t k) const { return reversed ? size() - 1 - k : k; }
  const Point3& point(std::uint32_t k) const { return points[vertex(k)]; }
};

/// Calls contact(k, j) for the light vertex j touched by the plane of blocker edge k, and step(j, k) for the light edge
/// j that is passed on the way to blocker edge k.
template <class OnContact, class OnStep>
void walk(const Walk& light, const Walk& blocker, double outward, OnContact contact, OnStep step) {
  const Point3* start = &blocker.point(0);
  const Point3* end = &blocker.point(1);
  const auto gain = [&](const Point3& from, const Point3& to) { return outward * determinant(*start, *end, from, to); };
  std::uint32_t j = 0;
  for (std::uint32_t i = 1; i < light.size(); ++i) {
    if (gain(light.point(j), light.point(i)) > 0) j = i;
  }
  if (gain(light.point(j), light.point(light.previous(j))) == 0) j = light.previous(j);
  const std::uint32_t first = j;
  std::uint32_t ahead = light.next(j);
  const Point3* here = &light.point(j);
  const Point3* there = &light.point(ahead);
  const auto advance = [&] {
    j = ahead;
    ahead = light.next(ahead);
    here = there;
    there = &light.point(ahead);
  };
  for (std::uint32_t k = 0; k < blocker.size(); ++k) {
    double gained = gain(*here, *there);
    while (gained > 0) {
      step(j, k);
      advance();
      gained = gain(*here, *there);
    }
    contact(k, gained == 0 ? std::min(light.vertex(j), light.vertex(ahead)) : light.vertex(j));
    if (gained == 0) advance();
    start = end;
    end = &blocker.point(blocker.next(blocker.next(k)));
  }
  for (; j != first; j = light.next(j)) step(j, 0);
}

}  // namespace

ExtremalPlanes plain_extremal_planes(const AreaLight& light, const ConvexPolygon& blocker) {
  const std::span<const Point3> l = light.polygon.points();
  const std::span<const Point3> b = blocker.points();
  const Walk lights{l, determinant(l[0], l[1], l[2], b[0]) > 0};
  const Walk blockers{b, determinant(b[0], b[1], b[2], l[0]) < 0};
  ExtremalPlanes planes;
  planes.separating_blocker.resize(b.size());
  planes.supporting_blocker.resize(b.size());
  planes.separating_light.reserve(l.size());
  const auto fill = [&](std::vector<BlockerPlane>& into) {
    return [&](std::uint32_t k, std::uint32_t vertex) {
      const std::uint32_t edge = blockers.edge(k);
      into[edge] = {BlockerEdge{edge}, LightVertex{vertex}};
    };
  };
  const auto pass = [&](std::uint32_t j, std::uint32_t k) {
    planes.separating_light.push_back({LightEdge{lights.edge(j)}, BlockerVertex{blockers.vertex(k)}});
  };
  walk(lights, blockers, -1, fill(planes.separating_blocker), pass);
  walk(lights, blockers, +1, fill(planes.supporting_blocker), [](std::uint32_t, std::uint32_t) {});
  // Passed in cyclic order, wanted from the lowest on.
  std::vector<LightPlane>& sides = planes.separating_light;
  if (lights.reversed) std::reverse(sides.begin(), sides.end());
  const auto lower = [](const LightPlane& a, const LightPlane& c) { return a.edge < c.edge; };
  std::rotate(sides.begin(), std::min_element(sides.begin(), sides.end(), lower), sides.end());
  return planes;
}

}  // namespace gnomon::report
