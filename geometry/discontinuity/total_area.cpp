#include "gnomon/receiver_mesh.h"

#include <algorithm>

#include "geometry/numbers/rounding.h"

namespace gnomon {

RegionArea total_area(std::span<const RegionArea> areas) {
  const bool all_exact =
      std::all_of(areas.begin(), areas.end(), [](const RegionArea& a) { return a.exact.has_value(); });
  if (!all_exact) {
    double sum = 0;
    for (const RegionArea& area : areas) sum += area.nearest;
    return {sum, std::nullopt};
  }
  Rational sum = 0;
  for (const RegionArea& area : areas) sum += Rational(*area.exact);
  ExactNumber number = exact_number(sum);
  return {number.nearest, std::move(number.exact)};
}

}  // namespace gnomon
