#include "geometry/bodies/own_blockers.h"

#include <algorithm>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/orientation.h"

namespace gnomon {
namespace {

/// True unless a vertex is before the facet's plane by more than rounding.
bool is_behind(const ConvexSolid& solid, const ConvexPolygon& facet) {
  const auto corner = [&](std::size_t k) { return facet.points()[facet.corners()[k]]; };
  return std::ranges::all_of(solid.points(), [&](const Point3& p) {
    if (exact_orientation(corner(0), corner(1), corner(2), p) <= 0) return true;
    std::vector<Point3> ring(facet.points().begin(), facet.points().end());
    ring.push_back(p);
    return polygon_plane(ring)->flatness <= Flatness::rounded;
  });
}

}  // namespace

OwnBlockers::OwnBlockers(std::span<const ConvexBlocker> blockers) : blockers_(blockers) {
  for (std::uint32_t b = 0; b < blockers.size(); ++b) {
    const auto* solid = std::get_if<ConvexSolid>(&blockers[b]);
    if (!solid) continue;
    for (const Point3& p : solid->points()) {
      std::vector<std::uint32_t>& solids = solids_at_[place_key(p)];
      if (solids.empty() || solids.back() != b) solids.push_back(b);
    }
  }
}

std::vector<std::uint32_t> OwnBlockers::of(const ConvexPolygon& facet) const {
  std::vector<std::uint32_t> common;
  bool first = true;
  for (const Point3& p : facet.points()) {
    const auto found = solids_at_.find(place_key(p));
    if (found == solids_at_.end()) return {};
    if (first) common = found->second;
    first = false;
    std::erase_if(common,
                  [&](std::uint32_t b) { return !std::binary_search(found->second.begin(), found->second.end(), b); });
  }
  std::erase_if(common, [&](std::uint32_t b) { return !is_behind(std::get<ConvexSolid>(blockers_[b]), facet); });
  return common;
}

}  // namespace gnomon
