#include "apps/proof/report/divided_blockers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gnomon::report {
namespace {

constexpr std::size_t few_corners = 64;

std::vector<Point3> corners_of(const ConvexPolygon& polygon) {
  std::vector<Point3> corners;
  for (const std::uint32_t i : polygon.corners()) corners.push_back(polygon.points()[i]);
  return corners;
}

/// Corners `first` to `last`, the last one first: so the side that cuts the piece off is asked about first, and rejects
/// most of what the exact level has to cut.
ConvexBlocker piece_between(std::span<const Point3> corners, std::size_t first, std::size_t last) {
  std::vector<Point3> piece = {corners[last % corners.size()]};
  for (std::size_t i = first; i < last; ++i) piece.push_back(corners[i]);
  return ConvexPolygon::from_points(std::move(piece));
}

void add_divided(std::vector<ConvexBlocker>& all, const ConvexPolygon& polygon) {
  const std::vector<Point3> corners = corners_of(polygon);
  const std::size_t n = corners.size();
  const auto step = static_cast<std::size_t>(std::lround(2 * std::sqrt(static_cast<double>(n))));
  std::vector<Point3> inner;
  std::vector<ConvexBlocker> pieces;
  for (std::size_t first = 0; first < n; first += step) {
    const std::size_t last = std::min(first + step, n);
    inner.push_back(corners[first]);
    if (last - first > 1) pieces.push_back(piece_between(corners, first, last));
  }
  all.emplace_back(ConvexPolygon::from_points(std::move(inner)));
  all.insert(all.end(), pieces.begin(), pieces.end());
}

}  // namespace

std::vector<ConvexBlocker> divided(std::span<const ConvexBlocker> blockers) {
  std::vector<ConvexBlocker> all;
  for (const ConvexBlocker& blocker : blockers) {
    const auto* polygon = std::get_if<ConvexPolygon>(&blocker);
    if (polygon != nullptr && polygon->is_flat() && polygon->corners().size() > few_corners) {
      add_divided(all, *polygon);
    } else {
      all.push_back(blocker);
    }
  }
  return all;
}

}  // namespace gnomon::report
