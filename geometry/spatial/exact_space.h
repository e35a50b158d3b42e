#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/vector3.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

using PlaneId = std::uint32_t;
using VertexId = std::uint32_t;

/// How a plane is given.
struct PlaneDefinition {
  enum class Kind {
    infinity,          ///< the plane at infinity: w = 0
    axis,              ///< sign * (x_axis - bound w) <= 0
    points,            ///< through three points, as HalfSpace says
    points_direction,  ///< through two points, along a vector
    apex               ///< through an apex: of a wide pyramid about a polyhedron, see ExactSpace::add_apex_plane
  };
  Kind kind = Kind::points;
  FacetName name;
  std::array<Point3, 3> points{};
  Point3 apex{};
  std::uint32_t axis = 0;
  double sign = 1;  ///< -1 for a plane whose sides are exchanged, if `kind` is not axis
  double bound = 0;
  int scale = 0;  ///< of an apex plane: its bound is times 2^(1000 scale)
};

/// An input point, or a direction between input points.
struct InputVertex {
  enum class Kind { point, difference, vector };
  Kind kind = Kind::point;
  Point3 first;   ///< the point, the vector, or where the direction starts
  Point3 second;  ///< where the direction leads: an input point on the ray's line
};

/// How a vertex is given.
struct VertexDefinition {
  static constexpr std::uint32_t none = ~0u;
  std::uint32_t input = none;       ///< index of an input vertex, or none: the meet of `planes`
  std::uint32_t line = none;        ///< index of an input direction on whose line (through its end) the vertex lies
  std::array<PlaneId, 3> planes{};  ///< of a meet; the last one is that which cut the edge of the others
  bool middle = false;     ///< the middle between the vertices planes[0] and planes[1], which are no planes then
  bool direction = false;  ///< at infinity
};

/// The planes and vertices of the polyhedra of one pair, by name: a vertex is an input point, the direction from one
/// input point to another, or the meet of three planes. Coordinates are intervals first and exact on demand.
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
  /// The plane sign * ((x - apex)_axis - bound * 2^(1000 scale) * (h(apex) - h(x))) <= 0, h being the value of the
  /// plane `downward`. Requires: `downward` is given by points.
  PlaneId add_apex_plane(const Point3& apex, std::uint32_t axis, double sign, double bound, int scale);
  /// The same plane with its sides exchanged.
  PlaneId add_reversed(PlaneId plane);

  VertexId add_point(const Point3& point);
  VertexId add_direction(const Point3& from, const Point3& to);
  VertexId add_vector(const Point3& vector);
  /// The vertex in which `plane` cuts the edge from u to v of the faces in the planes a and b.
  VertexId add_cut(VertexId u, VertexId v, PlaneId a, PlaneId b, PlaneId plane);
  /// The point or direction on three planes.
  VertexId add_meet(const std::array<PlaneId, 3>& planes, bool direction);
  /// The point in the middle between two points.
  VertexId add_middle(VertexId u, VertexId v);
  /// Another vertex at the same place.
  VertexId add_copy(VertexId vertex);

  const FacetName& name(PlaneId plane) const { return planes_[plane].definition.name; }
  const PlaneDefinition& definition(PlaneId plane) const { return planes_[plane].definition; }
  const VertexDefinition& vertex_definition(VertexId vertex) const { return vertices_[vertex].definition; }
  const InputVertex& input(std::uint32_t index) const { return inputs_[index]; }
  std::size_t plane_count() const { return planes_.size(); }
  std::size_t vertex_count() const { return vertices_.size(); }
  bool is_direction(VertexId vertex) const { return vertices_[vertex].definition.direction; }

  /// A point near a vertex that is no direction; it may be not finite.
  Point3 nearby_point(VertexId vertex) const {
    const auto middle = [&](std::size_t i) {
      const Interval& x = vertices_[vertex].approximate[i];
      return x.inf() / 2 + x.sup() / 2;
    };
    const double w = middle(3);
    return {middle(0) / w, middle(1) / w, middle(2) / w};
  }

  const Quadruple<ExactReal>& exact_plane(PlaneId plane) const;
  const Quadruple<ExactReal>& exact_vertex(VertexId vertex) const;

  /// The value of a plane at a point, negative inside, times 2^(1000 scale), between neighbouring doubles.
  Interval height(PlaneId plane, const Point3& point, int scale) const;

  /// Sign of the plane at the vertex: -1 inside, 0 on the plane, +1 outside.
  int side(PlaneId plane, VertexId vertex) const;
  /// Lexicographic order of two points: -1, 0, +1.
  int compare(VertexId a, VertexId b) const;

  /// +1 if three points of a plane run counterclockwise seen from its outside, -1 if clockwise, 0 if collinear.
  int turn(PlaneId plane, VertexId a, VertexId b, VertexId c) const;

 private:
  struct Plane {
    PlaneDefinition definition;
    std::optional<PlaneId> reverse_of;
    Quadruple<Interval> approximate{Interval(0), Interval(0), Interval(0), Interval(0)};
  };
  struct Vertex {
    VertexDefinition definition;
    Quadruple<Interval> approximate{Interval(0), Interval(0), Interval(0), Interval(0)};
  };

  static Interval approximate_height(const Plane& plane, const Quadruple<Interval>& point);
  PlaneId add(const PlaneDefinition& definition);
  VertexId add_input(const InputVertex& input);
  VertexId add_constructed(const VertexDefinition& definition);
  std::uint32_t common_line(VertexId u, VertexId v) const;
  bool is_on_line(VertexId vertex, std::uint32_t line) const;
  bool goes_through(PlaneId plane, VertexId vertex) const;
  Quadruple<ExactReal> constructed(VertexId vertex) const;

  std::vector<Plane> planes_;
  std::vector<Vertex> vertices_;
  std::vector<InputVertex> inputs_;
  mutable std::unordered_map<PlaneId, Quadruple<ExactReal>> exact_planes_;
  mutable std::unordered_map<VertexId, Quadruple<ExactReal>> exact_vertices_;
  mutable std::unordered_map<std::uint64_t, int> exact_sides_;
};

}  // namespace gnomon
