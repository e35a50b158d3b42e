#include "apps/proof/report/light_frame.h"

#include <span>

#include "apps/proof/report/vectors.h"

namespace gnomon::report {

LightFrame::LightFrame(const ConvexPolygon& polygon) : origin_(polygon.points()[polygon.corners()[0]]) {
  const std::span<const Point3> points = polygon.points();
  const std::span<const std::uint32_t> corners = polygon.corners();
  const Point3 first = difference(points[corners[1]], origin_);
  Point3 area;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    area = sum(area, cross(difference(points[corners[k - 1]], origin_), difference(points[corners[k]], origin_)));
  }
  u_ = scaled(1 / length(first), first);
  normal_ = scaled(1 / length(area), area);
  v_ = cross(normal_, u_);
}

double LightFrame::height(const Point3& p) const {
  return dot(difference(p, origin_), normal_);
}

Point2 LightFrame::flat(const Point3& p) const {
  const Point3 d = difference(p, origin_);
  return {dot(d, u_), dot(d, v_)};
}

Point3 LightFrame::lifted(const Point2& q) const {
  return sum(origin_, sum(scaled(q.x, u_), scaled(q.y, v_)));
}

}  // namespace gnomon::report
