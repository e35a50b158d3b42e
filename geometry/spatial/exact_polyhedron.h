#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/kernel.h"
#include "geometry/spatial/shadow_volume.h"

namespace gnomon {

using PlaneId = std::uint32_t;
using VertexId = std::uint32_t;

/// Homogeneous coordinates (x, y, z, w), or a plane's coefficients (a, b, c, d) with a x + b y + c z + d w <= 0 inside.
template <class Number>
using Quadruple = std::array<Number, 4>;

/// A convex polyhedron, possibly unbounded: its corners include points at infinity, and then one face lies there.
struct ConvexPolyhedron {
  struct Face {
    PlaneId plane;
    std::vector<VertexId> loop;  ///< strictly convex, counterclockwise seen from outside
  };
  std::vector<Face> faces;  ///< empty: no interior

  bool empty() const { return faces.empty(); }
};

/// The planes and vertices of the polyhedra of one pair, by name: a vertex is an input point, the direction from one
/// input point to another, or the meet of three planes. Coordinates are intervals first and rationals on demand.
///
/// Requires: the rounding mode is protected (CGAL::Protect_FPU_rounding) while any member runs.
class ExactSpace {
 public:
  /// The plane at infinity bounds nothing; polyhedra that reach infinity have a face there.
  static constexpr PlaneId at_infinity = 0;
  /// The plane given to the constructor.
  static constexpr PlaneId downward = 1;

  /// Requires: every direction that will occur points strictly to the inside of `downward`; so directions that are
  /// constructed as meets of planes are told from their opposites.
  explicit ExactSpace(const HalfSpace& downward_half_space);

  PlaneId add_plane(const HalfSpace& half_space);
  /// The plane of one side of a box; sides are numbered as in FacetName.
  PlaneId add_box_side(const Box3& box, int side);
  /// The same plane with its sides exchanged.
  PlaneId add_reversed(PlaneId plane);

  /// `planes` are planes known to go through the point (direction).
  VertexId add_point(const Point3& point, std::vector<PlaneId> planes);
  VertexId add_direction(const Point3& from, const Point3& to, std::vector<PlaneId> planes);

  /// Another vertex at the same place.
  VertexId add_copy(VertexId vertex);

  const FacetName& name(PlaneId plane) const { return planes_[plane].name; }
  const Quadruple<Rational>& exact_plane(PlaneId plane) const;
  const Quadruple<Rational>& exact_vertex(VertexId vertex) const;
  bool is_direction(VertexId vertex) const { return vertices_[vertex].direction; }
  /// Planes that are known to go through the vertex: all on which `clipped` found it, or which made it.
  const std::vector<PlaneId>& known_planes(VertexId vertex) const { return vertices_[vertex].planes; }

  /// Sign of the plane at the vertex: -1 inside, 0 on the plane, +1 outside.
  int side(PlaneId plane, VertexId vertex) const;
  /// Lexicographic order of two points: -1, 0, +1.
  int compare(VertexId a, VertexId b) const;

  /// +1 if three points of a plane run counterclockwise seen from its outside, -1 if clockwise, 0 if collinear.
  int turn(PlaneId plane, VertexId a, VertexId b, VertexId c) const;

  /// The part of the polyhedron inside the plane; empty if that has no interior.
  /// The faces keep their planes; the cut is a new face on `plane`.
  ConvexPolyhedron clipped(const ConvexPolyhedron& polyhedron, PlaneId plane);

  /// The whole box. Requires: `sides` are the six planes of the box in order.
  ConvexPolyhedron box(const Box3& box, const std::array<PlaneId, 6>& sides);

 private:
  struct Plane {
    FacetName name;
    std::array<Point3, 3> points;  ///< defining points, unless axis >= 0
    int axis = -1;
    int axis_sign = 0;
    double bound = 0;
    std::optional<PlaneId> reverse_of;
    Quadruple<Interval> approximate{Interval(0), Interval(0), Interval(0), Interval(0)};
    mutable std::optional<Quadruple<Rational>> exact;
  };
  struct Vertex {
    bool direction = false;
    bool input = false;
    std::array<Point3, 2> points;  ///< of an input point (first) or direction (from, to)
    std::vector<PlaneId> planes;   ///< known planes; the first three define a meet
    Quadruple<Interval> approximate{Interval(0), Interval(0), Interval(0), Interval(0)};
    mutable std::optional<Quadruple<Rational>> exact;
  };

  template <class Number>
  static Quadruple<Number> coefficients(const Plane& plane);
  PlaneId add(Plane plane);
  VertexId add_input(bool direction, const Point3& first, const Point3& second, std::vector<PlaneId> planes);
  VertexId add_meet(bool direction, PlaneId a, PlaneId b, PlaneId c);
  ConvexPolyhedron cut(const ConvexPolyhedron& polyhedron, PlaneId plane, std::unordered_map<VertexId, int>& sides);
  void remember(VertexId vertex, PlaneId plane);

  std::vector<Plane> planes_;
  std::vector<Vertex> vertices_;
};

}  // namespace gnomon
