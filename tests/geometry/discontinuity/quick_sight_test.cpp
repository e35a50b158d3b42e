#include <gtest/gtest.h>

#include <variant>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_sight.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

/// Every facet of every solid, seen from outside.
std::vector<ConvexPolygon> facets_of(const Blockers& solids) {
  std::vector<ConvexPolygon> facets;
  for (const ConvexBlocker& blocker : solids) {
    const auto& solid = std::get<ConvexSolid>(blocker);
    for (const ConvexSolid::Facet& facet : solid.facets()) {
      std::vector<Point3> loop;
      for (const std::uint32_t k : facet.loop) loop.push_back(solid.points()[k]);
      facets.push_back(ConvexPolygon::from_points(loop));
    }
  }
  return facets;
}

/// Boxes on each other and one beside them, each turned by another angle.
Blockers turned_stack(double twist) {
  return {turned_box(0, 0, 0, 0.5, 1, twist), turned_box(0, 0, 0.5, 1, 0.75, -twist),
          turned_box(0, 0.125, 1, 1.5, 0.5, 0.25 + twist), turned_box(1.5, -0.25, 0, 1.25, 0.25, 0.25)};
}

/// Asks exactly, face by face, at the point by which a face is judged; returns how many faces there were.
std::size_t expect_exact_labels(const Light& light, const Blockers& blockers) {
  std::vector<ConvexPolygon> receivers = facets_of(blockers);
  receivers.push_back(rectangle(-4, -4, 4, 4, 0, Facing::up));
  const ReceiverDivision division(light, blockers, receivers);
  const event::EventScene scene = [&] {
    const CGAL::Protect_FPU_rounding<true> upward;
    return event::EventScene(light, blockers, receivers);
  }();
  std::size_t faces = 0;
  for (std::uint32_t r = 0; r < receivers.size(); ++r) {
    const ReceiverMesh mesh = division.mesh(r);
    const ReceiverMesh::Data& data = mesh.data();
    event::ReceiverSight sight(scene, light, blockers, r, data.plane);
    for (std::uint32_t f = 0; f < data.faces.size(); ++f, ++faces) {
      if (data.faces[f].region == ReceiverRegion::unresolved_eee) continue;
      const VisiblePart seen = sight.visible_from(data.plane.spatial(data.arrangement.inner_point(f)));
      EXPECT_EQ(static_cast<int>(data.faces[f].region), static_cast<int>(seen.region)) << "receiver " << r << ", " << f;
    }
  }
  return faces;
}

TEST(FaceLabelsAgreement, OfFacetsAreThoseAskedExactlyFaceByFace) {
  std::size_t faces = 0;
  for (const double twist : {0.0, 0.125, 0.3125}) {
    // Above, so that planes of facets cut the light; low at the side; far away.
    faces += expect_exact_labels(lamp(rectangle(-1, -1, 1, 1, 3, Facing::down)), turned_stack(twist));
    faces +=
        expect_exact_labels(lamp(ConvexPolygon::from_points({{-4, 1, 0.25}, {-4, -1, 0.25}, {-4, -1, 2}, {-4, 1, 2}})),
                            turned_stack(twist));
    faces += expect_exact_labels(lamp(rectangle(1990, -10, 2010, 10, 3000, Facing::down)), turned_stack(twist));
  }
  EXPECT_GT(faces, 2000U);
}

}  // namespace
}  // namespace gnomon
