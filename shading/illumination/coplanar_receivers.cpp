#include "shading/illumination/coplanar_receivers.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/numbers/orientation.h"

namespace gnomon::illumination {
namespace {

using SideEnd = std::array<double, 3>;
using DirectedSide = std::pair<SideEnd, SideEnd>;

SideEnd side_end(const Point3& p) {
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

bool is_in_plane_of(const ConvexPolygon& receiver, const ConvexPolygon& other) {
  const auto corner = [&](std::size_t k) { return receiver.points()[receiver.corners()[k]]; };
  return std::ranges::all_of(
      other.points(), [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p) == 0; });
}

/// Sets of numbers, each with its lowest as its name.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t lowest(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t first = lowest(i), second = lowest(j);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> coplanar_groups(std::span<const ConvexPolygon> receivers) {
  // Neighbours with one front run along a shared edge in opposite directions.
  std::map<DirectedSide, std::vector<std::uint32_t>> along;
  const auto side = [&](std::uint32_t r, std::size_t k) {
    const auto points = receivers[r].points();
    return DirectedSide{side_end(points[k]), side_end(points[(k + 1) % points.size()])};
  };
  for (std::uint32_t r = 0; r < receivers.size(); ++r) {
    for (std::size_t k = 0; k < receivers[r].points().size(); ++k) along[side(r, k)].push_back(r);
  }
  Sets sets(receivers.size());
  for (std::uint32_t r = 0; r < receivers.size(); ++r) {
    for (std::size_t k = 0; k < receivers[r].points().size(); ++k) {
      const auto& [from, to] = side(r, k);
      const auto other = along.find({to, from});
      if (other == along.end()) continue;
      for (const std::uint32_t o : other->second) {
        if (is_in_plane_of(receivers[r], receivers[o])) sets.unite(r, o);
      }
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::uint32_t r = 0; r < receivers.size(); ++r) groups[sets.lowest(r)].push_back(r);
  std::vector<std::vector<std::uint32_t>> list;
  for (auto& [lowest, members] : groups) list.push_back(std::move(members));
  return list;
}

}  // namespace gnomon::illumination
