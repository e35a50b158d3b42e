#include "geometry/spatial/volume_mesh.h"

#include <CGAL/determinant.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>

#include "apps/laws/draw.h"
#include "apps/laws/spatial_cases.h"
#include "geometry/errors.h"
#include "geometry/rounding.h"
#include "geometry/spatial/penumbra_surface.h"
#include "geometry/spatial/vertex_rounding.h"

namespace gnomon {
namespace {

using laws::Domain;
using laws::draw;
using laws::SpatialCase;

/// A pair's volumes before rounding.
struct ExactVolumes {
  ExactVolumes(const SpatialCase& drawn, const Box3& box)
      : pair(standard_pair(drawn.light, drawn.blocker)), half_spaces(pair), polyhedra(pair, half_spaces) {
    const std::array<PlaneId, 6> sides = add_box(polyhedra.space, box);
    occlusion = clipped_by_box(polyhedra.space, polyhedra.occlusion, sides);
    umbra = clipped_by_box(polyhedra.space, polyhedra.umbra, sides);
    surfaces = {surface(occlusion), surface(umbra)};
    surfaces.push_back(penumbra_surface(polyhedra.space, occlusion, umbra, polyhedra, half_spaces, sides));
  }

  StandardPair pair;
  PairHalfSpaces half_spaces;
  ShadowPolyhedra polyhedra;
  ConvexPolyhedron occlusion;
  ConvexPolyhedron umbra;
  std::vector<ExactSurface> surfaces;  ///< occlusion, umbra, penumbra
};

std::vector<Point3> all_points(const SpatialCase& drawn) {
  std::vector<Point3> points(drawn.blocker.points().begin(), drawn.blocker.points().end());
  if (const auto* area = std::get_if<AreaLight>(&drawn.light)) {
    points.insert(points.end(), area->polygon.points().begin(), area->polygon.points().end());
  } else if (const auto* line = std::get_if<LinearLight>(&drawn.light)) {
    points.insert(points.end(), {line->start, line->end});
  } else {
    points.push_back(std::get<PointLight>(drawn.light).position);
  }
  return points;
}

/// A box whose sides often go through vertices, so that they cut the blocker or hold it, its edges or the light.
Box3 draw_box(const SpatialCase& drawn) {
  const std::vector<Point3> points = all_points(drawn);
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

struct MeshCase {
  SpatialCase pair;
  Box3 box;
};

void showValue(const MeshCase& drawn, std::ostream& out) {
  const auto& [a, b] = drawn.box;
  out << laws::description(drawn.pair) << std::setprecision(17) << "box " << a.x << ',' << a.y << ',' << a.z << ','
      << b.x << ',' << b.y << ',' << b.z;
}

MeshCase draw_case(Domain domain) {
  return *rc::gen::exec([domain] {
    const SpatialCase pair = *laws::spatial_cases(domain, laws::Lights::all);
    return MeshCase{pair, draw_box(pair)};
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

std::array<Rational, 3> coordinates(const ExactSpace& space, VertexId vertex) {
  return exact_coordinates(space, vertex);
}

/// True if c lies strictly between a and b.
bool strictly_between(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b,
                      const std::array<Rational, 3>& c) {
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
  std::map<VertexId, std::array<Rational, 3>> points;
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
  const ExactVolumes volumes(drawn.pair, drawn.box);
  for (const ExactSurface& surface : volumes.surfaces) {
    RC_ASSERT(is_closed(surface));
    RC_ASSERT_FALSE(has_t_junction(volumes.polyhedra.space, surface));
    for (const auto& facet : surface.facets) {
      for (const auto& triangle : facet.triangles) {
        for (const VertexId v : triangle) RC_ASSERT(plane_value(volumes.polyhedra.space, facet.plane, v) == 0);
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
  const ShadowMeshes meshes = shadow_meshes(drawn.pair.light, drawn.pair.blocker, drawn.box);
  const Rational occlusion(meshes.occlusion.volume.exact);
  const Rational umbra(meshes.umbra.volume.exact);
  const Rational penumbra(meshes.penumbra.volume.exact);
  RC_ASSERT(occlusion == umbra + penumbra);
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
  ExactVolumes volumes(drawn.pair, drawn.box);
  ExactSpace& space = volumes.polyhedra.space;
  Rational cells = 0;
  for (const auto& cell : penumbra_cells(space, volumes.occlusion, volumes.polyhedra.supporting_blocker)) {
    RC_ASSERT(is_closed(surface(cell)));
    RC_ASSERT(is_convex(space, cell));
    const Rational volume = six_volumes(space, cell);
    RC_ASSERT(volume > 0);
    cells += volume;
  }
  RC_ASSERT(cells == six_volumes(space, volumes.occlusion) - six_volumes(space, volumes.umbra));
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
    return std::array<Rational, 3>{Rational(p.x), Rational(p.y), Rational(p.z)};
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
