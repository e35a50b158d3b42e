#pragma once

#include <cstdint>
#include <string_view>

namespace gnomon {

/// What an element of an event belongs to.
enum class EventOf : std::uint8_t { light, blocker, receiver };

/// A vertex or an edge of the light, of a convex blocker or of a receiver, by its place in the list given.
struct EventElement {
  EventOf of = EventOf::light;
  std::uint32_t element = 0;  ///< index of the blocker or receiver; 0 for the light
  std::uint32_t index = 0;    ///< of a vertex or an edge of a polygon; of a solid's point, edge or facet

  friend auto operator<=>(const EventElement&, const EventElement&) = default;  // NOLINT(modernize-use-nullptr)
};

/// What happens along a discontinuity.
enum class EventKind : std::uint8_t {
  vertex_edge,     ///< an edge and a vertex are seen in line, in front of the light (EV); light edges among them
  coplanar_edges,  ///< two edges in one plane are seen in line, in front of the light; light edges among them
  coplanar_plane,  ///< a flat blocker, or a facet of a solid, is seen from its side in front of the light
  contact,         ///< a blocker touches the receiver or passes through it
  light_plane,     ///< the light shows its edge
  horizon,         ///< seen along the receiver's plane, two elements that meet it are in line with the light
  border,          ///< the receiver ends
};

/// What an event bounds, as far as light and one blocker decide it.
enum class Extremal : std::uint8_t {
  none,
  occlusion,  ///< the boundary of occlusion: the plane separates light and blocker
  umbra,      ///< the boundary of umbra: the plane supports both, along a blocker's edge
};

constexpr std::string_view name(Extremal extremal) {
  constexpr std::string_view names[] = {"none", "occlusion", "umbra"};
  return names[static_cast<int>(extremal)];
}

constexpr std::string_view name(EventKind kind) {
  constexpr std::string_view names[] = {"vertex_edge", "coplanar_edges", "coplanar_plane", "contact",
                                        "light_plane", "horizon",        "border"};
  return names[static_cast<int>(kind)];
}

/// The name of a discontinuity by input elements, and what is known of it.
///
/// `order` is the lowest derivative of the visible fraction that may jump: 0 the value, 1 the slope, 2 the curvature.
/// After: [P93] §4.2.3.2.
struct EventName {
  EventKind kind = EventKind::vertex_edge;
  EventElement vertex;  ///< of coplanar_edges and horizon the element nearer to the light; of other kinds as `edge`
  EventElement edge;    ///< of a facet or a flat blocker its index; of horizon an edge, as `vertex`
  std::uint8_t order = 2;
  Extremal extremal = Extremal::none;

  friend auto operator<=>(const EventName&, const EventName&) = default;  // NOLINT(modernize-use-nullptr)
};

}  // namespace gnomon
