#include "geometry/spatial/exposed_facets.h"

#include <map>
#include <optional>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "geometry/spatial/convex_difference.h"

namespace gnomon {
namespace {

using Kernel = ExactKernel;
using Loop3 = std::vector<Kernel::Point_3>;

Kernel::FT number(const Rational& value) {
  return Kernel::FT(Kernel::Exact_kernel::FT(value));
}

/// Coordinates of a plane: two of space, in the order in which the outside sees counterclockwise as counterclockwise.
struct Axes {
  std::size_t first;
  std::size_t second;
  std::size_t dropped;
};

Axes axes(const std::array<Rational, 4>& plane) {
  const std::size_t dropped = plane[2] != 0 ? 2 : plane[0] != 0 ? 0 : 1;
  const Axes result{(dropped + 1) % 3, (dropped + 2) % 3, dropped};
  return plane[dropped] > 0 ? result : Axes{result.second, result.first, dropped};
}

struct Facet {
  std::array<Rational, 4> coefficients;
  Kernel::Plane_3 plane;  ///< its positive side is outside
  Loop3 loop;
};

using Polyhedron = std::vector<Facet>;

Facet to_cgal(const ExactFacet& facet) {
  Facet result{facet.plane,
               {number(facet.plane[0]), number(facet.plane[1]), number(facet.plane[2]), number(facet.plane[3])},
               {}};
  for (const ExactVector& p : facet.loop) result.loop.emplace_back(number(p[0]), number(p[1]), number(p[2]));
  return result;
}

Kernel::Point_3 crossing(const Kernel::Plane_3& plane, const Kernel::Point_3& p, const Kernel::Point_3& q) {
  const auto height = [&](const Kernel::Point_3& x) {
    return plane.a() * x.x() + plane.b() * x.y() + plane.c() * x.z() + plane.d();
  };
  const Kernel::FT at_p = height(p);
  const Kernel::FT share = at_p / (at_p - height(q));
  Kernel::Point_3 result = p + share * (q - p);
  result.exact();  // keeps expressions shallow
  return result;
}

/// The part of a convex loop on the inside of a plane, or nothing if it has no area. A loop in the plane is kept.
Loop3 part_inside(const Kernel::Plane_3& plane, const Loop3& loop) {
  std::vector<CGAL::Oriented_side> sides;
  bool any_inside = false;
  bool any_outside = false;
  for (const Kernel::Point_3& p : loop) {
    sides.push_back(plane.oriented_side(p));
    any_inside = any_inside || sides.back() == CGAL::ON_NEGATIVE_SIDE;
    any_outside = any_outside || sides.back() == CGAL::ON_POSITIVE_SIDE;
  }
  if (!any_outside) return loop;
  if (!any_inside) return {};
  Loop3 result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    if (sides[i] != CGAL::ON_POSITIVE_SIDE) result.push_back(loop[i]);
    if (sides[i] * sides[next] < 0) result.push_back(crossing(plane, loop[i], loop[next]));
  }
  return result;
}

bool lies_in(const Kernel::Plane_3& plane, const Loop3& loop) {
  return plane.has_on(loop[0]) && plane.has_on(loop[1]) && plane.has_on(loop[2]);
}

bool same_outside(const Kernel::Plane_3& a, const Kernel::Plane_3& b) {
  return a.orthogonal_vector() * b.orthogonal_vector() > 0;
}

/// The part of a facet that another polyhedron takes away.
Loop3 hidden_part(const Facet& facet, const Polyhedron& other, bool other_is_earlier) {
  Loop3 loop = facet.loop;
  for (const Facet& f : other) {
    loop = part_inside(f.plane, loop);
    if (loop.empty()) return {};
    if (lies_in(f.plane, facet.loop) && same_outside(f.plane, facet.plane) && !other_is_earlier) return {};
  }
  return loop;
}

Kernel::Point_2 projected(const Axes& axes, const Kernel::Point_3& p) {
  return {p[static_cast<int>(axes.first)], p[static_cast<int>(axes.second)]};
}

ConvexLoop projected(const Axes& axes, const Loop3& loop) {
  ConvexLoop polygon;
  for (const Kernel::Point_3& p : loop) polygon.push_back(projected(axes, p));
  return polygon;
}

ExactVector lifted(const std::array<Rational, 4>& plane, const Axes& axes, const Kernel::Point_2& p) {
  ExactVector result;
  result[axes.first] = Rational(p.x().exact());
  result[axes.second] = Rational(p.y().exact());
  result[axes.dropped] =
      -(plane[axes.first] * result[axes.first] + plane[axes.second] * result[axes.second] + plane[3]) /
      plane[axes.dropped];
  return result;
}

}  // namespace

struct ExposedFacets::State {
  std::vector<Polyhedron> polyhedra;
};

ExposedFacets::ExposedFacets(std::span<const std::vector<ExactFacet>> polyhedra) : state_(std::make_unique<State>()) {
  for (const auto& facets : polyhedra) {
    Polyhedron& polyhedron = state_->polyhedra.emplace_back();
    for (const ExactFacet& facet : facets) polyhedron.push_back(to_cgal(facet));
  }
}
ExposedFacets::ExposedFacets(ExposedFacets&&) noexcept = default;
ExposedFacets& ExposedFacets::operator=(ExposedFacets&&) noexcept = default;
ExposedFacets::~ExposedFacets() = default;

std::vector<ExactEdge> ExposedFacets::edges(std::size_t polyhedron, std::size_t facet_index) const {
  const Facet& facet = state_->polyhedra[polyhedron][facet_index];
  const Axes frame = axes(facet.coefficients);
  std::vector<ConvexLoop> hidden;
  for (std::size_t j = 0; j < state_->polyhedra.size(); ++j) {
    if (j == polyhedron || state_->polyhedra[j].empty()) continue;
    const Loop3 loop = hidden_part(facet, state_->polyhedra[j], j < polyhedron);
    if (!loop.empty()) hidden.push_back(projected(frame, loop));
  }
  std::vector<ExactEdge> result;
  for (const auto& [from, to] : convex_difference(projected(frame, facet.loop), hidden)) {
    result.push_back({lifted(facet.coefficients, frame, from), lifted(facet.coefficients, frame, to)});
  }
  return result;
}

namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel,
                                                CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;

/// Tells each face whether it is in the region: every edge of the boundary has the region on one side only.
void mark_region(Triangulation& triangulation) {
  std::vector<Triangulation::Face_handle> open = {triangulation.infinite_face()};
  open.front()->info() = false;
  while (!open.empty()) {
    const Triangulation::Face_handle face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Triangulation::Face_handle next = face->neighbor(i);
      if (next->info()) continue;
      next->info() = *face->info() != face->is_constrained(i);
      open.push_back(next);
    }
  }
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> region_triangles(const std::array<Rational, 4>& plane,
                                                           const std::vector<ExactVector>& points,
                                                           const std::vector<std::array<std::uint32_t, 2>>& edges) {
  const Axes frame = axes(plane);
  Triangulation triangulation;
  std::map<std::uint32_t, Triangulation::Vertex_handle> handles;
  const auto handle = [&](std::uint32_t v) {
    const auto [entry, is_new] = handles.try_emplace(v);
    if (is_new) {
      entry->second = triangulation.insert({number(points[v][frame.first]), number(points[v][frame.second])});
      entry->second->info() = v;
    }
    return entry->second;
  };
  for (const auto& [a, b] : edges) {
    const Triangulation::Vertex_handle from = handle(a);
    triangulation.insert_constraint(from, handle(b));
  }
  mark_region(triangulation);
  std::vector<std::array<std::uint32_t, 3>> result;
  for (const Triangulation::Face_handle face : triangulation.finite_face_handles()) {
    if (!*face->info()) continue;
    result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return result;
}

}  // namespace gnomon
