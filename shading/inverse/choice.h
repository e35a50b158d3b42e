#pragma once

#include <optional>
#include <span>

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// A chosen position, or for a cone of directions a direction.
struct ChosenPoint {
  ExactVector position;
  Rational radius = 0;  ///< of a ball (of a cube half its side) around it in the cell; a lower bound of the largest
};

/// The point of the cells that a choice takes: of several equal ones the smallest in x, y, z.
///
/// Definition: centre: the largest ball in one of the cells, its radius measured in the cell's own dimension; where
/// many
///             balls are largest, the centre of their centres, and so on. cube: the same for cubes along the axes.
///             nearest: the point of least distance.
/// Exactness:  rational, in the cells that doubles do not leave out by more than 1e-5; lengths of normals are rounded
/// up, so a ball fits for certain. Requires:   at least one cell, bounded unless the choice is `nearest`.
ChosenPoint chosen_point(DesignSpace& space, std::span<const Cell> cells, Choice choice,
                         const std::optional<Point3>& near);

/// The direction of a cone that stays farthest from its boundary; its radius is the sine of that angle, a lower bound.
ChosenPoint chosen_direction(DesignSpace& space, std::span<const Cell> cones);

}  // namespace gnomon::inverse
