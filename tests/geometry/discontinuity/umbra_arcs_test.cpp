#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

#include "geometry/conics/flat_curve.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

const ConvexPolygon arcs_ground = rectangle(-8, -8, 8, 8, 0, Facing::up);

/// Two to five blockers between a lamp or a tube and the ground.
class ArcScene {
 public:
  explicit ArcScene(unsigned seed) : random_(seed) {}

  /// Tilted triangles and boxes anywhere.
  void draw_random() {
    const bool is_linear = whole(0, 1) == 0;
    if (is_linear) {
      light = LinearLight{{number(-2, 0), number(-1, 1), number(5, 7)}, {number(0, 2), number(-1, 1), number(5, 7)}};
    } else {
      light = lamp(rectangle(-1, -1, 1, 1, 6, Facing::down));
    }
    const int n = whole(2, 5);
    for (int k = 0; k < n; ++k) {
      const double z = 0.75 + 0.875 * k;
      blockers.push_back(whole(0, 3) == 0
                             ? turned_box(number(-1, 1), number(-1, 1), z, z + 0.5, number(-2, 2), number(-2, 2))
                             : triangle([&] { return number(-3, 3); }, z, number(-0.375, 0.375)));
    }
  }

  /// Small whole coordinates: level, upright and parallel edges, edges that cross and touch, vertices on edges, common
  /// vertices and edges, blockers on the ground and through it.
  void draw_degenerate() {
    if (whole(0, 1) == 0) {
      const int tilt = whole(-1, 1);
      light = LinearLight{{-1.0 * whole(0, 2), 0, 4}, {1.0 * whole(1, 2), whole(-1, 1) * 1.0, 4.0 + tilt}};
    } else {
      light = lamp(rectangle(-1, -1, 1, 1, 4, Facing::down));
    }
    const int n = whole(2, 5);
    for (int k = 0; k < n; ++k) blockers.push_back(degenerate_blocker());
  }

  Light light;
  Blockers blockers;

 private:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  template <class Draw>
  ConvexBlocker triangle(const Draw& draw, double z, double tilt) {
    while (true) {
      const Point3 a{draw(), draw(), z}, b{draw(), draw(), z + tilt}, c{draw(), draw(), z - tilt};
      if (std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) > 0.5)
        return ConvexPolygon::from_points({a, b, c});
    }
  }

  ConvexBlocker degenerate_blocker() {
    switch (whole(0, 3)) {
      case 0: {
        const double x = whole(-3, 1), y = whole(-3, 1), z = whole(0, 2);
        return box({x, y, z}, {x + whole(1, 3), y + whole(1, 3), z + 1});
      }
      case 1: {  // upright
        const double x = whole(-2, 1), y = whole(-2, 1), z = whole(-1, 1);
        const double dx = whole(-1, 2), dy = dx == 0 ? 2 : whole(-1, 2);
        return ConvexPolygon::from_points({{x, y, z}, {x + dx, y + dy, z}, {x + dx, y + dy, z + 2}, {x, y, z + 2}});
      }
      case 2:
        return triangle([&] { return double(whole(-3, 3)); }, whole(1, 3), 0);
      default:
        return triangle([&] { return double(whole(-3, 3)); }, 2, whole(-1, 1));
    }
  }

  std::mt19937 random_;
};

struct ArcTally {
  std::size_t arcs = 0;
  std::size_t straight = 0;  ///< boundaries that three edges make, but no arcs
  std::size_t compared = 0;
  std::size_t wrong = 0;
};

/// Beside each boundary that three edges make: points of doubles, closer and closer to it, have the region of the face
/// that they lie in.
void compare_beside_arcs(const ArcScene& scene, std::mt19937& random, ArcTally& tally) {
  const ReceiverMesh mesh = receiver_division(scene.light, scene.blockers, std::vector{arcs_ground}).front();
  EXPECT_TRUE(mesh.areas_add_up());
  const std::vector<Point3> vertices = mesh.vertices();
  for (const MeshFace& face : mesh.faces()) EXPECT_NE(face.region, ReceiverRegion::unresolved_eee);
  for (const MeshEdge& edge : mesh.edges()) {
    const bool is_of_three = std::ranges::any_of(
        edge.names, [&](std::uint32_t n) { return mesh.names()[n].kind == EventKind::triple_edge; });
    if (!is_of_three) continue;
    ++(edge.arc == MeshEdge::nowhere ? tally.straight : tally.arcs);
    EXPECT_NE(mesh.faces()[edge.left].region, mesh.faces()[edge.right].region);
    for (int i = 0; i < 10; ++i) {
      const double share = std::uniform_real_distribution<double>(0.02, 0.98)(random);
      const Point3 &a = vertices[edge.source], &b = vertices[edge.target];
      Point3 p{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), 0};
      double way_x = b.x - a.x, way_y = b.y - a.y;
      if (edge.arc != MeshEdge::nowhere) {
        const FaceArc& arc = mesh.data().arcs[edge.arc];
        const Rational t = arc.from.high + Rational(share) * (arc.to.low - arc.from.high);
        const auto at = *arc.curve.at(t);
        const auto way = conic::direction(arc.curve, t);
        const Rational size = abs(way.x) + abs(way.y);
        p = {at.x.convert_to<double>(), at.y.convert_to<double>(), 0};
        way_x = Rational(way.x / size).convert_to<double>(), way_y = Rational(way.y / size).convert_to<double>();
      }
      const double length = std::hypot(way_x, way_y), step = std::ldexp(i % 2 == 0 ? 1 : -1, -8 - 2 * i);
      const Point3 q{p.x - step * way_y / length, p.y + step * way_x / length, 0};
      for (const std::uint32_t f : {edge.left, edge.right}) {
        if (!is_in_face(mesh, f, exact(q))) continue;
        ++tally.compared;
        const auto region = exact_visibility(scene.light, {scene.blockers, {}}, q).region;
        if (static_cast<int>(region) == static_cast<int>(mesh.faces()[f].region)) continue;
        if (++tally.wrong <= 5) ADD_FAILURE() << q.x << " " << q.y << ", face " << f;
      }
    }
  }
}

template <class Draw>
ArcTally compare_scenes(unsigned count, const Draw& draw) {
  ArcTally tally;
  for (unsigned seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ArcScene scene(seed);
    draw(scene);
    std::mt19937 random(seed);
    compare_beside_arcs(scene, random, tally);
  }
  std::cout << count << " scenes from seed 1: " << tally.arcs << " arcs, " << tally.straight
            << " straight boundaries of three edges, " << tally.compared << " points beside them\n";
  return tally;
}

constexpr unsigned scene_count = GNOMON_LONG ? 10000 : 500;

TEST(UmbraArcsAgreement, PointsBesideThemHaveTheirFacesRegionInRandomScenes) {
  const ArcTally tally = compare_scenes(scene_count, [](ArcScene& scene) { scene.draw_random(); });
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_GT(tally.arcs, scene_count / 4);
  EXPECT_GT(tally.compared, scene_count);
}

TEST(UmbraArcsAgreement, PointsBesideThemHaveTheirFacesRegionInDegenerateScenes) {
  const ArcTally tally = compare_scenes(scene_count, [](ArcScene& scene) { scene.draw_degenerate(); });
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_GT(tally.straight, 0U);
  EXPECT_GT(tally.compared, scene_count / 4);
}

}  // namespace
}  // namespace gnomon
