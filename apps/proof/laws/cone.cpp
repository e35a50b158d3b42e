#include "apps/proof/laws/cone.h"

#include <stdexcept>

namespace gnomon::laws {
namespace {

Rational product(const ExactColumn& a, const ExactColumn& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// The first phase of the simplex method with Bland's rule: rows are equations, one column per generator, one per
/// artificial variable, and the right side last. The last row holds the reduced costs.
class Tableau {
 public:
  Tableau(const std::vector<ExactColumn>& generators, const ExactColumn& target)
      : generators_(generators), target_(target), rows_(target.size()), columns_(generators.size() + rows_) {
    cells_.assign(rows_ + 1, ExactColumn(columns_ + 1, Rational(0)));
    for (std::size_t i = 0; i < rows_; ++i) {
      const int flip = sign(target[i]) < 0 ? -1 : 1;
      flips_.push_back(flip);
      for (std::size_t j = 0; j < generators.size(); ++j) cells_[i][j] = flip * generators[j][i];
      cells_[i][generators.size() + i] = 1;
      cells_[i][columns_] = flip * target[i];
      basis_.push_back(generators.size() + i);
      for (std::size_t j = 0; j < generators.size(); ++j) cells_[rows_][j] -= cells_[i][j];
      cells_[rows_][columns_] -= cells_[i][columns_];
    }
  }

  bool feasible() {
    while (improve()) {
    }
    const bool yes = sign(cells_[rows_][columns_]) == 0;
    if (yes ? !weights_are_right() : !plane_is_right()) throw std::logic_error("cone: the certificate is wrong");
    return yes;
  }

 private:
  bool improve() {
    std::size_t entering = 0;
    while (entering < columns_ && sign(cells_[rows_][entering]) >= 0) ++entering;
    if (entering == columns_) return false;
    std::size_t leaving = rows_;
    Rational best = 0;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (sign(cells_[i][entering]) <= 0) continue;
      const Rational ratio = cells_[i][columns_] / cells_[i][entering];
      if (leaving == rows_ || ratio < best || (ratio == best && basis_[i] < basis_[leaving])) {
        leaving = i;
        best = ratio;
      }
    }
    if (leaving == rows_) throw std::logic_error("cone: the sum of artificial variables has no minimum");
    pivot(leaving, entering);
    return true;
  }

  void pivot(std::size_t row, std::size_t column) {
    const Rational divisor = cells_[row][column];
    for (Rational& cell : cells_[row]) cell /= divisor;
    for (std::size_t i = 0; i <= rows_; ++i) {
      const Rational factor = cells_[i][column];
      if (i == row || sign(factor) == 0) continue;
      for (std::size_t j = 0; j <= columns_; ++j) {
        if (sign(cells_[row][j]) != 0) cells_[i][j] -= factor * cells_[row][j];
      }
    }
    basis_[row] = column;
  }

  bool weights_are_right() const {
    ExactColumn sum(rows_, Rational(0));
    for (std::size_t i = 0; i < rows_; ++i) {
      const Rational& weight = cells_[i][columns_];
      if (sign(weight) < 0) return false;
      if (sign(weight) == 0) continue;
      if (basis_[i] >= generators_.size()) return false;
      for (std::size_t k = 0; k < rows_; ++k) sum[k] += weight * generators_[basis_[i]][k];
    }
    return sum == target_;
  }

  bool plane_is_right() const {
    ExactColumn normal(rows_);
    for (std::size_t i = 0; i < rows_; ++i) {
      normal[i] = flips_[i] * (1 - cells_[rows_][generators_.size() + i]);
    }
    for (const ExactColumn& generator : generators_) {
      if (sign(product(normal, generator)) > 0) return false;
    }
    return sign(product(normal, target_)) > 0;
  }

  const std::vector<ExactColumn>& generators_;
  const ExactColumn& target_;
  std::size_t rows_;
  std::size_t columns_;
  std::vector<ExactColumn> cells_;
  std::vector<std::size_t> basis_;
  std::vector<int> flips_;
};

ExactColumn lifted(const ExactVector& v, int w) {
  return {v.x, v.y, v.z, Rational(w)};
}

}  // namespace

bool is_in_cone(const std::vector<ExactColumn>& generators, const ExactColumn& target) {
  return Tableau(generators, target).feasible();
}

bool is_in_difference_cone(const ExactVector& p, const std::vector<ExactVector>& light,
                           const std::vector<ExactVector>& blocker) {
  std::vector<ExactColumn> generators;
  generators.reserve(blocker.size() + light.size());
  for (const ExactVector& b : blocker) generators.push_back(lifted(b, 1));
  for (const ExactVector& l : light) generators.push_back(lifted(Rational(-1) * l, -1));
  return is_in_cone(generators, lifted(p, 1));
}

bool is_in_hull_of_vertex_shadows(const ExactVector& p, const std::vector<ExactVector>& light,
                                  const std::vector<ExactVector>& blocker) {
  std::vector<ExactColumn> generators;
  for (const ExactVector& b : blocker) {
    generators.push_back(lifted(b, 1));
    for (const ExactVector& l : light) generators.push_back(lifted(b - l, 0));
  }
  return is_in_cone(generators, lifted(p, 1));
}

bool rays_meet_blocker_in_parallel(const std::vector<ExactVector>& light, const std::vector<ExactVector>& blocker,
                                   const std::optional<ExactPlane>& along) {
  // Such a direction d falls toward the blocker's plane and stays on the blocker's side of every plane (l, edge). By
  // Farkas there is none exactly if the plane's normal is a combination of the normals of these.
  ExactPlane plane = plane_of(blocker);
  if (plane.side(light[0]) < 0) plane = plane.reversed();
  const ExactVector inner = middle(blocker);
  std::vector<ExactColumn> inward;
  for (const ExactVector& l : light) {
    for (std::size_t i = 0; i < blocker.size(); ++i) {
      ExactPlane side = plane_through(l, blocker[i], blocker[(i + 1) % blocker.size()]);
      if (side.side(inner) < 0) side = side.reversed();
      inward.push_back({side.normal.x, side.normal.y, side.normal.z});
    }
  }
  if (along) {
    const ExactVector& n = along->normal;
    inward.push_back({n.x, n.y, n.z});
    inward.push_back({Rational(-n.x), Rational(-n.y), Rational(-n.z)});
  }
  return !is_in_cone(inward, {plane.normal.x, plane.normal.y, plane.normal.z});
}

}  // namespace gnomon::laws
