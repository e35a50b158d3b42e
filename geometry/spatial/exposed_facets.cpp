#include "geometry/spatial/exposed_facets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "geometry/bodies/box_hierarchy.h"
#include "geometry/bodies/boxes.h"
#include "geometry/numbers/rounding.h"
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

namespace {

/// Boxes around points in two frames: that of space, and one with its third axis along most shadows. Points that are
/// in both of two sets are in both boxes: extents are wider than what is rounded.
struct TwoBoxes {
  Box3 turned;
  Box3 straight;
};

class Frame {
 public:
  /// Bound. `largest` is at least the absolute value of every coordinate. A coordinate is off by u of itself, and a sum
  /// of three products of coordinates and components of at most 1 by 12 u of the largest in all.
  Frame(const Point3& along, double largest) : margin_(0x1p-44 * largest) {
    const double size = std::max({std::fabs(along.x), std::fabs(along.y), std::fabs(along.z)});
    if (!(size > 0) || !std::isfinite(size)) return;
    third_ = unit({along.x / size, along.y / size, along.z / size});
    const Vector3<double> aside = std::fabs(third_.x) < 0.6   ? Vector3<double>{1, 0, 0}
                                  : std::fabs(third_.y) < 0.6 ? Vector3<double>{0, 1, 0}
                                                              : Vector3<double>{0, 0, 1};
    first_ = unit(cross(third_, aside));
    second_ = cross(third_, first_);
  }

  TwoBoxes boxes(std::span<const Point3> points) const {
    TwoBoxes result{empty_box3(), empty_box3()};
    for (const Point3& p : points) {
      const Vector3<double> v{p.x, p.y, p.z};
      include(result.turned, {dot(v, first_), dot(v, second_), dot(v, third_)});
      include(result.straight, p);
    }
    for (Box3* box : {&result.turned, &result.straight}) {
      box->min = {box->min.x - margin_, box->min.y - margin_, box->min.z - margin_};
      box->max = {box->max.x + margin_, box->max.y + margin_, box->max.z + margin_};
    }
    return result;
  }

 private:
  static Vector3<double> unit(const Vector3<double>& v) { return (1 / std::sqrt(dot(v, v))) * v; }

  double margin_;
  Vector3<double> first_{1, 0, 0}, second_{0, 1, 0}, third_{0, 0, 1};
};

std::vector<Point3> near_points(const ExactFacet& facet) {
  std::vector<Point3> points;
  for (const ExactVector& p : facet.loop)
    points.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
  return points;
}

}  // namespace

struct ExposedFacets::State {
  std::vector<Polyhedron> polyhedra;
  std::vector<TwoBoxes> boxes;                     ///< of the polyhedra
  std::vector<std::vector<TwoBoxes>> facet_boxes;  ///< of their facets
  BoxHierarchy hierarchy;                          ///< over the turned boxes

  /// Those that may meet a facet, ascending.
  std::vector<std::uint32_t> near(std::size_t polyhedron, std::size_t facet) const {
    const TwoBoxes& own = facet_boxes[polyhedron][facet];
    std::vector<std::uint32_t> found;
    hierarchy.search([&](const Box3& box) { return overlap(box, own.turned); }, found);
    std::erase_if(found, [&](std::uint32_t j) { return j == polyhedron || !overlap(boxes[j].straight, own.straight); });
    std::sort(found.begin(), found.end());
    return found;
  }
};

ExposedFacets::ExposedFacets(std::span<const std::vector<ExactFacet>> polyhedra, const Point3& along)
    : state_(std::make_unique<State>()) {
  std::vector<std::vector<std::vector<Point3>>> points;
  double largest = 0;
  for (const auto& facets : polyhedra) {
    Polyhedron& polyhedron = state_->polyhedra.emplace_back();
    points.emplace_back();
    for (const ExactFacet& facet : facets) {
      polyhedron.push_back(to_cgal(facet));
      points.back().push_back(near_points(facet));
      for (const Point3& p : points.back().back()) {
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
      }
    }
  }
  const Frame frame(along, largest);
  std::vector<Box3> turned;
  for (const auto& of_polyhedron : points) {
    std::vector<Point3> all;
    state_->facet_boxes.emplace_back();
    for (const std::vector<Point3>& of_facet : of_polyhedron) {
      state_->facet_boxes.back().push_back(frame.boxes(of_facet));
      all.insert(all.end(), of_facet.begin(), of_facet.end());
    }
    state_->boxes.push_back(frame.boxes(all));
    turned.push_back(all.empty() ? Box3{} : state_->boxes.back().turned);  // an empty box has no middle
  }
  state_->hierarchy = BoxHierarchy(turned);
}
ExposedFacets::ExposedFacets(ExposedFacets&&) noexcept = default;
ExposedFacets& ExposedFacets::operator=(ExposedFacets&&) noexcept = default;
ExposedFacets::~ExposedFacets() = default;

std::vector<ExactEdge> ExposedFacets::edges(std::size_t polyhedron, std::size_t facet_index) const {
  const Facet& facet = state_->polyhedra[polyhedron][facet_index];
  const Axes frame = axes(facet.coefficients);
  std::vector<ConvexLoop> hidden;
  for (const std::uint32_t j : state_->near(polyhedron, facet_index)) {
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
