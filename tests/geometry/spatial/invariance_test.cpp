#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <tuple>

#include "apps/proof/laws/any_pair.h"
#include "apps/proof/laws/draw.h"
#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/kernel.h"
#include "gnomon/pair.h"
#include "gnomon/shadow_mesh.h"
#include "tests/geometry/spatial/named_facets.h"

// What becomes of the volumes of a pair when the pair is told or placed otherwise, for every kind of light and blocker
// wherever they stand.
//
// In all cases the same: position and facts; of every half-space its kind and, mapped, the points that its edge and its
// plane go through; exact volumes, times the cube of the scale; of every facet of a mesh, mapped, its vertices and what
// it may be named after. Names are always those of lowest index, so where vertices keep their order, names, facets and
// triangles are the same one by one. Coordinates are correctly rounded, so what maps doubles exactly (powers of two,
// mirrors) maps them bit by bit; translated ones differ by their two roundings at most.

namespace gnomon {
namespace {

using laws::Domain;
using laws::draw;
using laws::PairBlockerKind;
using laws::PairLightKind;
using Kinds = laws::PairKinds;
using Points = std::vector<Point3>;
using Map = std::function<Point3(const Point3&)>;

struct Case {
  Light light;
  ConvexBlocker blocker;
  Box3 box;
};

void showValue(const Case& drawn, std::ostream& out) {
  out << laws::description({drawn.light, drawn.blocker, {drawn.box.min, drawn.box.max}});
}

/// How points and directions are carried from one case to the other, and in which order its vertices stand.
struct Image {
  Map point = [](const Point3& p) { return p; };
  Map direction = [](const Point3& d) { return d; };
  std::function<Points(Points)> order_of_light = [](Points points) { return points; };
  std::function<Points(Points)> order_of_blocker = [](Points points) { return points; };
  double volume_factor = 1;
};

Points mapped(Points points, const Map& map) {
  std::transform(points.begin(), points.end(), points.begin(), map);
  return points;
}

/// The polygon of the points if they are one, as flat as the original.
std::optional<ConvexPolygon> polygon(const Points& points, bool is_flat) {
  if (ConvexPolygon::defect(points)) return std::nullopt;
  ConvexPolygon result = ConvexPolygon::from_points(points);
  if (result.is_flat() != is_flat) return std::nullopt;
  return result;
}

std::optional<Light> image_of(const Light& light, const Image& image) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return DirectionalLight{image.direction(sun->direction)};
  const Points points = image.order_of_light(mapped(points_of(light), image.point));
  if (points.size() == 1) return PointLight{points[0]};
  if (points.size() == 2)
    return points[0] == points[1] ? std::nullopt : std::optional<Light>(LinearLight{points[0], points[1]});
  const AreaLight& area = std::get<AreaLight>(light);
  const std::optional<ConvexPolygon> of_points = polygon(points, area.polygon.is_flat());
  if (!of_points) return std::nullopt;
  return AreaLight{*of_points, area.two_sided};
}

std::optional<ConvexBlocker> image_of(const ConvexBlocker& blocker, const Image& image) {
  const Points points = image.order_of_blocker(mapped(points_of(blocker), image.point));
  if (std::holds_alternative<ConvexSolid>(blocker)) {
    if (are_coplanar(points)) return std::nullopt;
    return ConvexSolid::hull_of(points);
  }
  const std::optional<ConvexPolygon> of_points = polygon(points, true);
  if (!of_points) return std::nullopt;
  return *of_points;
}

Box3 image_of(const Box3& box, const Image& image) {
  const Point3 a = image.point(box.min);
  const Point3 b = image.point(box.max);
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

/// The image, unless it is no supported pair: rounded polygons told otherwise may be flatter, or deviate too much.
std::optional<Case> image_of(const Case& drawn, const Image& image) {
  const std::optional<Light> light = image_of(drawn.light, image);
  const std::optional<ConvexBlocker> blocker = image_of(drawn.blocker, image);
  if (!light || !blocker || !pair_refusal(*light, *blocker).empty()) return std::nullopt;
  return Case{*light, *blocker, image_of(drawn.box, image)};
}

NamedPlane mapped(NamedPlane plane, const Image& image, bool touches_direction) {
  plane.edge = mapped(plane.edge, image.point);
  plane.touching = mapped(plane.touching, touches_direction ? image.direction : image.point);
  sort_distinct(plane.edge);
  sort_distinct(plane.touching);
  return plane;
}

std::vector<NamedPlane> named_planes(const Case& drawn, const ConvexVolume& volume, const Image& image) {
  std::vector<NamedPlane> result;
  for (const HalfSpace& half_space : volume.half_spaces) {
    RC_ASSERT(names_lowest(drawn.light, drawn.blocker, half_space));
    result.push_back(mapped(named_plane(drawn.light, drawn.blocker, half_space), image, half_space.third_is_direction));
  }
  sort(result);
  return result;
}

auto all_facts(const ShadowVolumes& volumes) {
  const auto facts = [](const VolumeFacts& f) { return std::tuple(f.empty, f.bounded, f.components); };
  return std::tuple(facts(volumes.occlusion_facts), facts(volumes.umbra_facts), facts(volumes.penumbra_facts),
                    volumes.umbra_pockets, volumes.occlusion.empty, volumes.umbra.empty);
}

void check_volumes(const Case& drawn, const Case& other, const Image& image) {
  RC_ASSERT(pair_position(drawn.light, drawn.blocker) == pair_position(other.light, other.blocker));
  const ShadowVolumes before = shadow_volumes(drawn.light, drawn.blocker);
  const ShadowVolumes after = shadow_volumes(other.light, other.blocker);
  RC_ASSERT(all_facts(before) == all_facts(after));
  RC_ASSERT(named_planes(drawn, before.occlusion, image) == named_planes(other, after.occlusion, {}));
  RC_ASSERT(named_planes(drawn, before.umbra, image) == named_planes(other, after.umbra, {}));
}

/// Coordinates are carried over exactly unless they are subnormal.
bool is_image(const Point3& before, const Point3& after, const Image& image) {
  const Point3 expected = image.point(before);
  const auto same = [](double original, double a, double b) {
    return a == b || (std::abs(original) < 0x1p-1022 && std::abs(b) < 0x1p-800);
  };
  return same(before.x, expected.x, after.x) && same(before.y, expected.y, after.y) &&
         same(before.z, expected.z, after.z);
}

void check_exact_volumes(const ShadowMeshes& before, const ShadowMeshes& after, const Image& image) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational expected = Rational(image.volume_factor) * Rational(all_meshes(before)[i]->volume.exact);
    RC_ASSERT(expected == Rational(all_meshes(after)[i]->volume.exact));
  }
}

/// Names, facets and triangles one by one; `is_same` compares vertices.
template <class Same>
void check_meshes_one_by_one(const ShadowMeshes& before, const ShadowMeshes& after, Same is_same) {
  for (std::size_t i = 0; i < 4; ++i) {
    const VolumeMesh& a = *all_meshes(before)[i];
    const VolumeMesh& b = *all_meshes(after)[i];
    RC_ASSERT(a.facets == b.facets);
    RC_ASSERT(a.truncated == b.truncated);
    RC_ASSERT(a.triangles.size() == b.triangles.size());
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
      RC_ASSERT(a.triangles[t].vertices == b.triangles[t].vertices);
      RC_ASSERT(a.triangles[t].facet == b.triangles[t].facet);
    }
    RC_ASSERT(a.vertices.size() == b.vertices.size());
    for (std::size_t v = 0; v < a.vertices.size(); ++v) RC_ASSERT(is_same(a.vertices[v], b.vertices[v]));
  }
}

std::vector<NamedFacet> facets_of(const Case& drawn, const ShadowMeshes& meshes, std::size_t which,
                                  const Image& image) {
  std::vector<NamedFacet> facets = named_facets(drawn.light, drawn.blocker, meshes, which);
  const bool has_direction = std::holds_alternative<DirectionalLight>(drawn.light);
  for (NamedFacet& facet : facets) {
    for (NamedPlane& plane : facet.planes) plane = mapped(plane, image, has_direction && !plane.edge.empty());
    sort(facet.planes);
    facet.vertices = mapped(facet.vertices, image.point);
    sort_distinct(facet.vertices);
  }
  sort(facets);
  return facets;
}

void check_facets(const Case& drawn, const ShadowMeshes& before, const Case& other, const ShadowMeshes& after,
                  const Image& image) {
  for (std::size_t i = 0; i < 4; ++i) {
    RC_ASSERT(facets_of(drawn, before, i, image) == facets_of(other, after, i, {}));
  }
}

ShadowMeshes meshes_of(const Case& drawn) {
  return shadow_meshes(drawn.light, drawn.blocker, drawn.box, {.penumbra = true, .cells = false, .planes = false});
}

/// A pair and a box about its blocker, whose sides may go through vertices.
Case draw_case(Domain domain, const Kinds& kinds) {
  return *rc::gen::exec([=] {
    const laws::AnyPair pair = laws::draw_any_pair(domain, kinds.light, kinds.blocker, 0);
    const Points points = points_of(pair.blocker);
    const auto range = [&](double Point3::*coordinate) {
      const double a = points[0].*coordinate - draw(1, 9);
      const double b = points[1].*coordinate + draw(1, 9);
      return std::pair(std::min(a, b), a == b ? std::nextafter(a, HUGE_VAL) : std::max(a, b));
    };
    const auto [x, X] = range(&Point3::x);
    const auto [y, Y] = range(&Point3::y);
    const auto [z, Z] = range(&Point3::z);
    return Case{pair.light, pair.blocker, {{x, y, z}, {X, Y, Z}}};
  });
}

Case draw_case(const Kinds& kinds) {
  const Domain domain = *rc::gen::element(Domain::random, Domain::near_degenerate);
  return draw_case(domain, kinds);
}

class SpatialInvariance : public testing::TestWithParam<Kinds> {};

void check_scaling(const Kinds& kinds) {
  const Case drawn = draw_case(kinds);
  const double s = std::ldexp(1.0, draw(0, 60));
  Image image;
  image.point = image.direction = [s](const Point3& p) { return Point3{s * p.x, s * p.y, s * p.z}; };
  image.volume_factor = s * s * s;
  const std::optional<Case> other = image_of(drawn, image);
  RC_ASSERT(other.has_value());
  check_volumes(drawn, *other, image);
  const ShadowMeshes before = meshes_of(drawn);
  const ShadowMeshes after = meshes_of(*other);
  check_exact_volumes(before, after, image);
  check_meshes_one_by_one(before, after, [&](const Point3& p, const Point3& q) { return is_image(p, q, image); });
}

TEST_P(SpatialInvariance, ScalingByAPowerOfTwoScalesCoordinatesBitByBitAndVolumesExactly) {
  EXPECT_TRUE(rc::check([] { check_scaling(GetParam()); }));
}

/// The distance of two numbers is at most half a unit in the last place of each.
bool is_translated(double before, double step, double after) {
  const auto half_unit = [](double x) {
    const double size = std::abs(x);
    return Rational(std::nextafter(size, HUGE_VAL) - size) / 2;
  };
  const Rational distance = Rational(after) - Rational(before) - Rational(step);
  const Rational allowed = half_unit(before) + half_unit(after);
  return -allowed <= distance && distance <= allowed;
}

/// The pair is first moved to where it can be brought back from exactly.
void check_translation(const Kinds& kinds) {
  const Case drawn = draw_case(kinds);
  const double s = std::ldexp(1.0, draw(0, 8));
  const Point3 step{s * draw(-3, 3), s * draw(-3, 3), s * draw(-3, 3)};
  Image there;
  there.point = [=](const Point3& p) { return Point3{p.x + step.x, p.y + step.y, p.z + step.z}; };
  Image back;
  back.point = [=](const Point3& p) { return Point3{p.x - step.x, p.y - step.y, p.z - step.z}; };
  const std::optional<Case> moved = image_of(drawn, there);
  const std::optional<Case> home = moved ? image_of(*moved, back) : std::nullopt;
  const std::optional<Case> again = home ? image_of(*home, there) : std::nullopt;
  const bool is_exact = again && points_of(again->light) == points_of(moved->light) &&
                        points_of(again->blocker) == points_of(moved->blocker) && again->box == moved->box &&
                        home->box.min.x < home->box.max.x && home->box.min.y < home->box.max.y &&
                        home->box.min.z < home->box.max.z;
  RC_TAG(is_exact ? "exact" : "not exact");
  if (!is_exact) return;
  check_volumes(*home, *moved, there);
  const ShadowMeshes before = meshes_of(*home);
  const ShadowMeshes after = meshes_of(*moved);
  check_exact_volumes(before, after, there);
  check_meshes_one_by_one(before, after, [&](const Point3& p, const Point3& q) {
    return is_translated(p.x, step.x, q.x) && is_translated(p.y, step.y, q.y) && is_translated(p.z, step.z, q.z);
  });
}

TEST_P(SpatialInvariance, AnExactTranslationKeepsNamesTrianglesAndVolumes) {
  EXPECT_TRUE(rc::check([] { check_translation(GetParam()); }));
}

/// Compares without regard to the order of anything.
void check_image(const Case& drawn, const Image& image) {
  const std::optional<Case> other = image_of(drawn, image);
  RC_TAG(other ? "an image" : "no image");
  if (!other) return;
  check_volumes(drawn, *other, image);
  const ShadowMeshes before = meshes_of(drawn);
  const ShadowMeshes after = meshes_of(*other);
  check_exact_volumes(before, after, image);
  check_facets(drawn, before, *other, after, image);
}

/// The order of a polygon seen from its other side, from the same first vertex on.
Points turned_over(Points points) {
  std::reverse(points.begin() + 1, points.end());
  return points;
}

TEST_P(SpatialInvariance, AMirrorImageHasTheMirrorImagesOfNamesVerticesAndVolumes) {
  EXPECT_TRUE(rc::check([] {
    const int axis = draw(0, 2);
    Image image;
    image.point = image.direction = [axis](Point3 p) {
      double& coordinate = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      coordinate = 0 - coordinate;
      return p;
    };
    image.order_of_light = turned_over;
    check_image(draw_case(GetParam()), image);
  }));
}

TEST_P(SpatialInvariance, FirstVerticesDoNotMatter) {
  EXPECT_TRUE(rc::check([] {
    const int of_light = draw(0, 7);
    const int of_blocker = draw(0, 7);
    const auto rotated = [](Points points, int first) {
      const auto middle = first % static_cast<int>(points.size());
      std::rotate(points.begin(), points.begin() + middle, points.end());
      return points;
    };
    Image image;
    image.order_of_light = [=](Points points) { return rotated(std::move(points), of_light); };
    image.order_of_blocker = [=](Points points) { return rotated(std::move(points), of_blocker); };
    check_image(draw_case(GetParam()), image);
  }));
}

/// What stands for the same set: a blocker wound the other way, points of a solid in another order and repeated, the
/// ends of a segment exchanged, a two-sided light wound the other way.
TEST_P(SpatialInvariance, EqualInputsCanBeExchanged) {
  EXPECT_TRUE(rc::check([] {
    const Case drawn = draw_case(GetParam());
    const auto* area = std::get_if<AreaLight>(&drawn.light);
    Image image;
    if (!area || (area->two_sided && area->polygon.is_flat())) {
      image.order_of_light = [](Points points) { return Points(points.rbegin(), points.rend()); };
    }
    const bool is_solid = std::holds_alternative<ConvexSolid>(drawn.blocker);
    image.order_of_blocker = [is_solid](Points points) {
      std::reverse(points.begin(), points.end());
      if (is_solid) points.push_back(points.front());
      return points;
    };
    check_image(drawn, image);
  }));
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpatialInvariance, testing::ValuesIn(laws::all_pair_kinds),
                         [](const auto& kinds) { return std::string(kinds.param.name); });

}  // namespace
}  // namespace gnomon
