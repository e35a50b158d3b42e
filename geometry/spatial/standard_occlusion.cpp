#include "geometry/spatial/standard_occlusion.h"

#include <array>

namespace gnomon {
namespace {

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

/// Directions that bound the occlusion at infinity. Each runs from a light corner through a blocker corner; the last
/// one that a face adds is the first one of the next.
class DirectionChain {
 public:
  DirectionChain(ExactSpace& space, const StandardPair& pair) : space_(space), pair_(pair) {
    keys_.reserve(2 * pair.blocker.size() + pair.light.size());
    loop_.reserve(keys_.capacity());
  }

  VertexId at(std::uint32_t blocker_corner, std::uint32_t light_corner) {
    const std::array<std::uint32_t, 2> key = {blocker_corner, light_corner};
    if (!keys_.empty() && key == keys_.back()) return loop_.back();
    if (!keys_.empty() && key == keys_.front()) return loop_.front();
    keys_.push_back(key);
    loop_.push_back(space_.add_direction(pair_.light.corner(light_corner), pair_.blocker.corner(blocker_corner)));
    return loop_.back();
  }
  Loop reversed_loop() const { return {loop_.rbegin(), loop_.rend()}; }

 private:
  ExactSpace& space_;
  const StandardPair& pair_;
  std::vector<std::array<std::uint32_t, 2>> keys_;
  std::vector<VertexId> loop_;
};

}  // namespace

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

ConvexPolyhedron standard_occlusion(ExactSpace& space, const StandardPair& pair, const StandardContacts& contacts,
                                    const std::vector<VertexId>& corners, const std::vector<PlaneId>& planes) {
  ConvexPolyhedron result;
  result.faces.reserve(planes.size() + 1);
  result.faces.push_back({planes[0], {corners.begin(), corners.end()}});
  DirectionChain directions(space, pair);
  auto light_side = planes.begin() + 1 + pair.blocker.size();
  for (std::uint32_t k = 0; k < pair.blocker.size(); ++k) {
    const std::uint32_t next = pair.blocker.next(k);
    const VertexId first = directions.at(k, contacts.separating[k].first);
    const VertexId last = directions.at(next, contacts.separating[k].last);
    result.faces.push_back({planes[1 + k], {corners[next], corners[k], first, last}});
    for (std::uint32_t j = contacts.separating[k].last; j != contacts.separating[next].first; j = pair.light.next(j)) {
      const VertexId from = directions.at(next, j);
      const VertexId to = directions.at(next, pair.light.next(j));
      result.faces.push_back({*light_side++, {corners[next], from, to}});
    }
  }
  result.faces.push_back({ExactSpace::at_infinity, directions.reversed_loop()});
  return result;
}

ConvexPolyhedron standard_umbra(ExactSpace& space, const std::vector<VertexId>& corners,
                                const std::vector<PlaneId>& planes) {
  const std::size_t size = corners.size();
  const auto plane = [&](std::size_t side) { return planes[1 + side % size]; };
  std::vector<VertexId> rays;
  rays.reserve(size);
  for (std::size_t k = 0; k < size; ++k) {
    rays.push_back(space.add_meet({plane(k + size - 1), plane(k), ExactSpace::at_infinity}, true));
    // The rays at both ends of a side lie in its plane. They spread if that at its start runs inside the next plane.
    if (space.side(plane(k + 1), rays[k]) >= 0) return {};
  }
  ConvexPolyhedron result;
  result.faces.reserve(size + 2);
  result.faces.push_back({planes[0], {corners.begin(), corners.end()}});
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t next = k + 1 == size ? 0 : k + 1;
    result.faces.push_back({plane(k), {corners[next], corners[k], rays[k], rays[next]}});
  }
  result.faces.push_back({ExactSpace::at_infinity, {rays.rbegin(), rays.rend()}});
  return result;
}

}  // namespace gnomon
