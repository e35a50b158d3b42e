#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "apps/laws/any_pair.h"
#include "apps/laws/cone.h"
#include "apps/laws/exact.h"
#include "geometry/spatial/position.h"
#include "geometry/spatial/shadow_volume.h"
#include "geometry/visibility/visibility.h"

// The volumes of pairs that stand anywhere, against what points see by the definition.

namespace gnomon::laws {

void showValue(const AnyPair& pair, std::ostream& out) {
  out << description(pair);
}

}  // namespace gnomon::laws

namespace gnomon {
namespace {

using laws::AnyPair;
using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;

bool is_extended(const Light& light) {
  return std::holds_alternative<LinearLight>(light) || std::holds_alternative<AreaLight>(light);
}

/// On the blocker's plane, where a flat blocker's volumes say nothing of single points; on a solid's surface likewise.
bool is_on_blocker(const ConvexBlocker& blocker, const Point3& p) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    const auto corner = [&](std::size_t k) { return polygon->points()[polygon->corners()[k]]; };
    return laws::plane_through(laws::exact(corner(0)), laws::exact(corner(1)), laws::exact(corner(2)))
               .side(laws::exact(p)) == 0;
  }
  const ConvexSolid& solid = std::get<ConvexSolid>(blocker);
  return std::all_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    const auto at = [&](std::size_t k) { return laws::exact(solid.points()[facet.loop[k]]); };
    return laws::plane_through(at(0), at(1), at(2)).side(laws::exact(p)) <= 0;
  });
}

/// What the volumes say of a point, or nothing where they leave it open.
std::optional<Region> expected_region(const AnyPair& pair, const ShadowVolumes& volumes, const Point3& p) {
  const Side occlusion = volumes.occlusion.oriented_side(p);
  const Side umbra = volumes.umbra.oriented_side(p);
  if (!is_extended(pair.light)) {
    return occlusion == Side::outside ? Region::lit : Region::umbra;  // closed: a grazing contact blocks
  }
  const auto* area = std::get_if<AreaLight>(&pair.light);
  if (area && !area->polygon.is_flat()) {  // its fraction is that of triangles inside its hull
    if (occlusion == Side::outside) return Region::lit;
    return umbra == Side::inside ? std::optional(Region::umbra) : std::nullopt;
  }
  // A grazing contact hides nothing of an area light. Of a linear light it may, along a plane that holds all of it.
  const bool is_area = area != nullptr;
  if (occlusion == Side::outside || (is_area && occlusion == Side::boundary && umbra == Side::outside)) {
    return Region::lit;
  }
  if (umbra == Side::inside || (is_area && umbra == Side::boundary && occlusion == Side::inside)) return Region::umbra;
  if (occlusion == Side::inside && umbra == Side::outside) return Region::penumbra;
  return std::nullopt;
}

void check_regions(Domain domain, LightKind light, BlockerKind blocker) {
  const AnyPair pair = *rc::gen::exec([=] { return laws::draw_any_pair(domain, light, blocker, 4); });
  const ShadowVolumes volumes = shadow_volumes(pair.light, pair.blocker);
  if (light != LightKind::direction) RC_TAG(std::string(name(pair_position(pair.light, pair.blocker))));
  const Obstacles obstacles{{pair.blocker}, {}};
  for (const Point3& p : pair.points) {
    if (is_on_blocker(pair.blocker, p)) continue;
    const Region seen = exact_visibility(pair.light, obstacles, p).region;
    if (seen == Region::unlit) continue;
    const std::optional<Region> expected = expected_region(pair, volumes, p);
    if (!expected) continue;
    RC_LOG() << "point " << p.x << ' ' << p.y << ' ' << p.z << ": volumes say " << name(*expected)
             << ", the definition says " << name(seen) << '\n';
    RC_ASSERT(*expected == seen);
  }
}

struct Kinds {
  LightKind light;
  BlockerKind blocker;
  const char* name;
};

class AnyPositionAgreement : public testing::TestWithParam<Kinds> {};

TEST_P(AnyPositionAgreement, VolumesSayOfEveryPointWhatTheDefinitionSays) {
  const Kinds kinds = GetParam();
  EXPECT_TRUE(rc::check("random", [=] { check_regions(Domain::random, kinds.light, kinds.blocker); }));
  EXPECT_TRUE(
      rc::check("nearly degenerate", [=] { check_regions(Domain::near_degenerate, kinds.light, kinds.blocker); }));
}

constexpr Kinds all_kinds[] = {
    {LightKind::point, BlockerKind::flat_polygon, "PointFlat"},
    {LightKind::point, BlockerKind::solid, "PointSolid"},
    {LightKind::point, BlockerKind::rounded_polygon, "PointRounded"},
    {LightKind::direction, BlockerKind::flat_polygon, "DirectionFlat"},
    {LightKind::direction, BlockerKind::solid, "DirectionSolid"},
    {LightKind::direction, BlockerKind::rounded_polygon, "DirectionRounded"},
    {LightKind::segment, BlockerKind::flat_polygon, "SegmentFlat"},
    {LightKind::segment, BlockerKind::solid, "SegmentSolid"},
    {LightKind::segment, BlockerKind::rounded_polygon, "SegmentRounded"},
    {LightKind::one_sided_polygon, BlockerKind::flat_polygon, "PolygonFlat"},
    {LightKind::one_sided_polygon, BlockerKind::solid, "PolygonSolid"},
    {LightKind::one_sided_polygon, BlockerKind::rounded_polygon, "PolygonRounded"},
    {LightKind::two_sided_polygon, BlockerKind::flat_polygon, "TwoSidedFlat"},
    {LightKind::two_sided_polygon, BlockerKind::solid, "TwoSidedSolid"},
    {LightKind::two_sided_polygon, BlockerKind::rounded_polygon, "TwoSidedRounded"},
    {LightKind::rounded_polygon, BlockerKind::flat_polygon, "RoundedFlat"},
    {LightKind::rounded_polygon, BlockerKind::solid, "RoundedSolid"},
    {LightKind::rounded_polygon, BlockerKind::rounded_polygon, "RoundedRounded"},
};

INSTANTIATE_TEST_SUITE_P(Kinds, AnyPositionAgreement, testing::ValuesIn(all_kinds),
                         [](const auto& kinds) { return std::string(kinds.param.name); });

}  // namespace
}  // namespace gnomon
