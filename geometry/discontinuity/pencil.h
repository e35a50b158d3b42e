#pragma once

/// The plane of an apex and an edge, and the lines through the apex that meet the edge. Private to this folder.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_point.h"

namespace gnomon::event {

/// Index of a point in the scene's list.
using PointId = std::uint32_t;

/// A point of the pencil's plane, in coordinates (x, y, z) with respect to apex, a and b, up to a positive factor:
/// x v + y a + z b. So y and z tell on which line through the apex it lies, and x = 0 on the edge's line.
struct Node {
  enum class Kind : std::uint8_t {
    point,     ///< scene point `first`
    crossing,  ///< where the edge from scene point `first`, above the plane, to `second`, below it, passes through
    cut,       ///< where the line from node `first` to node `second` meets the zero line of function `function`
  };
  Kind kind = Kind::point;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::uint32_t function = 0;
  Interval x = 0;
  Interval y = 0;
  Interval z = 0;
};

using NodeId = std::uint32_t;
using FunctionId = std::uint32_t;

/// A half of the lines of the pencil.
enum class Cone : std::int8_t {
  towards = 1,  ///< from the apex towards the edge
  away = -1,    ///< from the apex, the other way
};

/// A line of the pencil: through the apex and a node in the cone.
struct Ray {
  NodeId node = 0;
  Cone cone = Cone::towards;
};

/// A closed set of lines, from `first` to `last` as one turns from a to b.
struct RayRange {
  Ray first;
  Ray last;
};

/// A pencil of lines, and what is met by its plane.
///
/// Requires:  the rounding mode is protected while any member runs.
/// Exactness: every sign is exact: by intervals where they tell, else by exact arithmetic.
class Pencil {
 public:
  /// Functions on the plane that always exist: the coordinates.
  static constexpr FunctionId x = 0, y = 1, z = 2;
  /// Nodes that always exist: the ends of the edge.
  static constexpr NodeId end_a = 0, end_b = 1;

  Pencil(std::span<const EventPoint> points, PointId apex, PointId a, PointId b);

  /// False if apex, a and b lie on one line.
  bool is_plane() const { return axis_ < 3; }

  /// Side of the plane on which a point lies.
  int side(PointId point) const;

  /// The function whose value at a point of the plane is that of the bracket with three points, times `sign`.
  FunctionId add_plane(const std::array<PointId, 3>& plane, int sign);

  NodeId add_point(PointId point);
  /// Requires: `above` on the positive side, `below` on the negative one.
  NodeId add_crossing(PointId above, PointId below);

  /// Sign of a function at a node.
  int sign(FunctionId function, NodeId node) const;

  /// Cuts a convex polygon (a segment, a point) by the half-plane where the function times `sense` is not negative.
  /// Returns: false if nothing of it lies strictly inside.
  bool clip(std::vector<NodeId>& polygon, FunctionId function, int sense);

  /// Keeps what lies in the cone. Returns: false if nothing of it lies inside.
  bool clip_to(std::vector<NodeId>& polygon, Cone cone) {
    const int sense = static_cast<int>(cone);
    return clip(polygon, y, sense) && clip(polygon, z, sense);
  }

  /// The lines that meet a polygon in the cone; nothing if it is one line or none.
  std::optional<RayRange> range(std::span<const NodeId> polygon, Cone cone) const;

  /// +1 if the second line comes after the first as one turns from a to b, 0 if they are the same.
  int order(const Ray& first, const Ray& second) const;

  bool is_apex(NodeId node) const { return sign(y, node) == 0 && sign(z, node) == 0; }

  const Node& node(NodeId id) const { return nodes_[id]; }
  const std::array<ExactReal, 3>& exact(NodeId id) const;
  const std::array<ExactReal, 3>& exact_function(FunctionId id) const;
  PointId apex() const { return ids_[0]; }
  PointId a() const { return ids_[1]; }
  PointId b() const { return ids_[2]; }

 private:
  struct Function {
    std::array<PointId, 3> plane{};
    int sign = 1;
    std::array<Interval, 3> values{Interval(0), Interval(0), Interval(0)};
  };
  template <class Number>
  std::array<Number, 3> point_coordinates(PointId point) const;
  template <class Number>
  std::array<Number, 3> crossing_coordinates(PointId above, PointId below) const;
  std::array<ExactReal, 3> exact_coordinates(const Node& node) const;
  std::array<ExactReal, 3> exact_values(FunctionId id) const;
  NodeId add(const Node& node);
  bool is_known_zero(const Function& function, const Node& node) const;
  void choose_axis();

  std::span<const EventPoint> points_;
  std::array<PointId, 3> ids_;
  std::uint32_t axis_ = 3;  ///< the axis along which the plane is looked at; 3: there is none
  int axis_sign_ = 1;
  std::array<Interval, 3> normal_{Interval(0), Interval(0), Interval(0)};
  std::vector<Node> nodes_;
  std::vector<Function> functions_;
  // What was asked for exactly before. A map keeps its elements in place.
  mutable std::map<NodeId, std::array<ExactReal, 3>> exact_nodes_;
  mutable std::map<FunctionId, std::array<ExactReal, 3>> exact_functions_;
};

}  // namespace gnomon::event
