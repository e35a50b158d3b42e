#include "shading/illumination/coplanar_receivers.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <utility>

#include "geometry/numbers/orientation.h"
#include "geometry/numbers/place_key.h"
#include "geometry/numbers/vector3.h"

namespace gnomon::illumination {
namespace {

using DirectedSide = std::pair<PlaceKey, PlaceKey>;

ExactVector normal_of_receiver(const ConvexPolygon& receiver) {
  const auto corner = [&](std::size_t k) { return exact(receiver.points()[receiver.corners()[k]]); };
  return cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// The two sides of one polygon run along all edges in opposite directions, too.
bool have_one_front(const ConvexPolygon& receiver, const ConvexPolygon& other) {
  return dot(normal_of_receiver(receiver), normal_of_receiver(other)) > 0;
}

bool is_in_plane_of(const ConvexPolygon& receiver, const ConvexPolygon& other) {
  const auto corner = [&](std::size_t k) { return receiver.points()[receiver.corners()[k]]; };
  return std::ranges::all_of(
      other.points(), [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p) == 0; });
}

DirectedSide side_of(const ConvexPolygon& receiver, std::size_t k) {
  const auto points = receiver.points();
  return {place_key(points[k]), place_key(points[(k + 1) % points.size()])};
}

}  // namespace

std::vector<std::vector<std::uint32_t>> coplanar_groups(std::span<const ConvexPolygon> receivers) {
  std::map<DirectedSide, std::vector<std::uint32_t>> along;
  const auto n = static_cast<std::uint32_t>(receivers.size());
  for (std::uint32_t r = 0; r < n; ++r) {
    for (std::size_t k = 0; k < receivers[r].points().size(); ++k) along[side_of(receivers[r], k)].push_back(r);
  }
  // Neighbours with one front run along a shared edge in opposite directions.
  boost::disjoint_sets_with_storage<> sets(n);
  for (const auto& [side, members] : along) {
    const auto others = along.find({side.second, side.first});
    if (others == along.end()) continue;
    for (const std::uint32_t r : members) {
      for (const std::uint32_t other : others->second) {
        const bool are_one_wall =
            is_in_plane_of(receivers[r], receivers[other]) && have_one_front(receivers[r], receivers[other]);
        if (are_one_wall) sets.union_set(r, other);
      }
    }
  }
  std::map<std::size_t, std::size_t> place_of_set;
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::uint32_t r = 0; r < n; ++r) {
    const auto [place, is_new] = place_of_set.try_emplace(sets.find_set(r), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(r);
  }
  return groups;
}

}  // namespace gnomon::illumination
