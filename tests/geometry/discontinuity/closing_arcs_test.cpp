#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

#include "geometry/numbers/rounding.h"
#include "gnomon/scene.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

const ConvexPolygon change_ground = rectangle(-6, -6, 6, 6, 0, Facing::up);

/// Blockers one above the other that hide the light together.
class OverlappingScene {
 public:
  explicit OverlappingScene(unsigned seed) : random_(seed) {
    const int n = std::uniform_int_distribution<int>(2, 4)(random_);
    for (int k = 0; k < n; ++k) blockers.push_back(blocker(0.75 + k));
  }

  Light light = lamp(rectangle(-1, -1, 1, 1, 6, Facing::down));
  Blockers blockers;

 private:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  ConvexBlocker blocker(double z) {
    const double x = number(-1.5, 1.5), y = number(-1.5, 1.5), c = number(-2, 2), s = number(-2, 2);
    if (number(0, 1) < 0.25) return turned_box(x, y, z, z + 0.5, c, s);
    const double tilt = number(0, 1) < 0.5 ? 0 : 0.375;
    return ConvexPolygon::from_points({{x + c, y + s, z},
                                       {x - s, y + c, z + number(-tilt, tilt)},
                                       {x - c + number(-1, 1), y - s + number(-1, 1), z + number(-tilt, tilt)}});
  }

  std::mt19937 random_;
};

/// How many points drawn in a face have which region by the definition.
using RegionCount = std::array<std::size_t, receiver_region_count>;

/// Draws points of doubles in the plane z = 0: between three vertices of each face, half of them close to one.
std::vector<RegionCount> drawn_in_faces(const ReceiverMesh& mesh, const Light& light, const Blockers& blockers,
                                        std::size_t per_face) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const std::vector<Point3> vertices = mesh.vertices();
  std::vector<RegionCount> counts(mesh.faces().size());
  for (std::uint32_t f = 0; f < mesh.faces().size(); ++f) {
    const MeshFace& face = mesh.faces()[f];
    if (face.region == ReceiverRegion::lit || face.region == ReceiverRegion::unlit) continue;
    const auto& cycle = face.cycles.front();
    for (std::size_t i = 0; i < per_face; ++i) {
      double sum = 0;
      Point3 p{0, 0, 0};
      for (int k = 0; k < 3; ++k) {
        const MeshEdge& edge = mesh.edges()[cycle[random() % cycle.size()] / 2];
        const Point3& c = vertices[random() % 2 == 0 ? edge.source : edge.target];
        const double weight = i % 2 == 0 ? share(random) : std::pow(share(random), 8);
        sum += weight;
        p = {p.x + weight * c.x, p.y + weight * c.y, 0};
      }
      p = {p.x / sum, p.y / sum, 0};
      if (!is_in_face(mesh, f, exact(p))) continue;
      ++counts[f][static_cast<std::size_t>(exact_visibility(light, {blockers, {}}, p).region)];
    }
  }
  return counts;
}

std::size_t sum_of(const RegionCount& count) {
  std::size_t sum = 0;
  for (const std::size_t n : count) sum += n;
  return sum;
}

struct Tally {
  std::size_t faces = 0;
  std::size_t compared = 0;
  std::size_t arcs = 0;
};

/// Compares what faces are said to be with points drawn in them.
void expect_true_faces(const Light& light, const Blockers& blockers, Tally& tally) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{change_ground}).front();
  const std::vector<RegionCount> counts = drawn_in_faces(mesh, light, blockers, 24);
  tally.faces += counts.size();
  tally.arcs += mesh.data().arcs.size();
  for (std::size_t f = 0; f < counts.size(); ++f) {
    const ReceiverRegion region = mesh.faces()[f].region;
    EXPECT_NE(region, ReceiverRegion::unresolved_eee);
    tally.compared += sum_of(counts[f]);
    EXPECT_EQ(counts[f][static_cast<std::size_t>(region)], sum_of(counts[f])) << "face " << f;
  }
  EXPECT_TRUE(mesh.areas_add_up());
}

void expect_enough(const Tally& tally) {
  std::cout << tally.faces << " faces, " << tally.compared << " points, " << tally.arcs << " arcs\n";
  EXPECT_GT(tally.compared, 5000U);
  EXPECT_GT(tally.arcs, 10U);
}

TEST(FaceRegionsProperty, HoldAtEveryPointDrawnInTheirFaces) {
  Tally tally;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const OverlappingScene scene(seed);
    expect_true_faces(scene.light, scene.blockers, tally);
  }
  expect_enough(tally);
}

/// The solid hides no light from its own top, though it lies between the light's vertices and all of that in a sense.
TEST(FaceRegionsProperty, OfASolidsOwnTopHoldAtEveryPointDrawnInThem) {
  Tally tally;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    OverlappingScene scene(seed);
    scene.blockers.push_back(box({-6, -6, -1}, {6, 6, 0}));
    expect_true_faces(scene.light, scene.blockers, tally);
  }
  expect_enough(tally);
}

TEST(FaceRegions, LeaveNothingOfTheCornellBoxOpen) {
  const auto scene = std::get<SpaceScene>(read_scene(GNOMON_EXAMPLES "/cornell_box.scene.json"));
  const Blockers blockers = parts_of_blockers(scene);
  const std::vector<ConvexPolygon> receivers = receivers_of(scene);
  const Light& light = scene.lights.front().shape;
  const std::vector<ReceiverMesh> meshes = receiver_division(light, blockers, receivers);
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    const auto areas = meshes[r].areas();
    std::cout << scene.receivers[r].name << ": " << meshes[r].faces().size() << " faces";
    for (std::size_t k = 0; k < areas.size(); ++k) {
      std::cout << ", " << name(static_cast<ReceiverRegion>(k)) << " "
                << 100 * areas[k].nearest / meshes[r].area().nearest << " %";
    }
    std::cout << "\n";
    EXPECT_EQ(areas[static_cast<std::size_t>(ReceiverRegion::unresolved_eee)].exact, "0");
  }
  const std::vector<RegionCount> floor = drawn_in_faces(meshes.front(), light, blockers, 40);
  for (std::size_t f = 0; f < floor.size(); ++f) {
    EXPECT_EQ(floor[f][static_cast<std::size_t>(meshes.front().faces()[f].region)], sum_of(floor[f])) << f;
  }
}

}  // namespace
}  // namespace gnomon
