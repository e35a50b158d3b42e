#include "geometry/spatial/umbra_volume.h"

#include <algorithm>

#include "geometry/spatial/edge_planes.h"

namespace gnomon {

bool has_umbra(const BodyPair& pair, const LightContact& contact) {
  // That of a flat blocker has an interior if the corners outside of it lie strictly on one side.
  return !pair.blocker.flat || pair.light_sides(0, contact.corners_outside).strictly_on_one_side();
}

std::vector<HalfSpace> umbra_half_spaces(const BodyPair& pair, const LightContact& contact,
                                         const std::vector<HalfSpace>& light_planes) {
  std::vector<HalfSpace> result;
  const auto& touching = contact.shared_facets;
  for (std::uint32_t f = 0; f < pair.blocker.facets.size(); ++f) {
    const Sides outside = pair.light_sides(f, contact.corners_outside);
    if (outside.positive || outside.zero || std::find(touching.begin(), touching.end(), f) != touching.end()) {
      result.push_back(facet_half_space(pair, f));
    }
  }
  append(result, supporting_blocker_planes(pair, contact.corners_outside));
  append(result, light_planes);
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
