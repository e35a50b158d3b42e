#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "gnomon/scene.h"
#include "tests/geometry/discontinuity/mesh_probe.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

/// Scenes on which meshers are known to break: edges that coincide, coplanar walls, boxes that touch, walls around a
/// hole.
class NamedScene : public testing::TestWithParam<std::string> {};

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(GNOMON_TEST_DATA "/scenes/receivers")) {
    const std::string name = entry.path().filename().string();
    names.push_back(name.substr(0, name.find('.')));
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST_P(NamedScene, HasTheRegionsOfTheDefinitionOnEveryReceiver) {
  const auto scene =
      std::get<SpaceScene>(read_scene(GNOMON_TEST_DATA "/scenes/receivers/" + GetParam() + ".scene.json"));
  const std::vector<ConvexBlocker> blockers = parts_of_blockers(scene);
  const std::vector<ConvexPolygon> receivers = receivers_of(scene);
  const Light& light = scene.lights.front().shape;
  const std::vector<ReceiverMesh> meshes = receiver_division(light, blockers, receivers);
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    EXPECT_TRUE(meshes[r].areas_add_up());
    const ProbeResult result = compare_with_definition(meshes[r], receivers[r], light, blockers, 400, 11);
    EXPECT_EQ(result.different, 0U);
    std::cout << GetParam() << ", " << scene.receivers[r].name << ": " << meshes[r].faces().size() << " faces, "
              << meshes[r].names().size() << " events, " << result.unresolved << " of " << result.compared
              << " points unresolved\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Receivers, NamedScene, testing::ValuesIn(scene_names()),
                         [](const auto& named) { return named.param; });

}  // namespace
}  // namespace gnomon
