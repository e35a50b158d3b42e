#include "shading/inverse/brightness.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/rounding.h"
#include "shading/inverse/goal_sets.h"
#include "shading/inverse/linear_program.h"

namespace gnomon::inverse {
namespace {

/// What bounds the smallest E^(-1/2): a row n x - τ <= right of the program, or a wall of the cell.
struct Row {
  std::array<Rational, 4> left;
  Rational right;
};

Vector3<double> rounded_vector(const ExactVector& v) {
  return {nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)};
}

/// (wanted / E)^(1/2) at a position, and how it grows.
struct Darkness {
  double value;
  Vector3<double> gradient;
};

/// Nothing where the point is seen along its plane, or nearly: all the light is lost there.
std::optional<Darkness> darkness(const BrightPoint& point, const Point3& p) {
  const Vector3<double> n = rounded_vector(point.normal), v = step(point.point, p);
  const double square = dot(v, v), height = dot(n, v), length = std::sqrt(dot(n, n));
  if (!(height > 1e-4 * length * std::sqrt(square))) return std::nullopt;
  // g = (w |N|)^(1/2) |v|^(3/2) (N v)^(-1/2); grad g = g (3/2 v / |v|² - 1/2 N / (N v)).
  const double value = std::sqrt(point.wanted * length * square * std::sqrt(square) / height);
  Vector3<double> gradient;
  for (std::size_t k = 0; k < 3; ++k) gradient[k] = value * (1.5 * v[k] / square - 0.5 * n[k] / height);
  return Darkness{value, gradient};
}

/// The largest of all points' darkness; infinite where one has no light.
double largest_darkness(std::span<const BrightPoint> points, const Point3& p) {
  double most = 0;
  for (const BrightPoint& point : points) {
    const auto there = darkness(point, p);
    most = std::fmax(most, there ? there->value : HUGE_VAL);
  }
  return most;
}

/// A tangent, lowered. Heights of at least 1e-4 of the distance err by less than 1e-11 of themselves, and so do the
/// value and the two terms of the gradient.
Row tangent(const Darkness& there, const BrightPoint& point, const Point3& p, double diameter) {
  const Vector3<double> n = rounded_vector(point.normal), v = step(point.point, p);
  const double steepest = 1.5 / std::sqrt(dot(v, v)) + 0.5 * std::sqrt(dot(n, n)) / dot(n, v);
  const double off = 1e-10 * there.value * (1 + diameter * steepest);
  Row row;
  row.right = Rational(off) - Rational(there.value);
  const std::array<double, 3> at = {p.x, p.y, p.z};
  for (std::size_t k = 0; k < 3; ++k) {
    row.left[k] = Rational(there.gradient[k]);
    row.right += Rational(there.gradient[k]) * Rational(at[k]);
  }
  row.left[3] = -1;
  return row;
}

std::vector<Row> wall_rows(const DesignSpace& space, const Cell& cell) {
  std::vector<Row> rows;
  for (const Corner& corner : cell.corners) {
    for (const CellPlane plane : corner.planes) {
      const Whole& p = space.cells.plane(plane);
      for (const int sign : {1, -1}) {
        if (!lies(space.cells, cell, plane, sign > 0 ? PlaneSide::within : PlaneSide::beyond)) continue;
        const Rational s(sign);
        rows.push_back({{Rational(s * p[0]), Rational(s * p[1]), Rational(s * p[2]), 0}, Rational(-s * p[3])});
      }
    }
  }
  const auto key = [](const Row& row) { return std::tie(row.left, row.right); };
  std::ranges::sort(rows, {}, key);
  const auto same = std::ranges::unique(rows, {}, key);
  rows.erase(same.begin(), same.end());
  return rows;
}

/// The dual of: the lowest τ over all rows. Its multipliers are the place and τ.
StandardProgram program_of(const std::vector<Row>& rows) {
  StandardProgram program;
  program.right = {0, 0, 0, -1};
  for (const Row& row : rows) {
    program.columns.emplace_back(row.left.begin(), row.left.end());
    program.cost.push_back(row.right);
  }
  return program;
}

Point3 near_point(const ExactVector& p) {
  const Vector3<double> v = rounded_vector(p);
  return {v.x, v.y, v.z};
}

double diameter_of(const DesignSpace& space, const Cell& cell, std::span<const BrightPoint> points) {
  double most = 0;
  const Point3 first = near_point(coordinates(space.cells.corner(cell.corners[0].id)));
  for (const Corner& corner : cell.corners) {
    most = std::fmax(most, sum_norm(step(first, near_point(coordinates(space.cells.corner(corner.id))))));
  }
  for (const BrightPoint& point : points) most = std::fmax(most, sum_norm(step(first, point.point)));
  return 2 * most;
}

double share_of(double darkness) {
  return darkness == HUGE_VAL ? 0 : 1 / (darkness * darkness);
}

/// Looks for the darkest corner's best place in one cell.
class Search {
 public:
  Search(const DesignSpace& space, const Cell& cell, std::span<const BrightPoint> points)
      : points_(points),
        middle_(coordinates(middle(space.cells, cell))),
        diameter_(diameter_of(space, cell, points)),
        walls_(wall_rows(space, cell)),
        best_(middle_),
        least_(largest_darkness(points, near_point(middle_))) {}

  /// In doubles until not much is left to gain, then in rational numbers, with the tangents that matter there.
  BrightestPosition position() {
    constexpr int rough_rounds = 100, exact_rounds = 20;
    constexpr double rough_gap = 1e-7, gap = 1e-10;
    Point3 next = near_point(middle_);
    for (int round = 0; round < rough_rounds; ++round) {
      if (!add_tangents(next)) break;
      const std::vector<double> low = rough_multipliers(program_of(all_rows(tangents_)));
      next = {low[0], low[1], low[2]};
      if (low[3] >= largest_darkness(points_, next) * (1 - rough_gap)) break;
    }
    for (int round = 0; round < exact_rounds && bound_ < least_ * (1 - gap); ++round) {
      if (!add_tangents(next)) break;
      const ProgramSolution low = solved_program(program_of(all_rows(tangents_near(next))));
      if (low.kind != ProgramSolution::Kind::optimal)
        throw DesignError("the brightest position needs a bounded region");
      const ExactVector place = {low.multipliers[0], low.multipliers[1], low.multipliers[2]};
      bound_ = std::fmax(bound_, nearest_double(low.multipliers[3]));
      next = near_point(place);
      const double here = largest_darkness(points_, next);
      if (here >= least_) continue;
      least_ = here;
      best_ = place;
    }
    // Values of doubles err by less than 1e-11 of themselves.
    return {best_, share_of(least_) * (1 - 1e-10), bound_ > 0 ? share_of(bound_) * (1 + 1e-10) : HUGE_VAL};
  }

 private:
  std::vector<Row> all_rows(const std::vector<Row>& tangents) const {
    std::vector<Row> rows = walls_;
    rows.insert(rows.end(), tangents.begin(), tangents.end());
    return rows;
  }

  /// Where a point is seen along its plane there is no tangent: one from farther inside will do.
  bool add_tangents(Point3 at) {
    const Point3 inside = near_point(middle_);
    for (int k = 0; k < 40 && largest_darkness(points_, at) == HUGE_VAL; ++k) {
      at = {(at.x + inside.x) / 2, (at.y + inside.y) / 2, (at.z + inside.z) / 2};
    }
    const double most = largest_darkness(points_, at);
    if (most == HUGE_VAL) return false;
    for (const BrightPoint& point : points_) {
      const Darkness there = *darkness(point, at);
      if (there.value >= 0.5 * most) tangents_.push_back(tangent(there, point, at, diameter_));
    }
    return true;
  }

  /// The tangents that are highest at a place: fewer make a lower bound, too.
  std::vector<Row> tangents_near(const Point3& at) const {
    constexpr std::size_t most = 24;
    std::vector<std::pair<double, std::size_t>> heights;
    for (std::size_t k = 0; k < tangents_.size(); ++k) {
      const Row& row = tangents_[k];
      const double height = nearest_double(row.left[0]) * at.x + nearest_double(row.left[1]) * at.y +
                            nearest_double(row.left[2]) * at.z - nearest_double(row.right);
      heights.emplace_back(-height, k);
    }
    std::ranges::sort(heights);
    std::vector<Row> rows;
    for (std::size_t k = 0; k < std::min(most, heights.size()); ++k) rows.push_back(tangents_[heights[k].second]);
    return rows;
  }

  std::span<const BrightPoint> points_;
  ExactVector middle_;
  double diameter_;
  std::vector<Row> walls_, tangents_;
  ExactVector best_;
  double least_, bound_ = 0;
};

}  // namespace

BrightestPosition brightest_position(DesignSpace& space, std::span<const Cell> cells,
                                     std::span<const BrightPoint> points) {
  std::optional<BrightestPosition> best;
  double most = 0;
  for (const Cell& cell : cells) {
    BrightestPosition there = Search(space, cell, points).position();
    most = std::fmax(most, there.most);
    if (!best || there.share > best->share) best = std::move(there);
  }
  best->most = most;
  return *best;
}

std::vector<BrightPoint> bright_points(const DesignGoal& goal) {
  std::vector<BrightPoint> points;
  for (const DesignSubject& subject : goal.subjects) {
    const ExactVector normal = Rational(-1) * normal_of(front_plane(subject));
    const double wanted = goal.want == Want::irradiance ? goal.at_least : 1;
    for (const Point3& p : subject.points) points.push_back({p, normal, wanted});
  }
  return points;
}

double unit_irradiance(const BrightPoint& point, const ExactVector& position) {
  const ExactVector v = position - exact(point.point);
  const Rational height = dot(point.normal, v), square = dot(v, v);
  if (height <= 0) return 0;
  // The root of E², which is rational.
  return nearest_root(Rational(height * height / (dot(point.normal, point.normal) * square * square * square)));
}

bool is_bright_enough(const BrightPoint& point, const ExactVector& position) {
  const ExactVector v = position - exact(point.point);
  const Rational height = dot(point.normal, v), square = dot(v, v), wanted(point.wanted);
  return height > 0 && height * height >= wanted * wanted * dot(point.normal, point.normal) * square * square * square;
}

}  // namespace gnomon::inverse
