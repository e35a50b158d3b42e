#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>

#include "geometry/rounding.h"
#include "geometry/scene/convex_parts.h"
#include "geometry/scene/scene_reader.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

const ConvexPolygon ground = rectangle(-6, -6, 6, 6, 0, Facing::up);

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

/// True if the point lies inside the triangle.
bool is_inside(const ReceiverMesh& mesh, const ReceiverTriangle& t, const ExactVector& point) {
  const event::FlatPoint p = mesh.data().plane.flat(point);
  for (std::size_t k = 0; k < 3; ++k) {
    const event::FlatPoint a = mesh.data().point(t.vertices[k]), b = mesh.data().point(t.vertices[(k + 1) % 3]);
    const Rational turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (turn <= 0) return false;
  }
  return true;
}

/// How many points drawn in a face have which region by the definition.
using RegionCount = std::array<std::size_t, receiver_region_count>;

/// Draws in every face that is neither lit nor unlit, half of the points near corners and sides of its triangles.
/// Requires: a receiver in a plane on which one coordinate is 0, so that rounded points lie on it.
std::vector<RegionCount> drawn_in_faces(const ReceiverMesh& mesh, const Light& light, const Blockers& blockers,
                                        std::size_t per_triangle) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const std::vector<Point3> corners = mesh.vertices();
  std::vector<RegionCount> counts(mesh.faces().size());
  for (const ReceiverTriangle& t : mesh.triangles()) {
    const ReceiverRegion region = mesh.faces()[t.face].region;
    if (region == ReceiverRegion::lit || region == ReceiverRegion::unlit) continue;
    for (std::size_t i = 0; i < per_triangle; ++i) {
      std::array<double, 3> weights{};
      double sum = 0;
      for (double& w : weights) sum += w = i % 2 == 0 ? share(random) : std::pow(share(random), 8);
      Point3 p{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& c = corners[t.vertices[k]];
        p = {p.x + weights[k] / sum * c.x, p.y + weights[k] / sum * c.y, p.z + weights[k] / sum * c.z};
      }
      if (!is_inside(mesh, t, exact(p))) continue;
      ++counts[t.face][static_cast<std::size_t>(exact_visibility(light, {blockers, {}}, p).region)];
    }
  }
  return counts;
}

std::size_t sum_of(const RegionCount& count) {
  std::size_t sum = 0;
  for (const std::size_t n : count) sum += n;
  return sum;
}

bool is_mixed(const RegionCount& count) {
  return std::count_if(count.begin(), count.end(), [](std::size_t n) { return n > 0; }) > 1;
}

TEST(RegionCertificateProperty, OfAFaceHoldsAtEveryPointDrawnInIt) {
  std::size_t compared = 0, unresolved = 0, mixed = 0, faces = 0;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    const OverlappingScene scene(seed);
    const ReceiverMesh mesh = receiver_meshes(scene.light, scene.blockers, std::vector{ground}).front();
    const std::vector<RegionCount> counts = drawn_in_faces(mesh, scene.light, scene.blockers, 8);
    faces += counts.size();
    for (std::size_t f = 0; f < counts.size(); ++f) {
      const ReceiverRegion region = mesh.faces()[f].region;
      if (region == ReceiverRegion::unresolved_eee) {
        ++unresolved;
        mixed += is_mixed(counts[f]);
        continue;
      }
      compared += sum_of(counts[f]);
      EXPECT_EQ(counts[f][static_cast<std::size_t>(region)], sum_of(counts[f])) << "seed " << seed << ", face " << f;
    }
  }
  std::cout << faces << " faces, " << compared << " points in certified ones, " << unresolved << " faces unresolved, "
            << mixed << " of these seen to be mixed\n";
  EXPECT_GT(compared, 5000U);
  // Curved boundaries of umbra occur, and few other faces are left open.
  EXPECT_GT(mixed, 0U);
  EXPECT_LE(unresolved, 2 * mixed);
}

TEST(RegionCertificate, LeavesNothingOfTheCornellBoxOpen) {
  const Scene scene = read_scene(GNOMON_EXAMPLES "/cornell_box.scene.json");
  Blockers blockers;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (ConvexPart& part : convex_parts(blocker)) blockers.push_back(std::move(part.shape));
  }
  std::vector<ConvexPolygon> receivers;
  for (const SceneReceiver& receiver : scene.receivers) receivers.push_back(receiver.shape);
  const Light& light = scene.lights.front().shape;
  const std::vector<ReceiverMesh> meshes = receiver_meshes(light, blockers, receivers);
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
  const std::vector<RegionCount> floor = drawn_in_faces(meshes.front(), light, blockers, 16);
  for (std::size_t f = 0; f < floor.size(); ++f) {
    EXPECT_EQ(floor[f][static_cast<std::size_t>(meshes.front().faces()[f].region)], sum_of(floor[f])) << f;
  }
}

}  // namespace
}  // namespace gnomon
