#include "apps/proof/laws/meeting.h"

#include <algorithm>

#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/pair_generator.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

/// The part of a convex loop below a plane; of two points, of the segment between them.
Polygon below(const ExactPlane& plane, const Polygon& loop) {
  Polygon result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ExactVector& a = loop[i];
    const ExactVector& b = loop[(i + 1) % loop.size()];
    const Rational at_a = plane.height(a);
    const Rational at_b = plane.height(b);
    if (sign(at_a) <= 0) result.push_back(a);
    if (sign(at_a) * sign(at_b) < 0) result.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return result;
}

bool has_area(const Polygon& loop) {
  for (std::size_t i = 2; i < loop.size(); ++i) {
    if (!is_zero(cross(loop[i - 1] - loop[0], loop[i] - loop[0]))) return true;
  }
  return false;
}

bool has_length(const Polygon& loop) {
  return std::ranges::any_of(loop, [&](const ExactVector& p) { return p != loop[0]; });
}

}  // namespace

std::vector<ExactVector> vertices_of(const Light& light) {
  return exact(light_points(light));
}

std::vector<ExactVector> vertices_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return exact(shape.points()); }, blocker);
}

bool holds(const Walls& blocker, const ExactVector& p) {
  return std::ranges::all_of(blocker, [&](const ExactPlane& wall) { return wall.side(p) <= 0; });
}

bool meet(const std::vector<ExactVector>& polygon, const Walls& blocker) {
  Polygon common = polygon;
  for (const ExactPlane& wall : blocker) common = below(wall, common);
  return !common.empty();
}

bool meet_measurably(const Light& light, const Walls& blocker) {
  Polygon common = vertices_of(light);
  for (const ExactPlane& wall : blocker) common = below(wall, common);
  if (std::holds_alternative<AreaLight>(light)) return has_area(common);
  return std::holds_alternative<LinearLight>(light) ? has_length(common) : !common.empty();
}

std::optional<ExactPlane> front_of(const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  if (!area || area->two_sided || !area->polygon.is_flat()) return std::nullopt;
  return plane_of(vertices_of(light));
}

std::optional<ExactPlane> plane_of(const ConvexBlocker& blocker) {
  if (std::holds_alternative<ConvexSolid>(blocker)) return std::nullopt;
  return plane_of(vertices_of(blocker));
}

bool are_coplanar(const Light& light, const ConvexBlocker& blocker) {
  const std::optional<ExactPlane> plane = plane_of(blocker);
  return plane && std::ranges::all_of(vertices_of(light), [&](const auto& l) { return plane->side(l) == 0; });
}

bool reaches_front(const Light& light, const ConvexBlocker& blocker) {
  const std::optional<ExactPlane> front = front_of(light);
  return !front || std::ranges::any_of(vertices_of(blocker), [&](const auto& b) { return front->side(b) > 0; });
}

bool parallel_rays_meet(const std::vector<ExactVector>& points, const std::vector<ExactVector>& blocker,
                        const std::optional<ExactPlane>& front) {
  // The direction is a mean of all b - l of the first point l, so it is not zero, and has multiples that are sums of
  // the b - l of every other point: three equations each. One more says that the weights of the mean add up to 1, and
  // one that the direction rises over the front.
  const std::size_t rows = 3 * (points.size() - 1) + 2;
  std::vector<ExactColumn> columns;
  const auto put = [](ExactColumn& column, std::size_t i, const ExactVector& v) {
    column[3 * i] = v.x;
    column[3 * i + 1] = v.y;
    column[3 * i + 2] = v.z;
  };
  for (const ExactVector& b : blocker) {
    ExactColumn& mean = columns.emplace_back(rows, Rational(0));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) put(mean, i, b - points[0]);
    mean[rows - 1] = 1;
    if (front) mean[rows - 2] = dot(front->normal, b - points[0]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      put(columns.emplace_back(rows, Rational(0)), i, points[i + 1] - b);
    }
  }
  if (front) columns.emplace_back(rows, Rational(0))[rows - 2] = -1;
  ExactColumn target(rows, Rational(0));
  target[rows - 1] = 1;
  return is_in_cone(columns, target);
}

}  // namespace gnomon::laws
