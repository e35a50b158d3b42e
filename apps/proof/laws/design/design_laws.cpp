#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/law_lists.h"
#include "apps/proof/laws/point_text.h"
#include "apps/proof/laws/visibility_cases.h"
#include "apps/proof/laws/visibility_definition.h"
#include "geometry/bodies/body.h"

namespace gnomon::laws {
namespace {

DesignObstacles obstacles_of(const std::vector<ConvexBlocker>& blockers) {
  DesignObstacles obstacles{{blockers, {}}, {}, {}};
  for (std::size_t k = 0; k < blockers.size(); ++k) obstacles.parts.push_back("b" + std::to_string(k));
  obstacles.elements = obstacles.parts;
  return obstacles;
}

/// The case as a design of one goal, in which the variable's value is that of the light or blocker as drawn.
Design design_of(const VisibilityCase& drawn, FreeVariable variable, Want want) {
  Design design;
  design.variable = variable;
  design.light = drawn.light;
  design.blocker = "b0";
  DesignGoal goal;
  goal.name = "goal";
  goal.want = want;
  goal.subjects = {{{drawn.point}, {}}};
  goal.light = drawn.light;
  if (variable == FreeVariable::blocker) goal.by = "b0";
  design.goals = {goal};
  return design;
}

Point3 value_as_drawn(const VisibilityCase& drawn, FreeVariable variable) {
  if (variable == FreeVariable::position) return std::get<PointLight>(drawn.light).position;
  if (variable == FreeVariable::scale) return {1, 0, 0};
  if (variable != FreeVariable::direction) return {0, 0, 0};
  const Point3& d = std::get<DirectionalLight>(drawn.light).direction;
  return {-d.x, -d.y, -d.z};
}

/// A wall seen edge-on hides nothing that has a measure; such shifts have no neighbours that are as good.
bool is_edge_on(const VisibilityCase& drawn) {
  for (const ConvexBlocker& blocker : drawn.blockers) {
    for (const ExactPlane& wall : walls(blocker)) {
      if (blocker.index() == 0 && wall.side(exact(drawn.point)) == 0) return true;
    }
  }
  return false;
}

/// The design says of the light as it stands what the definition says.
template <FreeVariable variable>
Verdict check_place(const VisibilityCase& drawn, const Subject& subject) {
  if (variable == FreeVariable::blocker && is_edge_on(drawn)) return premise_fails();
  std::vector<Walls> blockers;
  for (const ConvexBlocker& blocker : drawn.blockers) {
    blockers.push_back(walls(blocker));
    if (variable == FreeVariable::blocker) break;
  }
  const Region region = region_behind(blockers, drawn.light, exact(drawn.point));
  bool is_any_decided = false;
  for (const auto& [want, wanted] : {std::pair(Want::dark, Region::umbra), {Want::lit, Region::lit}}) {
    const auto found = subject.design_place(design_of(drawn, variable, want), obstacles_of(drawn.blockers),
                                            value_as_drawn(drawn, variable));
    if (!found) continue;
    is_any_decided = true;
    if (*found != (region == wanted)) {
      return verdict(false, std::string(name(want)) + (*found ? " where it is " : " nowhere about where it is ") +
                                std::string(name(region)));
    }
  }
  return is_any_decided ? Verdict{} : premise_fails();
}

rc::Gen<VisibilityCase> cases_of(Domain domain, std::vector<LightKind> lights, int most_blockers) {
  return visibility_cases(
      domain, {std::move(lights), {BlockerKind::polygon, BlockerKind::polygon, BlockerKind::solid}, most_blockers});
}

rc::Gen<VisibilityCase> point_cases(Domain domain) {
  return cases_of(domain, {LightKind::point}, 3);
}
rc::Gen<VisibilityCase> direction_cases(Domain domain) {
  return cases_of(domain, {LightKind::direction}, 3);
}
rc::Gen<VisibilityCase> single_cases(Domain domain) {
  return cases_of(domain, {LightKind::segment, LightKind::polygon}, 1);
}
rc::Gen<VisibilityCase> joint_cases(Domain domain) {
  return cases_of(domain, {LightKind::segment, LightKind::polygon}, 2);
}
rc::Gen<VisibilityCase> any_light_cases(Domain domain) {
  return cases_of(domain, {LightKind::point, LightKind::direction, LightKind::segment, LightKind::polygon}, 1);
}

/// Two points that want the shadows of two vertices.
struct NailCase {
  std::array<Point3, 2> subjects;
  std::array<Point3, 2> vertices;
  Point3 third;
};

std::string description(const NailCase& drawn) {
  std::ostringstream text;
  text << std::setprecision(17);
  write(text, "shadow points", drawn.subjects);
  write(text, "vertices", drawn.vertices);
  write(text, "third vertex", std::array{drawn.third});
  return text.str();
}

Point3 along(const Point3& p, const Point3& d, int t) {
  return {p.x - t * d.x, p.y - t * d.y, p.z - t * d.z};
}

/// Most nails are made to meet somewhere; near degeneracy one of them then misses by little.
NailCase draw_nails(Domain domain) {
  NailCase drawn;
  const Point3 meet = draw_vector(4);
  for (std::size_t k = 0; k < 2; ++k) {
    const Point3 d = draw_vector(3);
    const int t = draw(-1, 3);
    drawn.subjects[k] = along(meet, d, t);
    drawn.vertices[k] = along(meet, d, t - 1);
    if (once_in(6)) drawn.subjects[k] = draw_vector(4);
  }
  drawn.third = draw_vector(5);
  if (domain == Domain::near_degenerate && once_in(2)) {
    drawn.vertices[0].x = std::nextafter(drawn.vertices[0].x, once_in(2) ? 9 : -9);
  }
  return drawn;
}

rc::Gen<NailCase> nail_cases(Domain domain) {
  return rc::gen::exec([=] { return draw_nails(domain); });
}

/// Where the two rays beyond the vertices meet, in closed form; nothing if they do not, or lie on one line.
std::optional<ExactVector> meeting_of_nails(const NailCase& drawn, bool before_too) {
  const ExactVector q1 = exact(drawn.subjects[0]), q2 = exact(drawn.subjects[1]), w = q2 - q1;
  const ExactVector u1 = exact(drawn.vertices[0]) - q1, u2 = exact(drawn.vertices[1]) - q2, n = cross(u1, u2);
  const Rational square = dot(n, n);
  if (square == 0 || dot(w, n) != 0) return std::nullopt;
  const Rational t1 = dot(cross(w, u2), n) / square, t2 = dot(cross(w, u1), n) / square;
  if (!before_too && (t1 <= 1 || t2 <= 1)) return std::nullopt;
  return q1 + t1 * u1;
}

/// True if the nails are two rays that lie on no common line, and their blocker is a triangle.
bool are_nails(const NailCase& drawn) {
  const auto [a, b] = drawn.vertices;
  if (ConvexPolygon::defect(std::vector{a, b, drawn.third})) return false;
  const ExactVector q1 = exact(drawn.subjects[0]), q2 = exact(drawn.subjects[1]);
  const ExactVector u1 = exact(a) - q1, u2 = exact(b) - q2;
  if (is_zero(u1) || is_zero(u2)) return false;
  return !(is_zero(cross(u1, u2)) && is_zero(cross(u1, q2 - q1)));
}

DesignResult nailed(const NailCase& drawn, const Subject& subject) {
  Design design;
  for (std::uint32_t k = 0; k < 2; ++k) {
    DesignGoal goal;
    goal.name = "nail" + std::to_string(k);
    goal.want = Want::nail;
    goal.subjects = {{{drawn.subjects[k]}, {}}};
    goal.by = "b0";
    goal.element = k;
    design.goals.push_back(goal);
  }
  const std::vector<ConvexBlocker> blockers = {
      ConvexPolygon::from_points({drawn.vertices[0], drawn.vertices[1], drawn.third})};
  return subject.solved_design(design, obstacles_of(blockers), {});
}

/// True if the subject finds the meeting, or that there is none.
bool agrees(const NailCase& drawn, const Subject& subject) {
  const DesignResult result = nailed(drawn, subject);
  const auto meeting = meeting_of_nails(drawn, false);
  if (!meeting) return result.status == DesignStatus::infeasible;
  if (!result.answer) return false;
  const auto& [x, y, z] = result.answer->exact;
  return Rational(x.exact) == meeting->x && Rational(y.exact) == meeting->y && Rational(z.exact) == meeting->z;
}

Verdict check_nails(const NailCase& drawn, const Subject& subject) {
  if (!are_nails(drawn)) return premise_fails();
  return verdict(agrees(drawn, subject), "the nails meet elsewhere, or only one says that they do");
}

/// "The lines of two shadow points and their blocker points intersect at a unique point": premise, that they lie in one
/// plane, as lines that are said to meet do.
Verdict check_unique_meeting(const NailCase& drawn, const Subject& subject) {
  if (!are_nails(drawn)) return premise_fails();
  const ExactVector w = exact(drawn.subjects[1]) - exact(drawn.subjects[0]);
  const ExactVector u1 = exact(drawn.vertices[0]) - exact(drawn.subjects[0]);
  const ExactVector u2 = exact(drawn.vertices[1]) - exact(drawn.subjects[1]);
  if (dot(w, cross(u1, u2)) != 0) return premise_fails();
  if (!agrees(drawn, subject)) return verdict(false, "the subject contradicts the closed form");
  if (meeting_of_nails(drawn, false)) return {};
  return refutes("the lines lie in one plane, and no light beyond both vertices is on both");
}

}  // namespace

std::vector<Law> design_laws() {
  return {
      law({"D1", "own, [P93] 5.2.3",
           "A point light darkens a point exactly in the point's dark cones; outside of all the point is lit."},
          point_cases, check_place<FreeVariable::position>),
      law({"D4", "own", "So does a directional light by its direction."}, direction_cases,
          check_place<FreeVariable::direction>),
      law({"D6", "own",
           "A moved light darkens a point while all its corners lie in the dark cone, and lights it outside a sum of "
           "two convex sets."},
          single_cases, check_place<FreeVariable::translation>),
      law({"D7", "own",
           "Behind several blockers a moved light darkens a point exactly while it reaches into no cell that the point "
           "sees."},
          joint_cases, check_place<FreeVariable::translation>),
      law({"D8", "own", "A scaled light darkens a point in an interval of scales, and reaches into its shadow in one."},
          single_cases, check_place<FreeVariable::scale>),
      law({"D9", "own",
           "A moved blocker hides a light from a point while it meets every segment to a corner, and nothing outside a "
           "sum of convex sets."},
          any_light_cases, check_place<FreeVariable::blocker>),
      law({"D10", "own",
           "Two nails meet in the point of a closed form, if they lie in one plane and it lies beyond both vertices."},
          nail_cases, check_nails),
  };
}

std::vector<Law> design_claims() {
  const std::vector<NailCase> known = {{{{{0, 0, 0}, {4, 0, 0}}}, {{{0, 0, 1}, {5, 0, 1}}}, {1, 2, 1}},
                                       {{{{0, 0, 0}, {4, 0, 0}}}, {{{0, 0, 1}, {4, 0, 1}}}, {1, 2, 1}}};
  return {refuted_claim(
      {"X4", "[P93] 5.2.3",
       "Two shadow points and their blocker points determine a light: their lines intersect at a unique point."},
      known, nail_cases, check_unique_meeting)};
}

std::vector<Mutant> design_mutants() {
  const auto mutant = [](const char* name, const char* does, std::vector<std::string> caught_by, auto broken) {
    Mutant result{name, does, Part::design_place, {}, std::move(caught_by)};
    result.subject.design_place = broken;
    return result;
  };
  const auto with_first_corner = [](const Light& light) -> Light {
    const std::vector<Point3> corners = gnomon::light_points(light);
    return corners.empty() ? light : Light(PointLight{corners[0]});
  };
  Mutant nails{"nails_from_half_way", "a nail that begins half way to its vertex", Part::solved_design, {}, {"D10"}};
  nails.subject.solved_design = [](const Design& design, const DesignObstacles& obstacles, const DesignEffort& effort) {
    const auto points = std::get<ConvexPolygon>(obstacles.obstacles.blockers[0]).points();
    std::vector<Point3> moved(points.begin(), points.end());
    for (std::size_t k = 0; k < 2; ++k) {
      const Point3& q = design.goals[k].subjects[0].points[0];
      moved[k] = {(q.x + points[k].x) / 2, (q.y + points[k].y) / 2, (q.z + points[k].z) / 2};
    }
    if (ConvexPolygon::defect(moved)) return solved_design(design, obstacles, effort);
    return solved_design(design, obstacles_of({ConvexPolygon::from_points(moved)}), effort);
  };
  return {
      mutant("skip_last_dark_cone", "the last blocker's dark cone left out", {"D1", "D4", "D6", "D7"},
             [](const Design& design, const DesignObstacles& obstacles, const Point3& position) {
               DesignObstacles fewer = obstacles;
               fewer.obstacles.blockers.pop_back();
               fewer.parts.pop_back();
               fewer.elements.pop_back();
               return design_place(design, fewer, position);
             }),
      mutant("cone_without_its_start", "a dark cone that begins at the point, not behind the blocker", {"D1"},
             [](const Design& design, const DesignObstacles& obstacles, const Point3& p) {
               const Point3& q = design.goals[0].subjects[0].points[0];
               return design_place(design, obstacles,
                                   {q.x + 1024 * (p.x - q.x), q.y + 1024 * (p.y - q.y), q.z + 1024 * (p.z - q.z)});
             }),
      mutant("first_corner_for_all", "one corner of a moved, scaled or shaded light taken for all",
             {"D6", "D7", "D8", "D9"},
             [=](const Design& design, const DesignObstacles& obstacles, const Point3& position) {
               Design smaller = design;
               smaller.goals[0].light = with_first_corner(design.goals[0].light);
               const Light corner = with_first_corner(design.light);
               if (design.variable != FreeVariable::blocker) smaller.light = corner;
               return design_place(smaller, obstacles, position);
             }),
      nails,
  };
}

}  // namespace gnomon::laws
