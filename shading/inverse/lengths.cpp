#include "shading/inverse/lengths.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/rounding.h"

namespace gnomon::inverse {
namespace {

ExactVector vector_between(const Whole& from, const Whole& to) {
  if (to[3] == 0) return {Rational(to[0]), Rational(to[1]), Rational(to[2])};
  if (from[3] == 0) return {Rational(from[0]), Rational(from[1]), Rational(from[2])};
  return coordinates(to) - coordinates(from);
}

/// Vectors that lead along a cell, the first ones independent.
std::vector<ExactVector> basis(const CellSpace& space, const Cell& cell) {
  std::vector<ExactVector> result;
  for (const Corner& corner : cell.corners) {
    const ExactVector v = vector_between(space.corner(cell.corners[0].id), space.corner(corner.id));
    const bool is_new = result.empty()       ? !is_zero(v)
                        : result.size() == 1 ? !is_zero(cross(result[0], v))
                                             : dot(cross(result[0], result[1]), v) != 0;
    if (is_new) result.push_back(v);
    if (result.size() == 3) break;
  }
  return result;
}

Rational size_of_fan(const CellSpace& space, const Cell& cell, const std::vector<std::uint32_t>& loop,
                     ExactVector& doubled) {
  const auto at = [&](std::uint32_t place) { return coordinates(space.corner(cell.corners[place].id)); };
  Rational six_volumes = 0;
  const ExactVector apex = at(0);
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const ExactVector a = at(loop[0]), b = at(loop[k - 1]), c = at(loop[k]);
    const ExactVector normal = cross(b - a, c - a);
    doubled = doubled + normal;
    six_volumes += dot(normal, a - apex);
  }
  return abs(six_volumes);
}

/// A quotient, right to 2^-51 of itself: no common divisor is sought.
double near_quotient(const Integer& top, const Integer& bottom) {
  long up = 0, down = 0;
  const double a = mpz_get_d_2exp(&up, top.backend().data()), b = mpz_get_d_2exp(&down, bottom.backend().data());
  return std::ldexp(a / b, static_cast<int>(up - down));
}

}  // namespace

Extent::Extent(const CellSpace& space, const Cell& cell) {
  const std::vector<ExactVector> along = basis(space, cell);
  dimension_ = static_cast<int>(along.size());
  if (dimension_ == 1) across_ = along[0];
  if (dimension_ == 2) across_ = cross(along[0], along[1]);
}

Rational Extent::squared(const ExactVector& normal) const {
  if (dimension_ == 3) return dot(normal, normal);
  if (dimension_ == 0) return 0;
  const Rational part = dot(normal, across_);
  const Rational along = part * part / dot(across_, across_);
  return dimension_ == 1 ? along : Rational(dot(normal, normal) - along);
}

Rational Extent::length_above(const ExactVector& normal) const {
  const Rational square = squared(normal);
  const double nearest = nearest_root(square);
  const Rational length(nearest);
  if (length * length == square) return length;
  return Rational(std::nextafter(nearest, HUGE_VAL));
}

Rational Extent::cube_support(const ExactVector& normal) const {
  if (dimension_ == 0) return 0;
  if (dimension_ == 3) return abs(normal.x) + abs(normal.y) + abs(normal.z);
  if (dimension_ == 1) {
    const Rational longest = std::max({Rational(abs(across_.x)), Rational(abs(across_.y)), Rational(abs(across_.z))});
    return abs(dot(normal, across_)) / longest;
  }
  // The corners of the section lie on edges of the cube.
  Rational most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (across_[axis] == 0) continue;
    for (const int u : {-1, 1}) {
      for (const int v : {-1, 1}) {
        ExactVector p;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        p[axis] = -dot(p, across_) / across_[axis];
        if (abs(p[axis]) <= 1) most = std::max(most, Rational(abs(dot(normal, p))));
      }
    }
  }
  return most;
}

double near_volume(const CellSpace& space, const Cell& cell) {
  const Whole& apex = space.corner(cell.corners[0].id);
  double sum = 0;
  for (const CellFace& face : faces(space, cell)) {
    const auto at = [&](std::size_t k) -> const Whole& { return space.corner(cell.corners[face.corners[k]].id); };
    for (std::size_t k = 2; k < face.corners.size(); ++k) {
      const Whole plane = unreduced_complement(at(0), at(k - 1), at(k));
      const Integer weights = apex[3] * at(0)[3] * at(k - 1)[3] * at(k)[3];
      // None is below 0, so the sum is as right as its parts.
      sum += near_quotient(Integer(abs(value(plane, apex))), Integer(6 * weights));
    }
  }
  return sum;
}

Rational squared_size(const CellSpace& space, const Cell& cell) {
  const int n = dimension(space, cell);
  if (n == 0) return 0;
  if (n == 1) {
    Rational most = 0;
    for (const Corner& corner : cell.corners) {
      const ExactVector v = vector_between(space.corner(cell.corners[0].id), space.corner(corner.id));
      most = std::max(most, Rational(dot(v, v)));
    }
    return most;
  }
  ExactVector doubled;
  if (n == 2) {
    // A polygon is a face of itself: its corners are in order where its edges are.
    std::vector<std::vector<std::uint32_t>> next(cell.corners.size());
    for (const auto& [a, b] : edges(cell)) {
      next[a].push_back(b);
      next[b].push_back(a);
    }
    std::vector<std::uint32_t> loop = {0};
    for (std::uint32_t before = ~0U; loop.size() < cell.corners.size();) {
      const auto& near = next[loop.back()];
      const std::uint32_t here = loop.back();
      loop.push_back(near[0] != before ? near[0] : near[1]);
      before = here;
    }
    size_of_fan(space, cell, loop, doubled);
    return dot(doubled, doubled) / 4;
  }
  Rational six_volumes = 0;
  for (const CellFace& face : faces(space, cell)) six_volumes += size_of_fan(space, cell, face.corners, doubled);
  return six_volumes * six_volumes / 36;
}

}  // namespace gnomon::inverse
