#include "apps/proof/laws/law_lists.h"

#include <algorithm>

#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/event_premise.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/receiver_cases.h"
#include "apps/proof/laws/receiver_probe.h"

namespace gnomon::laws {
namespace {

bool is_blocker_point(const ReceiverScene& scene, const ExactVector& p) {
  return std::ranges::any_of(scene.blockers, [&](const Walls& blocker) {
    return std::ranges::all_of(blocker, [&](const ExactPlane& wall) { return wall.side(p) <= 0; });
  });
}

/// A point of the floor in the shadow of a blocker's vertex, as a light's vertex throws it: an event away from
/// contacts.
std::optional<ExactVector> event_point(const ReceiverScene& scene) {
  const std::vector<ExactVector> light = vertices(scene.drawn.light);
  const ConvexBlocker& blocker = scene.drawn.blockers[scene.drawn.choice % scene.drawn.blockers.size()];
  const auto edges = edges_of(blocker);
  const auto& edge = edges[scene.drawn.choice % edges.size()];
  const ExactVector b = edge[0] + Rational(scene.drawn.share) * (edge[1] - edge[0]);
  const ExactVector& l = light[scene.drawn.choice % light.size()];
  const Rational high = scene.floor.height(l), low = scene.floor.height(b);
  if (sign(low) <= 0 || low >= high) return std::nullopt;
  const ExactVector p = l + Rational(high / (high - low)) * (b - l);
  return plane_of(light).side(p) == 0 ? std::nullopt : std::optional(p);
}

bool is_continuous(const ReceiverScene& scene, const ExactVector& p) {
  const Path path = scene.path(p, scene.direction);
  return visible_share_after(scene.drawn.light, scene.blockers, path).value ==
         visible_share_after(scene.drawn.light, scene.blockers, path.reversed()).value;
}

bool is_contact(const EventName& name) {
  return name.kind == EventKind::contact && name.order == 0;
}

Verdict check_contact(const ReceiverCase& drawn, const Subject& subject) {
  const ReceiverScene scene(drawn);
  const auto all = contacts(scene);
  if (all.empty()) return premise_fails();
  const auto& contact = all[drawn.choice % all.size()];
  const ExactVector along = contact[1] - contact[0];
  const ExactVector p = contact[0] + Rational(drawn.share) * along;
  if (is_zero(cross(along, scene.direction)) || !scene.is_on_floor(p) || is_continuous(scene, p)) {
    return premise_fails();
  }
  const auto away = event_point(scene);
  if (away && !is_blocker_point(scene, *away) && !is_continuous(scene, *away)) {
    return verdict(false, "a jump away from all contacts");
  }
  const DividedReceiver mesh = subject.divided_receiver(drawn.light, drawn.blockers, drawn.floor);
  const bool found = std::ranges::any_of(mesh.edges, [&](const MeshEdge& edge) {
    return std::ranges::any_of(edge.names, [&](std::uint32_t n) { return is_contact(mesh.names[n]); }) &&
           may_lie_on(scene, mesh, edge, p);
  });
  return verdict(found, "no edge of order D0 where a blocker touches the receiver");
}

std::vector<VisiblePiece> structure_at(const ReceiverScene& scene, const ExactVector& p) {
  return visible_pieces(std::get<AreaLight>(scene.drawn.light), scene.blockers, scene.path(p, {}));
}

const std::array<std::array<Rational, 3>, 2> triangle_shares = {
    {{Rational(3, 4), Rational(1, 8), Rational(1, 8)}, {Rational(1, 8), Rational(1, 4), Rational(5, 8)}}};

/// Points of one face: of one triangle, and of another if no three edges can be in line.
std::vector<ExactVector> points_of_a_face(const ReceiverScene& scene, const DividedReceiver& mesh) {
  const std::size_t n = mesh.triangles.size(), first = scene.drawn.choice % n;
  std::vector<ExactVector> points;
  for (const auto& share : triangle_shares) {
    if (const auto p = place_in(scene, mesh, mesh.triangles[first], share)) points.push_back(*p);
  }
  if (scene.blockers.size() > 1 || points.empty()) return points;
  for (std::size_t k = 1; k < n; ++k) {
    const ReceiverTriangle& other = mesh.triangles[(first + k) % n];
    if (other.face != mesh.triangles[first].face) continue;
    const auto p = place_in(scene, mesh, other, triangle_shares[0]);
    if (!p) continue;
    points.push_back(*p);
    break;
  }
  return points;
}

Verdict check_faces(const ReceiverCase& drawn, const Subject& subject) {
  const ReceiverScene scene(drawn);
  const DividedReceiver mesh = subject.divided_receiver(drawn.light, drawn.blockers, drawn.floor);
  const std::vector<ExactVector> points = points_of_a_face(scene, mesh);
  if (points.size() < 2) return premise_fails();
  const std::vector<VisiblePiece> structure = structure_at(scene, points[0]);
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (structure_at(scene, points[k]) == structure) continue;
    // Within a triangle the way between the two stays in the face.
    if (sees_three_edges_in_line(scene, points[0], points[k])) return premise_fails();
    return verdict(false, "two points of a face see different arrangements of edges");
  }
  return verdict(true, "");
}

bool is_lit(ReceiverRegion region) {
  return region == ReceiverRegion::lit;
}

bool is_unlit(ReceiverRegion region) {
  return region == ReceiverRegion::unlit;
}

/// Where a line on the floor meets the planes, as shares of its direction, ascending.
std::vector<Rational> meetings(const std::vector<ExactPlane>& planes, const ExactVector& start,
                               const ExactVector& along) {
  std::vector<Rational> places;
  for (const ExactPlane& plane : planes) {
    const Rational rise = dot(plane.normal, along);
    if (sign(rise) != 0) places.push_back(Rational(-plane.height(start) / rise));
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Between two planes next to each other, lit at the start and at the end or neither: where light ends on the line, it
/// does so at a plane.
bool is_same_between(const ReceiverScene& scene, const std::vector<ExactPlane>& planes, const ExactVector& start) {
  const std::vector<Rational> places = meetings(planes, start, scene.direction);
  if (places.size() < 2) return true;
  const std::size_t k = scene.drawn.choice % (places.size() - 1);
  const auto at = [&](std::size_t i) { return start + places[i] * scene.direction; };
  return is_lit_after(scene.drawn.light, scene.blockers, scene.path(at(k), scene.direction)) ==
         is_lit_after(scene.drawn.light, scene.blockers, scene.path(at(k + 1), scene.direction).reversed());
}

/// The planes of the events that a mesh names along an edge; of a contact all facets' of the blocker. A place where a
/// blocker meets the light is no vertex of either: light ends in no plane of it alone.
std::vector<ExactPlane> named_planes(const ReceiverCase& drawn, const DividedReceiver& mesh, const MeshEdge& edge) {
  std::vector<ExactPlane> planes;
  for (const std::uint32_t n : edge.names) {
    const EventName& name = mesh.names[n];
    if (name.kind == EventKind::vertex_edge) {
      const auto vertex = named_points(name.vertex, true, false, drawn.light, drawn.blockers);
      const auto ends = named_points(name.edge, false, false, drawn.light, drawn.blockers);
      if (!vertex.empty() && !ends.empty()) planes.push_back(plane_through(vertex[0], ends[0], ends[1]));
    }
    if (name.kind == EventKind::coplanar_edges || name.kind == EventKind::horizon) {
      const auto ends = named_points(name.edge, false, false, drawn.light, drawn.blockers);
      if (ends.empty()) continue;
      for (const ExactVector& p : named_points(name.vertex, false, false, drawn.light, drawn.blockers)) {
        const ExactVector normal = cross(ends[1] - ends[0], p - ends[0]);
        if (dot(normal, normal) != 0) planes.push_back(plane_through(p, ends[0], ends[1]));
      }
    }
    if (name.kind != EventKind::contact && name.kind != EventKind::coplanar_plane) continue;
    for (const auto& loop : loops_of(drawn.blockers[number(name.edge.body)])) planes.push_back(plane_of(loop));
  }
  return planes;
}

/// Where an edge of the mesh parts light from shadow, a plane of the events that it names passes along it, and light
/// ends there.
Verdict ends_at_a_plane(const ReceiverScene& scene, const DividedReceiver& mesh, const MeshEdge& edge) {
  const ExactVector a = exact(mesh.vertices[edge.source]), b = exact(mesh.vertices[edge.target]);
  const ExactVector middle = a + Rational(scene.drawn.share) * (b - a);
  const Rational length = dot(b - a, b - a);
  if (length <= Rational(1 << 30) * scene.little) return premise_fails();
  // From the left, seen from the front, to the right.
  const ExactVector across{Rational(b.y - a.y), Rational(a.x - b.x), Rational(0)};
  const bool lit_left = is_lit(mesh.faces[edge.left]);
  for (const Rational& place : meetings(named_planes(scene.drawn, mesh, edge), middle, across)) {
    if (place * place * length > Rational(4096) * scene.little * scene.little) continue;
    const Path path = scene.path(middle + place * across, across);
    const bool after = is_lit_after(scene.drawn.light, scene.blockers, path);
    const bool before = is_lit_after(scene.drawn.light, scene.blockers, path.reversed());
    if (before == lit_left && after == !lit_left) return verdict(true, "");
  }
  return verdict(false, "light does not end at a plane of vertex and edge where the mesh says so");
}

/// An edge between light and shadow.
const MeshEdge* boundary_edge(const DividedReceiver& mesh, std::uint32_t choice) {
  std::vector<const MeshEdge*> boundary;
  for (const MeshEdge& edge : mesh.edges) {
    if (edge.left == MeshEdge::nowhere || edge.right == MeshEdge::nowhere) continue;
    const ReceiverRegion left = mesh.faces[edge.left], right = mesh.faces[edge.right];
    if (is_lit(left) != is_lit(right) && !is_unlit(left) && !is_unlit(right)) boundary.push_back(&edge);
  }
  return boundary.empty() ? nullptr : boundary[choice % boundary.size()];
}

Verdict check_boundary(const ReceiverCase& drawn, const Subject& subject) {
  const ReceiverScene scene(drawn);
  const DividedReceiver mesh = subject.divided_receiver(drawn.light, drawn.blockers, drawn.floor);
  const ReceiverTriangle& triangle = mesh.triangles[drawn.choice % mesh.triangles.size()];
  const auto p = place_in(scene, mesh, triangle, triangle_shares[0]);
  const ReceiverRegion region = mesh.faces[triangle.face];
  if (p && !is_unlit(region)) {
    const bool lit = is_lit_after(drawn.light, scene.blockers, scene.path(*p, scene.direction));
    if (lit != is_lit(region)) return verdict(false, "light and shadow confused");
    // One case in eight looks for places where light ends and nothing is drawn; it takes all planes there are.
    if (drawn.choice % 8 == 0 && !is_same_between(scene, event_planes(scene), *p)) {
      return verdict(false, "light ends away from all planes");
    }
  }
  const MeshEdge* edge = boundary_edge(mesh, drawn.choice);
  return edge ? ends_at_a_plane(scene, mesh, *edge) : premise_fails();
}

rc::Gen<ReceiverCase> standing_blockers(Domain domain) {
  return receiver_cases(domain, 2, Stands::on_floor);
}

rc::Gen<ReceiverCase> one_or_two_blockers(Domain domain) {
  return receiver_cases(domain, 2);
}

rc::Gen<ReceiverCase> some_blockers(Domain domain) {
  return receiver_cases(domain, 3);
}

}  // namespace

std::vector<Law> receiver_laws() {
  return {
      law({"M5", "Demouth et al. 2009",
           "On a plane, light and shadow of many convex blockers meet along segments: in planes of a vertex and an "
           "edge of the light and one blocker, or of a blocker's facet."},
          some_blockers, check_boundary),
      law({"E1", "[P93] 4.2.3.2",
           "Where a blocker touches a receiver and its two sides hide different measures of an area light, the order "
           "is D0; away from contacts and the light's plane there is none."},
          standing_blockers, check_contact),
      law({"E7", "own",
           "In a face between all traces of vertices and edges in line, of planes of coplanar edges and facets, of the "
           "light's plane and of lines of sight in the receiver's, which no three edges in line cross, one arrangement "
           "of edges is seen."},
          one_or_two_blockers, check_faces),
  };
}

}  // namespace gnomon::laws
