/// What a program outside of the project does with an installed gnomon: read a scene, name the extremal planes of its
/// pair, ask whether points lie in shadow. Ends with 0 if the answers are those of a lamp above an aligned square.

#include <cstdio>
#include <variant>

#include <gnomon/scene.h>
#include <gnomon/shadow_volume.h>

namespace {

constexpr const char* kScene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}],
  "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]}]
})";

}  // namespace

int main() {
  const auto scene = std::get<gnomon::SpaceScene>(gnomon::parse_scene(kScene, "table", "."));
  const gnomon::Light& lamp = scene.lights.front().shape;
  const auto& table = std::get<gnomon::ConvexPolygon>(scene.blockers.front().shape);

  const gnomon::ExtremalPlanes planes = gnomon::extremal_planes(lamp, table);
  const gnomon::ShadowVolumes volumes = gnomon::shadow_volumes(lamp, table);
  const bool below_is_dark = volumes.umbra.oriented_side({0, 0, 0}) == gnomon::Side::inside;
  const bool beside_is_lit = volumes.occlusion.oriented_side({9, 9, 1}) == gnomon::Side::outside;

  std::printf("%zu separating and %zu supporting planes\n", planes.separating_blocker.size(),
              planes.supporting_blocker.size());
  const bool aligned_squares =
      planes.separating_blocker.size() == 4 && planes.separating_light.empty() && planes.supporting_blocker.size() == 4;
  return below_is_dark && beside_is_lit && aligned_squares ? 0 : 1;
}
