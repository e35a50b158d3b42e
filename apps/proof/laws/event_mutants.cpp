#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <utility>

namespace gnomon::laws {
namespace {

using Keys = std::vector<std::string>;
using Surfaces = std::vector<DiscontinuitySurface>;

Mutant surfaces(std::string name, std::string does, Keys caught_by, void (*break_them)(Surfaces&)) {
  Mutant mutant{std::move(name), std::move(does), Part::discontinuity_surfaces, {}, std::move(caught_by)};
  mutant.subject.discontinuity_surfaces = [=, original = mutant.subject.discontinuity_surfaces](
                                              const auto& light, const auto& blockers, const auto& receivers,
                                              const Box3& box) {
    Surfaces found = original(light, blockers, receivers, box);
    break_them(found);
    return found;
  };
  return mutant;
}

Mutant receiver(std::string name, std::string does, Keys caught_by, void (*break_it)(DividedReceiver&)) {
  Mutant mutant{std::move(name), std::move(does), Part::divided_receiver, {}, std::move(caught_by)};
  mutant.subject.divided_receiver = [=](const auto& light, const auto& blockers, const ConvexPolygon& floor) {
    DividedReceiver found = divided_receiver(light, blockers, floor);
    break_it(found);
    return found;
  };
  return mutant;
}

/// Makes one face of all faces of a region.
void merge_faces(DividedReceiver& receiver) {
  for (ReceiverTriangle& triangle : receiver.triangles) {
    const auto first = std::ranges::find(receiver.faces, receiver.faces[triangle.face]);
    triangle.face = static_cast<std::uint32_t>(first - receiver.faces.begin());
  }
}

/// Makes one region of the two beside each edge that lines of sight in the receiver's plane alone have made.
void forget_horizon(DividedReceiver& receiver) {
  for (const MeshEdge& edge : receiver.edges) {
    if (edge.left == MeshEdge::nowhere || edge.right == MeshEdge::nowhere) continue;
    const bool forgotten =
        std::ranges::all_of(edge.names, [&](std::uint32_t n) { return receiver.names[n].kind == EventKind::horizon; });
    if (forgotten) receiver.faces[edge.left] = receiver.faces[edge.right];
  }
}

template <class Change>
void change_beside_arcs(DividedReceiver& receiver, const Change& change) {
  for (const MeshEdge& edge : receiver.edges) {
    const bool is_arc = std::ranges::any_of(
        edge.names, [&](std::uint32_t n) { return receiver.names[n].kind == EventKind::triple_edge; });
    if (is_arc) change(receiver.faces[edge.left], receiver.faces[edge.right]);
  }
}

void forget_arcs(DividedReceiver& receiver) {
  change_beside_arcs(receiver, [](ReceiverRegion& left, ReceiverRegion& right) { left = right; });
}

void exchange_beside_arcs(DividedReceiver& receiver) {
  change_beside_arcs(receiver, [](ReceiverRegion& left, ReceiverRegion& right) { std::swap(left, right); });
}

void light_beside_arcs(DividedReceiver& receiver) {
  change_beside_arcs(receiver, [](ReceiverRegion& left, ReceiverRegion& right) {
    for (ReceiverRegion* region : {&left, &right}) {
      if (*region == ReceiverRegion::penumbra) *region = ReceiverRegion::lit;
    }
  });
}

void exchange(ReceiverRegion& region) {
  if (region == ReceiverRegion::lit) {
    region = ReceiverRegion::penumbra;
  } else if (region == ReceiverRegion::penumbra) {
    region = ReceiverRegion::lit;
  }
}

}  // namespace

std::vector<Mutant> event_mutants() {
  return {
      surfaces("drop_surface", "the last discontinuity surface forgotten", {"E6"},
               [](Surfaces& all) {
                 if (!all.empty()) all.pop_back();
               }),
      surfaces("first_order", "every discontinuity surface said to be of order D1", {"E5", "E2"},
               [](Surfaces& all) {
                 for (DiscontinuitySurface& surface : all) surface.name.order = 1;
               }),
      surfaces("coplanar_unnoticed", "coplanar edges not noticed: orders D0 and D1 raised by one", {"E5", "E3"},
               [](Surfaces& all) {
                 for (DiscontinuitySurface& surface : all) {
                   if (surface.name.order < 2) ++surface.name.order;
                 }
               }),
      surfaces("swap_vertices", "vertices 0 and 1 exchanged in the names of discontinuity surfaces", {"E5", "E2"},
               [](Surfaces& all) {
                 for (DiscontinuitySurface& surface : all) {
                   const std::uint32_t index = number(surface.name.vertex.index);
                   if (index < 2) surface.name.vertex.index = EventIndex{1 - index};
                 }
               }),
      surfaces("neighbour_edge", "a neighbouring edge in the name of the first discontinuity surface", {"E6"},
               [](Surfaces& all) {
                 EventIndex& index = all.front().name.edge.index;
                 index = EventIndex{number(index) == 0 ? 1 : number(index) - 1};
               }),
      receiver("drop_contacts", "contacts of blockers and receivers said to be of order D2", {"E1"},
               [](DividedReceiver& found) {
                 for (EventName& name : found.names) {
                   if (name.kind == EventKind::contact) name.order = 2;
                 }
               }),
      receiver("forget_horizon", "edges of lines of sight in the receiver's plane forgotten", {"M5"}, forget_horizon),
      receiver("merge_faces", "edges between faces of one region forgotten", {"E7"}, merge_faces),
      receiver("swap_light_and_penumbra", "lit and penumbral faces of a receiver exchanged", {"M5"},
               [](DividedReceiver& found) { std::ranges::for_each(found.faces, exchange); }),
      receiver("closing_triple_left_out", "arcs that bound an umbra forgotten", {"T7"}, forget_arcs),
      receiver("closing_is_passing", "umbra and penumbra beside arcs exchanged", {"T7"}, exchange_beside_arcs),
      receiver("arc_ends_light", "penumbra beside an arc said to be lit", {"T7", "T9"}, light_beside_arcs),
      receiver("neighbour_of_three", "a neighbouring edge in the names of arcs", {"T7"},
               [](DividedReceiver& found) {
                 for (EventName& name : found.names) {
                   if (name.kind != EventKind::triple_edge) continue;
                   EventIndex& index = name.third.index;
                   index = EventIndex{number(index) == 0 ? 1 : number(index) - 1};
                 }
               }),
      receiver("arcs_of_first_order", "orders of arcs taken for those of the other kind of light", {"T7"},
               [](DividedReceiver& found) {
                 for (EventName& name : found.names) {
                   if (name.kind == EventKind::triple_edge) name.order = static_cast<std::uint8_t>(3 - name.order);
                 }
               }),
      receiver("shift_boundary", "vertices of a receiver's mesh a little aside", {"M5", "E1"},
               [](DividedReceiver& found) {
                 for (Point3& p : found.vertices) p = {p.x + 0x1p-20, p.y + 0x1p-20, p.z};
               }),
  };
}

}  // namespace gnomon::laws
