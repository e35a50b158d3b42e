#include "shading/inverse/cells.h"

#include <algorithm>
#include <cmath>

namespace gnomon::inverse {
namespace {

using Planes = std::vector<CellPlane>;

Planes common_planes(const Corner& a, const Corner& b) {
  Planes result;
  std::ranges::set_intersection(a.planes, b.planes, std::back_inserter(result));
  return result;
}

/// An edge lies on two planes at least.
bool is_edge(const Cell& cell, std::size_t i, std::size_t j, const Planes& both) {
  if (both.size() < 2) return false;
  for (std::size_t k = 0; k < cell.corners.size(); ++k) {
    if (k != i && k != j && std::ranges::includes(cell.corners[k].planes, both)) return false;
  }
  return true;
}

void insert(Planes& planes, CellPlane plane) {
  const auto place = std::ranges::lower_bound(planes, plane);
  if (place == planes.end() || *place != plane) planes.insert(place, plane);
}

/// Where the edge from u to v meets a plane that has the values hu < 0 < hv, or the other way round.
Whole crossing(const Whole& u, const Integer& hu, const Whole& v, const Integer& hv) {
  Whole result;
  const Integer a = abs(hv), b = abs(hu);
  for (std::size_t k = 0; k < 4; ++k) result[k] = u[k] * a + v[k] * b;
  return reduced(std::move(result));
}

std::vector<int> signs(const CellSpace& space, const Cell& cell, CellPlane plane, PlaneSide side) {
  std::vector<int> result;
  result.reserve(cell.corners.size());
  for (const Corner& corner : cell.corners) {
    const int sign = space.side(plane, corner.id);
    result.push_back(side == PlaneSide::within ? sign : -sign);
  }
  return result;
}

/// The rank of the corners as vectors of four numbers: the cell's dimension, and one more.
int rank(const CellSpace& space, const Cell& cell) {
  std::vector<std::array<Rational, 4>> rows;
  for (const Corner& corner : cell.corners) {
    std::array<Rational, 4> row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = Rational(space.corner(corner.id)[k]);
    for (const auto& earlier : rows) {
      const auto pivot = static_cast<std::size_t>(
          std::ranges::find_if(earlier, [](const Rational& x) { return x != 0; }) - earlier.begin());
      const Rational factor = row[pivot] / earlier[pivot];
      for (std::size_t k = 0; k < 4; ++k) row[k] -= factor * earlier[k];
    }
    if (std::ranges::any_of(row, [](const Rational& x) { return x != 0; })) rows.push_back(row);
    if (rows.size() == 4) break;
  }
  return static_cast<int>(rows.size());
}

/// The places of a face's corners, one beside the next where the face is a polygon.
std::vector<std::uint32_t> in_order(const Cell& cell, std::vector<std::uint32_t> places) {
  if (places.size() < 4) return places;
  Cell face;
  for (const std::uint32_t place : places) face.corners.push_back(cell.corners[place]);
  std::vector<std::vector<std::uint32_t>> next(places.size());
  for (const auto& [a, b] : edges(face)) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<std::uint32_t> order = {0};
  std::vector<bool> seen(places.size(), false);
  seen[0] = true;
  while (true) {
    const auto& near = next[order.back()];
    const auto found = std::ranges::find_if(near, [&](std::uint32_t k) { return !seen[k]; });
    if (found == near.end()) break;
    seen[*found] = true;
    order.push_back(*found);
  }
  for (std::uint32_t& place : order) place = places[place];
  return order;
}

}  // namespace

CellSpace::Numbers CellSpace::numbers(Whole exact) {
  long largest = std::numeric_limits<long>::min();
  std::array<double, 4> parts{};
  std::array<long, 4> exponents{};
  for (std::size_t k = 0; k < 4; ++k) {
    parts[k] = mpz_get_d_2exp(&exponents[k], exact[k].backend().data());
    if (parts[k] != 0) largest = std::max(largest, exponents[k]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const long down = parts[k] == 0 ? 0 : exponents[k] - largest;
    parts[k] = down < -1000 ? 0 : std::ldexp(parts[k], static_cast<int>(down));
  }
  return {std::move(exact), parts};
}

CellPlane CellSpace::add_plane(Whole plane) {
  planes_.push_back(numbers(std::move(plane)));
  return static_cast<CellPlane>(planes_.size() - 1);
}

CornerId CellSpace::add_corner(Whole corner) {
  corners_.push_back(numbers(std::move(corner)));
  return static_cast<CornerId>(corners_.size() - 1);
}

int CellSpace::side(CellPlane plane, CornerId corner) const {
  const Numbers& p = planes_[plane];
  const Numbers& c = corners_[corner];
  double sum = 0, size = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double product = p.near[k] * c.near[k];
    sum += product;
    size += std::fabs(product);
  }
  const double bound = 9 * 0x1p-52 * size + 0x1p-990;
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  return value(p.exact, c.exact).sign();
}

Cell part(CellSpace& space, const Cell& cell, CellPlane plane, PlaneSide side, FlatParts flat) {
  const std::vector<int> sign = signs(space, cell, plane, side);
  if (std::ranges::none_of(sign, [](int s) { return s > 0; })) return cell;
  if (flat == FlatParts::dropped && std::ranges::none_of(sign, [](int s) { return s < 0; })) return {};
  Cell result;
  for (std::size_t i = 0; i < sign.size(); ++i) {
    if (sign[i] > 0) continue;
    result.corners.push_back(cell.corners[i]);
    if (sign[i] == 0) {
      insert(result.corners.back().planes, plane);
      continue;
    }
    for (std::size_t j = 0; j < sign.size(); ++j) {
      if (sign[j] <= 0) continue;
      Planes both = common_planes(cell.corners[i], cell.corners[j]);
      if (!is_edge(cell, i, j, both)) continue;
      const Whole& u = space.corner(cell.corners[i].id);
      const Whole& v = space.corner(cell.corners[j].id);
      Whole point = crossing(u, value(space.plane(plane), u), v, value(space.plane(plane), v));
      insert(both, plane);
      result.corners.push_back({space.add_corner(std::move(point)), std::move(both)});
    }
  }
  return result;
}

Cell section(CellSpace& space, const Cell& cell, CellPlane plane) {
  const Cell half = part(space, cell, plane, PlaneSide::within, FlatParts::kept);
  Cell result;
  for (const Corner& corner : half.corners) {
    if (space.side(plane, corner.id) != 0) continue;
    result.corners.push_back(corner);
    insert(result.corners.back().planes, plane);
  }
  return result;
}

bool lies(const CellSpace& space, const Cell& cell, CellPlane plane, PlaneSide side) {
  const int outside = side == PlaneSide::within ? 1 : -1;
  return std::ranges::none_of(cell.corners, [&](const Corner& c) { return space.side(plane, c.id) == outside; });
}

int dimension(const CellSpace& space, const Cell& cell) {
  return rank(space, cell) - 1;
}

bool reaches_infinity(const CellSpace& space, const Cell& cell) {
  return std::ranges::any_of(cell.corners, [&](const Corner& c) { return space.corner(c.id)[3] == 0; });
}

Whole middle(const CellSpace& space, const Cell& cell) {
  ExactVector sum;
  Rational weight = 0;
  for (const Corner& c : cell.corners) {
    const Whole& corner = space.corner(c.id);
    const Rational w = corner[3] == 0 ? Rational(1) : Rational(corner[3]);
    sum = sum + ExactVector{Rational(corner[0] / w), Rational(corner[1] / w), Rational(corner[2] / w)};
    if (corner[3] != 0) weight += 1;
  }
  if (weight == 0) return whole_direction(sum);
  const Rational share = 1 / weight;
  return whole_point(share * sum);
}

std::vector<std::array<std::uint32_t, 2>> edges(const Cell& cell) {
  std::vector<std::array<std::uint32_t, 2>> result;
  for (std::uint32_t i = 0; i < cell.corners.size(); ++i) {
    for (std::uint32_t j = i + 1; j < cell.corners.size(); ++j) {
      if (is_edge(cell, i, j, common_planes(cell.corners[i], cell.corners[j]))) result.push_back({i, j});
    }
  }
  return result;
}

std::vector<CellFace> faces(const CellSpace& space, const Cell& cell) {
  std::vector<CellPlane> planes;
  for (const Corner& corner : cell.corners) planes.insert(planes.end(), corner.planes.begin(), corner.planes.end());
  std::ranges::sort(planes);
  planes.erase(std::ranges::unique(planes).begin(), planes.end());
  // What a plane touches is part of a face; faces are the largest such sets but the cell itself.
  std::vector<CellFace> touched;
  for (const CellPlane plane : planes) {
    CellFace face{plane, {}};
    for (std::uint32_t i = 0; i < cell.corners.size(); ++i) {
      if (space.side(plane, cell.corners[i].id) == 0) face.corners.push_back(i);
    }
    const auto is_same = [&](const CellFace& other) { return other.corners == face.corners; };
    if (face.corners.size() == cell.corners.size() || std::ranges::any_of(touched, is_same)) continue;
    touched.push_back(std::move(face));
  }
  std::vector<CellFace> result;
  for (const CellFace& face : touched) {
    const auto is_more = [&](const CellFace& other) {
      return other.corners.size() > face.corners.size() && std::ranges::includes(other.corners, face.corners);
    };
    if (std::ranges::none_of(touched, is_more)) result.push_back({face.plane, in_order(cell, face.corners)});
  }
  return result;
}

}  // namespace gnomon::inverse
