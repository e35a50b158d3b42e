#include "geometry/spatial/occlusion_volume.h"

#include <array>

#include "geometry/spatial/edge_planes.h"

namespace gnomon {
namespace {

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

std::vector<HalfSpace> occlusion_half_spaces(const BodyPair& pair, const std::vector<HalfSpace>& light_planes) {
  std::vector<HalfSpace> result;
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    if (!pair.light_sides(f).negative) result.push_back(facet_half_space(pair, f));
  }
  append(result, separating_blocker_planes(pair));
  append(result, separating_light_planes(pair));
  append(result, light_planes);
  return result;
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

}  // namespace gnomon
