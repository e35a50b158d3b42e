#include "geometry/spatial/pair_half_spaces.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "geometry/spatial/light_contact.h"
#include "geometry/spatial/occlusion_volume.h"
#include "geometry/spatial/umbra_volume.h"

namespace gnomon {
namespace {

/// The half-space in front of a facet of the light.
HalfSpace front_half_space(const BodyPair& pair, std::uint32_t facet) {
  const Body& light = pair.light;
  return {{FacetKind::light_plane, {}, light.flat ? std::nullopt : std::optional(facet)},
          {light.facet_point(facet, 1), light.facet_point(facet, 0), light.facet_point(facet, 2)}};
}

/// The planes of the light's facets that touch the blocker with all of it in front, and that of a one-sided light which
/// the blocker crosses.
std::vector<HalfSpace> light_half_spaces(const BodyPair& pair, bool one_sided) {
  std::vector<HalfSpace> result;
  for (std::uint32_t f = 0; f < pair.light.facets.size(); ++f) {
    const Sides blocker = pair.blocker_sides(f);
    const bool touches_from_front = blocker.zero && blocker.positive && !blocker.negative;
    const bool crosses = f == 0 && one_sided && pair.light.flat && blocker.negative;
    if (touches_from_front || crosses) result.push_back(front_half_space(pair, f));
  }
  return result;
}

bool holds_light(const BodyPair& pair, const HalfSpace& half_space) {
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

bool may_be_shared(const BodyPair& pair, const HalfSpace& half_space) {
  const FacetKind kind = half_space.name.kind;
  if (kind == FacetKind::separating_light_plane) return false;
  return kind == FacetKind::blocker_face || kind == FacetKind::light_plane || holds_light(pair, half_space);
}

/// Which half-spaces of the umbra are also the occlusion's: those of common facets, of the light's plane, and planes
/// through one blocker edge that hold the whole light.
std::vector<std::uint32_t> shared_half_spaces(const BodyPair& pair, const PairHalfSpaces& half_spaces) {
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

HalfSpace blocker_half_space(const StandardPair& pair, std::uint32_t k, const TouchedCorners& touched, FacetKind kind) {
  const BlockerPlane plane = blocker_plane(pair, k, touched);
  return {{kind, number(plane.edge), number(plane.vertex)},
          {pair.blocker.corner(k), pair.blocker.corner(pair.blocker.next(k)), pair.light.corner(touched.first)}};
}

HalfSpace light_half_space(const StandardPair& pair, const LightSideContact& contact) {
  const LightPlane plane = light_plane(pair, contact);
  return {{FacetKind::separating_light_plane, number(plane.edge), number(plane.vertex)},
          {pair.light.corner(contact.light_side), pair.light.corner(pair.light.next(contact.light_side)),
           pair.blocker.corner(contact.blocker_corner)}};
}

}  // namespace

HalfSpace facet_half_space(const BodyPair& pair, std::uint32_t facet) {
  const auto index = pair.blocker.flat ? std::nullopt : std::optional(facet);
  return {{FacetKind::blocker_face, {}, index},
          {pair.blocker.facet_point(facet, 0), pair.blocker.facet_point(facet, 1), pair.blocker.facet_point(facet, 2)}};
}

void append(std::vector<HalfSpace>& to, const std::vector<HalfSpace>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

PairHalfSpaces pair_half_spaces(const BodyPair& pair, const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  const bool one_sided = area && !area->two_sided;
  PairHalfSpaces result;
  const bool coplanar = pair.blocker.flat && pair.light_sides(0).all_zero();
  const bool behind = one_sided && pair.light.flat && !pair.blocker_sides(0).positive;
  if (coplanar || behind) return {true, true, {}, {}, {}};
  const std::vector<HalfSpace> light_planes = light_half_spaces(pair, one_sided);
  result.occlusion = occlusion_half_spaces(pair, light_planes);
  LightContact contact;
  if (pair.light.at_infinity) {
    contact.corners_outside = {0};
  } else {
    contact = light_contact(pair);
  }
  result.umbra_empty = !has_umbra(pair, contact);
  if (result.umbra_empty) return result;
  result.umbra = umbra_half_spaces(pair, contact, light_planes);
  result.shared = shared_half_spaces(pair, result);
  return result;
}

StandardContacts::StandardContacts(const StandardPair& pair)
    : separating(separating_contacts(pair)),
      supporting(supporting_contacts(pair)),
      light_sides(separating_light_contacts(pair, separating)) {}

PairHalfSpaces standard_half_spaces(const StandardPair& pair, const StandardContacts& contacts) {
  const std::uint32_t size = pair.blocker.size();
  const HalfSpace face{{FacetKind::blocker_face},
                       {pair.blocker.corner(0), pair.blocker.corner(1), pair.blocker.corner(2)}};
  PairHalfSpaces result;
  result.occlusion.reserve(1 + size + contacts.light_sides.size());
  result.umbra.reserve(1 + size);
  result.shared.reserve(1 + size);
  result.occlusion.push_back(face);
  result.umbra.push_back(face);
  result.shared.push_back(0);
  for (std::uint32_t k = 0; k < size; ++k) {
    using enum FacetKind;
    const TouchedCorners& supporting = contacts.supporting[k];
    result.occlusion.push_back(blocker_half_space(pair, k, contacts.separating[k], separating_blocker_plane));
    result.umbra.push_back(blocker_half_space(pair, k, supporting, supporting_blocker_plane));
    result.shared.push_back(supporting.holds_light ? 1 + k : PairHalfSpaces::none);
  }
  for (const LightSideContact& contact : contacts.light_sides) {
    result.occlusion.push_back(light_half_space(pair, contact));
  }
  return result;
}

std::vector<VertexId> standard_corners(ExactSpace& space, const StandardPair& pair) {
  std::vector<VertexId> corners;
  corners.reserve(pair.blocker.size());
  for (std::uint32_t k = 0; k < pair.blocker.size(); ++k) corners.push_back(space.add_point(pair.blocker.corner(k)));
  return corners;
}

}  // namespace gnomon
