#pragma once

/// Wedges: the lines through a vertex and an edge that come from the light, beyond the farther of the two. Private to
/// this folder.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"

namespace gnomon::event {

/// Which way light passes the apex and the edge.
enum class WedgeKind : std::uint8_t {
  from_light_vertex,  ///< from the apex, a vertex of the light, past a blocker's edge
  from_light_edge,    ///< from the edge, one of the light, past the apex, a blocker's vertex
  edge_first,         ///< past a blocker's edge, then past the apex, a blocker's vertex
  apex_first,         ///< past the apex, a blocker's vertex, then past a blocker's edge
  from_light_place,   ///< from the apex, where a blocker's edge meets the light: a and b only bound the lines
};

/// True of lines that begin at the apex, on the light.
constexpr bool is_from_light_at_apex(WedgeKind kind) {
  return kind == WedgeKind::from_light_vertex || kind == WedgeKind::from_light_place;
}

/// The edge of a coplanar pair that is nearer to the light, by its ends.
struct FarEdge {
  PointId a = 0;
  PointId b = 0;
  bool is_on_light = false;
  EventElement name;
};

/// A vertex and an edge in line; or, of a coplanar pair, both edges and a place in their plane.
struct Wedge {
  WedgeKind kind = WedgeKind::from_light_vertex;
  PointId apex = 0;
  PointId a = 0;
  PointId b = 0;
  std::uint32_t vertex = 0;              ///< index among the light's or the blockers' vertices
  std::uint32_t edge = 0;                ///< index among the light's or the blockers' edges
  std::optional<std::uint32_t> facet{};  ///< of a facet whose plane cuts the light: then the wedge lies in that plane
  std::optional<FarEdge> far{};          ///< of a coplanar pair: only lines that meet it beyond the edge count
};

/// How many sources wedges have: edges, facets and vertices, each with the wedges that are found from it.
std::size_t wedge_source_count(const EventScene& scene);

/// Calls `take` with every wedge of a source that may reach the light and something beyond, and with some others.
///
/// Cost:  for a blocker's vertex two searches with the pyramid between it and the light; see coplanar_pairs.h.
/// After: `scene` is as before; points are added for the time of a call only.
void for_each_wedge(EventScene& scene, std::size_t source, const std::function<void(const Wedge&)>& take);

/// The same with the wedges of all sources, one after the other.
void for_each_wedge(EventScene& scene, const std::function<void(const Wedge&)>& take);

/// The event's name, its order and whether it is extremal.
EventName event_name(const EventScene& scene, const Wedge& wedge);

/// A part of a receiver's plane along which a wedge meets it: a segment, by homogeneous coordinates of its ends.
struct Trace {
  std::uint32_t receiver = 0;
  std::uint32_t name = 0;
  std::array<Quadruple<ExactReal>, 2> ends;
};

/// Traces wedges on receivers.
///
/// Definition: the trace holds every point of the receiver from which vertex and edge are in line with a point of the
///             light, in the right order, strictly before the receiver's plane, and no blocker is in between: none has
///             a point of its (relative) inside on the open segment, or all of a neighbourhood would be. What touches
///             the segment only does not stop it.
/// Exactness:  exact.
class WedgeTracer {
 public:
  explicit WedgeTracer(const EventScene& scene) : scene_(scene) {}

  /// Appends the traces of positive length, with `name` 0.
  void append_traces(const Wedge& wedge, std::vector<Trace>& traces);

  /// A shape's section with the half of the lines on which receivers are.
  struct Obstacle {
    ShapeId shape = 0;
    std::vector<NodeId> polygon;
    RayRange range;
  };

  /// Finds what look_along is about: the lines that come from the light, what blockers and receivers they meet, and on
  /// which half. Returns: false if no line comes through.
  bool look_along(Pencil& pencil, const Wedge& wedge);
  const std::vector<RayRange>& allowed() const { return allowed_; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }

 private:
  using Nodes = std::vector<NodeId>;

  bool begin(Pencil& pencil, const Wedge& wedge);
  bool is_between_faces(const Pencil& pencil, const Wedge& wedge) const;
  void set_half_spaces(const Wedge& wedge);
  Nodes light_section(Pencil& pencil) const;
  bool passes_through_apex(const Pencil& pencil, const Nodes& segment) const;
  bool is_before_light(Pencil& pencil, const Wedge& wedge, const Shape& shape, Nodes& nodes);
  bool keep_far(Pencil& pencil, const Wedge& wedge);
  bool find_allowed(Pencil& pencil, const Wedge& wedge);
  bool subtract_towards_light(Pencil& pencil, const Wedge& wedge, Cone cone);
  bool collect_obstacles(Pencil& pencil, const Wedge& wedge, Cone cone);
  void trace_on(Pencil& pencil, const Wedge& wedge, Cone cone, std::uint32_t receiver, std::vector<Trace>& traces);
  bool receiver_range(Pencil& pencil, const Wedge& wedge, Cone cone, const Shape& receiver, RayRange& range);
  void append_blocked(Pencil& pencil, const Shape& receiver, FunctionId plane, const RayRange& range, Cone cone);
  FunctionId light_function(Pencil& pencil, const Wedge& wedge);

  const EventScene& scene_;
  std::vector<RayRange> allowed_;
  std::vector<RayRange> blocked_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> found_receivers_;
  std::array<RoughHalfSpace, 5>
      half_spaces_;  ///< both sides of the plane, both of the cone, the edge's side of the apex
  std::optional<FunctionId> light_function_;
};

/// The half of a wedge's lines beyond the farther element, where receivers are.
constexpr Cone receivers_cone(WedgeKind kind) {
  return is_from_light_at_apex(kind) || kind == WedgeKind::apex_first ? Cone::towards : Cone::away;
}

}  // namespace gnomon::event
