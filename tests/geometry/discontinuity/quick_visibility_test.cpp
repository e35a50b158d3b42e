#include <gtest/gtest.h>

#include <random>
#include <string>
#include <variant>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_visibility.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

using Blockers = std::vector<ConvexBlocker>;

/// Every facet of every solid, seen from outside.
std::vector<ConvexPolygon> facets_of(const Blockers& blockers) {
  std::vector<ConvexPolygon> facets;
  for (const ConvexBlocker& blocker : blockers) {
    const auto* solid = std::get_if<ConvexSolid>(&blocker);
    if (!solid) continue;
    for (const ConvexSolid::Facet& facet : solid->facets()) {
      std::vector<Point3> loop;
      for (const std::uint32_t k : facet.loop) loop.push_back(solid->points()[k]);
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

/// Boxes and plates of small whole numbers, one layer touching the next.
class LayeredScene {
 public:
  explicit LayeredScene(unsigned seed) : random_(seed) {
    const int layers = whole(2, 4);
    for (int z = 0; z < layers; ++z) {
      blockers_.push_back(blocker(z));
      if (whole(0, 2) == 0) blockers_.push_back(plate(z + 0.5));
    }
    light_z_ = layers + whole(1, 2);
  }
  const Blockers& blockers() const { return blockers_; }
  /// A rectangle, a triangle that shines both ways, or a segment.
  Light light() {
    const double x = whole(-2, 1), y = whole(-2, 1), z = light_z_;
    const double far_x = x + whole(1, 2), far_y = y + whole(1, 2);
    const int kind = whole(0, 3);
    if (kind == 0) return LinearLight{{x, y, z}, {far_x, y + whole(-1, 1), z - whole(0, 1) / 2.0}};
    if (kind == 1) return AreaLight{ConvexPolygon::from_points({{x, y, z}, {x, far_y, z}, {far_x, y, z + 0.5}}), true};
    return lamp(rectangle(x, y, far_x, far_y, z, Facing::down));
  }

 private:
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  ConvexBlocker blocker(int z) {
    if (whole(0, 3) == 0) return plate(z + 1);
    const Point3 low{whole(-2, 1) / 1.0, whole(-2, 1) / 1.0, z / 1.0};
    return box(low, {low.x + whole(1, 2), low.y + whole(1, 2), z + 1.0});
  }
  ConvexBlocker plate(double z) {
    const double x = whole(-2, 1), y = whole(-2, 1);
    if (whole(0, 1) == 0) return rectangle(x, y, x + whole(1, 2), y + whole(1, 2), z, Facing::up);
    return ConvexPolygon::from_points({{x, y, z}, {x + 2, y + whole(-1, 1), z}, {x + whole(0, 1), y + 2, z}});
  }

  std::mt19937 random_;
  Blockers blockers_;
  int light_z_ = 0;
};

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
    event::ReceiverVisibility visibility(scene, light, blockers, r, data.plane);
    for (std::uint32_t f = 0; f < data.arrangement.faces().size(); ++f, ++faces) {
      EXPECT_NE(data.faces[f].region, ReceiverRegion::unresolved_eee);
      const ExactVector inside = data.plane.spatial(data.arrangement.inner_point(f));
      if (data.faces.size() > data.arrangement.faces().size() && !is_in_face(mesh, f, inside)) continue;
      const VisiblePart seen = visibility.visible_from(inside);
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

TEST(FaceLabelsAgreement, OnLayersOfTouchingBlockersAreThoseAskedExactlyFaceByFace) {
  std::size_t faces = 0;
  for (unsigned seed = 1; seed <= (GNOMON_LONG ? 2000 : 100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LayeredScene scene(seed);
    faces += expect_exact_labels(scene.light(), scene.blockers());
  }
  EXPECT_GT(faces, 4000U);
}

}  // namespace
}  // namespace gnomon
