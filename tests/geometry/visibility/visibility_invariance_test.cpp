#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/visibility_cases.h"
#include "gnomon/visibility.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::draw;
using laws::LightKind;
using laws::VisibilityCase;
using Points = std::vector<Point3>;

const laws::VisibilityMix everything = {
    {LightKind::point, LightKind::direction, LightKind::segment, LightKind::polygon, LightKind::rounded_polygon},
    {BlockerKind::polygon, BlockerKind::solid, BlockerKind::rounded_polygon},
    3};

Visibility seen(const VisibilityCase& drawn) {
  return exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
}

VisibilityCase draw_case() {
  const Domain domain = laws::once_in(2) ? Domain::near_degenerate : Domain::random;
  return *laws::visibility_cases(domain, everything);
}

/// The same vertices in the same order, each moved.
template <class Map>
ConvexBlocker mapped(const ConvexBlocker& blocker, Map map) {
  return std::visit(
      [&](const auto& shape) -> ConvexBlocker {
        Points points(shape.points().begin(), shape.points().end());
        std::ranges::transform(points, points.begin(), map);
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, ConvexSolid>)
          return ConvexSolid::hull_of(points);
        else
          return ConvexPolygon::from_points(points);
      },
      blocker);
}

struct Winding {
  enum Kind { kept, reversed };
};

/// `move` acts on places, `turn` on directions. A mirror image of an area light is wound the other way, around the
/// same first vertex.
template <class Move, class Turn>
VisibilityCase mapped(const VisibilityCase& drawn, Move move, Turn turn, Winding::Kind winding) {
  VisibilityCase result = drawn;
  result.point = move(drawn.point);
  for (ConvexBlocker& blocker : result.blockers) blocker = mapped(blocker, move);
  if (auto* point = std::get_if<PointLight>(&result.light)) point->position = move(point->position);
  if (auto* sun = std::get_if<DirectionalLight>(&result.light)) sun->direction = turn(sun->direction);
  if (auto* line = std::get_if<LinearLight>(&result.light)) *line = {move(line->start), move(line->end)};
  if (auto* area = std::get_if<AreaLight>(&result.light)) {
    Points points(area->polygon.points().begin(), area->polygon.points().end());
    std::ranges::transform(points, points.begin(), move);
    if (winding == Winding::reversed) std::reverse(points.begin() + 1, points.end());
    area->polygon = ConvexPolygon::from_points(points);
  }
  return result;
}

RC_GTEST_PROP(VisibilityInvariance, ScalingByAPowerOfTwoChangesNothing, ()) {
  const VisibilityCase drawn = draw_case();
  const double s = std::ldexp(1.0, draw(-200, 200));
  const auto scaled = [s](const Point3& p) { return Point3{s * p.x, s * p.y, s * p.z}; };
  RC_ASSERT(seen(mapped(drawn, scaled, scaled, Winding::kept)) == seen(drawn));
}

RC_GTEST_PROP(VisibilityInvariance, AnExactTranslationChangesNothing, ()) {
  const VisibilityCase drawn = *laws::visibility_cases(Domain::random, everything);
  const double s = std::ldexp(1.0, draw(0, 8));
  const Point3 step{s * draw(-3, 3), s * draw(-3, 3), s * draw(-3, 3)};
  bool exact = true;
  const auto translated = [&](const Point3& p) {
    const Point3 q{p.x + step.x, p.y + step.y, p.z + step.z};
    exact = exact && q.x - step.x == p.x && q.y - step.y == p.y && q.z - step.z == p.z;
    return q;
  };
  const auto same = [](const Point3& p) { return p; };
  const VisibilityCase moved = mapped(drawn, translated, same, Winding::kept);
  RC_PRE(exact);
  RC_ASSERT(seen(moved) == seen(drawn));
}

RC_GTEST_PROP(VisibilityInvariance, AMirrorImageSeesTheSame, ()) {
  const VisibilityCase drawn = draw_case();
  const int axis = draw(0, 2);
  const auto mirrored = [axis](Point3 p) {
    (axis == 0 ? p.x : axis == 1 ? p.y : p.z) *= -1;
    return p;
  };
  RC_ASSERT(seen(mapped(drawn, mirrored, mirrored, Winding::reversed)) == seen(drawn));
}

RC_GTEST_PROP(VisibilityInvariance, TheStartAndSenseOfABlockersVerticesAndOfAFlatLightsStartDoNotMatter, ()) {
  VisibilityCase drawn = draw_case();
  const Visibility before = seen(drawn);
  const auto rotated = [](std::span<const Point3> given) {
    Points points(given.begin(), given.end());
    std::rotate(points.begin(), points.begin() + draw(0, int(points.size()) - 1), points.end());
    return points;
  };
  for (ConvexBlocker& blocker : drawn.blockers) {
    if (auto* solid = std::get_if<ConvexSolid>(&blocker)) {
      *solid = ConvexSolid::hull_of(rotated(solid->points()));
    } else {
      Points points = rotated(std::get<ConvexPolygon>(blocker).points());
      if (laws::once_in(2)) std::ranges::reverse(points);
      blocker = ConvexPolygon::from_points(points);
    }
  }
  if (auto* line = std::get_if<LinearLight>(&drawn.light)) std::swap(line->start, line->end);
  auto* area = std::get_if<AreaLight>(&drawn.light);
  if (area && area->polygon.is_flat()) area->polygon = ConvexPolygon::from_points(rotated(area->polygon.points()));
  RC_ASSERT(seen(drawn) == before);
}

RC_GTEST_PROP(VisibilityInvariance, TheOrderOfBlockersAndRepeatingThemDoNotMatter, ()) {
  VisibilityCase drawn = draw_case();
  const Visibility before = seen(drawn);
  std::ranges::reverse(drawn.blockers);
  if (laws::once_in(2)) drawn.blockers.push_back(drawn.blockers.front());
  RC_ASSERT(seen(drawn) == before);
}

RC_GTEST_PROP(VisibilityInvariance, ATwoSidedLightIsAsVisibleAsItsOneSideIfThatIsTurnedToThePoint, ()) {
  VisibilityCase drawn = *laws::visibility_cases(Domain::random, {{LightKind::polygon}, everything.blockers, 2});
  auto& light = std::get<AreaLight>(drawn.light);
  light.two_sided = false;
  const Visibility one_sided = seen(drawn);
  light.two_sided = true;
  const Visibility two_sided = seen(drawn);
  RC_ASSERT(one_sided.region == Region::unlit || one_sided == two_sided);
}

}  // namespace
}  // namespace gnomon
