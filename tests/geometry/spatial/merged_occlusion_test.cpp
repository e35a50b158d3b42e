#include "gnomon/shadow_mesh.h"

#include <CGAL/determinant.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <ostream>

#include "apps/proof/laws/any_pair.h"
#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/numbers/rounding.h"
#include "geometry/spatial/pair_polyhedra.h"
#include "geometry/spatial/vertex_rounding.h"
#include "gnomon/errors.h"
#include "gnomon/pair.h"
#include "gnomon/visibility.h"

namespace gnomon {
namespace {

using laws::Domain;
using laws::draw;

struct MergeCase {
  Light light;
  std::vector<ConvexBlocker> parts;
  Box3 box;
};

void showValue(const MergeCase& drawn, std::ostream& out) {
  for (const ConvexBlocker& part : drawn.parts) {
    out << laws::description(laws::AnyPair{drawn.light, part, {}}) << '\n';
  }
  const auto& [a, b] = drawn.box;
  out << std::setprecision(17) << "box " << a.x << ',' << a.y << ',' << a.z << ',' << b.x << ',' << b.y << ',' << b.z;
}

std::vector<Point3> corner_points(const ConvexBlocker& blocker) {
  const auto points = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  return {points.begin(), points.end()};
}

/// A box whose sides often go through vertices.
Box3 draw_box(const std::vector<Point3>& points) {
  const auto range = [&](double Point3::*coordinate) {
    const int last = static_cast<int>(points.size()) - 1;
    const double a = points[static_cast<std::size_t>(draw(0, last))].*coordinate + draw(-9, 2);
    const double b = points[static_cast<std::size_t>(draw(0, last))].*coordinate + draw(-2, 9);
    return std::pair(std::min(a, b), a == b ? std::nextafter(a, HUGE_VAL) : std::max(a, b));
  };
  const auto [x, X] = range(&Point3::x);
  const auto [y, Y] = range(&Point3::y);
  const auto [z, Z] = range(&Point3::z);
  return {{x, y, z}, {X, Y, Z}};
}

/// One to four parts that share most of their vertices, so that sides, edges and planes are common to several. Every
/// part but the first is a triangle between vertices of the first one and a few more points, half of them in its plane.
MergeCase draw_case(Domain domain) {
  return *rc::gen::exec([domain] {
    const auto light = static_cast<laws::PairLightKind>(draw(0, 4));
    const auto blocker = static_cast<laws::PairBlockerKind>(draw(0, 1));
    const laws::AnyPair pair = laws::draw_any_pair(domain, light, blocker, 0);
    MergeCase result{pair.light, {pair.blocker}, {}};
    std::vector<Point3> pool = corner_points(pair.blocker);
    for (int i = draw(1, 3); i > 0; --i) {
      const Point3 a = pool[static_cast<std::size_t>(draw(0, 2))];
      const Point3 b = pool[static_cast<std::size_t>(draw(0, 2))];
      const Point3 c = pool[2];
      pool.push_back(laws::once_in(2) ? Point3{a.x + (b.x - c.x), a.y + (b.y - c.y), a.z + (b.z - c.z)}
                                      : Point3{a.x + draw(-3, 3), a.y + draw(-3, 3), a.z + draw(-3, 3)});
    }
    for (int i = draw(0, 3); i > 0; --i) {
      const int last = static_cast<int>(pool.size()) - 1;
      std::vector<Point3> triangle;
      for (int k = 0; k < 3; ++k) triangle.push_back(pool[static_cast<std::size_t>(draw(0, last))]);
      if (ConvexPolygon::defect(triangle)) continue;
      result.parts.push_back(convex_blocker(ConvexPolygon::from_points(triangle)));
    }
    result.box = draw_box(pool);
    return result;
  });
}

Rational volume(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  Rational six_volumes = 0;
  for (const auto& face : polyhedron.faces) {
    for (std::size_t i = 1; i + 1 < face.loop.size(); ++i) {
      const auto a = exact_coordinates(space, face.loop[0]);
      const auto b = exact_coordinates(space, face.loop[i]);
      const auto c = exact_coordinates(space, face.loop[i + 1]);
      six_volumes += CGAL::determinant<Rational>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
    }
  }
  return six_volumes / 6;
}

/// The volume that the occlusions of some parts have in common: the first one's, cut by the half-spaces of the others.
Rational common_volume(const MergeCase& drawn, const std::vector<std::size_t>& chosen) {
  const CGAL::Protect_FPU_rounding<true> protection;
  const PreparedPair pair = prepared_pair(drawn.light, drawn.parts[chosen.front()]);
  PairPolyhedra polyhedra(pair, drawn.box);
  ExactSpace& space = polyhedra.planes.space;
  ConvexPolyhedron common = polyhedra.occlusion;
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    const ConvexVolume other = shadow_volumes(drawn.light, drawn.parts[chosen[i]]).occlusion;
    if (other.empty || common.empty()) return 0;
    std::vector<PlaneId> planes;
    for (const HalfSpace& half_space : other.half_spaces) planes.push_back(space.add_plane(half_space));
    common = part_inside(space, common, planes);
  }
  return volume(space, common);
}

Rational union_volume_by_inclusion_and_exclusion(const MergeCase& drawn) {
  Rational result = 0;
  for (unsigned subset = 1; subset < 1u << drawn.parts.size(); ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < drawn.parts.size(); ++i) {
      if (subset >> i & 1u) chosen.push_back(i);
    }
    const Rational common = common_volume(drawn, chosen);
    chosen.size() % 2 == 1 ? result += common : result -= common;
  }
  return result;
}

MergeCase draw_supported_case(Domain domain) {
  MergeCase drawn = draw_case(domain);
  for (const ConvexBlocker& part : drawn.parts) {
    if (!pair_refusal(drawn.light, part).empty()) RC_DISCARD("no volumes are defined");
  }
  return drawn;
}

void check_volume(Domain domain) {
  const MergeCase drawn = draw_supported_case(domain);
  const MergedOcclusion merged = merged_occlusion(drawn.light, drawn.parts, drawn.box);
  RC_TAG(merged.mesh.triangles.empty() ? "nothing in the box" : "something in the box");
  RC_ASSERT(merged.mesh.volume.exact == exact_number(union_volume_by_inclusion_and_exclusion(drawn)).exact);
}

TEST(MergedOcclusionAgreement, VolumeIsThatOfInclusionAndExclusionExactly) {
  EXPECT_TRUE(rc::check("random", [] { check_volume(Domain::random); }));
  EXPECT_TRUE(rc::check("nearly degenerate", [] { check_volume(Domain::near_degenerate); }));
}

bool is_closed(const VolumeMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (const auto& [v, facet] : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{v[i], v[(i + 1) % 3]}];
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto& [edge, count] = entry;
    return count == 1 && edges.count({edge[1], edge[0]}) == 1;
  });
}

void check_closed(Domain domain) {
  const MergeCase drawn = draw_supported_case(domain);
  const MergedOcclusion merged = merged_occlusion(drawn.light, drawn.parts, drawn.box);
  RC_ASSERT(is_closed(merged.mesh));
  RC_ASSERT(merged.facet_part.size() == merged.mesh.facets.size());
}

TEST(MergedOcclusionProperty, SurfaceIsClosedAndEveryEdgeIsInTwoTriangles) {
  EXPECT_TRUE(rc::check("random", [] { check_closed(Domain::random); }));
  EXPECT_TRUE(rc::check("nearly degenerate", [] { check_closed(Domain::near_degenerate); }));
}

/// On the boundary of a part's occlusion or in the plane of a flat part, where single points follow no volume.
bool is_on_boundary(const MergeCase& drawn, const Point3& p) {
  return std::any_of(drawn.parts.begin(), drawn.parts.end(), [&](const ConvexBlocker& part) {
    const auto* polygon = std::get_if<ConvexPolygon>(&part);
    const auto corner = [&](std::size_t k) { return laws::exact(polygon->points()[polygon->corners()[k]]); };
    if (polygon && laws::plane_through(corner(0), corner(1), corner(2)).side(laws::exact(p)) == 0) return true;
    return shadow_volumes(drawn.light, part).occlusion.oriented_side(p) == Side::boundary;
  });
}

bool is_strictly_in(const Box3& box, const Point3& p) {
  return box.min.x < p.x && p.x < box.max.x && box.min.y < p.y && p.y < box.max.y && box.min.z < p.z && p.z < box.max.z;
}

// Coordinates are small integers and quarters, so that a point off the surface is far off it compared with the
// rounding of the surface's vertices, which therefore cannot matter.
TEST(MergedOcclusionAgreement, PointIsOutsideIfAndOnlyIfEveryPartLeavesItLit) {
  EXPECT_TRUE(rc::check([] {
    const MergeCase drawn = draw_supported_case(Domain::random);
    const MergedOcclusion merged = merged_occlusion(drawn.light, drawn.parts, drawn.box);
    ClosedSurface surface{merged.mesh.vertices, {}};
    for (const MeshTriangle& triangle : merged.mesh.triangles) surface.triangles.push_back(triangle.vertices);
    for (int i = 0; i < 8; ++i) {
      const Point3& o = drawn.box.min;
      const Point3 p{o.x + draw(1, 60) / 4.0, o.y + draw(1, 60) / 4.0, o.z + draw(1, 60) / 4.0};
      if (!is_strictly_in(drawn.box, p) || is_on_boundary(drawn, p)) continue;
      bool all_lit = true;
      bool unlit = false;
      for (const ConvexBlocker& part : drawn.parts) {
        const Region seen = exact_visibility(drawn.light, {{part}, {}}, p).region;
        all_lit = all_lit && seen == Region::lit;
        unlit = unlit || seen == Region::unlit;
      }
      if (unlit) continue;
      RC_LOG() << "point " << p.x << ' ' << p.y << ' ' << p.z << '\n';
      RC_ASSERT(is_strictly_inside(p, surface) == !all_lit);
    }
  }));
}

ConvexBlocker square(double x, double y, double z) {
  return ConvexPolygon::from_points({{x, y, z}, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z}});
}

constexpr Box3 unit_high{{-9, -9, 0}, {9, 9, 9}};
const Light from_above = DirectionalLight{{0, 0, -1}};

TEST(MergedOcclusionDegenerate, PartsThatShareACornerTouchAlongAnEdgeAndStayClosed) {
  const std::vector<ConvexBlocker> parts = {square(0, 0, 1), square(1, 1, 1)};
  const MergedOcclusion merged = merged_occlusion(from_above, parts, unit_high);
  EXPECT_TRUE(is_closed(merged.mesh));
  EXPECT_EQ(merged.mesh.volume.exact, "2");
  EXPECT_EQ(merged.mesh.vertices.size(), 16u);
}

TEST(MergedOcclusionDegenerate, FacetBetweenTwoPartsThatShareAnEdgeIsGone) {
  const std::vector<ConvexBlocker> parts = {square(0, 0, 1), square(1, 0, 1)};
  const MergedOcclusion merged = merged_occlusion(from_above, parts, unit_high);
  EXPECT_TRUE(is_closed(merged.mesh));
  EXPECT_EQ(merged.mesh.volume.exact, "2");
  EXPECT_EQ(merged.mesh.facets.size(), 10u);
  EXPECT_EQ(std::count(merged.facet_part.begin(), merged.facet_part.end(), 1u), 5);
}

/// k x k squares of a floor with the height 1, in rows; each second row is of halves, so that corners meet sides.
std::vector<ConvexBlocker> tiles(int k) {
  std::vector<ConvexBlocker> parts;
  for (int y = 0; y < k; ++y) {
    for (int x = 0; x < (y % 2 == 0 ? k : 2 * k); ++x) {
      const double w = y % 2 == 0 ? 1 : 0.5, left = w * x;
      parts.push_back(ConvexPolygon::from_points(
          {{left, 1.0 * y, 1}, {left + w, 1.0 * y, 1}, {left + w, y + 1.0, 1}, {left, y + 1.0, 1}}));
    }
  }
  return parts;
}

TEST(MergedOcclusionProperty, OfTilesThatTouchNoWallIsLeftInsideWhereverTheLightComesFrom) {
  constexpr int k = 8;
  const std::vector<ConvexBlocker> parts = tiles(k);
  for (const Light& light : {Light(DirectionalLight{{0, 0, -1}}), Light(DirectionalLight{{0.3, 0.2, -1}}),
                             Light(DirectionalLight{{1, -0.7, -0.1}}), Light(PointLight{{3.1, 2.7, 9}})}) {
    const MergedOcclusion merged = merged_occlusion(light, parts, {{-30, -30, 0}, {30, 30, 5}});
    EXPECT_TRUE(is_closed(merged.mesh));
    // Of each tile a top and a floor, and what of its walls is the outside of all.
    const std::size_t rows_of_whole = k / 2, rows_of_halves = k / 2;
    const std::size_t outside = k + 2 * k + 2 * rows_of_whole + 2 * rows_of_halves;
    EXPECT_EQ(merged.mesh.facets.size(), 2 * parts.size() + outside);
    if (std::holds_alternative<DirectionalLight>(light)) {
      EXPECT_EQ(merged.mesh.volume.exact, "64");
    }
  }
}

TEST(MergedOcclusionProperty, OfPartsFarApartIsTheSumOfTheirOcclusions) {
  std::vector<ConvexBlocker> parts;
  Rational sum = 0;
  const Light lamp = AreaLight{ConvexPolygon::from_points({{40, 40, 60}, {40, 41, 60}, {41, 41, 60}, {41, 40, 60}})};
  const Box3 box{{-50, -50, 0}, {150, 150, 70}};
  for (int i = 0; i < 49; ++i) {
    parts.push_back(square(10.0 * (i % 7), 10.0 * (i / 7), 1));
    sum += common_volume({lamp, {parts.back()}, box}, {0});
  }
  EXPECT_EQ(merged_occlusion(lamp, parts, box).mesh.volume.exact, exact_number(sum).exact);
}

TEST(MergedOcclusionDegenerate, PartGivenTwiceIsUnitedOnceAndNamedByTheFirst) {
  const std::vector<ConvexBlocker> parts = {square(0, 0, 1), square(0, 0, 1)};
  const MergedOcclusion merged = merged_occlusion(from_above, parts, unit_high);
  EXPECT_EQ(merged.mesh.volume.exact, "1");
  EXPECT_EQ(merged.facet_part, std::vector<std::uint32_t>(6, 0));
}

TEST(MergedOcclusionDegenerate, NoPartsAndPartsOutsideTheBoxGiveAnEmptyMesh) {
  EXPECT_TRUE(merged_occlusion(from_above, {}, unit_high).mesh.triangles.empty());
  const std::vector<ConvexBlocker> parts = {square(20, 20, 1)};
  EXPECT_TRUE(merged_occlusion(from_above, parts, unit_high).mesh.triangles.empty());
}

TEST(MergedOcclusion, RefusesABoxWithoutInteriorAndResultsTooEarly) {
  const std::vector<ConvexBlocker> parts = {square(0, 0, 1)};
  EXPECT_THROW(merged_occlusion(from_above, parts, {{0, 0, 0}, {0, 1, 1}}), PreconditionError);
  EXPECT_THROW(OcclusionMerger(from_above, parts, unit_high).result(), PreconditionError);
}

}  // namespace
}  // namespace gnomon
