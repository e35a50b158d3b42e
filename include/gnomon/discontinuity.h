#pragma once

/// @file
/// Surfaces in space on which what is seen of a light changes its formula.
///
///     #include <gnomon/discontinuity.h>
///     int main() {
///       using namespace gnomon;
///       const Light lamp = AreaLight{ConvexPolygon::from_points({{0, 0, 4}, {0, 1, 4}, {1, 0, 4}})};
///       const ConvexBlocker board = ConvexPolygon::from_points({{-1, -1, 2}, {2, -1, 2}, {0, 2, 2}});
///       const ConvexPolygon floor = ConvexPolygon::from_points({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}});
///       const auto surfaces = discontinuity_surfaces(lamp, {&board, 1}, {&floor, 1}, {{-9, -9, 0}, {9, 9, 5}});
///       return surfaces.size() == 18 ? 0 : 1;  // each edge of one with each vertex of the other
///     }

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/light.h"
#include "gnomon/names.h"
#include "gnomon/point.h"

namespace gnomon {

/// What an element of an event belongs to.
enum class EventOf : std::uint8_t { light, blocker, receiver };

/// The place of a convex blocker or of a receiver in the list given; 0 for the light. And the index, in one of them, of
/// a vertex or an edge of a polygon, of a solid's point, edge or facet. `number(index)` is the bare number.
enum class EventBody : std::uint32_t {};
enum class EventIndex : std::uint32_t {};

/// A vertex or an edge of the light, of a convex blocker or of a receiver.
struct EventElement {
  EventOf of = EventOf::light;
  EventBody body{};
  EventIndex index{};

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
  triple_edge,     ///< three edges are seen in line, in front of the light or one of them the light's (EEE)
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
                                        "light_plane", "horizon",        "border",         "triple_edge"};
  return names[static_cast<int>(kind)];
}

/// The name of a discontinuity by input elements, and what is known of it.
///
/// `order` is the lowest derivative of the visible fraction that may jump: 0 the value, 1 the slope, 2 the curvature.
/// After: [P93] §4.2.3.2.
struct EventName {
  EventKind kind = EventKind::vertex_edge;
  EventElement vertex;  ///< of coplanar_edges and horizon the element nearer to the light, of triple_edge the first
                        ///< edge; of other kinds as `edge`
  EventElement edge;    ///< of a facet or a flat blocker its index; of horizon an edge, as `vertex`
  std::uint8_t order = 2;
  Extremal extremal = Extremal::none;
  EventElement third{};  ///< of triple_edge the third edge; of other kinds nothing

  friend auto operator<=>(const EventName&, const EventName&) = default;  // NOLINT(modernize-use-nullptr)
};

/// A discontinuity in space: the part of an event's plane on which vertex and edge are in line with visible points of
/// the light.
///
/// Definition: it begins at the element that is farther from the light and ends where the first blocker or receiver
///             stops it, or at the clip box.
struct DiscontinuitySurface {
  EventName name;
  std::vector<std::vector<Point3>> polygons;  ///< convex pieces, not overlapping; rounded to nearest
};

/// All edge-vertex surfaces of a scene of one light, cut by a box. Surfaces that are stopped where they begin, or lie
/// outside the box, are left out; so are pieces so thin that rounding leaves them fewer than three different corners.
///
/// Requires:  flat receivers and a flat area light; a box with an interior.
/// Exactness: which surfaces there are and where they end is exact; coordinates are rounded once.
/// Throws:    PreconditionError.
/// After:     [P93] §4.2.3.2.
std::vector<DiscontinuitySurface> discontinuity_surfaces(const Light& light, std::span<const ConvexBlocker> blockers,
                                                         std::span<const ConvexPolygon> receivers, const Box3& box);

}  // namespace gnomon
