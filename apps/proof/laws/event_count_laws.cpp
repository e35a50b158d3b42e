#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/event_premise.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/spatial_cases.h"

namespace gnomon::laws {
namespace {

/// A corner or a side of the light or the blocker, by the index that events name it by.
struct Element {
  EventOf of;
  std::uint32_t index;
  std::vector<ExactVector> points;
};

struct Shape {
  std::vector<Element> corners;
  std::vector<Element> sides;
};

Shape shape_of(const ConvexPolygon& polygon, EventOf of) {
  Shape shape;
  const auto corners = polygon.corners();
  const auto at = [&](std::size_t k) { return exact(polygon.points()[corners[k % corners.size()]]); };
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    shape.corners.push_back({of, corners[k], {at(k)}});
    shape.sides.push_back({of, polygon.side_edge(k), {at(k), at(k + 1)}});
  }
  return shape;
}

Shape shape_of(const Light& light) {
  if (const auto* area = std::get_if<AreaLight>(&light)) return shape_of(area->polygon, EventOf::light);
  const std::vector<ExactVector> ends = vertices(light);
  return {{{EventOf::light, 0, {ends[0]}}, {EventOf::light, 1, {ends[1]}}}, {{EventOf::light, 0, ends}}};
}

/// A plane by numbers that are the same for the same plane.
using PlaneKey = std::array<Rational, 4>;

PlaneKey key(const ExactPlane& plane) {
  PlaneKey numbers{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
  const Rational lead = *std::ranges::find_if(numbers, [](const Rational& r) { return sign(r) != 0; });
  for (Rational& r : numbers) r /= lead;
  return numbers;
}

/// Who the vertex and the edge of an event are.
using Name = std::tuple<EventOf, std::uint32_t, EventOf, std::uint32_t>;

/// Events by the planes they lie in.
struct Events {
  std::map<PlaneKey, std::set<Name>> by_plane;
  std::set<Name> names;
  Rational least_squared_width = Rational(Integer(1) << 4000);  ///< of the lines from a vertex to its edge

  void add(const Element& vertex, const Element& edge) {
    const ExactPlane plane = plane_through(vertex.points[0], edge.points[0], edge.points[1]);
    if (is_zero(plane.normal)) return;  // the vertex lies on the line of a linear light
    const ExactVector u = edge.points[0] - vertex.points[0], v = edge.points[1] - vertex.points[0];
    const Rational longer = std::max(dot(u, u), dot(v, v));
    least_squared_width = std::min(least_squared_width, Rational(dot(plane.normal, plane.normal) / longer));
    const Name name{vertex.of, vertex.index, edge.of, edge.index};
    by_plane[key(plane)].insert(name);
    names.insert(name);
  }
};

Events events_of(const Shape& light, const Shape& blocker) {
  Events events;
  for (const auto& [corners, sides] : {std::pair{&light.corners, &blocker.sides}, {&blocker.corners, &light.sides}}) {
    for (const Element& corner : *corners) {
      for (const Element& side : *sides) events.add(corner, side);
    }
  }
  return events;
}

bool are_coplanar(const Element& a, const Element& b) {
  return sign(dot(cross(a.points[1] - a.points[0], b.points[0] - a.points[0]), b.points[1] - a.points[0])) == 0;
}

std::size_t coplanar_pairs(const Shape& light, const Shape& blocker) {
  std::size_t pairs = 0;
  for (const Element& side : light.sides) {
    pairs += std::size_t(std::ranges::count_if(blocker.sides, [&](const Element& e) { return are_coplanar(side, e); }));
  }
  return pairs;
}

/// True if events share a plane only as the four of a pair of coplanar edges do.
bool is_general(const Events& events, std::size_t all, std::size_t pairs) {
  const auto shared = std::ranges::count_if(events.by_plane, [](const auto& e) { return e.second.size() > 1; });
  const auto of_pairs = std::ranges::count_if(events.by_plane, [](const auto& e) { return e.second.size() == 4; });
  return events.names.size() == all && shared == of_pairs && of_pairs == std::ptrdiff_t(pairs);
}

/// True unless the surface of some event is so thin, beside its coordinates, that it could round to a line.
bool is_of_one_scale(const Events& events, const Box3& box) {
  Rational largest = 0;
  for (const Point3& p : {box.min, box.max}) {
    for (const double c : {p.x, p.y, p.z}) largest = std::max(largest, Rational(std::abs(c)));
  }
  const Rational least = largest / Rational(Integer(1) << 44);
  return events.least_squared_width >= least * least;
}

Verdict check_counts(const SpatialCase& drawn, const Subject& subject) {
  const Shape light = shape_of(drawn.light), blocker = shape_of(drawn.blocker, EventOf::blocker);
  const Events expected = events_of(light, blocker);
  const std::vector<ConvexBlocker> blockers{drawn.blocker};
  const EventCase box_case{drawn.light, blockers, drawn.blocker.points()[0], {}, {}, {}, {}, 0};
  const Box3 box = box_around(box_case);
  if (!is_of_one_scale(expected, box)) return premise_fails();
  Events found;
  for (const auto& surface : subject.discontinuity_surfaces(drawn.light, blockers, {}, box)) {
    const EventName& name = surface.name;
    const auto vertex = named_points(name.vertex, true, false, drawn.light, blockers);
    const auto edge = named_points(name.edge, false, false, drawn.light, blockers);
    if (name.kind != EventKind::vertex_edge || vertex.empty() || edge.empty()) return verdict(false, "a wrong name");
    // Of a side with vertices inside, the first piece is its line as well.
    found.add({name.vertex.of, number(name.vertex.index), vertex}, {name.edge.of, number(name.edge.index), edge});
  }
  if (found.names.size() != expected.names.size()) {
    return verdict(
        false, std::to_string(found.names.size()) + " surfaces instead of " + std::to_string(expected.names.size()));
  }
  if (found.names != expected.names) return verdict(false, "a surface of other elements");
  const std::size_t n = light.corners.size(), m = blocker.corners.size();
  const std::size_t all = n == 2 ? 3 * m : 2 * n * m, pairs = coplanar_pairs(light, blocker);
  if (!is_general(expected, all, pairs)) return premise_fails();
  return verdict(found.by_plane.size() == all - 3 * pairs,
                 std::to_string(found.by_plane.size()) + " planes instead of " + std::to_string(all - 3 * pairs));
}

rc::Gen<SpatialCase> pairs(Domain domain) {
  return spatial_cases(domain, Lights::with_extent);
}

}  // namespace

std::vector<Law> event_count_laws() {
  return {
      law({"E6", "own",
           "A pair in standard position has n m surfaces of light vertices and n m of light edges, or 2 m and m of a "
           "linear light; the four of each pair of coplanar edges lie in one plane, all others in planes of their "
           "own."},
          pairs, check_counts),
  };
}

}  // namespace gnomon::laws
