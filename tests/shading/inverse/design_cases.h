#pragma once

#include "gnomon/light_design.h"
#include "tests/support/dice.h"

namespace gnomon::test_support {

/// A design drawn at random, near to degenerate where coordinates are few.
struct DesignCase {
  Design design;
  DesignObstacles obstacles;
};

/// How far coordinates reach: of small numbers many points lie in one plane.
enum class Numbers { small, large };

DesignObstacles drawn_obstacles(Dice& dice, Numbers numbers, int count);

/// A goal of lit or dark for a point, or for a receiver.
DesignGoal drawn_goal(Dice& dice, Numbers numbers, int number, const DesignObstacles& obstacles);

/// A point light sought in a box, behind one to three blockers, with one to four goals.
DesignCase drawn_position_case(Dice& dice, Numbers numbers);

/// True if every goal is fulfilled, asked of visibility alone, from the light's side.
bool is_fulfilled(const DesignCase& c, const Point3& position);

/// What a case was, for messages.
std::string told(const DesignCase& c, const Point3& position);

Point3 drawn_point(Dice& dice, Numbers numbers, int least_z, int most_z);

}  // namespace gnomon::test_support
