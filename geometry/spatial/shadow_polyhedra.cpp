#include "geometry/spatial/shadow_polyhedra.h"

#include <algorithm>

namespace gnomon {
namespace {

FacetName facet_name(FacetKind kind, std::uint32_t edge, std::uint32_t vertex) {
  return {kind, static_cast<std::int32_t>(edge), static_cast<std::int32_t>(vertex)};
}

std::vector<HalfSpace> blocker_half_spaces(const StandardPair& pair, const std::vector<TouchedCorners>& contacts,
                                           FacetKind kind) {
  std::vector<HalfSpace> half_spaces(contacts.size());
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const BlockerPlane plane = blocker_plane(pair, k, contacts[k]);
    half_spaces[k] = {
        facet_name(kind, number(plane.edge), number(plane.vertex)),
        {pair.blocker.corner(k), pair.blocker.corner(pair.blocker.next(k)), pair.light.corner(contacts[k].first)}};
  }
  return half_spaces;
}

HalfSpace light_half_space(const StandardPair& pair, const LightSideContact& contact) {
  const LightPlane plane = light_plane(pair, contact);
  return {facet_name(FacetKind::separating_light_plane, number(plane.edge), number(plane.vertex)),
          {pair.light.corner(contact.light_side), pair.light.corner(pair.light.next(contact.light_side)),
           pair.blocker.corner(contact.blocker_corner)}};
}

std::vector<PlaneId> add_all(ExactSpace& space, const std::vector<HalfSpace>& half_spaces) {
  std::vector<PlaneId> planes;
  for (const HalfSpace& half_space : half_spaces) planes.push_back(space.add_plane(half_space));
  return planes;
}

/// The blocker's corners as vertices, each with the planes that go through it.
std::vector<VertexId> add_blocker_corners(ExactSpace& space, const StandardPair& pair,
                                          const std::vector<std::vector<PlaneId>>& planes_of_sides) {
  std::vector<VertexId> corners;
  for (std::uint32_t k = 0; k < pair.blocker.size(); ++k) {
    std::vector<PlaneId> known = {ExactSpace::downward};
    for (const auto& planes : planes_of_sides) {
      known.push_back(planes[k]);
      known.push_back(planes[pair.blocker.previous(k)]);
    }
    corners.push_back(space.add_point(pair.blocker.corner(k), std::move(known)));
  }
  return corners;
}

/// Directions that bound the occlusion at infinity. Each runs from a light corner through a blocker corner; the last
/// one that a face adds is the first one of the next.
class DirectionChain {
 public:
  DirectionChain(ExactSpace& space, const StandardPair& pair) : space_(space), pair_(pair) {}

  VertexId at(std::uint32_t blocker_corner, std::uint32_t light_corner) {
    const std::array<std::uint32_t, 2> key = {blocker_corner, light_corner};
    if (!keys_.empty() && key == keys_.back()) return loop_.back();
    if (!keys_.empty() && key == keys_.front()) return loop_.front();
    keys_.push_back(key);
    loop_.push_back(space_.add_direction(pair_.light.corner(light_corner), pair_.blocker.corner(blocker_corner),
                                         {ExactSpace::at_infinity}));
    return loop_.back();
  }
  std::vector<VertexId> reversed_loop() const { return {loop_.rbegin(), loop_.rend()}; }

 private:
  ExactSpace& space_;
  const StandardPair& pair_;
  std::vector<std::array<std::uint32_t, 2>> keys_;
  std::vector<VertexId> loop_;
};

/// B + cone{b - l}: its corners are the blocker's, its unbounded edges run away from light corners.
ConvexPolyhedron occlusion_polyhedron(ExactSpace& space, const StandardPair& pair, const std::vector<VertexId>& corners,
                                      const std::vector<PlaneId>& sides, const PairHalfSpaces& half_spaces) {
  const std::vector<TouchedCorners>& contacts = half_spaces.separating;
  ConvexPolyhedron result;
  result.faces.push_back({ExactSpace::downward, corners});
  DirectionChain directions(space, pair);
  auto light_side = half_spaces.separating_light.begin();
  for (std::uint32_t k = 0; k < sides.size(); ++k) {
    const std::uint32_t next = pair.blocker.next(k);
    const VertexId first = directions.at(k, contacts[k].first);
    const VertexId last = directions.at(next, contacts[k].last);
    result.faces.push_back({sides[k], {corners[next], corners[k], first, last}});
    for (std::uint32_t j = contacts[k].last; j != contacts[next].first; j = pair.light.next(j)) {
      const VertexId from = directions.at(next, j);
      const VertexId to = directions.at(next, pair.light.next(j));
      result.faces.push_back({space.add_plane(*light_side++), {corners[next], from, to}});
    }
  }
  result.faces.push_back({ExactSpace::at_infinity, directions.reversed_loop()});
  return result;
}

/// The shadow of the light's first corner, cut by all supporting planes.
ConvexPolyhedron umbra_polyhedron(ExactSpace& space, const StandardPair& pair, const std::vector<VertexId>& corners,
                                  const std::vector<PlaneId>& first_corner_sides,
                                  const std::vector<PlaneId>& supporting) {
  const std::uint32_t size = pair.blocker.size();
  std::vector<VertexId> directions;
  for (std::uint32_t k = 0; k < size; ++k) {
    directions.push_back(space.add_direction(
        pair.light.corner(0), pair.blocker.corner(k),
        {ExactSpace::at_infinity, first_corner_sides[k], first_corner_sides[pair.blocker.previous(k)]}));
  }
  ConvexPolyhedron result;
  result.faces.push_back({ExactSpace::downward, corners});
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::uint32_t next = pair.blocker.next(k);
    result.faces.push_back({first_corner_sides[k], {corners[next], corners[k], directions[k], directions[next]}});
  }
  result.faces.push_back({ExactSpace::at_infinity, {directions.rbegin(), directions.rend()}});
  for (std::uint32_t k = 0; k < size; ++k) {
    if (supporting[k] != first_corner_sides[k]) result = space.clipped(result, supporting[k]);
  }
  return result;
}

/// For each blocker side the plane through it and the light's first corner: the supporting one where that touches it.
std::vector<PlaneId> add_first_corner_sides(ExactSpace& space, const StandardPair& pair,
                                            const std::vector<TouchedCorners>& supporting_contacts,
                                            const std::vector<PlaneId>& supporting) {
  std::vector<PlaneId> planes = supporting;
  for (std::uint32_t k = 0; k < planes.size(); ++k) {
    const TouchedCorners& touched = supporting_contacts[k];
    if (touched.holds_light || touched.first == 0 || touched.last == 0) continue;
    const FacetName& name = space.name(supporting[k]);
    planes[k] = space.add_plane(
        {name, {pair.blocker.corner(k), pair.blocker.corner(pair.blocker.next(k)), pair.light.corner(0)}});
  }
  return planes;
}

}  // namespace

PairHalfSpaces::PairHalfSpaces(const StandardPair& pair)
    : separating(separating_contacts(pair)),
      supporting(supporting_contacts(pair)),
      light_sides(separating_light_contacts(pair, separating)),
      blocker_face{{FacetKind::blocker_face}, {pair.blocker.corner(0), pair.blocker.corner(1), pair.blocker.corner(2)}},
      separating_blocker(blocker_half_spaces(pair, separating, FacetKind::separating_blocker_plane)),
      supporting_blocker(blocker_half_spaces(pair, supporting, FacetKind::supporting_blocker_plane)) {
  for (const LightSideContact& contact : light_sides) separating_light.push_back(light_half_space(pair, contact));
}

ShadowPolyhedra::ShadowPolyhedra(const StandardPair& pair, const PairHalfSpaces& half_spaces)
    : space(half_spaces.blocker_face),
      separating_blocker(add_all(space, half_spaces.separating_blocker)),
      supporting_blocker(add_all(space, half_spaces.supporting_blocker)) {
  const std::vector<PlaneId> first_sides =
      add_first_corner_sides(space, pair, half_spaces.supporting, supporting_blocker);
  const std::vector<VertexId> corners =
      add_blocker_corners(space, pair, {separating_blocker, supporting_blocker, first_sides});
  occlusion = occlusion_polyhedron(space, pair, corners, separating_blocker, half_spaces);
  umbra = umbra_polyhedron(space, pair, corners, first_sides, supporting_blocker);
}

bool reaches_infinity(const ExactSpace& space, const ConvexPolyhedron::Face& face) {
  return std::any_of(face.loop.begin(), face.loop.end(), [&](VertexId v) { return space.is_direction(v); });
}

bool reaches_infinity(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  return std::any_of(polyhedron.faces.begin(), polyhedron.faces.end(),
                     [&](const auto& face) { return reaches_infinity(space, face); });
}

std::array<PlaneId, 6> add_box(ExactSpace& space, const Box3& box) {
  std::array<PlaneId, 6> sides;
  for (int side = 0; side < 6; ++side) sides[static_cast<std::size_t>(side)] = space.add_box_side(box, side);
  return sides;
}

ConvexPolyhedron clipped_by_box(ExactSpace& space, ConvexPolyhedron polyhedron, const std::array<PlaneId, 6>& sides) {
  for (const PlaneId side : sides) polyhedron = space.clipped(polyhedron, side);
  return polyhedron;
}

std::vector<ConvexPolyhedron> penumbra_cells(ExactSpace& space, ConvexPolyhedron rest,
                                             const std::vector<PlaneId>& supporting) {
  std::vector<ConvexPolyhedron> cells;
  for (const PlaneId plane : supporting) {
    if (rest.empty()) break;
    ConvexPolyhedron cell = space.clipped(rest, space.add_reversed(plane));
    if (!cell.empty()) cells.push_back(std::move(cell));
    rest = space.clipped(rest, plane);
  }
  return cells;
}

}  // namespace gnomon
