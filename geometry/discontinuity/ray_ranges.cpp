#include "geometry/discontinuity/ray_ranges.h"

#include <algorithm>

namespace gnomon::event {

bool intersect(const Pencil& pencil, RayRange& range, const RayRange& other) {
  if (pencil.order(range.first, other.first) > 0) range.first = other.first;
  if (pencil.order(other.last, range.last) > 0) range.last = other.last;
  return pencil.order(range.first, range.last) > 0;
}

void subtract(const Pencil& pencil, std::vector<RayRange>& blocked, std::vector<RayRange>& ranges) {
  if (blocked.empty()) return;
  std::sort(blocked.begin(), blocked.end(),
            [&](const RayRange& p, const RayRange& q) { return pencil.order(p.first, q.first) > 0; });
  std::vector<RayRange> left;
  for (const RayRange& range : ranges) {
    Ray start = range.first;
    for (const RayRange& hole : blocked) {
      if (pencil.order(hole.first, range.last) <= 0) break;
      if (pencil.order(start, hole.last) <= 0) continue;
      if (pencil.order(start, hole.first) > 0) left.push_back({start, hole.first});
      start = hole.last;
      if (pencil.order(start, range.last) <= 0) break;
    }
    if (pencil.order(start, range.last) > 0) left.push_back({start, range.last});
  }
  ranges.swap(left);
}

}  // namespace gnomon::event
