#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string tent(const std::string& keys) {
  return R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [{"name": "tent", "shape": "mesh", )" + keys +
         "}]}";
}

std::string written_mesh_refusal(const std::string& keys) {
  try {
    parse_scene(tent(keys), "test", ".");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "none";
}

const std::string corners = R"("vertices": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 2]], )";

TEST(WrittenMesh, IsAClosedConvexSolidAsAFileWouldBe) {
  const std::string facets = R"("facets": [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])";
  const auto scene = std::get<SpaceScene>(parse_scene(tent(corners + facets), "test", "."));
  const auto& mesh = std::get<Mesh>(scene.blockers.front().shape);
  EXPECT_TRUE(mesh.closed);
  EXPECT_EQ(mesh.dents, 0);
  EXPECT_EQ(mesh.file, "");
  EXPECT_EQ(convex_parts(scene.blockers.front()).size(), 1U);
  EXPECT_EQ(scene_bodies(scene).names, std::vector<std::string>{"tent"});
}

TEST(WrittenMesh, DoubtsWhatIsNotClosed) {
  const auto scene = std::get<SpaceScene>(parse_scene(tent(corners + R"("facets": [[0, 1, 4]])"), "test", "."));
  ASSERT_FALSE(scene.doubts.empty());
  EXPECT_THAT(scene.doubts.front(), HasSubstr("the mesh is not closed"));
}

TEST(WrittenMesh, RefusesIndicesAndFacetsByTheirPlace) {
  EXPECT_EQ(
      written_mesh_refusal(corners + R"("facets": [[0, 1, 5]])"),
      "test: /blockers/0/facets/0/2: blocker \"tent\": found the number 5; expected the index of a vertex, from 0 "
      "to 4");
  EXPECT_THAT(written_mesh_refusal(corners + R"("facets": [[0, 1, 0.5]])"), HasSubstr("/blockers/0/facets/0/2"));
  EXPECT_THAT(written_mesh_refusal(corners + R"("facets": [[0, 1, 4], [0, 2, 1, 3]])"), HasSubstr("found facet 1, "));
  EXPECT_THAT(written_mesh_refusal(corners + R"("facets": 5)"), HasSubstr("expected an array of facets"));
  EXPECT_THAT(written_mesh_refusal(R"("vertices": [], "facets": [])"),
              HasSubstr("expected an array of at least 3 points"));
  EXPECT_THAT(written_mesh_refusal(R"("facets": [[0, 1, 2]])"), HasSubstr("/blockers/0/vertices"));
  EXPECT_THAT(written_mesh_refusal(R"("vertices": [[0, 0, 0]])"), HasSubstr("/blockers/0/facets"));
}

TEST(WrittenMesh, IsNoFileBesides) {
  const std::string facets = R"("facets": [[0, 1, 4]])";
  for (const char* key : {R"(, "file": "a.obj")", R"(, "usemtl": "wood")"}) {
    EXPECT_THAT(written_mesh_refusal(corners + facets + key), HasSubstr("expected no such key beside \"facets\""))
        << key;
  }
  EXPECT_THAT(written_mesh_refusal(corners + facets + R"(, "normals": "file")"), HasSubstr("as the mesh is no file"));
  EXPECT_EQ(written_mesh_refusal(corners + facets + R"(, "normals": "angle")"), "none");
}

}  // namespace
}  // namespace gnomon
