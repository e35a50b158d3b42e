#include "geometry/spatial/pair_half_spaces.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "geometry/spatial/edge_planes.h"
#include "geometry/spatial/light_contact.h"

namespace gnomon {
namespace {

HalfSpace facet_half_space(const HullPair& pair, std::uint32_t facet) {
  const auto index = pair.blocker.flat ? std::nullopt : std::optional(facet);
  return {{FacetKind::blocker_face, {}, index},
          {pair.blocker.facet_point(facet, 0), pair.blocker.facet_point(facet, 1), pair.blocker.facet_point(facet, 2)}};
}

/// Lowest and highest side on which light corners lie of a facet.
struct Range {
  int low = 1;
  int high = -1;
};

Range light_range(const HullPair& pair, std::uint32_t facet, const std::vector<std::uint32_t>& corners) {
  Range range;
  for (const std::uint32_t j : corners) {
    range.low = std::min(range.low, pair.facet_side(facet, j));
    range.high = std::max(range.high, pair.facet_side(facet, j));
  }
  return range;
}

Range blocker_range(const HullPair& pair, std::uint32_t light_facet) {
  const Hull& light = pair.light;
  Range range;
  for (const Point3& corner : pair.blocker.corners) {
    const int side = pair.orientation(light.facet_point(light_facet, 0), light.facet_point(light_facet, 1),
                                      light.facet_point(light_facet, 2), corner);
    range.low = std::min(range.low, side);
    range.high = std::max(range.high, side);
  }
  return range;
}

/// The half-space in front of a facet of the light.
HalfSpace front_half_space(const HullPair& pair, std::uint32_t facet) {
  const Hull& light = pair.light;
  return {{FacetKind::light_plane, {}, light.flat ? std::nullopt : std::optional(facet)},
          {light.facet_point(facet, 1), light.facet_point(facet, 0), light.facet_point(facet, 2)}};
}

/// The planes of the light's facets that touch the blocker with all of it in front, and that of a one-sided light which
/// the blocker crosses.
std::vector<HalfSpace> light_half_spaces(const HullPair& pair, bool one_sided) {
  std::vector<HalfSpace> result;
  for (std::uint32_t f = 0; f < pair.light.facets.size(); ++f) {
    const Range range = blocker_range(pair, f);
    const bool touches_from_front = range.low == 0 && range.high > 0;
    const bool crosses = f == 0 && one_sided && pair.light.flat && range.low < 0;
    if (touches_from_front || crosses) result.push_back(front_half_space(pair, f));
  }
  return result;
}

std::vector<std::uint32_t> all_corners(const HullPair& pair) {
  std::vector<std::uint32_t> corners(pair.light.corners.size());
  for (std::uint32_t j = 0; j < corners.size(); ++j) corners[j] = j;
  return corners;
}

void append(std::vector<HalfSpace>& to, const std::vector<HalfSpace>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

std::vector<HalfSpace> occlusion_half_spaces(const HullPair& pair, const std::vector<HalfSpace>& light_planes) {
  std::vector<HalfSpace> result;
  const std::vector<std::uint32_t> corners = all_corners(pair);
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    if (light_range(pair, f, corners).low >= 0) result.push_back(facet_half_space(pair, f));
  }
  append(result, separating_blocker_planes(pair));
  append(result, separating_light_planes(pair));
  append(result, light_planes);
  return result;
}

/// True if the umbra of a flat blocker has an interior: the corners outside it lie strictly on one side.
bool has_flat_umbra(const HullPair& pair, const std::vector<std::uint32_t>& outside) {
  const Range range = light_range(pair, 0, outside);
  return range.low == range.high && range.low != 0;
}

std::vector<HalfSpace> umbra_half_spaces(const HullPair& pair, const LightContact& contact,
                                         const std::vector<HalfSpace>& light_planes) {
  std::vector<HalfSpace> result;
  const auto& touching = contact.shared_facets;
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    const bool is_seen = light_range(pair, f, contact.corners_outside).high >= 0;
    if (is_seen || std::find(touching.begin(), touching.end(), f) != touching.end()) {
      result.push_back(facet_half_space(pair, f));
    }
  }
  append(result, supporting_blocker_planes(pair, contact.corners_outside));
  append(result, light_planes);
  return result;
}

bool holds_light(const HullPair& pair, const HalfSpace& half_space) {
  if (pair.light.corners.size() == 1) return true;
  const auto& plane = half_space.plane;
  return std::all_of(pair.light.corners.begin(), pair.light.corners.end(),
                     [&](const Point3& corner) { return pair.orientation(plane[0], plane[1], plane[2], corner) == 0; });
}

/// What tells planes apart that hold the whole light: the facet of the blocker or light, or the blocker edge.
using PlaneKey = std::tuple<FacetKind, std::optional<std::uint32_t>, std::array<double, 6>>;

PlaneKey plane_key(const HalfSpace& half_space) {
  const FacetName& name = half_space.name;
  if (name.kind == FacetKind::blocker_face || name.kind == FacetKind::light_plane) {
    return {name.kind, name.vertex_index, {}};
  }
  const auto coordinates = [](const Point3& p) { return std::array{p.x, p.y, p.z}; };
  auto a = coordinates(half_space.plane[0]);
  auto b = coordinates(half_space.plane[1]);
  if (b < a) std::swap(a, b);
  return {FacetKind::separating_blocker_plane, 0, {a[0], a[1], a[2], b[0], b[1], b[2]}};
}

bool may_be_shared(const HullPair& pair, const HalfSpace& half_space) {
  const FacetKind kind = half_space.name.kind;
  if (kind == FacetKind::separating_light_plane) return false;
  return kind == FacetKind::blocker_face || kind == FacetKind::light_plane || holds_light(pair, half_space);
}

/// Which half-spaces of the umbra are also the occlusion's: those of common facets, of the light's plane, and planes
/// through one blocker edge that hold the whole light.
std::vector<std::uint32_t> shared_half_spaces(const HullPair& pair, const PairHalfSpaces& half_spaces) {
  std::map<PlaneKey, std::uint32_t> known;
  for (std::uint32_t i = 0; i < half_spaces.occlusion.size(); ++i) {
    if (may_be_shared(pair, half_spaces.occlusion[i])) known[plane_key(half_spaces.occlusion[i])] = i;
  }
  std::vector<std::uint32_t> shared;
  for (const HalfSpace& half_space : half_spaces.umbra) {
    const auto found = may_be_shared(pair, half_space) ? known.find(plane_key(half_space)) : known.end();
    shared.push_back(found == known.end() ? PairHalfSpaces::none : found->second);
  }
  return shared;
}

}  // namespace

PairHalfSpaces pair_half_spaces(const HullPair& pair, const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  const bool one_sided = area && !area->two_sided;
  PairHalfSpaces result;
  const std::vector<std::uint32_t> corners = all_corners(pair);
  const Range of_light = pair.blocker.flat ? light_range(pair, 0, corners) : Range{1, -1};
  const bool coplanar = pair.blocker.flat && of_light.low == 0 && of_light.high == 0;
  const bool behind = one_sided && pair.light.flat && blocker_range(pair, 0).high <= 0;
  if (coplanar || behind) return {true, true, {}, {}, {}};
  const std::vector<HalfSpace> light_planes = light_half_spaces(pair, one_sided);
  result.occlusion = occlusion_half_spaces(pair, light_planes);
  LightContact contact;
  if (pair.light.at_infinity) {
    contact.corners_outside = corners;
  } else {
    contact = light_contact(pair);
  }
  result.umbra_empty = pair.blocker.flat && !has_flat_umbra(pair, contact.corners_outside);
  if (result.umbra_empty) return result;
  result.umbra = umbra_half_spaces(pair, contact, light_planes);
  result.shared = shared_half_spaces(pair, result);
  return result;
}

}  // namespace gnomon
