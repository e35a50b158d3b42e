#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <array>

#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/planar/partition_data.h"

namespace gnomon::laws {
namespace {

using planar::BoundaryKind;
using planar::BoundaryName;
using planar::EventPoint;
using planar::EventPointKind;
using planar::Partition;

Region region_with(const Rational& f) {
  return f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
}

/// The visible fractions of the case's point: behind all blockers, and behind each.
struct Fractions {
  Rational together;
  std::vector<Rational> alone;

  Fractions(const FlatlandCase& drawn, const ExactVector& p)
      : together(visible_fraction(drawn.light, drawn.blockers, p)) {
    for (const auto& blocker : drawn.blockers) alone.push_back(visible_fraction(drawn.light, blocker, p));
  }
  explicit Fractions(const FlatlandCase& drawn) : Fractions(drawn, exact(drawn.point)) {}

  std::size_t count(Region region) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(alone, [&](const Rational& f) { return region_with(f) == region; }));
  }
};

/// What the subject says of the case's point.
Verdict check_point(const FlatlandCase& drawn, const Subject& subject, const Rational& f) {
  const planar::VisibleLight seen = subject.planar_visible_light(drawn.flatland(), drawn.point);
  if (seen.region != region_with(f)) return verdict(false, "the point's region differs");
  if (drawn.light.size() == 1) return {};
  const auto parts = visible_parts(drawn.light, drawn.blockers, exact(drawn.point));
  return verdict(seen.intervals.size() == parts.size(), "another number of visible intervals");
}

Verdict check_umbra_grows(const FlatlandCase& drawn, const Subject& subject) {
  const Fractions f(drawn);
  if (f.count(Region::umbra) == 0) return premise_fails();
  if (f.together != 0) return verdict(false, "f > 0 in the umbra of a blocker");
  return check_point(drawn, subject, f.together);
}

Verdict check_penumbra_shrinks(const FlatlandCase& drawn, const Subject& subject) {
  const Fractions f(drawn);
  if (region_with(f.together) != Region::penumbra) return premise_fails();
  if (f.count(Region::penumbra) == 0) return verdict(false, "in the penumbra of no blocker");
  return check_point(drawn, subject, f.together);
}

Verdict check_shadow_is_union(const FlatlandCase& drawn, const Subject& subject) {
  const Fractions f(drawn);
  const bool in_some = f.count(Region::lit) < f.alone.size();
  if (in_some != (f.together < 1)) return verdict(false, "f < 1 elsewhere");
  return check_point(drawn, subject, f.together);
}

Verdict check_umbra_of_pairs(const FlatlandCase& drawn, const Subject& subject) {
  const Fractions f(drawn);
  if (f.together != 0) return premise_fails();
  const bool explained = f.count(Region::umbra) > 0 || f.count(Region::penumbra) > 1;
  if (!explained) return verdict(false, "dark, but in no umbra and in fewer than two penumbrae");
  return check_point(drawn, subject, f.together);
}

/// The points of Q5: ends of the light and of the blockers, and where a blocker crosses the light.
std::vector<ExactVector> event_points(const FlatlandCase& drawn) {
  std::vector<ExactVector> points;
  for (const Point2& p : drawn.light) points.push_back(exact(p));
  const ExactVector l = exact(drawn.light.front()), d = exact(drawn.light.back()) - l;
  for (const auto& [a, b] : drawn.blockers) {
    points.push_back(exact(a));
    points.push_back(exact(b));
    const ExactVector edge = exact(b) - exact(a);
    const Rational parallel = cross(d, edge).z;
    if (parallel == 0) continue;
    const Rational t = cross(exact(a) - l, edge).z / parallel, s = cross(exact(a) - l, d).z / parallel;
    if (t >= 0 && t <= 1 && s >= 0 && s <= 1) points.push_back(l + t * d);
  }
  return points;
}

/// Where the segment from p to q crosses a line, as a share of the way.
void add_crossing(const ExactVector& p, const ExactVector& q, const ExactVector& a, const ExactVector& b,
                  std::vector<Rational>& shares) {
  const Rational parallel = cross(q - p, b - a).z;
  if (parallel == 0) return;
  const Rational share = cross(a - p, b - a).z / parallel;
  if (share > 0 && share < 1) shares.push_back(share);
}

/// Q5 as it stands, along a segment: between two of its crossings with the lines named the region is one.
bool changes_on_lines_only(const FlatlandCase& drawn, const ExactVector& p, const ExactVector& q) {
  std::vector<Rational> shares{0, 1};
  const std::vector<ExactVector> points = event_points(drawn);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (points[i] != points[j]) add_crossing(p, q, points[i], points[j], shares);
    }
  }
  std::ranges::sort(shares);
  for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
    const Rational step = shares[k + 1] - shares[k];
    const auto region_at = [&](const Rational& share) {
      return region_with(
          visible_fraction(drawn.light, drawn.blockers, p + Rational(shares[k] + share * step) * (q - p)));
    };
    if (step != 0 && region_at(Rational(1, 100)) != region_at(Rational(99, 100))) return false;
  }
  return true;
}

ExactVector named_point(const FlatlandCase& drawn, const EventPoint& name) {
  if (name.kind == EventPointKind::light_end) return exact(drawn.light.at(name.end));
  const auto& [a, b] = drawn.blockers.at(name.element);
  if (name.kind == EventPointKind::blocker_end) return exact(name.end == 0 ? a : b);
  const ExactVector l = exact(drawn.light.front()), d = exact(drawn.light.back()) - l, edge = exact(b) - exact(a);
  return l + Rational(cross(exact(a) - l, edge).z / cross(d, edge).z) * d;
}

/// Two points of the line that an edge of the partition names.
std::array<ExactVector, 2> named_line(const FlatlandCase& drawn, const BoundaryName& name) {
  if (name.kind == BoundaryKind::light_line) return {exact(drawn.light.front()), exact(drawn.light.back())};
  if (name.kind == BoundaryKind::event) return {named_point(drawn, name.near), named_point(drawn, name.far)};
  const auto& [a, b] = drawn.blockers.at(name.element);
  return {exact(a), exact(b)};
}

/// The partition's vertices lie on the lines that its edges name.
bool edges_keep_their_names(const FlatlandCase& drawn, const Partition& partition) {
  return std::ranges::all_of(partition.edges(), [&](const planar::PartitionEdge& edge) {
    const auto line = named_line(drawn, partition.names()[edge.name]);
    if (line[0] == line[1]) return false;
    return std::ranges::all_of(std::array{edge.source, edge.target}, [&](std::uint32_t end) {
      if (end == planar::nowhere) return true;
      const planar::ExactPoint& p = partition.data().exact_vertices[end];
      return side_of(line[0], line[1], {p.x, p.y, 0}) == 0;
    });
  });
}

Verdict check_boundaries(const FlatlandCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point), q = exact(drawn.blockers.front()[0]) + ExactVector{3, 7, 0};
  if (!changes_on_lines_only(drawn, p, q)) return verdict(false, "the region changes off the lines");
  const Partition partition = subject.planar_partition(drawn.flatland());
  return verdict(edges_keep_their_names(drawn, partition), "an edge is off the line it names");
}

/// The end that the first two blockers share, with their other ends.
struct Joint {
  ExactVector at;
  std::array<ExactVector, 2> ends;
};

std::optional<Joint> first_joint(const FlatlandCase& drawn) {
  if (drawn.blockers.size() < 2) return std::nullopt;
  for (const std::size_t i : {0U, 1U}) {
    for (const std::size_t j : {0U, 1U}) {
      if (drawn.blockers[0][i] != drawn.blockers[1][j]) continue;
      return Joint{exact(drawn.blockers[0][i]), {exact(drawn.blockers[0][1 - i]), exact(drawn.blockers[1][1 - j])}};
    }
  }
  return std::nullopt;
}

/// Q6, behind the joint on the line from the light's middle, at the latest so near that nothing else matters.
Verdict check_joint(const FlatlandCase& drawn, const Subject& subject) {
  const std::optional<Joint> joint = first_joint(drawn);
  if (!joint || drawn.light.size() == 1) return premise_fails();
  if (side_of(exact(drawn.light[0]), exact(drawn.light[1]), joint->at) == 0) return premise_fails();
  for (const Point2& l : drawn.light) {
    const int first = side_of(exact(l), joint->at, joint->ends[0]),
              second = side_of(exact(l), joint->at, joint->ends[1]);
    if (first * second >= 0 || first != side_of(exact(drawn.light.front()), joint->at, joint->ends[0])) {
      return premise_fails();
    }
  }
  const std::array both{drawn.blockers[0], drawn.blockers[1]};
  const ExactVector middle = Rational(1, 2) * (exact(drawn.light.front()) + exact(drawn.light.back()));
  Rational step = 1;
  for (int halvings = 0; halvings < 300; ++halvings) {
    const ExactVector p = joint->at + step * (joint->at - middle);
    step /= 2;
    if (visible_fraction(drawn.light, both, p) != 0) continue;
    const bool neither = visible_fraction(drawn.light, both[0], p) > 0 && visible_fraction(drawn.light, both[1], p) > 0;
    if (!neither) continue;
    return check_point(drawn, subject, visible_fraction(drawn.light, drawn.blockers, exact(drawn.point)));
  }
  return verdict(false, "light behind the joint");
}

auto cases(Layout layout, int most) {
  return [=](Domain domain) { return flatland_cases(domain, layout, most); };
}

}  // namespace

std::vector<Law> flatland_laws() {
  return {
      law({"Q1", "[P93] 4.2.2.2", "The umbra of all blockers contains the umbra of each."}, cases(Layout::any, 6),
          check_umbra_grows),
      law({"Q2", "[P93] 4.2.2.2", "The penumbra of all blockers lies in the union of their penumbrae."},
          cases(Layout::any, 6), check_penumbra_shrinks),
      law({"Q3", "[P93] 4.2.2.2", "The shadow of all blockers is the union of their shadows."}, cases(Layout::any, 6),
          check_shadow_is_union),
      law({"Q4", "[P93] 4.2.2.2",
           "The umbra of all blockers lies in the union of their umbrae and of the common parts of two penumbrae."},
          cases(Layout::any, 6), check_umbra_of_pairs),
      law({"Q5", "own",
           "Every boundary of a region lies on a line through two points, each an end of the light or of a blocker or "
           "where a blocker crosses the light, or on a blocker, or on the light's line."},
          cases(Layout::any, 3), check_boundaries),
      law({"Q6", "own",
           "Behind a joint of two blockers that lie on opposite sides of it as seen from the light, off the light's "
           "line, "
           "f = 0 near the joint although neither alone hides the light."},
          cases(Layout::joint, 2), check_joint),
  };
}

}  // namespace gnomon::laws
