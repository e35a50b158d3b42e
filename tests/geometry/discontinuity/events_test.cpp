#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/visibility/fast_visibility.h"
#include "gnomon/discontinuity.h"
#include "gnomon/pair.h"
#include "tests/geometry/discontinuity/mesh_probe.h"
#include "tests/geometry/discontinuity/triple_edges.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;
using Names = std::set<std::tuple<std::uint32_t, std::uint32_t>>;

const Box3 wide_box{{-20, -20, -1}, {20, 20, 5}};
const ConvexPolygon events_ground = rectangle(-8, -8, 8, 8, 0, Facing::up);

std::vector<EventName> surface_names(const Light& light, const Blockers& blockers) {
  std::vector<EventName> names;
  for (const auto& s : discontinuity_surfaces(light, blockers, std::vector{events_ground}, wide_box))
    names.push_back(s.name);
  return names;
}

/// A triangle that no edge of the other is parallel to, up to chance.
ConvexPolygon triangle(std::mt19937& random, double z, Facing facing) {
  std::uniform_real_distribution<double> shift(-0.25, 0.25);
  std::vector<Point3> points{{shift(random) - 1, shift(random) - 1, z + shift(random)},
                             {shift(random) + 1, shift(random) - 1, z + shift(random)},
                             {shift(random), shift(random) + 1, z + shift(random)}};
  if (facing == Facing::down) std::swap(points[0], points[1]);
  return ConvexPolygon::from_points(points);
}

/// The pairs (edge, vertex) of the events with one mark, the edge being of the light or of the blocker.
Names marked(const std::vector<EventName>& names, Extremal extremal, EventOf edge_of) {
  Names found;
  for (const EventName& name : names) {
    if (name.extremal == extremal && name.edge.of == edge_of)
      found.insert({number(name.edge.index), number(name.vertex.index)});
  }
  return found;
}

TEST(DiscontinuitySurfacesProperty, AreNMPlusNMForOnePairInStandardPosition) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Light light = lamp(triangle(random, 3, Facing::down));
    EXPECT_EQ(surface_names(light, {triangle(random, 1.5, Facing::up)}).size(), 18U);
  }
}

TEST(DiscontinuitySurfacesProperty, AreTwoMPlusMForALinearLight) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const LinearLight light{{-0.75, 0.125, 3}, {0.5, 0.25, 3.125}};
    const auto names = surface_names(light, {triangle(random, 1.5, Facing::up)});
    EXPECT_EQ(names.size(), 9U);
    EXPECT_TRUE(std::all_of(names.begin(), names.end(), [](const EventName& n) { return n.order == 1; }));
  }
}

TEST(DiscontinuitySurfacesProperty, MarkAsExtremalWhatBoundsThePairsVolumes) {
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const Light light = lamp(triangle(random, 3, Facing::down));
    const ConvexPolygon blocker = triangle(random, 1.5, Facing::up);
    if (pair_position(light, blocker) != Position::standard) continue;
    const ExtremalPlanes planes = extremal_planes(light, blocker);
    Names separating, supporting, separating_light;
    for (const auto& p : planes.separating_blocker) separating.insert({number(p.edge), number(p.vertex)});
    for (const auto& p : planes.supporting_blocker) supporting.insert({number(p.edge), number(p.vertex)});
    for (const auto& p : planes.separating_light) separating_light.insert({number(p.edge), number(p.vertex)});
    const auto names = surface_names(light, {blocker});
    EXPECT_EQ(marked(names, Extremal::occlusion, EventOf::blocker), separating);
    EXPECT_EQ(marked(names, Extremal::umbra, EventOf::blocker), supporting);
    EXPECT_EQ(marked(names, Extremal::occlusion, EventOf::light), separating_light);
  }
}

TEST(DiscontinuitySurfaces, OfASolidStartAtItsOutlineOnly) {
  // From a point light above a corner only the upper square is an outline.
  const auto names = surface_names(PointLight{{0, 0, 4}}, {box({-1, -1, 1}, {1, 1, 2})});
  EXPECT_EQ(names.size(), 4U);
  EXPECT_TRUE(std::all_of(names.begin(), names.end(), [](const EventName& n) { return n.order == 0; }));
}

TEST(DiscontinuitySurfaces, EndAtTheFirstBlockerOrReceiver) {
  const Blockers shelves{rectangle(-1, -1, 1, 1, 2, Facing::up), rectangle(-4, -4, 4, 4, 1, Facing::up)};
  for (const auto& surface :
       discontinuity_surfaces(PointLight{{0, 0, 4}}, shelves, std::vector{events_ground}, wide_box)) {
    const bool of_upper = surface.name.edge.body == EventBody{0};
    for (const auto& polygon : surface.polygons) {
      for (const Point3& p : polygon) {
        EXPECT_GE(p.z, of_upper ? 1 : 0);
        EXPECT_LE(p.z, of_upper ? 2 : 1);
      }
    }
  }
}

/// How fast 1 - f grows from a boundary of the lit region on: g(2 t) / g(t) for small t.
double growth(const Light& light, const Blockers& blockers, const Point3& boundary, double dx, double dy) {
  const auto lost = [&](double t) {
    const Point3 p{boundary.x + t * dx, boundary.y + t * dy, boundary.z};
    return 1 - exact_visibility(light, {blockers, {}}, p).fraction;
  };
  return lost(0x1p-11) / lost(0x1p-12);
}

/// For every edge between a lit and a penumbral face: the growth and the lowest order of its names.
std::vector<std::pair<double, int>> growths(const Light& light, const Blockers& blockers) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{events_ground}).front();
  const std::vector<Point3> points = mesh.vertices();
  std::vector<std::pair<double, int>> found;
  for (const MeshEdge& edge : mesh.edges()) {
    if (edge.left == MeshEdge::nowhere || edge.right == MeshEdge::nowhere) continue;
    const auto left = mesh.faces()[edge.left].region, right = mesh.faces()[edge.right].region;
    if (left == right || (left != ReceiverRegion::lit && right != ReceiverRegion::lit)) continue;
    const Point3 &p = points[edge.source], &q = points[edge.target];
    const double side = left == ReceiverRegion::lit ? -1 : 1, length = std::hypot(q.x - p.x, q.y - p.y);
    if (length < 0.125) continue;
    int order = 3;
    for (const std::uint32_t n : edge.names) order = std::min<int>(order, mesh.names()[n].order);
    const Point3 middle{(p.x + q.x) / 2, (p.y + q.y) / 2, p.z};
    found.push_back(
        {growth(light, blockers, middle, -side * (q.y - p.y) / length, side * (q.x - p.x) / length), order});
  }
  return found;
}

TEST(EventOrder, OfAVertexAndAnEdgeIsTwoForAnAreaLight) {
  std::mt19937 random(5);
  std::size_t checked = 0;
  for (int i = 0; i < 10; ++i) {
    for (const auto& [ratio, order] :
         growths(lamp(triangle(random, 3, Facing::down)), {triangle(random, 1.5, Facing::up)})) {
      EXPECT_EQ(order, 2);
      EXPECT_NEAR(ratio, 4, 0.05);
      ++checked;
    }
  }
  EXPECT_GT(checked, 30U);
}

TEST(EventOrder, OfCoplanarEdgesIsOneForAnAreaLight) {
  const auto found = growths(lamp(rectangle(-1, -1, 1, 1, 3, Facing::down)), {rectangle(-1, -1, 1, 1, 1, Facing::up)});
  EXPECT_FALSE(found.empty());
  for (const auto& [ratio, order] : found) {
    EXPECT_EQ(order, 1);
    EXPECT_NEAR(ratio, 2, 0.05);
  }
}

TEST(EventOrder, OfALinearLightIsOneAndZeroWhereAnEdgeIsCoplanar) {
  std::mt19937 random(6);
  const LinearLight light{{-1, 0, 3}, {1, 0, 3}};
  for (const auto& [ratio, order] : growths(light, {triangle(random, 1.5, Facing::up)})) {
    EXPECT_EQ(order, 1);
    EXPECT_NEAR(ratio, 2, 0.05);
  }
  std::set<int> orders;
  for (const auto& [ratio, order] : growths(light, {rectangle(-1, -1, 1, 1, 1.5, Facing::up)})) {
    orders.insert(order);
    EXPECT_NEAR(ratio, order == 0 ? 1 : 2, 0.05);
  }
  EXPECT_EQ(orders, (std::set<int>{0, 1}));
}

TEST(EventOrder, OfAPointLightIsZero) {
  const auto found = growths(PointLight{{0.5, 0.25, 3}}, {rectangle(-1, -1, 1, 1, 1, Facing::up)});
  // A point light knows no penumbra: the boundary lies between lit and umbra.
  EXPECT_EQ(found.size(), 4U);
  for (const auto& [ratio, order] : found) {
    EXPECT_EQ(order, 0);
    EXPECT_EQ(ratio, 1);
  }
}

/// The edges that bound what a point sees, with multiplicity.
using Structure = std::multiset<std::pair<std::int64_t, std::uint32_t>>;

std::optional<Structure> structure_at(FastVisibility& visibility, const Point3& p) {
  const auto seen = visibility.visible_from(p);
  if (!seen) return std::nullopt;
  Structure structure;
  for (const BoundaryPiece& piece : seen->boundary) {
    structure.insert({piece.blocker ? std::int64_t{*piece.blocker} : -1, piece.edge});
  }
  return structure;
}

/// Compares what several points of each face see; returns the number of comparisons.
std::size_t expect_constant_structure(const AreaLight& light, const Blockers& blockers) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{events_ground}).front();
  const CGAL::Protect_FPU_rounding<true> upward;
  const event::EventScene scene(light, blockers, std::vector{events_ground});
  const CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  FastVisibility visibility(light, BlockerSet(blockers));
  const std::vector<Point3> points = mesh.vertices();
  std::vector<std::uint32_t> shapes(blockers.size());
  for (std::uint32_t s = 0; s < shapes.size(); ++s) shapes[s] = s;
  std::map<std::uint32_t, Structure> of_face;
  std::map<std::uint32_t, bool> is_crossed;
  std::size_t compared = 0;
  for (const ReceiverTriangle& t : straight_triangles(mesh)) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      // Two thirds of the way from a corner to the middle of the opposite side, and nearer to the corner than others.
      Point3 p{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = k == corner ? 0.5 : 0.25;
        p.x += share * points[t.vertices[k]].x;
        p.y += share * points[t.vertices[k]].y;
      }
      if (face_at(mesh, exact(p)) != t.face) continue;
      if (!is_crossed.contains(t.face)) {
        std::vector<ExactVector> hull;
        for (const MeshEdgeUse use : mesh.faces()[t.face].cycles[0]) {
          const MeshEdge& edge = mesh.edges()[use / 2];
          hull.push_back(mesh.data().plane.spatial(mesh.data().point(use % 2 == 0 ? edge.source : edge.target)));
        }
        is_crossed[t.face] = event::may_have_triple_edges(scene, shapes, hull);
      }
      if (is_crossed[t.face]) continue;
      const auto structure = structure_at(visibility, p);
      if (!structure) continue;
      const auto [known, is_new] = of_face.try_emplace(t.face, *structure);
      EXPECT_EQ(known->second, *structure) << p.x << " " << p.y;
      compared += is_new ? 0 : 1;
    }
  }
  return compared;
}

TEST(BackprojectionProperty, IsConstantInEachFaceThatNoTripleEdgeEventCrosses) {
  std::mt19937 random(8);
  std::size_t compared = 0;
  for (int i = 0; i < 6; ++i) {
    const AreaLight light = lamp(triangle(random, 3, Facing::down));
    compared += expect_constant_structure(light, {triangle(random, 1.5, Facing::up)});
    compared += expect_constant_structure(light, {turned_box(0.25, -0.125, 0.5, 1.5, 0.75, 0.25)});
    compared += expect_constant_structure(light, {triangle(random, 1.5, Facing::up), box({-3, -2, 0}, {-2, 1, 1})});
  }
  const AreaLight square = lamp(rectangle(-1, -1, 1, 1, 3, Facing::down));
  compared += expect_constant_structure(square, {box({-1, -1, 0}, {1, 1, 1}), box({-0.5, -0.5, 1}, {0.5, 0.5, 1.5})});
  compared += expect_constant_structure(
      square, {rectangle(-1, -1, 0, 1, 1, Facing::up), rectangle(0, -1, 1, 1, 1, Facing::up)});
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace gnomon
