#include "gnomon/shadow_mesh.h"

#include <CGAL/determinant.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>

#include "apps/proof/laws/any_pair.h"
#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/spatial_cases.h"
#include "geometry/numbers/rounding.h"
#include "geometry/spatial/difference_surface.h"
#include "geometry/spatial/pair_polyhedra.h"
#include "geometry/spatial/vertex_rounding.h"
#include "gnomon/errors.h"
#include "gnomon/pair.h"

namespace gnomon {
namespace {

using laws::Domain;
using laws::draw;
using laws::SpatialCase;

struct MeshCase {
  Light light;
  ConvexBlocker blocker;
  Box3 box;
};

/// A pair's volumes before rounding.
struct ExactVolumes {
  explicit ExactVolumes(const MeshCase& drawn)
      : pair(prepared_pair(drawn.light, drawn.blocker)), polyhedra(pair, drawn.box) {
    surfaces = {surface(polyhedra.occlusion), surface(polyhedra.umbra)};
    if (pair.has_penumbra()) {
      surfaces.push_back(difference_surface(polyhedra.planes.space, polyhedra.occlusion, polyhedra.umbra));
    }
    if (pair.has_solid()) {
      solid = solid_in_umbra(pair, polyhedra);
      surfaces.push_back(difference_surface(polyhedra.planes.space, polyhedra.umbra, solid));
    }
  }

  PreparedPair pair;
  PairPolyhedra polyhedra;
  ConvexPolyhedron solid;
  std::vector<ExactSurface> surfaces;  ///< occlusion, umbra, penumbra, pockets
};

std::vector<Point3> all_points(const Light& light, const ConvexBlocker& blocker) {
  const auto of_blocker = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  std::vector<Point3> points(of_blocker.begin(), of_blocker.end());
  if (std::holds_alternative<DirectionalLight>(light)) return points;
  const std::vector<Point3> of_light = laws::light_points(light);
  points.insert(points.end(), of_light.begin(), of_light.end());
  return points;
}

/// A box whose sides often go through vertices, so that they cut the blocker or hold it, its edges or the light.
Box3 draw_box(const std::vector<Point3>& points) {
  const int reach = laws::once_in(2) ? 9 : 60;
  const auto range = [&](double Point3::*coordinate) {
    const int last = static_cast<int>(points.size()) - 1;
    const double a = points[static_cast<std::size_t>(draw(0, last))].*coordinate + draw(-reach, 2);
    const double b = points[static_cast<std::size_t>(draw(0, last))].*coordinate + draw(-2, reach);
    return std::pair(std::min(a, b), a == b ? std::nextafter(a, HUGE_VAL) : std::max(a, b));
  };
  const auto [x, X] = range(&Point3::x);
  const auto [y, Y] = range(&Point3::y);
  const auto [z, Z] = range(&Point3::z);
  return {{x, y, z}, {X, Y, Z}};
}

void showValue(const MeshCase& drawn, std::ostream& out) {
  const auto& [a, b] = drawn.box;
  out << laws::description(laws::AnyPair{drawn.light, drawn.blocker, {}}) << std::setprecision(17) << "box " << a.x
      << ',' << a.y << ',' << a.z << ',' << b.x << ',' << b.y << ',' << b.z;
}

/// Half of the pairs are in standard position, the rest of any kind in any position.
MeshCase draw_case(Domain domain) {
  return *rc::gen::exec([domain] {
    if (laws::once_in(2)) {
      const SpatialCase pair = *laws::spatial_cases(domain, laws::Lights::all);
      return MeshCase{pair.light, pair.blocker, draw_box(all_points(pair.light, pair.blocker))};
    }
    const auto light = static_cast<laws::PairLightKind>(draw(0, 5));
    const auto blocker = static_cast<laws::PairBlockerKind>(draw(0, 2));
    const laws::AnyPair pair = laws::draw_any_pair(domain, light, blocker, 0);
    return MeshCase{pair.light, pair.blocker, draw_box(all_points(pair.light, pair.blocker))};
  });
}

MeshCase draw_solid_case(Domain domain) {
  return *rc::gen::exec([domain] {
    const auto light = static_cast<laws::PairLightKind>(draw(0, 4));
    const laws::AnyPair pair = laws::draw_any_pair(domain, light, laws::PairBlockerKind::solid, 0);
    return MeshCase{pair.light, pair.blocker, draw_box(all_points(pair.light, pair.blocker))};
  });
}

using Edges = std::map<std::pair<VertexId, VertexId>, int>;

Edges directed_edges(const ExactSurface& surface) {
  Edges edges;
  for (const auto& facet : surface.facets) {
    for (const auto& t : facet.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    }
  }
  return edges;
}

bool is_closed(const ExactSurface& surface) {
  const Edges edges = directed_edges(surface);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto opposite = edges.find({entry.first.second, entry.first.first});
    return entry.second == 1 && opposite != edges.end() && opposite->second == 1;
  });
}

ExactReal plane_value(const ExactSpace& space, PlaneId plane, VertexId vertex) {
  const Quadruple<ExactReal>& p = space.exact_plane(plane);
  const Quadruple<ExactReal>& v = space.exact_vertex(vertex);
  return p[0] * v[0] + p[1] * v[1] + p[2] * v[2] + p[3] * v[3];
}

ExactVector coordinates(const ExactSpace& space, VertexId vertex) {
  return exact_coordinates(space, vertex);
}

/// True if c lies strictly between a and b.
bool strictly_between(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  Rational product = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Rational cross = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    if (cross != 0) return false;
    product += (a[i] - c[i]) * (b[i] - c[i]);
  }
  return product < 0;
}

bool has_t_junction(const ExactSpace& space, const ExactSurface& surface) {
  std::map<VertexId, ExactVector> points;
  const Edges edges = directed_edges(surface);
  for (const auto& [edge, count] : edges) points.try_emplace(edge.first, coordinates(space, edge.first));
  for (const auto& [edge, count] : edges) {
    for (const auto& [vertex, point] : points) {
      if (strictly_between(points.at(edge.first), points.at(edge.second), point)) return true;
    }
  }
  return false;
}

void check_surfaces(Domain domain) {
  const MeshCase drawn = draw_case(domain);
  const CGAL::Protect_FPU_rounding<true> protection;
  const ExactVolumes volumes(drawn);
  for (const ExactSurface& surface : volumes.surfaces) {
    RC_ASSERT(is_closed(surface));
    RC_ASSERT_FALSE(has_t_junction(volumes.polyhedra.planes.space, surface));
    for (const auto& facet : surface.facets) {
      for (const auto& triangle : facet.triangles) {
        for (const VertexId v : triangle) RC_ASSERT(plane_value(volumes.polyhedra.planes.space, facet.plane, v) == 0);
      }
    }
  }
}

TEST(VolumeMeshProperty, SurfacesAreClosedWithoutTJunctionsAndVerticesLieExactlyOnTheirPlanes) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_surfaces(Domain::random); }));
  EXPECT_TRUE(rc::check("on nearly degenerate pairs", [] { check_surfaces(Domain::near_degenerate); }));
}

void check_volumes(Domain domain) {
  const MeshCase drawn = draw_case(domain);
  const ShadowMeshes meshes = shadow_meshes(drawn.light, drawn.blocker, drawn.box);
  const Rational occlusion(meshes.occlusion.volume.exact);
  const Rational umbra(meshes.umbra.volume.exact);
  const Rational penumbra(meshes.penumbra.volume.exact);
  const bool has_extent =
      std::holds_alternative<LinearLight>(drawn.light) || std::holds_alternative<AreaLight>(drawn.light);
  RC_ASSERT(occlusion == umbra + penumbra);
  RC_ASSERT(has_extent || penumbra == 0);
  RC_ASSERT(umbra >= 0);
  RC_ASSERT(penumbra >= 0);
  RC_ASSERT((umbra > 0) == !meshes.umbra.triangles.empty());
  RC_ASSERT((penumbra > 0) == !meshes.penumbra.triangles.empty());
  RC_ASSERT((penumbra > 0) == !meshes.penumbra_cells.cells.empty());
  RC_TAG(umbra > 0 ? "umbra in the box" : "no umbra in the box");
}

TEST(VolumeMeshProperty, UmbraAndPenumbraAddUpToTheOcclusionExactly) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_volumes(Domain::random); }));
  EXPECT_TRUE(rc::check("on nearly degenerate pairs", [] { check_volumes(Domain::near_degenerate); }));
}

Rational six_volumes(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  Rational sum = 0;
  for (const auto& facet : surface(polyhedron).facets) {
    for (const auto& [a, b, c] : facet.triangles) {
      const auto p = coordinates(space, a);
      const auto q = coordinates(space, b);
      const auto r = coordinates(space, c);
      sum += CGAL::determinant<Rational>(p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]);
    }
  }
  return sum;
}

bool is_convex(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  for (const auto& face : polyhedron.faces) {
    for (const auto& other : polyhedron.faces) {
      for (const VertexId v : other.loop) {
        if (plane_value(space, face.plane, v) > 0) return false;
      }
    }
  }
  return true;
}

void check_cells(Domain domain) {
  const MeshCase drawn = draw_case(domain);
  const CGAL::Protect_FPU_rounding<true> protection;
  ExactVolumes volumes(drawn);
  ExactSpace& space = volumes.polyhedra.planes.space;
  Rational cells = 0;
  for (const auto& cell : penumbra_cells(volumes.pair, volumes.polyhedra)) {
    RC_ASSERT(is_closed(surface(cell)));
    RC_ASSERT(is_convex(space, cell));
    const Rational volume = six_volumes(space, cell);
    RC_ASSERT(volume > 0);
    cells += volume;
  }
  const Rational penumbra =
      six_volumes(space, volumes.polyhedra.occlusion) - six_volumes(space, volumes.polyhedra.umbra);
  RC_ASSERT(cells == penumbra);
}

TEST(VolumeMeshProperty, CellsAreConvexAndFillThePenumbraExactly) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_cells(Domain::random); }));
  EXPECT_TRUE(rc::check("on nearly degenerate pairs", [] { check_cells(Domain::near_degenerate); }));
}

/// Six times the volume of a cell from its rounded vertices.
Rational six_volumes(const VolumeCells& cells, const VolumeCells::Cell& cell) {
  Rational sum = 0;
  const auto point = [&](std::uint32_t i) {
    const Point3& p = cells.vertices[i];
    return ExactVector{Rational(p.x), Rational(p.y), Rational(p.z)};
  };
  for (const auto& face : cell.faces) {
    const auto a = point(face[0]);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const auto b = point(face[i]);
      const auto c = point(face[i + 1]);
      sum +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum;
}

Rational six_volumes(const ExactSpace& space, const ExactSurface& surface) {
  Rational sum = 0;
  for (const auto& facet : surface.facets) {
    for (const auto& [a, b, c] : facet.triangles) {
      const auto p = coordinates(space, a), q = coordinates(space, b), r = coordinates(space, c);
      sum += CGAL::determinant<Rational>(p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]);
    }
  }
  return sum;
}

void check_pockets(Domain domain) {
  const MeshCase drawn = draw_solid_case(domain);
  const CGAL::Protect_FPU_rounding<true> protection;
  const ExactVolumes volumes(drawn);
  const ExactSpace& space = volumes.polyhedra.planes.space;
  const Rational outside = six_volumes(space, volumes.polyhedra.umbra) - six_volumes(space, volumes.solid);
  RC_ASSERT(six_volumes(space, volumes.surfaces.back()) == outside);
}

TEST(VolumeMeshProperty, PocketsAreTheUmbraWithoutTheSolidExactly) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_pockets(Domain::random); }));
  EXPECT_TRUE(rc::check("on nearly degenerate pairs", [] { check_pockets(Domain::near_degenerate); }));
}

/// Number of solids that a surface bounds: of its pieces (two triangles are of one piece if they share a vertex) those
/// that hold a volume; the others are hollows in them.
std::size_t pieces(const ExactSpace& space, const ExactSurface& surface) {
  std::map<VertexId, VertexId> parent;
  const auto root = [&](VertexId v) {
    while (parent.try_emplace(v, v).first->second != v) v = parent[v];
    return v;
  };
  for (const auto& facet : surface.facets) {
    for (const auto& [a, b, c] : facet.triangles) parent[root(a)] = root(b), parent[root(c)] = root(b);
  }
  std::map<VertexId, ExactSurface> by_root;
  for (const auto& facet : surface.facets) {
    for (const auto& triangle : facet.triangles) {
      ExactSurface::Facet& part = by_root[root(triangle[0])].facets.emplace_back();
      part.plane = facet.plane;
      part.triangles.push_back(triangle);
    }
  }
  return static_cast<std::size_t>(std::count_if(
      by_root.begin(), by_root.end(), [&](const auto& entry) { return six_volumes(space, entry.second) > 0; }));
}

/// In a box that holds all corners of the volumes, which have small integer coordinates, there are as many pieces as in
/// all of space.
void check_components() {
  MeshCase drawn = laws::once_in(2) ? draw_solid_case(Domain::random) : draw_case(Domain::random);
  // No bounded umbra ends so far away, however nearly parallel its planes are.
  drawn.box = {{-0x1p200, -0x1p200, -0x1p200}, {0x1p200, 0x1p200, 0x1p200}};
  const ShadowVolumes facts = shadow_volumes(drawn.light, drawn.blocker);
  const CGAL::Protect_FPU_rounding<true> protection;
  const ExactVolumes volumes(drawn);
  RC_TAG(std::to_string(facts.penumbra_facts.components) + " penumbrae, " + std::to_string(facts.umbra_pockets) +
         " pockets");
  if (volumes.pair.has_solid())
    RC_ASSERT(pieces(volumes.polyhedra.planes.space, volumes.surfaces.back()) == facts.umbra_pockets);
  if (volumes.pair.has_penumbra() && !volumes.polyhedra.umbra.empty()) {
    RC_ASSERT(pieces(volumes.polyhedra.planes.space, volumes.surfaces[2]) == facts.penumbra_facts.components);
  }
  RC_ASSERT(volumes.polyhedra.occlusion.empty() == facts.occlusion_facts.empty);
  RC_ASSERT(volumes.polyhedra.umbra.empty() == facts.umbra_facts.empty);
  const bool reaches_box =
      std::any_of(volumes.polyhedra.umbra.faces.begin(), volumes.polyhedra.umbra.faces.end(), [&](const auto& face) {
        return face.plane >= volumes.polyhedra.sides[0] && face.plane <= volumes.polyhedra.sides[5];
      });
  RC_ASSERT(reaches_box == !facts.umbra_facts.bounded);
}

TEST(VolumeMeshAgreement, VolumesHaveAsManyPiecesAsTheirFactsSay) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_components(); }));
}

void check_rounding(Domain domain) {
  const MeshCase drawn = draw_case(domain);
  const ShadowMeshes meshes = shadow_meshes(drawn.light, drawn.blocker, drawn.box, {false, false, false, false});
  std::vector<ExactVector> exact;
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    const ExactVolumes volumes(drawn);
    std::set<VertexId> seen;
    for (const auto& facet : volumes.surfaces[0].facets) {
      for (const auto& triangle : facet.triangles) {
        for (const VertexId v : triangle) {
          if (seen.insert(v).second) exact.push_back(coordinates(volumes.polyhedra.planes.space, v));
        }
      }
    }
  }
  RC_ASSERT(exact.size() == meshes.occlusion.vertices.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Point3& p = meshes.occlusion.vertices[i];
    RC_ASSERT(p.x == nearest_double(exact[i][0]));
    RC_ASSERT(p.y == nearest_double(exact[i][1]));
    RC_ASSERT(p.z == nearest_double(exact[i][2]));
  }
}

TEST(VolumeMeshAgreement, VerticesAreTheExactOnesRoundedToNearest) {
  EXPECT_TRUE(rc::check("on random pairs", [] { check_rounding(Domain::random); }));
  EXPECT_TRUE(rc::check("on nearly degenerate pairs", [] { check_rounding(Domain::near_degenerate); }));
}

TEST(VolumeMesh, CellsOfASquareUnderASquareFillThePenumbra) {
  // Numbers are chosen so that every vertex is a double: nothing is rounded.
  const Light light = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
  const ConvexPolygon blocker = ConvexPolygon::from_points({{-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}});
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-16, -16, -2}, {16, 16, 4}});
  Rational six = 0;
  for (const auto& cell : meshes.penumbra_cells.cells) six += six_volumes(meshes.penumbra_cells, cell);
  EXPECT_EQ(Rational(six / 6), Rational(meshes.penumbra.volume.exact));
  EXPECT_EQ(meshes.umbra_cells.cells.size(), 1u);
  EXPECT_EQ(Rational(six_volumes(meshes.umbra_cells, meshes.umbra_cells.cells[0]) / 6),
            Rational(meshes.umbra.volume.exact));
  // Umbra: frusta between half-widths 2 and 4; occlusion: between 2 and 8; height 4.
  EXPECT_EQ(meshes.umbra.volume.exact, Rational(Rational(4) / 3 * (16 + 32 + 64)).str());
  EXPECT_EQ(meshes.occlusion.volume.exact, Rational(Rational(4) / 3 * (16 + 64 + 256)).str());
}

TEST(VolumeMeshDegenerate, BoxThatMissesTheShadowGivesEmptyMeshes) {
  const Light light = PointLight{{0, 0, 4}};
  const ConvexPolygon blocker = ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}});
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-9, -9, 2}, {9, 9, 5}});
  EXPECT_TRUE(meshes.occlusion.triangles.empty());
  EXPECT_TRUE(meshes.umbra.triangles.empty());
  EXPECT_TRUE(meshes.penumbra.triangles.empty());
  EXPECT_EQ(meshes.occlusion.volume.exact, "0");
}

TEST(VolumeMeshDegenerate, PointLightHasNoPenumbra) {
  const Light light = PointLight{{0, 0, 4}};
  const ConvexPolygon blocker = ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}});
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-9, -9, -2}, {9, 9, 5}});
  EXPECT_EQ(meshes.occlusion.volume.exact, meshes.umbra.volume.exact);
  EXPECT_TRUE(meshes.penumbra.triangles.empty());
  EXPECT_TRUE(meshes.penumbra_cells.cells.empty());
}

TEST(VolumeMesh, ExtremalPlanesAreCutByTheBoxOneByOne) {
  const Light light = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {0, 1, 4}, {1, -1, 4}})};
  const ConvexPolygon blocker = ConvexPolygon::from_points({{-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}});
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-16, -16, -2}, {16, 16, 4}});
  const ExtremalPlanes planes = extremal_planes(light, blocker);
  EXPECT_EQ(meshes.extremal_planes.size(),
            planes.separating_blocker.size() + planes.separating_light.size() + planes.supporting_blocker.size());
  for (const PlanePolygon& polygon : meshes.extremal_planes) EXPECT_GE(polygon.vertices.size(), 3u);
}

TEST(VolumeMesh, RefusesABoxWithoutInterior) {
  const Light light = PointLight{{0, 0, 4}};
  const ConvexPolygon blocker = ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}});
  EXPECT_THROW(shadow_meshes(light, blocker, {{0, 0, 0}, {1, 0, 1}}), PreconditionError);
  EXPECT_THROW(shadow_meshes(light, blocker, {{0, 0, 0}, {1, HUGE_VAL, 1}}), PreconditionError);
}

}  // namespace
}  // namespace gnomon
