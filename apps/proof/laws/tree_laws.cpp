#include <algorithm>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/law_lists.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/visibility_cases.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::laws {
namespace {

/// A small light, blockers, and points: that of the case, and others near vertices, behind them, anywhere.
struct TreeCase {
  VisibilityCase visibility;
  std::vector<Point3> points;
};

std::string description(const TreeCase& drawn) {
  VisibilityCase told = drawn.visibility;
  std::string text;
  for (const Point3& p : drawn.points) {
    told.point = p;
    text = description(told);
  }
  return text;
}

TreeCase draw_tree_case(Domain domain) {
  const int most = once_in(4) ? 12 : 4;
  TreeCase drawn{*visibility_cases(domain, {{LightKind::point, LightKind::direction},
                                            {BlockerKind::polygon, BlockerKind::polygon, BlockerKind::solid},
                                            most}),
                 {}};
  drawn.points.push_back(drawn.visibility.point);
  for (int i = 0; i < 6; ++i) {
    const Point3 p = draw_vector(9);
    const Point3& q = drawn.visibility.point;
    const double third = 1.0 / 3;
    drawn.points.push_back(once_in(2) ? p : Point3{q.x + third * p.x, q.y + third * p.y, q.z + third * p.z});
  }
  return drawn;
}

rc::Gen<TreeCase> tree_cases(Domain domain) {
  return rc::gen::exec([=] { return draw_tree_case(domain); });
}

Verdict check_tree(const TreeCase& drawn, const Subject& subject) {
  const auto found = subject.tree_regions(drawn.visibility.light, drawn.visibility.blockers, drawn.points);
  std::vector<Walls> blockers;
  for (const ConvexBlocker& blocker : drawn.visibility.blockers) blockers.push_back(walls(blocker));
  bool is_any_decided = false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    is_any_decided = true;
    if (*found[i] != region_behind(blockers, drawn.visibility.light, laws::exact(drawn.points[i]))) {
      return verdict(false, "point " + std::to_string(i) + ": another region");
    }
  }
  return is_any_decided ? Verdict{} : premise_fails();
}

}  // namespace

std::vector<Law> tree_laws() {
  return {law({"ST1", "own", "A shadow tree tells of every point off the planes on its path what the definition says."},
              tree_cases, check_tree)};
}

std::vector<Mutant> tree_mutants() {
  const auto mutant = [](const char* name, const char* does, auto broken) {
    Mutant result{name, does, Part::tree_regions, {}, {"ST1"}};
    result.subject.tree_regions = broken;
    return result;
  };
  using Points = std::vector<Point3>;
  using Blockers = std::vector<ConvexBlocker>;
  return {
      mutant("skip_last_in_tree", "the last blocker left out of a shadow tree",
             [](const Light& light, const Blockers& blockers, const Points& points) {
               return tree_regions(light, {blockers.begin(), blockers.end() - 1}, points);
             }),
      mutant("swap_leaves_of_tree", "shadow told before the facets of a leaf, too",
             [](const Light& light, const Blockers& blockers, const Points& points) {
               // As if facets were between the light and every point of their cells: the light seen from far beyond.
               Points far = points;
               for (Point3& p : far) {
                 if (const auto* lamp = std::get_if<PointLight>(&light)) {
                   const Point3& l = lamp->position;
                   p = {l.x + 1024 * (p.x - l.x), l.y + 1024 * (p.y - l.y), l.z + 1024 * (p.z - l.z)};
                 } else {
                   const Point3& d = std::get<DirectionalLight>(light).direction;
                   p = {p.x + 1024 * d.x, p.y + 1024 * d.y, p.z + 1024 * d.z};
                 }
               }
               return tree_regions(light, blockers, far);
             }),
  };
}

}  // namespace gnomon::laws
