#include "apps/gnomon/view_surfaces.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "apps/gnomon/commands.h"
#include "geometry/bodies/plate.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {
namespace {

std::vector<Point3> reversed(std::span<const Point3> points) {
  return {points.rbegin(), points.rend()};
}

void add_plate(ViewSurfaces& surfaces, const std::string& name, std::span<const Point3> ring, bool is_closed) {
  const ConvexPolygon front = ConvexPolygon::from_points({ring.begin(), ring.end()});
  if (is_closed) return surfaces.add(name, {front});
  surfaces.add(name + "/front", {front});
  surfaces.add(name + "/back", {ConvexPolygon::from_points(reversed(ring))});
}

void add_facets(ViewSurfaces& surfaces, const std::string& name, const ConvexSolid& solid) {
  for (std::size_t f = 0; f < solid.facets().size(); ++f) {
    std::vector<Point3> ring;
    for (const std::uint32_t i : solid.facets()[f].loop) ring.push_back(solid.points()[i]);
    surfaces.add(name + "/facet#" + std::to_string(f), {ConvexPolygon::from_points(std::move(ring))});
  }
}

bool is_closed_mesh(const BlockerShape& shape) {
  const auto* mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->closed;
}

}  // namespace

ViewSurfaces receiver_surfaces(const SpaceScene& scene) {
  ViewSurfaces surfaces;
  for (const SceneReceiver& facet : scene.receivers) {
    if (surfaces.names.empty() || surfaces.names.back() != facet.side) surfaces.add(facet.side, {});
    surfaces.shapes.back().push_back(facet.shape);
  }
  return surfaces;
}

ViewSurfaces blocker_surfaces(const SpaceScene& scene, const SceneBodies& bodies) {
  ViewSurfaces surfaces;
  for (std::size_t b = 0; b < bodies.names.size(); ++b) {
    const bool is_closed = is_closed_mesh(scene.blockers[bodies.blocker_ids[b]].shape);
    const ConvexBlocker& part = bodies.obstacles.blockers[b];
    if (const auto* polygon = std::get_if<ConvexPolygon>(&part)) {
      add_plate(surfaces, bodies.names[b], polygon->points(), is_closed);
      continue;
    }
    const auto& solid = std::get<ConvexSolid>(part);
    const std::vector<Point3> plate = plate_ring(solid);
    plate.empty() ? add_facets(surfaces, bodies.names[b], solid)
                  : add_plate(surfaces, bodies.names[b], plate, is_closed);
  }
  return surfaces;
}

void require_range(const SpaceScene& scene, const ViewSurfaces& surfaces, const Obstacles& obstacles) {
  const auto require = [&](std::string_view refusal, const std::string& what) {
    if (!refusal.empty()) throw UnsupportedError(scene.source + ": " + what + ' ' + std::string(refusal));
  };
  for (std::size_t s = 0; s < surfaces.names.size(); ++s) {
    for (const ConvexPolygon& piece : surfaces.shapes[s]) require(range_refusal(piece.points()), surfaces.names[s]);
  }
  for (const ConvexBlocker& blocker : obstacles.blockers) {
    require(std::visit([](const auto& shape) { return range_refusal(shape.points()); }, blocker), "a blocker");
  }
}

}  // namespace gnomon
