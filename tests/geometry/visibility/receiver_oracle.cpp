#include "tests/geometry/visibility/receiver_oracle.h"

#include <algorithm>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::test_support {
namespace {

using laws::ExactPlane;
using laws::ExactVector;
using laws::VisibilityCase;
using laws::Walls;
using Polygon = std::vector<ExactVector>;

ExactPlane plane_of(const ReceiverPoint& receiver) {
  if (const auto* facet = std::get_if<FacetFront>(&receiver.front)) {
    return laws::plane_through(laws::exact(facet->corners[0]), laws::exact(facet->corners[1]),
                               laws::exact(facet->corners[2]));
  }
  const ExactVector n = laws::exact(std::get<FacingNormal>(receiver.front).normal);
  return {n, laws::dot(n, laws::exact(receiver.point))};
}

/// What of the light lies before the plane: a polygon, or a segment of two ends; empty if that has no extent.
Polygon part_before(const Polygon& shape, const ExactPlane& plane) {
  Polygon kept;
  bool any = false;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const ExactVector& a = shape[k];
    const ExactVector& b = shape[(k + 1) % shape.size()];
    const Rational at_a = plane.height(a), at_b = plane.height(b);
    any = any || at_a > 0;
    if (at_a >= 0) kept.push_back(a);
    if (shape.size() == 2 && k == 1) break;
    if (laws::sign(at_a) * laws::sign(at_b) < 0) kept.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return any ? kept : Polygon{};
}

ExactVector doubled_area(const Polygon& polygon) {
  ExactVector sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum = sum + laws::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return sum;
}

/// Blockers that have something before the plane.
std::vector<Walls> walls_before(const VisibilityCase& drawn, const ExactPlane& plane) {
  std::vector<Walls> result;
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const auto points = std::visit([](const auto& shape) { return shape.points(); }, blocker);
    const bool reaches = std::ranges::any_of(points, [&](const Point3& p) { return plane.side(laws::exact(p)) > 0; });
    if (reaches) result.push_back(laws::walls(blocker));
  }
  return result;
}

/// The part of L+ that is visible from the moved point, and L+ itself, as shares of the light.
struct Shares {
  std::vector<Rational> visible;
  std::vector<Rational> before;
};

struct SharesOf {
  const std::vector<Walls>& blockers;
  const ExactPlane& plane;
  const ExactVector& p;      ///< as it is
  const ExactVector& moved;  ///< a little to the front

  Shares operator()(const PointLight& light) const {
    const ExactVector l = laws::exact(light.position);
    if (plane.side(l) <= 0) return {{0}, {0}};
    const bool hidden = std::ranges::any_of(blockers, [&](const Walls& b) { return laws::is_blocked(b, moved, l); });
    return {{hidden ? 0 : 1}, {1}};
  }
  Shares operator()(const DirectionalLight& light) const {
    const ExactVector towards = Rational(-1) * laws::exact(light.direction);
    if (laws::dot(plane.normal, towards) <= 0) return {{0}, {0}};
    const bool hidden =
        std::ranges::any_of(blockers, [&](const Walls& b) { return laws::is_blocked_towards(b, moved, towards); });
    return {{hidden ? 0 : 1}, {1}};
  }
  Shares operator()(const LinearLight& light) const {
    const Polygon whole = {laws::exact(light.start), laws::exact(light.end)};
    const Polygon before = part_before(whole, plane);
    if (before.empty() || before[0] == before[1]) return {{0}, {0}};
    const ExactVector along = whole[1] - whole[0];
    const Rational share = laws::dot(before[1] - before[0], along) / laws::dot(along, along);
    return {{Rational(share * laws::visible_length_share(before[0], before[1], blockers, moved))}, {share}};
  }
  Shares operator()(const AreaLight& light) const {
    Shares shares;
    const auto facets = laws::light_facets(light.polygon);
    for (const Polygon& facet : facets) {
      const int side = laws::plane_of(facet).side(p);
      const bool is_shown = light.two_sided ? side != 0 : side > 0;
      const Polygon before = is_shown || facets.size() == 1 ? part_before(facet, plane) : Polygon{};
      const ExactVector whole = doubled_area(facet);
      shares.before.push_back(0);
      shares.visible.push_back(0);
      if (before.size() < 3) continue;
      shares.before.back() = laws::dot(doubled_area(before), whole) / laws::dot(whole, whole);
      if (shares.before.back() == 0 || !is_shown) continue;
      shares.visible.back() = shares.before.back() * laws::visible_area_share(before, blockers, moved);
    }
    return shares;
  }
};

}  // namespace

ExpectedReceived expected_received(const VisibilityCase& drawn, const ReceiverPoint& receiver) {
  const ExactPlane plane = plane_of(receiver);
  const Rational least(1, boost::multiprecision::mpz_int(1) << 1500);
  const Rational step(1, boost::multiprecision::mpz_int(1) << 4000);
  const ExactVector p = laws::exact(receiver.point);
  const ExactVector moved = p + step * plane.normal;
  const std::vector<Walls> blockers = walls_before(drawn, plane);
  const Shares shares = std::visit(SharesOf{blockers, plane, p, moved}, drawn.light);
  ExpectedReceived result{Region::lit, shares.visible[0], shares.before[0]};
  const auto none = [&](const std::vector<Rational>& list) {
    return std::ranges::all_of(list, [&](const Rational& share) { return share < least; });
  };
  bool all = true;
  for (std::size_t k = 0; k < shares.visible.size(); ++k) {
    all = all && shares.before[k] - shares.visible[k] < least;
  }
  const bool is_unlit = laws::is_unlit(drawn.light, p) || none(shares.before);
  result.region = is_unlit               ? Region::unlit
                  : none(shares.visible) ? Region::umbra
                  : all                  ? Region::lit
                                         : Region::penumbra;
  if (is_unlit) result.fraction = 0;
  return result;
}

ReceiverPoint draw_receiver(const VisibilityCase& drawn) {
  using laws::draw;
  std::vector<Point3> points = {drawn.point};
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const auto more = std::visit([](const auto& shape) { return shape.points(); }, blocker);
    points.insert(points.end(), more.begin(), more.end());
  }
  const auto vertex = [&] { return points[std::size_t(draw(0, int(points.size()) - 1))]; };
  const auto difference = [](const Point3& a, const Point3& b) { return Point3{a.x - b.x, a.y - b.y, a.z - b.z}; };
  const Point3 a = vertex(), b = vertex(), c = vertex();
  const Point3 u = difference(b, a), v = difference(c, a);
  const Point3 across{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const int kind = draw(0, 5);
  if (kind == 5) {
    const ExactVector exact_across = laws::plane_through(laws::exact(a), laws::exact(b), laws::exact(c)).normal;
    if (!laws::is_zero(exact_across)) return {drawn.point, FacetFront{{a, b, c}}};
  }
  Point3 normal = kind >= 3 ? across : kind == 2 ? u : laws::draw_vector(3);
  if (normal == Point3{}) normal = {0, 0, 1};
  return {drawn.point, FacingNormal{normal}};
}

}  // namespace gnomon::test_support
