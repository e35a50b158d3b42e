#include "shading/inverse/outcome.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/rounding.h"
#include "shading/inverse/brightness.h"
#include "shading/inverse/forward.h"
#include "shading/inverse/highlight.h"
#include "shading/inverse/lengths.h"

namespace gnomon::inverse {
namespace {

/// A signed square of a distance, and the plane from which it is one.
struct Slack {
  Rational square = 0;  ///< below 0 for a distance below 0
  std::optional<CellPlane> plane;

  bool operator<(const Slack& other) const { return square < other.square; }
};

/// Measures distances of one point from planes.
class SlackMeter {
 public:
  SlackMeter(const DesignSpace& space, const Cell& domain, CornerId point)
      : space_(space), extent_(space.cells, domain), point_(space.cells.corner(point)) {
    if (point_[3] == 0) length_ = dot(normal_of(point_), normal_of(point_));
  }

  /// Positive where the point lies on the side that `sign` says: -1 within, 1 beyond. Nothing for planes that the
  /// domain does not cross.
  std::optional<Slack> of(CellPlane plane, int sign) const {
    const Whole& numbers = space_.cells.plane(plane);
    const ExactVector normal = normal_of(numbers);
    const bool is_direction = point_[3] == 0;
    const Rational along = is_direction ? Rational(dot(normal, normal) * length_) : extent_.squared(normal);
    if (along == 0) return std::nullopt;
    Rational height(value(numbers, point_));
    if (!is_direction) height /= Rational(point_[3]);
    const Rational square = height * height / along;
    return Slack{(height < 0) == (sign < 0) ? square : Rational(-square), plane};
  }

  /// How far inside a set: the distance from the nearest plane.
  std::optional<Slack> inside(const std::vector<Wall>& walls) const {
    std::optional<Slack> least;
    for (const Wall& wall : walls) take_less(least, of(wall.plane, -1));
    return least;
  }

  /// How far outside: the distance from the farthest plane, which is not more than that from the set.
  std::optional<Slack> outside(const ConvexSet& set) const {
    std::optional<Slack> most;
    for (const Wall& wall : set.walls) take_more(most, of(wall.plane, 1));
    return most;
  }

  std::optional<Slack> of(const GoalSets& goal) const {
    std::optional<Slack> least = inside(goal.within);
    for (const auto& sets : goal.any) {
      std::optional<Slack> most;
      for (const ConvexSet& set : sets) take_more(most, inside(set.walls));
      take_less(least, most);
    }
    for (const ConvexSet& set : goal.none) take_less(least, outside(set));
    for (const CellPlane plane : goal.on) {
      std::optional<Slack> off = of(plane, -1);
      if (off && off->square > 0) off->square = -off->square;
      take_less(least, off);
    }
    return least;
  }

 private:
  static void take_less(std::optional<Slack>& least, const std::optional<Slack>& other) {
    if (other && (!least || *other < *least)) least = other;
  }
  static void take_more(std::optional<Slack>& most, const std::optional<Slack>& other) {
    if (other && (!most || *most < *other)) most = other;
  }

  const DesignSpace& space_;
  Extent extent_;
  Whole point_;
  Rational length_ = 1;
};

/// The region that all subjects have; `penumbra` where they differ.
std::optional<Region> region_of(const Design& design, const DesignGoal& goal, const DesignObstacles& obstacles,
                                const Point3& position) {
  const Light light = placed_light(design, goal, position);
  const Obstacles standing = placed_obstacles(design, goal, obstacles, position);
  std::optional<Region> all;
  for (const DesignSubject& subject : goal.subjects) {
    const auto region = forward_region(light, subject, standing);
    if (!region) return std::nullopt;
    all = !all || *all == *region ? region : Region::penumbra;
  }
  return all;
}

bool is_asked_of_visibility(Want want) {
  return want == Want::lit || want == Want::shadow || want == Want::dark || want == Want::penumbra ||
         want == Want::not_seen_from || want == Want::irradiance;
}

/// The irradiance of the darkest corner, in the scene's units.
BoundedNumber darkest_irradiance(const Design& design, const DesignGoal& goal, const ExactVector& position) {
  double least = HUGE_VAL;
  for (const BrightPoint& point : bright_points(goal)) least = std::fmin(least, unit_irradiance(point, position));
  return {least * design.intensity, least * design.intensity * 0x1p-49};
}

/// What brightness and highlights say of themselves.
void add_shading(const Design& design, const DesignGoal& goal, const Point3& position, GoalOutcome& outcome) {
  if (goal.want == Want::irradiance) {
    outcome.irradiance = darkest_irradiance(design, goal, exact(position));
    const auto is_bright = [&](const BrightPoint& point) { return is_bright_enough(point, exact(position)); };
    outcome.satisfied = outcome.satisfied && std::ranges::all_of(bright_points(goal), is_bright);
  }
  if (goal.want != Want::highlight || !goal.contour) return;
  const ExactVector q = exact(*goal.contour);
  const bool is_direction = design.variable == FreeVariable::direction;
  outcome.exponent = phong_exponent(exact(std::get<FacingNormal>(*goal.subjects[0].front).normal), exact(goal.eye) - q,
                                    is_direction ? exact(position) : exact(position) - q, goal.threshold);
}

bool is_satisfied_by(Region region, Want want) {
  switch (want) {
    case Want::irradiance:
    case Want::lit:
      return region == Region::lit;
    case Want::shadow:
      return region == Region::penumbra || region == Region::umbra;
    case Want::penumbra:
      return region == Region::penumbra;
    case Want::not_seen_from:
      return region == Region::umbra || region == Region::unlit;
    default:
      return region == Region::umbra;
  }
}

}  // namespace

GoalOutcome goal_outcome(DesignSpace& space, const Design& design, std::uint32_t number, const GoalSets& sets,
                         const DesignObstacles& obstacles, const Point3& position, const Cell& domain) {
  const DesignGoal& goal = design.goals[number];
  const bool is_direction = design.variable == FreeVariable::direction;
  const CornerId point = space.cells.add_corner(is_direction ? whole_direction(position) : whole_point(position));
  GoalOutcome outcome;
  outcome.satisfied = holds(space, sets, point);
  if (is_asked_of_visibility(goal.want)) {
    if (const auto region = region_of(design, goal, obstacles, position)) {
      outcome.satisfied = is_satisfied_by(*region, goal.want);
      outcome.region = std::string(name(*region));
    }
  }
  add_shading(design, goal, position, outcome);
  if (const auto slack = SlackMeter(space, domain, point).of(sets)) {
    const double distance = nearest_root(Rational(abs(slack->square)));
    outcome.slack = slack->square < 0 ? -distance : distance;
    outcome.wall = space.names[*slack->plane];
  }
  return outcome;
}

}  // namespace gnomon::inverse
