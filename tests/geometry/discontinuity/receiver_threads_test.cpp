#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_mesh_data.h"
#include "geometry/discontinuity/receiver_visibility.h"
#include "tests/geometry/discontinuity/mesh_cases.h"

namespace gnomon {
namespace {

using test_support::Dice;
using test_support::SideCase;

bool is_same(const MeshEdge& a, const MeshEdge& b) {
  return a.source == b.source && a.target == b.target && a.left == b.left && a.right == b.right && a.names == b.names;
}

void expect_same(const ReceiverMesh& a, const ReceiverMesh& b) {
  EXPECT_EQ(a.vertices(), b.vertices());
  EXPECT_EQ(a.names(), b.names());
  EXPECT_TRUE(std::equal(a.edges().begin(), a.edges().end(), b.edges().begin(), b.edges().end(), is_same));
  EXPECT_TRUE(
      std::equal(a.faces().begin(), a.faces().end(), b.faces().begin(), b.faces().end(),
                 [](const MeshFace& f, const MeshFace& g) { return f.region == g.region && f.cycles == g.cycles; }));
}

TEST(ReceiverThreads, ChangeNothingButTheTime) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const SideCase drawn = test_support::mesh_under_lamp(dice);
    const ReceiverDivision one(drawn.light, drawn.blockers, drawn.receivers);
    const ReceiverDivision three(drawn.light, drawn.blockers, drawn.receivers, 3);
    for (std::uint32_t r = 0; r < one.size(); ++r) {
      const ReceiverMesh mesh = one.mesh(r);
      expect_same(mesh, three.mesh(r, 3));
      EXPECT_EQ(one.visible_fractions(r, mesh), one.visible_fractions(r, mesh, 3));
    }
  }
}

TEST(VisibleFractionsAgreement, AreThoseOfRationalClipping) {
  for (unsigned seed = 1; seed <= (GNOMON_LONG ? 500 : 50); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const SideCase drawn = test_support::mesh_under_lamp(dice);
    const ReceiverDivision division(drawn.light, drawn.blockers, drawn.receivers);
    const ReceiverMesh mesh = division.mesh(0);
    const event::EventScene scene = [&] {
      const CGAL::Protect_FPU_rounding<true> upward;
      return event::EventScene(drawn.light, drawn.blockers, drawn.receivers);
    }();
    event::ReceiverVisibility visibility(scene, drawn.light, drawn.blockers, 0, mesh.data().plane);
    const std::vector<double> fractions = division.visible_fractions(0, mesh);
    for (std::uint32_t v = 0; v < mesh.vertex_count(); v += 7) {
      const ExactVector p = mesh.data().plane.spatial(mesh.data().point(v));
      EXPECT_EQ(fractions[v], visible_fraction(visibility.visible_from(p)).nearest);
    }
  }
}

}  // namespace
}  // namespace gnomon
