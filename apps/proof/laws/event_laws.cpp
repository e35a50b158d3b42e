#include "apps/proof/laws/law_lists.h"

#include <algorithm>

#include "apps/proof/laws/event_cases.h"
#include "apps/proof/laws/event_premise.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/visibility_along_path.h"

namespace gnomon::laws {
namespace {

using enum OnLine;

std::string told(std::optional<int> order) {
  return order ? "D" + std::to_string(*order) : "no discontinuity up to the second derivative";
}

/// The order that the definition gives the path across the event.
Verdict has_order(const EventScene& scene, int expected) {
  const auto order = order_at_start(scene.near_light, scene.blockers, scene.path);
  return verdict(order == expected, "expected D" + std::to_string(expected) + ", but there is " + told(order));
}

/// What the subject says of the event of a vertex and an edge.
Verdict is_named(const EventCase& drawn, const Subject& subject, int order) {
  const auto surfaces = subject.discontinuity_surfaces(drawn.light, drawn.blockers, {}, box_around(drawn));
  for (const DiscontinuitySurface& surface : surfaces) {
    if (names_event(surface.name, drawn)) {
      return verdict(surface.name.order == order, "said to be of order D" + std::to_string(surface.name.order));
    }
  }
  return verdict(false, "no surface has this vertex and edge");
}

/// What the subject says of the plane of coplanar elements.
Verdict is_named_in_plane(const EventScene& scene, const Subject& subject, int order) {
  const EventCase& drawn = scene.drawn;
  const auto surfaces = subject.discontinuity_surfaces(drawn.light, drawn.blockers, {}, box_around(drawn));
  const bool found = std::ranges::any_of(surfaces, [&](const DiscontinuitySurface& surface) {
    return surface.name.order == order && lies_in_plane(surface.name, drawn, scene.plane);
  });
  return verdict(found, "no surface in this plane has the order D" + std::to_string(order));
}

Verdict both(const Verdict& first, const Verdict& second) {
  return first.kind == Verdict::Kind::holds ? second : first;
}

/// The subject makes all surfaces for one answer: it is asked in one case of four.
bool is_asked(const EventCase& drawn) {
  return drawn.choice == 0;
}

Verdict check_vertex_and_edge(const EventCase& drawn, const Subject& subject) {
  const EventScene scene(drawn);
  if (!is_seen_alone(scene) || !is_simple_vertex_edge(scene)) return premise_fails();
  const Verdict found = has_order(scene, 2);
  return is_asked(drawn) ? both(found, is_named(drawn, subject, 2)) : found;
}

Verdict check_coplanar(const EventCase& drawn, const Subject& subject) {
  const EventScene scene(drawn);
  if (!is_seen_alone(scene) || !is_simple_plane(scene)) return premise_fails();
  const Verdict found = has_order(scene, 1);
  return is_asked(drawn) ? both(found, is_named_in_plane(scene, subject, 1)) : found;
}

/// What the subject says of a point beside the event, on one side or the other.
Verdict sees_as_defined(const EventScene& scene, const Subject& subject) {
  const int side = scene.drawn.choice % 2 == 0 ? 1 : -1;
  const Point3 p = rounded(scene.path.start + Rational(side, 64) * scene.path.direction);
  const Jet seen = visible_share_after(scene.drawn.light, scene.blockers, {exact(p), {}});
  const Visibility told = subject.visibility(scene.drawn.light, {scene.drawn.blockers, {}}, p);
  return verdict(abs(Rational(told.fraction) - seen.value) <= Rational(told.error_bound),
                 "another share of the light is said to be seen beside the event");
}

Verdict check_three_edges(const EventCase& drawn, const Subject& subject) {
  const EventScene scene(drawn);
  if (!is_seen_alone(scene) || !is_simple_triple(scene)) return premise_fails();
  if (!is_quadratic(scene)) return verdict(false, "the event is not part of a quadric");
  return both(has_order(scene, 2), sees_as_defined(scene, subject));
}

Verdict check_linear_light(const EventCase& drawn, const Subject& subject) {
  const EventScene scene(drawn);
  if (!is_seen_alone(scene)) return premise_fails();
  if (drawn.elements.size() == 3) {
    return is_simple_triple(scene) ? both(has_order(scene, 1), sees_as_defined(scene, subject)) : premise_fails();
  }
  if (std::ranges::none_of(drawn.elements, [](const auto& e) { return e.what == vertex; })) {
    return is_simple_plane(scene) ? both(has_order(scene, 0), is_named_in_plane(scene, subject, 0)) : premise_fails();
  }
  return is_simple_vertex_edge(scene) ? both(has_order(scene, 1), is_named(drawn, subject, 1)) : premise_fails();
}

rc::Gen<EventCase> vertices_and_edges(Domain domain) {
  return event_cases(domain, EventLight::area,
                     {{{edge}, vertex}, {{vertex}, edge}, {{edge, vertex}, inside}, {{vertex, edge}, inside}});
}

rc::Gen<EventCase> coplanar_events(Domain domain) {
  return event_cases(domain, EventLight::area,
                     {{{edge}, edge, true}, {{edge, edge}, inside, true}, {{facet}, inside, true}});
}

rc::Gen<EventCase> three_edges(Domain domain) {
  return event_cases(domain, EventLight::area, {{{edge, edge}, edge}, {{edge, edge, edge}, inside}});
}

rc::Gen<EventCase> linear_events(Domain domain) {
  return event_cases(domain, EventLight::linear,
                     {{{edge}, vertex}, {{vertex}, edge}, {{edge, edge}, edge}, {{edge}, edge, true}});
}

}  // namespace

std::vector<Law> event_laws() {
  return {
      law({"E2", "[P93] 4.2.3.2",
           "Before an area light, the event of a vertex and an edge in line, no edge at the vertex being coplanar with "
           "the edge as seen, is of order D2: so is f of the part of the light next to the line of sight."},
          vertices_and_edges, check_vertex_and_edge),
      law({"E3", "own",
           "Before an area light, the order is D1 where two edges are coplanar and overlap as seen, of light and "
           "blocker or of two blockers, and in the plane of a flat blocker or facet that meets the light."},
          coplanar_events, check_coplanar),
      law({"E4", "[P93] 4.2.3.2",
           "An event of a light edge and two blocker edges, or of three blocker edges before the light, is part of a "
           "quadric and of order D2."},
          three_edges, check_three_edges),
      law({"E5", "own",
           "A linear light has D1 at events of a vertex and an edge and of three edges, and D0 where a blocker edge is "
           "coplanar with it."},
          linear_events, check_linear_light),
  };
}

}  // namespace gnomon::laws
