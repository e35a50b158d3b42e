#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "geometry/scene/scene_doubts.h"
#include "gnomon/scene.h"
#include "tests/support/json_schema.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A tube along x with more keys, and more keys of the scene.
std::string shaded_scene(const std::string& light_keys, const std::string& scene_keys = "") {
  return R"({"gnomon": 1, "dimension": 3, )" + scene_keys + R"("blockers": [], "lights": [
    {"name": "tube", "shape": "segment", "vertices": [[0,0,2], [1,0,2]])" +
         light_keys + "}]}";
}

SpaceScene parsed_scene(const std::string& text) {
  std::ifstream stream(GNOMON_SCHEMAS "/scene.schema.json");
  EXPECT_THAT(schema_violation(nlohmann::json::parse(text), nlohmann::json::parse(stream)), IsEmpty()) << text;
  return std::get<SpaceScene>(parse_scene(text, "test", "."));
}

/// What is wrong, in the reader's words.
std::string refusal_of(const std::string& text) {
  try {
    parse_scene(text, "test", ".");
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

bool schema_allows(const std::string& text) {
  std::ifstream stream(GNOMON_SCHEMAS "/scene.schema.json");
  return schema_violation(nlohmann::json::parse(text), nlohmann::json::parse(stream)).empty();
}

Emission emission_of(const std::string& keys) {
  return std::get<LinearLight>(parsed_scene(shaded_scene(keys)).lights[0].shape).emission;
}

TEST(EmissionKeys, ReadProfileFlapsAndShade) {
  EXPECT_TRUE(is_isotropic(emission_of("")));
  EXPECT_TRUE(is_isotropic(emission_of(R"(, "emission": {"profile": "isotropic"})")));
  EXPECT_EQ(emission_of(R"(, "emission": {"profile": "cosine"})").exponent, 1);
  EXPECT_EQ(emission_of(R"(, "emission": {"profile": "cosine", "exponent": 100})").exponent, 100);
  EXPECT_EQ(emission_of(R"(, "flaps": {"angle": 60})").flaps, 60);
  const Emission emission = emission_of(R"(, "shade": {"from": [0,-1,0], "to": [9,0,-1]})");
  EXPECT_EQ(emission.shade->from, (Point3{0, -1, 0}));
  EXPECT_EQ(emission.shade->to, (Point3{9, 0, -1}));
}

struct BadKeys {
  std::string keys;
  std::vector<std::string> parts;
};

class BadLightKeys : public ::testing::TestWithParam<BadKeys> {};

TEST_P(BadLightKeys, AreRefusedByPlaceFoundAndExpected) {
  const std::string message = refusal_of(shaded_scene(GetParam().keys));
  EXPECT_THAT(message, HasSubstr("light \"tube\"")) << GetParam().keys;
  for (const std::string& part : GetParam().parts) EXPECT_THAT(message, HasSubstr(part)) << GetParam().keys;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadLightKeys,
    ::testing::Values(
        BadKeys{R"(, "emission": 1)", {"/lights/0/emission", "the number 1"}},
        BadKeys{R"(, "emission": {})", {"/lights/0/emission/profile", "no such key"}},
        BadKeys{R"(, "emission": {"profile": "sharp"})", {"/emission/profile", "\"sharp\"", "\"cosine\""}},
        BadKeys{R"(, "emission": {"profile": "cosine", "exponent": 1.5})", {"/exponent", "1.5", "from 0 to 100"}},
        BadKeys{R"(, "emission": {"profile": "cosine", "exponent": 101})", {"/exponent", "101", "from 0 to 100"}},
        BadKeys{R"(, "emission": {"profile": "isotropic", "exponent": 1})", {"/exponent", "no exponent"}},
        BadKeys{R"(, "flaps": {"angle": 0})", {"/flaps/angle", "the number 0", "less than 90"}},
        BadKeys{R"(, "flaps": {"angle": 90})", {"/flaps/angle", "the number 90", "less than 90"}},
        BadKeys{R"(, "flaps": {"angel": 9})", {"/flaps/angel", "unknown key", "\"angle\""}},
        BadKeys{R"(, "shade": {"from": [1,0,0], "to": [0,1,0]})", {"/shade/from", "the light's own direction"}},
        BadKeys{R"(, "shade": {"from": [0,1,0], "to": [0,0,0]})", {"/shade/to", "the zero vector"}},
        BadKeys{R"(, "shade": {"from": [0,1,0], "to": [5,2,0]})", {"/shade/to", "half-plane of \"from\""}},
        BadKeys{R"(, "shade": {"from": [0,1,0]})", {"/shade/to", "no such key"}}));

TEST(EmissionKeys, OfOtherLightsAreRefused) {
  const std::string lamp = R"({"gnomon": 1, "dimension": 3, "blockers": [], "lights": [{"name": "lamp",
    "shape": "point", "position": [0,0,1], "flaps": {"angle": 30}}]})";
  EXPECT_THAT(refusal_of(lamp), HasSubstr("/lights/0/flaps"));
  EXPECT_FALSE(schema_allows(lamp));
}

TEST(CameraKey, IsReadWithDefaults) {
  const SpaceScene scene =
      parsed_scene(shaded_scene("", R"("up": "y", "camera": {"eye": [0,0,5], "look_at": [0,0,0]}, )"));
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->up, (Point3{0, 1, 0}));
  EXPECT_EQ(scene.camera->fov, 40);
  EXPECT_EQ(scene.camera->width, 640u);
  EXPECT_FALSE(parsed_scene(shaded_scene("")).camera);
}

class BadCamera : public ::testing::TestWithParam<BadKeys> {};

TEST_P(BadCamera, IsRefusedByPlaceFoundAndExpected) {
  const std::string message = refusal_of(shaded_scene("", "\"camera\": {" + GetParam().keys + "}, "));
  for (const std::string& part : GetParam().parts) EXPECT_THAT(message, HasSubstr(part)) << GetParam().keys;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadCamera,
    ::testing::Values(
        BadKeys{R"("look_at": [0,0,0])", {"/camera/eye", "no such key"}},
        BadKeys{R"("eye": [0,0,1], "look_at": [0,0,1])", {"/camera/look_at", "the eye itself"}},
        BadKeys{R"("eye": [0,0,1], "look_at": [0,0,0])", {"/camera", "along the way"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "up": [0,3,3])", {"/camera/up", "along the way"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "up": [0,0,0])", {"/camera/up", "the zero vector"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "fov": 0)", {"/camera/fov", "the number 0", "less than 180"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "fov": 180)", {"/camera/fov", "the number 180"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "width": 2.5)", {"/camera/width", "the number 2.5"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "height": 0)", {"/camera/height", "the number 0"}},
        BadKeys{R"("eye": [0,1,1], "look_at": [0,0,0], "lens": 1)", {"/camera/lens", "unknown key"}}));

TEST(SmoothnessKeys, BelongToMeshes) {
  const std::string polygon = R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [{"name": "b",
    "shape": "polygon", "vertices": [[0,0,0], [1,0,0], [0,1,0]], "normals": "angle"}]})";
  EXPECT_THAT(refusal_of(polygon), HasSubstr("/blockers/0/normals"));
  EXPECT_FALSE(schema_allows(polygon));
}

/// A mesh of one triangle and one square, written beside the scene.
SpaceScene mesh_scene(const std::string& obj, const std::string& normals, const std::string& more = "") {
  const auto folder = std::filesystem::temp_directory_path() / ("gnomon-normals-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "m.obj") << obj;
  const std::string text = R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [{"name": "m", "shape": "mesh",
    "file": "m.obj", "normals": ")" +
                           normals + "\"" + more + "}]}";
  const auto remove = [](const std::filesystem::path* made) { std::filesystem::remove_all(*made); };
  const std::unique_ptr<const std::filesystem::path, decltype(remove)> clean_up(&folder, remove);
  return std::get<SpaceScene>(parse_scene(text, "test", folder));
}

const std::string obj_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

TEST(SmoothnessKeys, ThatDoNothingAreDoubted) {
  const std::string obj = obj_vertices + "f 1 2 3\n";
  const auto is_doubted = testing::Contains(HasSubstr("blocker \"m\": its \"crease\" does nothing"));
  EXPECT_THAT(lighting_doubts(mesh_scene(obj, "flat", ", \"crease\": 40")), is_doubted);
  EXPECT_THAT(lighting_doubts(mesh_scene(obj, "area", ", \"crease\": 40")), testing::Not(is_doubted));
  EXPECT_THAT(lighting_doubts(mesh_scene(obj, "flat")), testing::Not(is_doubted));
}

TEST(AmbientLight, ThatNothingReflectsIsDoubted) {
  const auto doubts = [](const std::string& material) {
    const std::string text = R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [], "ambient_radiance": 2,
      "materials": [{"name": "chalk")" +
                             material + "}]}";
    return lighting_doubts(std::get<SpaceScene>(parse_scene(text, "test", ".")));
  };
  EXPECT_THAT(doubts(""), testing::Contains(HasSubstr("\"ambient_radiance\": no material has an \"ambient\" share")));
  EXPECT_THAT(doubts(R"(, "ambient": 0.5)"), testing::Not(testing::Contains(HasSubstr("ambient"))));
}

TEST(SmoothnessKeys, TakeNormalsFromAnObjFile) {
  const SpaceScene scene =
      mesh_scene(obj_vertices + "vn 0 0 2\nvn 1 0 1\nf 1//1 2//2 3//-2\nf 2//1 4//1 3//1\n", "file");
  const auto& mesh = std::get<Mesh>(scene.blockers[0].shape);
  ASSERT_EQ(mesh.corner_normals.size(), 2u);
  EXPECT_EQ(mesh.corner_normals[0], (std::vector<Point3>{{0, 0, 2}, {1, 0, 1}, {0, 0, 2}}));
  EXPECT_TRUE(std::get<Mesh>(mesh_scene(obj_vertices + "f 1 2 3\n", "angle").blockers[0].shape).corner_normals.empty());
}

TEST(SmoothnessKeys, RefuseAFileWithoutNormalsAndDoubtZeroOnes) {
  try {
    mesh_scene(obj_vertices + "vn 0 0 1\nf 1//1 2//1 3//1\nf 2 4 3\n", "file");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("/blockers/0/normals"), HasSubstr("line 7, facet 1"),
                                             HasSubstr("a normal at every corner")));
  }
  const SpaceScene zero = mesh_scene(obj_vertices + "vn 0 0 0\nf 1//1 2//1 3//1\n", "file");
  EXPECT_THAT(zero.doubts, testing::Contains(HasSubstr("1 facet, which is shaded flat")));
}

}  // namespace
}  // namespace gnomon
