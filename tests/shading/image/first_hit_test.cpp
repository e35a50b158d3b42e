#include "shading/image/first_hit.h"

#include <gtest/gtest.h>

#include "geometry/numbers/exact_vector.h"
#include "tests/support/dice.h"

namespace gnomon::image {
namespace {

using test_support::Dice;

Point3 small_point(Dice& dice) {
  return {double(dice.draw(-3, 3)), double(dice.draw(-3, 3)), double(dice.draw(-3, 3))};
}

std::vector<Facet> drawn_facets(Dice& dice) {
  std::vector<Facet> facets;
  while (facets.size() < 12) {
    const std::vector<Point3> corners = {small_point(dice), small_point(dice), small_point(dice)};
    if (ConvexPolygon::defect(corners)) continue;
    facets.push_back({ConvexPolygon::from_points(corners), {0, 0, 1}, {}, 0, std::uint32_t(facets.size()), {}, {}, {}});
  }
  return facets;
}

/// Where the ray meets a triangle, by its definition in rational numbers: o + t d = a + u (b - a) + v (c - a).
std::optional<Rational> met_at(const Ray& ray, const Facet& facet) {
  const auto& p = facet.shape.points();
  const ExactVector a = exact(p[0]), ab = exact(p[1]) - a, ac = exact(p[2]) - a;
  const ExactVector o = exact(ray.eye) - a, d = exact(ray.through) - exact(ray.eye);
  const Rational volume = dot(d, cross(ac, ab));
  if (volume == 0) return std::nullopt;
  const Rational t = dot(o, cross(ab, ac)) / volume, u = dot(d, cross(ac, o)) / volume,
                 v = dot(d, cross(o, ab)) / volume;
  if (t < 0 || u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return t;
}

TEST(FirstHit, IsTheNearestFacetAndOfEquallyNearOnesTheLowest) {
  Dice dice(71);
  int hits = 0, ties = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<Facet> facets = drawn_facets(dice);
    const FirstHit first(facets);
    for (int k = 0; k < 10; ++k) {
      Ray ray{small_point(dice), small_point(dice)};
      if (ray.eye == ray.through) continue;
      std::optional<std::uint32_t> expected;
      Rational nearest;
      for (std::uint32_t f = 0; f < facets.size(); ++f) {
        const std::optional<Rational> t = met_at(ray, facets[f]);
        if (t && *t == 0) continue;  // through the eye: seen edge-on
        ties += t && expected && *t == nearest;
        if (t && (!expected || *t < nearest)) expected = f, nearest = *t;
      }
      const std::optional<Hit> hit = first.along(ray);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << round;
      if (!hit) continue;
      ++hits;
      ASSERT_EQ(hit->facet, *expected) << round;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(ties, 30);
}

TEST(FirstHit, TellsTheSideThePlaceAndTheSharesOfTheCorners) {
  const std::vector<Facet> facets = {
      {ConvexPolygon::from_points({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}), {0, 0, 1}, {}, 0, 0, {}, {}, {}}};
  const FirstHit first(facets);
  const std::optional<Hit> above = first.along({{3, 1, 8}, {3, 1, 4}}), below = first.along({{1, 3, -8}, {1, 3, -4}});
  ASSERT_TRUE(above && below);
  EXPECT_TRUE(above->is_front);
  EXPECT_FALSE(below->is_front);
  EXPECT_EQ(above->place, (Point3{3, 1, 0}));
  EXPECT_EQ(above->triangle, 0u);
  EXPECT_EQ(above->shares, (std::array<double, 3>{0.25, 0.5, 0.25}));
  EXPECT_EQ(below->triangle, 1u);
  EXPECT_FALSE(first.along({{3, 1, 8}, {3, 1, 9}}));
  EXPECT_FALSE(first.along({{-1, 1, 0}, {3, 1, 0}})) << "along the facet";
}

}  // namespace
}  // namespace gnomon::image
