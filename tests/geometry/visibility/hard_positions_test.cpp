#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "apps/proof/laws/definition.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/scene.h"
#include "tests/geometry/visibility/definition_check.h"

// The scenes of tests/data/scenes/hard: degenerate positions of light and blockers, each also one ulp off; needles, far
// places, rounded vertices.

namespace gnomon {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(GNOMON_TEST_DATA) / "scenes" / "hard";

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
    names.back().resize(names.back().size() - std::string(".scene.json").size());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<ConvexBlocker> parts_of(const SpaceScene& scene) {
  std::vector<ConvexBlocker> parts;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (ConvexPart& part : convex_parts(blocker)) parts.push_back(std::move(part.shape));
  }
  return parts;
}

/// Where it is decided what is seen: at vertices, half way between them, and behind blocker vertices in line with those
/// of the light.
std::vector<Point3> points_of_interest(const SpaceScene& scene, const Light& light) {
  const std::vector<Point3> ends = light_points(light);
  std::vector<Point3> points = ends;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (const Point3& b : blocker_points(blocker.shape)) {
      points.push_back(b);
      for (const Point3& l : ends) {
        points.push_back({b.x + (b.x - l.x), b.y + (b.y - l.y), b.z + (b.z - l.z)});
        points.push_back({b.x / 2 + l.x / 2, b.y / 2 + l.y / 2, b.z / 2 + l.z / 2});
      }
      const Point3 far{b.x, b.y, b.z - 3};
      if (ends.empty()) points.push_back(far);
    }
  }
  return points;
}

/// The point, and one coordinate after the other one ulp off.
std::vector<Point3> with_neighbours(const std::vector<Point3>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Point3> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point3 beside = points[i];
    double& coordinate = i % 3 == 0 ? beside.x : i % 3 == 1 ? beside.y : beside.z;
    coordinate = std::nextafter(coordinate, i % 2 == 0 ? infinity : -infinity);
    result.insert(result.end(), {points[i], beside});
  }
  return result;
}

class HardPosition : public ::testing::TestWithParam<std::string> {};

TEST_P(HardPosition, IsDecidedAsDefined) {
  const auto scene = std::get<SpaceScene>(read_scene(folder / (GetParam() + ".scene.json")));
  const std::vector<ConvexBlocker> blockers = parts_of(scene);
  for (const SceneLight& light : scene.lights) {
    const std::vector<Point3> points = with_neighbours(points_of_interest(scene, light.shape));
    // All of them in a long run.
    const std::size_t step = GNOMON_LONG ? 1 : points.size() / 60 + 1;
    for (std::size_t i = 0; i < points.size(); i += step) {
      const laws::VisibilityCase drawn{light.shape, blockers, points[i]};
      const auto difference = disagreement(drawn, exact_visibility(light.shape, {blockers, {}}, points[i]));
      ASSERT_FALSE(difference) << *difference << '\n' << light.name << '\n' << description(drawn);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardPosition, ::testing::ValuesIn(scene_names()),
                         [](const auto& tested) { return tested.param; });

TEST(HardPosition, EveryDegeneratePositionIsThereOneUlpOffToo) {
  const std::vector<std::string> names = scene_names();
  EXPECT_GE(names.size(), 50u);
  const auto has = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
  for (const std::string name :
       {"coplanar", "touching_plane", "touching_edge", "shared_vertex", "shared_edge", "collinear",
        "light_crosses_plane", "blocker_crosses_plane", "intersecting", "behind_light"}) {
    EXPECT_TRUE(has(name) && has(name + "_one_ulp_up") && has(name + "_one_ulp_down")) << name;
  }
}

/// A polygon with corners on a circle, in a tilted plane that doubles hold: exactly flat.
ConvexPolygon flat_round(int corners, double z) {
  std::vector<Point3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    const double x = std::ldexp(std::round(std::ldexp(std::cos(angle), 40)), -40);
    const double y = std::ldexp(std::round(std::ldexp(std::sin(angle), 40)), -40);
    points.push_back({x, y, z + x / 4});
  }
  return ConvexPolygon::from_points(points);
}

TEST(HardPosition, AFlatThousandGonHidesWhatClippingByItsSidesLeavesOut) {
  const ConvexPolygon disk = flat_round(1000, 2);
  ASSERT_TRUE(disk.is_flat());
  const ConvexPolygon lamp = ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}});
  for (const Point3& p : {Point3{2, 0, 0}, Point3{2.5, 1, 0}, Point3{0, 0, 0}}) {
    const Visibility got = exact_visibility(AreaLight{lamp}, {{disk}, {}}, p);
    const Rational want = *laws::visible_fraction(AreaLight{lamp}, disk, laws::exact(p));
    EXPECT_LE(abs(Rational(Rational(got.fraction) - want)), Rational(got.error_bound));
    EXPECT_EQ(got.region == Region::lit, want == 1);
    EXPECT_EQ(got.region == Region::umbra, want == 0);
  }
}

TEST(HardPosition, ATenThousandGonHidesALampInItsMiddleAndNoneFarAway) {
  const Light lamp = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
  const ConvexPolygon disk = flat_round(10000, 2);
  EXPECT_EQ(exact_visibility(lamp, {{disk}, {}}, {0, 0, 0}), (Visibility{Region::umbra, 0, 0}));
  EXPECT_EQ(exact_visibility(lamp, {{disk}, {}}, {9, 9, 0}), (Visibility{Region::lit, 1, 0}));
  EXPECT_EQ(exact_visibility(lamp, {{disk}, {}}, disk.points()[17]), (Visibility{Region::lit, 1, 0}));
}

TEST(HardPosition, ATenThousandGonAsLightIsSeenByHalfAboveABlockersEdge) {
  const Light disk = AreaLight{flat_round(10000, 4), true};
  const ConvexPolygon board = ConvexPolygon::from_points({{0, -9, 2}, {9, -9, 2}, {9, 9, 2}, {0, 9, 2}});
  const Visibility got = exact_visibility(disk, {{board}, {}}, {0, 0, 0});
  EXPECT_EQ(got.region, Region::penumbra);
  EXPECT_NEAR(got.fraction, 0.5, 1e-9);
}

}  // namespace
}  // namespace gnomon
