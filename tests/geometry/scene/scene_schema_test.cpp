#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/json_schema.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = std::filesystem;

json parsed(const fs::path& file) {
  std::ifstream stream(file);
  return json::parse(stream, nullptr, false);
}

const json& scene_schema() {
  static const json schema = parsed(GNOMON_SCHEMAS "/scene.schema.json");
  return schema;
}

std::string violation(const fs::path& file) {
  return schema_violation(parsed(file), scene_schema());
}

std::size_t expect_valid_scenes(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.path().string().ends_with(".scene.json") || entry.path().string().find("/bad/") != std::string::npos) {
      continue;
    }
    EXPECT_THAT(violation(entry.path()), IsEmpty()) << entry.path();
    ++count;
  }
  return count;
}

TEST(SceneSchema, HoldsForTheExamplesAndForTheScenesOfTests) {
  EXPECT_GT(expect_valid_scenes(GNOMON_EXAMPLES), 10u);
  EXPECT_GT(expect_valid_scenes(GNOMON_TEST_DATA "/scenes"), 10u);
}

TEST(SceneSchema, RefusesNamesAndMeshFilesThatLeadElsewhereAndAnUpAxisInThePlane) {
  const auto blocker = [](const char* name, const char* file) {
    return json{{"gnomon", 1},
                {"dimension", 3},
                {"lights", json::array()},
                {"blockers", {{{"name", name}, {"shape", "mesh"}, {"file", file}}}}};
  };
  for (const char* good : {"vase.obj", "meshes/vase.obj", "a..b/..vase.obj", "."}) {
    EXPECT_THAT(schema_violation(blocker("vase", good), scene_schema()), IsEmpty()) << good;
  }
  for (const char* bad : {"/vase.obj", "../vase.obj", "a/../vase.obj", "a/.."}) {
    EXPECT_THAT(schema_violation(blocker("vase", bad), scene_schema()), Not(IsEmpty())) << bad;
  }
  EXPECT_THAT(schema_violation(blocker("..", "vase.obj"), scene_schema()), Not(IsEmpty()));
  EXPECT_THAT(schema_violation(blocker("...", "vase.obj"), scene_schema()), IsEmpty());
  json plane = {{"gnomon", 1}, {"dimension", 2}, {"lights", json::array()}, {"blockers", json::array()}};
  EXPECT_THAT(schema_violation(plane, scene_schema()), IsEmpty());
  plane["up"] = "y";
  EXPECT_THAT(schema_violation(plane, scene_schema()), Not(IsEmpty()));
}

TEST(SceneSchema, RefusesWhatTheReaderRefusesByItsForm) {
  for (const std::string name : {"root_is_array",
                                 "no_version",
                                 "newer_version",
                                 "no_dimension",
                                 "dimension_4",
                                 "no_lights",
                                 "no_blockers",
                                 "lights_is_object",
                                 "length_unit_empty",
                                 "length_unit_unknown",
                                 "unknown_key_in_scene",
                                 "unknown_key_in_light",
                                 "unknown_key_in_blocker",
                                 "element_is_number",
                                 "no_name",
                                 "empty_name",
                                 "name_is_number",
                                 "name_with_slash",
                                 "name_with_hash",
                                 "name_with_newline",
                                 "name_too_long",
                                 "no_shape",
                                 "unknown_shape",
                                 "unknown_light_shape",
                                 "receiver_shape",
                                 "no_vertices",
                                 "vertices_is_text",
                                 "vertex_of_two_coordinates",
                                 "coordinate_is_text",
                                 "too_few_vertices",
                                 "segment_of_three_points",
                                 "point_without_position",
                                 "negative_strength",
                                 "strength_is_text",
                                 "wrong_strength",
                                 "two_sided_is_number",
                                 "polytope_of_three_points",
                                 "dimension_2_with_polygon",
                                 "dimension_2_with_space_points",
                                 "planar_polyline_of_one_point",
                                 "planar_direction"}) {
    const fs::path file = fs::path(GNOMON_TEST_DATA "/scenes/bad") / (name + ".scene.json");
    ASSERT_TRUE(fs::exists(file)) << name;
    EXPECT_THAT(violation(file), Not(IsEmpty())) << name;
  }
}

TEST(SceneSchema, TellsThePlaceOfAViolation) {
  EXPECT_THAT(schema_violation({{"a", {1, "x"}}}, {{"properties", {{"a", {{"items", {{"type", "integer"}}}}}}}}),
              HasSubstr("/a/1"));
  EXPECT_THROW(schema_violation(1, {{"multipleOf", 2}}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon
