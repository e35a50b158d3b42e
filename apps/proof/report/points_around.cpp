#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/hard_cases.h"
#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

using Corners = std::vector<Point3>;

std::vector<Point3> corners_of(const ConvexBlocker& blocker) {
  const auto chosen = [](const auto& shape) {
    Corners corners;
    for (const std::uint32_t i : shape.corners()) corners.push_back(shape.points()[i]);
    return corners;
  };
  return std::visit(chosen, blocker);
}

class PointDraws {
 public:
  explicit PointDraws(const HardCase& hard) : draws_(seed(hard.name)), focus_(hard.focus) {
    for (const std::uint32_t i : hard.light.polygon.corners()) light_.push_back(hard.light.polygon.points()[i]);
    for (const ConvexBlocker& blocker : hard.blockers) blockers_.push_back(corners_of(blocker));
  }

  /// The focus, or a point behind something of a blocker as seen from something of the light; moved a little or not at
  /// all.
  Point3 point() {
    if (draws_.below(3) == 0) return moved(focus_, length(difference(focus_, light_[0])));
    const Corners& blocker = blockers_[draws_.below(blockers_.size())];
    const std::size_t kind = draws_.below(3);
    const Point3 l = kind == 1 ? on_edge(light_) : corner(light_);
    const Point3 b = kind == 0 ? corner(blocker) : kind == 1 ? corner(blocker) : on_edge(blocker);
    const double shares[] = {1, 2, 0.5, draws_.between(0, 4)};
    const Point3 p = sum(b, scaled(shares[draws_.below(4)], difference(b, l)));
    return moved(p, length(difference(b, l)));
  }

 private:
  static std::size_t seed(const std::string& name) {
    std::uint32_t hash = 2166136261U;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
  }

  Point3 corner(const Corners& corners) { return corners[draws_.below(corners.size())]; }

  Point3 on_edge(const Corners& corners) {
    const std::size_t k = draws_.below(corners.size());
    return between(corners[k], corners[(k + 1) % corners.size()], draws_.between(0, 1));
  }

  Point3 moved(Point3 p, double size) {
    const std::size_t kind = draws_.below(3);
    const double way = size * std::pow(10.0, draws_.between(-16, -1));
    for (double* coordinate : {&p.x, &p.y, &p.z}) {
      if (kind == 1) *coordinate = some_ulps_beside(*coordinate);
      if (kind == 2) *coordinate += draws_.between(-1, 1) * way;
    }
    return p;
  }

  double some_ulps_beside(double value) {
    const std::size_t ulps = draws_.below(5);
    const double towards = (draws_.below(2) == 0 ? 1 : -1) * std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < ulps; ++i) value = std::nextafter(value, towards);
    return value;
  }

  Draws draws_;
  Point3 focus_;
  Corners light_;
  std::vector<Corners> blockers_;
};

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

std::vector<Point3> points_around(const HardCase& hard, std::size_t count) {
  PointDraws draws(hard);
  std::vector<Point3> points = {hard.focus};
  while (points.size() < count) {
    const Point3 p = draws.point();
    if (is_finite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace gnomon::report
