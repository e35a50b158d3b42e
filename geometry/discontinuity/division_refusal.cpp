#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/bodies/body.h"
#include "geometry/bodies/closed_surface.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {
namespace {

/// Products of a few differences of such coordinates neither vanish nor overflow in doubles; of smaller ones the
/// arrangement of segments is not to be trusted.
bool is_in_range(const Point3& p) {
  const auto fits = [](double c) { return c == 0 || (0x1p-200 <= std::fabs(c) && std::fabs(c) <= 0x1p200); };
  return fits(p.x) && fits(p.y) && fits(p.z);
}

}  // namespace

std::string_view range_refusal(std::span<const Point3> points) {
  if (std::ranges::all_of(points, is_in_range)) return {};
  return "has a coordinate that is not zero and smaller than 2^-200 (6.2e-61) or larger than 2^200 (1.6e60); "
         "receivers are divided for coordinates in between";
}

std::string_view range_refusal(const Light& light) {
  const auto* parallel = std::get_if<DirectionalLight>(&light);
  return range_refusal(parallel ? std::vector{parallel->direction} : light_points(light));
}

std::string_view division_refusal(const Light& light, std::span<const ClosedSurface> enclosures) {
  const auto* area = std::get_if<AreaLight>(&light);
  if (area && !area->polygon.is_flat()) return "its vertices are not exactly coplanar";
  for (const Point3& p : light_points(light)) {
    const auto holds = [&](const ClosedSurface& surface) { return is_strictly_inside(p, surface); };
    if (std::ranges::any_of(enclosures, holds)) return "it lies inside a closed mesh";
  }
  return {};
}

}  // namespace gnomon
