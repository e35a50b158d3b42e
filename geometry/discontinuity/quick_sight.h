#pragma once

/// The region of a point by intervals, where these tell. Private to this folder.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/region.h"

namespace gnomon::event {

/// What is known of a point's region.
struct QuickAnswer {
  Region region = Region::lit;
  bool is_certain_of_face = false;  ///< a vertex is seen before the light, or all of it: no triple-edge event ends that
  std::optional<ShapeId> cover{};   ///< umbra: a blocker that hides all of the light
  /// Penumbra: a light vertex that is seen, and one that is hidden, if such are known.
  std::optional<std::array<std::uint32_t, 2>> witness{};
};

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

/// Answers for one receiver, some of the light before its plane.
class QuickSight {
 public:
  QuickSight(const EventScene& scene, const VertexShadows& shadows, std::uint32_t receiver, const LightBefore& light)
      : scene_(scene),
        shadows_(shadows),
        receiver_(scene.receivers[receiver]),
        light_(light),
        known_(scene.shapes.size(), 0) {}

  /// The region of a point of the receiver, given the blockers that may hide something from it; nothing if intervals do
  /// not tell.
  std::optional<QuickAnswer> region(const PointEnclosure& p, std::span<const ShapeId> near);

 private:
  bool is_before_plane(PointId p) const;
  bool hides_nothing(ShapeId shape);
  bool is_beside_light(const Shape& shape, const PointEnclosure& p) const;
  bool is_in_light(PointId v, const PointEnclosure& p, int before) const;
  bool leaves_open(const Shape& shape, const PointEnclosure& p, PointId v) const;
  bool is_on_outline(const Shape& shape, const PointEnclosure& p, PointId v) const;
  bool shows_vertex(const PointEnclosure& p, std::span<const ShapeId> near, int before);
  int side(const PointEnclosure& p, PointId a, PointId b, PointId c) const;

  const EventScene& scene_;
  const VertexShadows& shadows_;
  const Shape& receiver_;
  const LightBefore& light_;
  std::vector<std::int8_t> known_;  ///< of each shape: 0 not yet, 1 may hide something, 2 hides nothing
};

}  // namespace gnomon::event
