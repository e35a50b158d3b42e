#include <algorithm>
#include <array>
#include <optional>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/event_premise.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/law_lists.h"
#include "apps/proof/laws/receiver_cases.h"
#include "apps/proof/laws/receiver_probe.h"
#include "apps/proof/laws/triple_edge_cases.h"
#include "geometry/bodies/polygon_checks.h"

namespace gnomon::laws {
namespace {

ExactVector on(const Segment& s, const Rational& share) {
  return s[0] + share * (s[1] - s[0]);
}

Rational volume(const ExactVector& p, const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return dot(cross(a - p, b - p), c - p);
}

/// D: zero where p sees the lines of three edges in one line.
Rational determinant(const ExactVector& p, const std::array<Segment, 3>& edges) {
  std::array<ExactVector, 3> normals;
  for (std::size_t k = 0; k < 3; ++k) normals[k] = cross(edges[k][0] - p, edges[k][1] - p);
  return dot(cross(normals[0], normals[1]), normals[2]);
}

/// The values of D at start, start + step, ... of a walk.
template <std::size_t count>
std::array<Rational, count> values(const TripleCase& drawn) {
  std::array<Rational, count> found;
  for (std::size_t k = 0; k < count; ++k) {
    found[k] = determinant(drawn.start + Rational(static_cast<int>(k)) * drawn.step, drawn.edges);
  }
  return found;
}

Verdict check_degree(const TripleCase& drawn, const Subject&) {
  const auto d = values<4>(drawn);
  return verdict(Rational(d[0] - 3 * d[1] + 3 * d[2] - d[3]) == 0, "D is not quadratic along a line");
}

Verdict check_base(const TripleCase& drawn, const Subject&) {
  const auto& [base, j, k] = drawn.edges;
  const auto at = [&](const Segment& edge, const ExactVector& l) { return volume(drawn.start, edge[0], edge[1], l); };
  const Rational parted = at(j, base[0]) * at(k, base[1]) - at(k, base[0]) * at(j, base[1]);
  return verdict(determinant(drawn.start, drawn.edges) == parted, "D is not A_j B_k - A_k B_j");
}

/// The point at that height that sees three edges in line at a share of the first one; nothing at infinity.
std::optional<ExactVector> point_in_line(const std::array<Segment, 3>& edges, const Rational& t, const Rational& z) {
  const ExactVector l = on(edges[0], t);
  // The traces of two planes, as functions of (1, x, y).
  const auto trace = [&](const Segment& edge) {
    const ExactVector n = cross(edge[0] - l, edge[1] - l);
    return ExactVector{Rational(n.z * z - dot(n, l)), n.x, n.y};
  };
  const ExactVector p = cross(trace(edges[1]), trace(edges[2]));
  if (p.x == 0) return std::nullopt;
  return ExactVector{Rational(p.y / p.x), Rational(p.z / p.x), z};
}

Verdict check_point(const TripleCase& drawn, const Subject&) {
  const auto p = point_in_line(drawn.edges, drawn.share, 0);
  if (!p) return premise_fails();
  const ExactVector l = on(drawn.edges[0], drawn.share);
  const bool in_line = volume(*p, l, drawn.edges[1][0], drawn.edges[1][1]) == 0 &&
                       volume(*p, l, drawn.edges[2][0], drawn.edges[2][1]) == 0;
  return verdict(in_line && determinant(*p, drawn.edges) == 0, "p(t) does not see the edges in line at l(t)");
}

Verdict check_meeting(const TripleCase& drawn, const Subject&) {
  const auto& [base, j, k] = drawn.edges;
  const auto p = point_in_line(drawn.edges, drawn.share, 0);
  const ExactVector l = on(base, drawn.share);
  const Rational u = volume(l, k[0], k[1], j[0]), w = volume(l, k[0], k[1], j[1]);
  if (!p || u == w || is_zero(*p - l)) return premise_fails();
  const ExactVector met = on(j, Rational(u / (u - w)));
  return verdict(is_zero(cross(*p - l, met - l)), "the line does not meet the edge at u / (u - w)");
}

Verdict check_level(const TripleCase& drawn, const Subject&) {
  TripleCase level = drawn;
  for (Segment& edge : level.edges) edge[1].z = edge[0].z;
  const auto d = values<3>(level);
  return verdict(Rational(d[0] - 2 * d[1] + d[2]) == 0, "of level edges D is not linear on a level floor");
}

/// Two of the edges made to cross in a point, or to be parallel.
Verdict check_crossing(const TripleCase& drawn, const Subject&) {
  TripleCase bent = drawn;
  auto& [i, j, k] = bent.edges;
  const ExactVector meeting = on(i, drawn.share);
  j[1] = j[0] + 2 * (meeting - j[0]);
  const Rational of_plane = volume(drawn.start, i[0], i[1], j[0]);
  if (is_zero(cross(i[1] - i[0], j[1] - j[0])) || volume(drawn.start, meeting, k[0], k[1]) == 0) {
    return premise_fails();
  }
  // D over the two factors is the same everywhere.
  const auto quotient = [&](const ExactVector& p) -> std::optional<Rational> {
    const Rational factors = volume(p, i[0], i[1], j[0]) * volume(p, meeting, k[0], k[1]);
    if (factors == 0) return std::nullopt;
    return Rational(determinant(p, bent.edges) / factors);
  };
  const auto here = quotient(drawn.start), there = quotient(drawn.start + drawn.step);
  if (of_plane == 0 || !here || !there) return premise_fails();
  return verdict(*here == *there, "D is not the product of two planes");
}

/// Of four edges through one point of what is seen, each with one open side.
Verdict check_four(const TripleCase& drawn, const Subject&) {
  std::array<ExactVector, 4> open;
  const ExactVector* ways[] = {&drawn.step, &drawn.edges[0][0], &drawn.edges[1][0], &drawn.edges[2][0]};
  for (std::size_t k = 0; k < 4; ++k) open[k] = {ways[k]->x, ways[k]->y, Rational(0)};
  const auto turn = [&](std::size_t a, std::size_t b) { return sign(Rational(cross(open[a], open[b]).z)); };
  int closing = 0;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    std::array<std::size_t, 3> three{};
    for (std::size_t k = 0, n = 0; k < 4; ++k) {
      if (k != left_out) three[n++] = k;
    }
    const int turns[] = {turn(three[0], three[1]), turn(three[1], three[2]), turn(three[2], three[0])};
    if (std::ranges::find(turns, 0) != std::end(turns)) return premise_fails();
    closing += turns[0] == turns[1] && turns[1] == turns[2] ? 1 : 0;
  }
  return verdict(closing == 0 || closing == 2, "of four edges in line, one, three or four triples close");
}

bool is_of_three(const DividedReceiver& mesh, const MeshEdge& edge) {
  return std::ranges::any_of(edge.names, [&](std::uint32_t n) { return mesh.names[n].kind == EventKind::triple_edge; });
}

/// A boundary that three edges make, the name, and an exact point of it.
struct Closing {
  const MeshEdge* edge = nullptr;
  const EventName* name = nullptr;
  std::array<Segment, 3> edges;
  ExactVector near;                  ///< a point of the mesh's line
  std::optional<ExactVector> point;  ///< one that sees the three edges in line, next to it
  ExactVector across;                ///< from right to left, seen from the front
};

/// The share of an edge at which the plane through p and another one meets it.
std::optional<Rational> share_met(const Segment& edge, const ExactVector& p, const Segment& other) {
  const Rational a = volume(p, other[0], other[1], edge[0]), b = volume(p, other[0], other[1], edge[1]);
  if (a == b) return std::nullopt;
  return Rational(a / (a - b));
}

std::optional<Closing> closing_of(const ReceiverScene& scene, const DividedReceiver& mesh) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    if (is_of_three(mesh, mesh.edges[e])) all.push_back(e);
  }
  if (all.empty()) return std::nullopt;
  const std::uint32_t e = all[scene.drawn.choice % all.size()];
  Closing found;
  found.edge = &mesh.edges[e];
  for (const std::uint32_t n : found.edge->names) {
    if (mesh.names[n].kind == EventKind::triple_edge) found.name = &mesh.names[n];
  }
  const ExactVector a = laws::exact(mesh.vertices[found.edge->source]),
                    b = laws::exact(mesh.vertices[found.edge->target]);
  const ExactVector way = b - a;  // half way along, an arc runs along its chord
  if (is_zero(way)) return std::nullopt;
  found.near = Rational(1, 2) * (a + b);
  if (found.edge->arc != MeshEdge::nowhere) {
    const MeshArc& arc = mesh.arcs[found.edge->arc];
    const Rational w(arc.weight);
    found.near = Rational(1 / (2 + 2 * w)) * (a + Rational(2 * w) * laws::exact(arc.points[1]) + b);
  }
  found.across = {Rational(-way.y), way.x, Rational(0)};
  std::array<Segment, 3>& edges = found.edges;
  const EventElement* elements[] = {&found.name->vertex, &found.name->edge, &found.name->third};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto ends = named_points(*elements[i], false, false, scene.drawn.light, scene.drawn.blockers);
    edges[i] = {ends[0], ends[1]};
  }
  if (const auto t = share_met(edges[0], found.near, edges[1])) {
    // Nearly that share: a point that is exactly one of the arc, and short numbers.
    const Rational share(t->convert_to<double>());
    const auto p = point_in_line(edges, share, found.near.z);
    // Where two of the planes are nearly one, it may be anywhere along the arc.
    const auto is_near = [&](const ExactVector& q) { return 64 * dot(q - found.near, q - found.near) < dot(way, way); };
    if (p && share > 0 && share < 1 && is_near(*p)) found.point = p;
  }
  return found;
}

/// Whether the mesh's line passes where the edges are in line, up to rounding.
bool is_where_named(const ReceiverScene& scene, const Closing& closing) {
  // The way across is no longer than its coordinates' sum.
  const ExactVector& across = closing.across;
  const Rational step = Rational(1 << 20) * scene.little / (abs(across.x) + abs(across.y));
  const int left = sign(determinant(closing.near + step * across, closing.edges));
  const int right = sign(determinant(closing.near - step * across, closing.edges));
  return left * right <= 0;
}

/// What a receiver's side of an arc sees next to it.
bool agrees(const Jet& seen, ReceiverRegion region) {
  const bool nothing = seen == Jet{};
  return nothing == (region == ReceiverRegion::umbra) && (seen.value == 1) == (region == ReceiverRegion::lit);
}

/// The order in which a gap that is closed at the start of a path grows.
int order_of(const Jet& gap) {
  return gap.value != 0 ? 0 : gap.slope != 0 ? 1 : 2;
}

Verdict check_closing(const ReceiverCase& drawn, const Subject& subject) {
  const ReceiverScene scene(drawn);
  const DividedReceiver mesh = subject.divided_receiver(drawn.light, drawn.blockers, drawn.floor);
  const auto closing = closing_of(scene, mesh);
  if (!closing) return premise_fails();
  if (!is_where_named(scene, *closing)) return verdict(false, "an arc lies where its three edges are not in line");
  if (!closing->point) return premise_fails();
  const auto seen = [&](const Path& path) { return visible_share_after(drawn.light, scene.blockers, path); };
  const Path path = scene.path(*closing->point, closing->across);
  const Jet left = seen(path), right = seen(path.reversed()), nothing;
  const MeshEdge& edge = *closing->edge;
  if (!agrees(left, mesh.faces[edge.left]) || !agrees(right, mesh.faces[edge.right])) {
    return verdict(false, "beside an arc a face has another region");
  }
  if ((left == nothing) == (right == nothing)) return verdict(false, "no gap closes at an arc");
  if (seen(scene.path(*closing->point, {})) != nothing) return verdict(false, "something is seen from the arc itself");
  // What else happens along it may do so in a lower order.
  const auto is_triple = [&](std::uint32_t n) { return mesh.names[n].kind == EventKind::triple_edge; };
  if (!std::ranges::all_of(edge.names, is_triple)) return {};
  const int expected = std::holds_alternative<LinearLight>(drawn.light) ? 1 : 2;
  const bool is_order = order_of(left == nothing ? right : left) == expected && closing->name->order == expected;
  return verdict(is_order, "the gap's measure grows in another order");
}

bool parts_lit(const DividedReceiver& mesh, const MeshEdge& edge) {
  if (edge.left == MeshEdge::nowhere || edge.right == MeshEdge::nowhere) return false;
  return (mesh.faces[edge.left] == ReceiverRegion::lit) != (mesh.faces[edge.right] == ReceiverRegion::lit);
}

Verdict check_lit(const ReceiverCase& drawn, const Subject& subject) {
  const DividedReceiver mesh = subject.divided_receiver(drawn.light, drawn.blockers, drawn.floor);
  bool is_of_any = false;
  for (const MeshEdge& edge : mesh.edges) {
    is_of_any = is_of_any || is_of_three(mesh, edge);
    const auto is_triple = [&](std::uint32_t n) { return mesh.names[n].kind == EventKind::triple_edge; };
    if (parts_lit(mesh, edge) && std::ranges::all_of(edge.names, is_triple)) {
      return verdict(false, "light ends where nothing but three edges are in line");
    }
  }
  return is_of_any ? Verdict{} : premise_fails();
}

}  // namespace

std::vector<Law> triple_edge_laws() {
  const std::string own = "own";
  return {
      law({"T1", own,
           "The points that see three lines in one line lie on a quadric: the determinant D of the normals of the "
           "planes "
           "through a point and each of them is quadratic along every line."},
          triple_cases, check_degree),
      law({"T2", own,
           "With one edge as base, D = A_j B_k - A_k B_j: A and B are the sides of both ends of the base of the planes "
           "through the point and the other edges."},
          triple_cases, check_base),
      law({"T3", own,
           "Where the traces of the planes through a point l(t) of the base and each of two other edges cross, all "
           "three "
           "are seen in line; on a receiver an arc lies where its three edges are."},
          triple_cases, check_point),
      law({"T4", own,
           "The line through l(t) and p(t) meets edge j at the share u / (u - w), u and w the sides of its ends of the "
           "plane through l(t) and edge k."},
          triple_cases, check_meeting),
      law({"T5", own, "If all three edges are parallel to a plane, D is linear on it: the arc is straight."},
          triple_cases, check_level),
      law({"T6", own,
           "If two of the edges cross, D is the product of the planes of these two, and of their common point and the "
           "third edge, times a constant."},
          triple_cases, check_crossing),
      law({"T7", own,
           "An arc that bounds an umbra lies where its three edges are in line; on it and on one side nothing is seen "
           "of "
           "the light, on the other a gap whose measure begins with the square of the way under an area light, with "
           "the "
           "way under a linear light."},
          joint_cases, check_closing),
      law({"T8", own, "Of four edges in line none of the four triples closes a gap, or exactly two."}, triple_cases,
          check_four),
      law({"T9", "Demouth et al. 2009", "Light never ends where three edges alone are in line."}, joint_cases,
          check_lit),
  };
}

}  // namespace gnomon::laws
