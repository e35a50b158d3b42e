#pragma once

/// What single vertices of the light would leave dark. Private to this folder.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// For every light vertex and blocker the half-spaces of the shadow that the vertex alone would throw.
///
/// Requires: the rounding mode is protected while any member runs.
class VertexShadows {
 public:
  explicit VertexShadows(const EventScene& scene);

  enum class Answer { hidden, seen, unknown };
  /// Whether a shape hides a light vertex from a point. Exactness: intervals; unknown where they do not tell.
  Answer ask(std::uint32_t light_vertex, ShapeId shape, const PointEnclosure& p) const;

  /// False if nothing is known, because the light vertex lies in the plane of a face of the shape.
  bool knows(std::uint32_t light_vertex, ShapeId shape) const { return range(light_vertex, shape).count > 0; }

  /// True if the closed shadow holds a point near `near`; exact: the point itself is asked for only if need be.
  bool holds(std::uint32_t light_vertex, ShapeId shape, const PointEnclosure& near,
             const std::function<ExactVector()>& exact_point) const;

 private:
  /// A side of a shadow: positive inside, the plane of three points.
  struct Side {
    std::array<Interval, 3> normal{Interval(0), Interval(0), Interval(0)};
    Point3 origin;
    std::array<PointId, 3> points{};
    int sign = 1;
  };
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0: nothing is known
  };

  const Range& range(std::uint32_t light_vertex, ShapeId shape) const {
    return ranges_[light_vertex * scene_.shapes.size() + shape];
  }
  void add(PointId light, const Shape& shape);
  bool add_side(const std::array<PointId, 3>& points, PointId inside, const Shape& shape);
  Interval value(const Side& side, const PointEnclosure& p) const;

  const EventScene& scene_;
  std::vector<Side> sides_;
  std::vector<Range> ranges_;  ///< light vertex by light vertex
};

}  // namespace gnomon::event
