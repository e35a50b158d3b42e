#include "apps/proof/laws/subject.h"

#include <algorithm>
#include <utility>

#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/shadow_tree.h"

namespace gnomon::laws {

DividedReceiver divided_receiver(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                 const ConvexPolygon& receiver) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{receiver}).front();
  MeshDrawing drawing = mesh.drawing();
  // Triangles of a face with an arc may reach a little beyond it.
  std::erase_if(drawing.triangles, [&](const ReceiverTriangle& t) {
    return std::ranges::any_of(mesh.edges(), [&](const MeshEdge& edge) {
      return edge.arc != MeshEdge::nowhere && (edge.left == t.face || edge.right == t.face);
    });
  });
  DividedReceiver result{std::move(drawing.points),    mesh.edges(), {}, mesh.names(),
                         std::move(drawing.triangles), mesh.arcs()};
  for (const MeshFace& face : mesh.faces()) result.faces.push_back(face.region);
  return result;
}

FoundOccluders found_occluders(const LinearLight& light, const std::vector<ConvexBlocker>& blockers,
                               const LinearSearch& search, const std::vector<Point3>& points) {
  FastLinearVisibility visibility(light, BlockerSet(blockers), search);
  FoundOccluders found;
  for (const Point3& p : points) {
    const auto occluders = visibility.occluders(p);
    if (occluders) {
      found.emplace_back(std::in_place, occluders->begin(), occluders->end());
    } else {
      found.emplace_back();
    }
  }
  return found;
}

std::vector<std::optional<Region>> tree_regions(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                                const std::vector<Point3>& points) {
  std::vector<std::optional<Region>> regions(points.size());
  std::optional<ShadowTree> tree;
  if (const auto* point = std::get_if<PointLight>(&light)) tree.emplace(*point, blockers);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) tree.emplace(*sun, blockers);
  for (std::size_t i = 0; tree && i < points.size(); ++i) regions[i] = tree->region_from(points[i]);
  return regions;
}

std::vector<Visibility> searched_visibility(const LinearLight& light, const std::vector<ConvexBlocker>& blockers,
                                            const LinearSearch& search, const std::vector<Point3>& points,
                                            const Point3& normal) {
  const PreparedObstacles obstacles({blockers, {}});
  LightVisibility visibility(light, obstacles, search);
  std::vector<Visibility> seen;
  for (const Point3& p : points) {
    seen.push_back(visibility.at(p));
    seen.push_back(visibility.received(resting_point(obstacles, p, normal)));
  }
  return seen;
}

}  // namespace gnomon::laws
