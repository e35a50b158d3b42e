#include "tests/shading/inverse/design_cases.h"

#include <sstream>

#include "geometry/bodies/body.h"
#include "shading/inverse/forward.h"

namespace gnomon::test_support {
namespace {

int reach(Numbers numbers) {
  return numbers == Numbers::small ? 2 : 9;
}

/// A triangle, a quadrangle or a tetrahedron.
ConvexBlocker drawn_blocker(Dice& dice, Numbers numbers) {
  while (true) {
    std::vector<Point3> points;
    const int count = dice.once_in(3) ? 4 : 3;
    for (int k = 0; k < count; ++k) points.push_back(drawn_point(dice, numbers, 1, 4));
    if (count == 3) {
      if (!ConvexPolygon::defect(points)) return ConvexPolygon::from_points(points);
      continue;
    }
    if (dice.once_in(2)) {
      const int z = dice.draw(1, 3), x = dice.draw(-2, 1), y = dice.draw(-2, 1), a = dice.draw(1, 3),
                b = dice.draw(1, 3);
      const double low = z, left = x, near = y, right = x + a, far = y + b;
      return ConvexPolygon::from_points({{left, near, low}, {right, near, low}, {right, far, low}, {left, far, low}});
    }
    try {
      return ConvexSolid::hull_of(points);
    } catch (const std::logic_error&) {
    }
  }
}

DesignSubject drawn_receiver(Dice& dice, Numbers numbers) {
  while (true) {
    const std::vector<Point3> points = {drawn_point(dice, numbers, -1, 1), drawn_point(dice, numbers, -1, 1),
                                        drawn_point(dice, numbers, -1, 1)};
    if (ConvexPolygon::defect(points)) continue;
    return {points, FacetFront{{points[0], points[1], points[2]}}};
  }
}

}  // namespace

Point3 drawn_point(Dice& dice, Numbers numbers, int least_z, int most_z) {
  const int r = reach(numbers);
  return {static_cast<double>(dice.draw(-r, r)), static_cast<double>(dice.draw(-r, r)),
          static_cast<double>(dice.draw(least_z, most_z))};
}

DesignObstacles drawn_obstacles(Dice& dice, Numbers numbers, int count) {
  DesignObstacles obstacles;
  for (int k = 0; k < count; ++k) {
    obstacles.obstacles.blockers.push_back(drawn_blocker(dice, numbers));
    obstacles.parts.push_back("b" + std::to_string(k));
  }
  obstacles.elements = obstacles.parts;
  return obstacles;
}

DesignGoal drawn_goal(Dice& dice, Numbers numbers, int number, const DesignObstacles& obstacles) {
  DesignGoal goal;
  goal.name = "g" + std::to_string(number);
  goal.want = dice.once_in(2) ? Want::dark : Want::lit;
  goal.subjects.push_back(dice.once_in(3) ? drawn_receiver(dice, numbers)
                                          : DesignSubject{{drawn_point(dice, numbers, -1, 2)}, {}});
  if (dice.once_in(2)) goal.by = dice.one_of(obstacles.elements);
  return goal;
}

DesignCase drawn_position_case(Dice& dice, Numbers numbers) {
  DesignCase c;
  c.obstacles = drawn_obstacles(dice, numbers, dice.draw(1, 3));
  c.design.domain = {DomainShape::box, {{-4, -4, 2}, {4, 4, 8}}};
  const int goals = dice.draw(1, 4);
  for (int k = 0; k < goals; ++k) c.design.goals.push_back(drawn_goal(dice, numbers, k, c.obstacles));
  return c;
}

bool is_fulfilled(const DesignCase& c, const Point3& position) {
  for (const DesignGoal& goal : c.design.goals) {
    const Light light = inverse::placed_light(c.design, goal, position);
    const Obstacles standing = inverse::placed_obstacles(c.design, goal, c.obstacles, position);
    for (const DesignSubject& subject : goal.subjects) {
      const auto region = inverse::forward_region(light, subject, standing);
      const bool good = goal.want == Want::lit        ? region == Region::lit
                        : goal.want == Want::dark     ? region == Region::umbra
                        : goal.want == Want::penumbra ? region == Region::penumbra
                                                      : region == Region::umbra || region == Region::penumbra;
      if (!good) return false;
    }
  }
  return true;
}

std::string told(const DesignCase& c, const Point3& position) {
  std::ostringstream text;
  const auto add = [&](std::span<const Point3> points) {
    for (const Point3& p : points) text << " (" << p.x << ' ' << p.y << ' ' << p.z << ')';
    text << '\n';
  };
  for (const ConvexBlocker& b : c.obstacles.obstacles.blockers) {
    text << (b.index() == 0 ? "polygon" : "solid");
    add(std::visit([](const auto& shape) { return shape.points(); }, b));
  }
  for (const DesignGoal& goal : c.design.goals) {
    text << name(goal.want) << " by '" << goal.by << "'";
    for (const DesignSubject& s : goal.subjects) add(s.points);
  }
  if (c.design.variable == FreeVariable::scale || c.design.variable == FreeVariable::translation) {
    text << "light";
    add(light_points(c.design.light));
    text << "about";
    add({&c.design.centre, 1});
  }
  text << "at";
  add({&position, 1});
  return text.str();
}

}  // namespace gnomon::test_support
