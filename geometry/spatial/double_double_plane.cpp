#include "geometry/spatial/double_double_plane.h"

#include <algorithm>

// Bounds, u = 2^-53. What is added to a low part is less than 16 u times the sum S of the absolute values of the
// products involved (products and sums lose at most u S each, low parts are at most u times high ones), and there are
// fewer than 16 additions and products of low parts, each rounded: an error of less than 256 u^2 S. Products of two low
// words, which are left out, are less than 2 u^2 S. So 2^-97 S = 512 u^2 S covers all of it, and the rounding of S and
// of the bounds themselves. 2^-900 is more than what sixteen underflows lose, and so large that no product of bounds
// is a subnormal number, with which processors are slow.

namespace gnomon {
namespace {

using Triple = std::array<double, 3>;

constexpr double sum_rounding = 0x1p-97;
constexpr double underflow = 0x1p-900;

struct Number {
  DoubleDouble sum;
  double error;
};

/// a d - b c.
Number minor_of(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c, const DoubleDouble& d) {
  const DoubleDouble first = exact_product(a.high, d.high);
  const DoubleDouble second = exact_product(b.high, c.high);
  const DoubleDouble high = exact_difference(first.high, second.high);
  const double low =
      high.low + (first.low - second.low) + ((a.high * d.low + a.low * d.high) - (b.high * c.low + b.low * c.high));
  return {exact_sum(high.high, low), (std::abs(first.high) + std::abs(second.high)) * sum_rounding + underflow};
}

/// normal x + offset.
Number height(const DoubleDoublePlane& plane, const std::array<Halves, 3>& x) {
  DoubleDouble sum = plane.offset;
  double size = std::abs(sum.high);
  double error = plane.offset_error;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble product = exact_product(plane.normal[i], x[i]);
    const DoubleDouble next = exact_sum(sum.high, product.high);
    sum = {next.high, sum.low + (next.low + (product.low + plane.normal_low[i] * x[i].value))};
    size += std::abs(product.high);
    error += plane.normal_error[i] * std::abs(x[i].value);
  }
  return {exact_sum(sum.high, sum.low), error + size * sum_rounding + underflow};
}

void set_axis_plane(const PlaneDefinition& plane, DoubleDoublePlane& result) {
  result.normal[plane.axis] = 1;
  result.offset.high = -plane.bound;
}

void set_point_plane(const PlaneDefinition& plane, DoubleDoublePlane& result) {
  const auto& [p, q, r] = plane.points;
  const bool along = plane.kind == PlaneDefinition::Kind::points_direction;
  const auto second = [&](double to, double from) { return along ? DoubleDouble{to, 0} : exact_difference(to, from); };
  const std::array<DoubleDouble, 3> a = {exact_difference(q.x, p.x), exact_difference(q.y, p.y),
                                         exact_difference(q.z, p.z)};
  const std::array<DoubleDouble, 3> b = {second(r.x, p.x), second(r.y, p.y), second(r.z, p.z)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto [sum, error] = minor_of(a[j], a[k], b[j], b[k]);
    result.normal[i] = sum.high;
    result.normal_low[i] = sum.low;
    result.normal_error[i] = error;
  }
  const auto [sum, error] = height(result, {p.x, p.y, p.z});
  result.offset = {-sum.high, -sum.low};
  result.offset_error = error;
}

Triple cross_product(const DoubleDoublePlane& a, const DoubleDoublePlane& b) {
  const auto component = [&](std::size_t j, std::size_t k) {
    return a.normal[j].value * b.normal[k].value - a.normal[k].value * b.normal[j].value;
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

/// Sum of the absolute values of a normal's rounding errors, of their effect on a product with it, and more.
double normal_defect(const DoubleDoublePlane& plane) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += std::abs(plane.normal[i].value) * 0x1p-50 + std::abs(plane.normal_low[i]) + plane.normal_error[i];
  }
  return sum;
}

}  // namespace

DoubleDoublePlane::DoubleDoublePlane(const PlaneDefinition& plane) {
  using enum PlaneDefinition::Kind;
  if (plane.kind == PlaneDefinition::Kind::axis) {
    set_axis_plane(plane, *this);
  } else if (plane.kind == points || plane.kind == points_direction) {
    set_point_plane(plane, *this);
  } else {
    offset_error = HUGE_VAL;
  }
  normal_defect = gnomon::normal_defect(*this);
}

CommonPoint::CommonPoint(const DoubleDoublePlane& a, const DoubleDoublePlane& b, const DoubleDoublePlane& c)
    : planes_{&a, &b, &c} {
  const std::array<Triple, 3> columns = {cross_product(b, c), cross_product(c, a), cross_product(a, b)};
  const double determinant =
      a.normal[0].value * columns[0][0] + a.normal[1].value * columns[0][1] + a.normal[2].value * columns[0][2];
  const double factor = 1 / determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inverse_[i][j] = columns[j][i] * factor;
  }
  const Triple normal_defects = {a.normal_defect, b.normal_defect, c.normal_defect};
  for (std::size_t i = 0; i < 3; ++i) {
    const Triple& row = inverse_[i];
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double entry =
          row[0] * a.normal[k].value + row[1] * b.normal[k].value + row[2] * c.normal[k].value - (i == k ? 1 : 0);
      sum += std::abs(entry) + std::abs(row[k]) * normal_defects[k];
    }
    defect_[i] = sum * (1 + 0x1p-40);
  }
}

CommonPoint::Step CommonPoint::step_from(const std::array<Halves, 3>& x) const {
  Step step{{0, 0, 0}, {0, 0, 0}};
  for (std::size_t j = 0; j < 3; ++j) {
    const auto [sum, error] = height(*planes_[j], x);
    for (std::size_t i = 0; i < 3; ++i) {
      step.length[i] -= inverse_[i][j] * sum.high;
      step.error[i] += std::abs(inverse_[i][j]) * (error + std::abs(sum.high) * 0x1p-50);
    }
  }
  double longest = 0;  // of the step without errors, if the defect is less than a half
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, std::abs(step.length[i]) + step.error[i]);
  const double defect = std::max({defect_[0], defect_[1], defect_[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    step.error[i] = defect < 0.5 ? (step.error[i] + defect_[i] * 2 * longest) * (1 + 0x1p-40) : HUGE_VAL;
  }
  return step;
}

std::optional<Point3> CommonPoint::rounded(const Point3& nearby) const {
  Triple x = {nearby.x, nearby.y, nearby.z};
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Step step = step_from({x[0], x[1], x[2]});
    bool decided = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const DoubleDouble sum = exact_sum(x[i], step.length[i]);
      decided = rounds_to_high(sum, step.error[i]) && decided;
      x[i] = sum.high;
    }
    if (decided) return Point3{x[0], x[1], x[2]};
  }
  return std::nullopt;
}

}  // namespace gnomon
