#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

using testing::HasSubstr;

const std::filesystem::path folder = std::filesystem::path(GNOMON_TEST_DATA) / "scenes" / "bad";

/// A scene file that is refused, and what the message says besides the file.
struct BadScene {
  std::string name;
  std::vector<std::string> parts;
};

std::ostream& operator<<(std::ostream& out, const BadScene& scene) {
  return out << scene.name;
}

const std::vector<BadScene> bad_scenes = {
    // Not the text of a JSON document
    {"empty", {"an empty file"}},
    {"truncated", {"line 5, column 72", "/lights/0/vertices/1/1", "light \"lamp\"", "the end of the text"}},
    {"trailing_comma", {"line 8, column 76", "/blockers/0/vertices/1", "blocker \"table\"", "unexpected ']'"}},
    {"trailing_text", {"line 11, column 1", "unexpected '{'", "expected end of input"}},
    {"comment", {"line 1, column 3", "not valid JSON"}},
    {"invalid_utf8", {"line 8", "/blockers/0/name", "ill-formed UTF-8"}},
    {"utf16", {"UTF-16", "UTF-8"}},
    {"zero_byte", {"line 11, column 1", "zero byte"}},
    {"not_a_number", {"line 8", "/blockers/0/vertices/1/1", "blocker \"table\"", "found NaN", "a finite number"}},
    {"minus_infinity", {"line 8", "/blockers/0/vertices/1/1", "found -Infinity", "a finite number"}},
    {"overflow", {"/blockers/0/vertices/1/1", "blocker \"table\"", "1e999", "overflows", "a finite double"}},
    {"duplicate_key", {"/blockers/0/name", "the key \"name\" twice"}},
    // The document as a whole
    {"root_is_array", {"the whole document", "an array of 0", "an object"}},
    {"no_version", {"/gnomon", "no such key", "version"}},
    {"newer_version", {"/gnomon", "the number 2", "1"}},
    {"version_as_text", {"/gnomon", "the string \"1\""}},
    {"no_dimension", {"/dimension", "no such key", "2 or 3"}},
    {"dimension_4", {"/dimension", "the number 4", "2 or 3"}},
    {"no_lights", {"/lights", "no such key", "an array of lights"}},
    {"no_blockers", {"/blockers", "no such key", "an array of blockers"}},
    {"lights_is_object", {"/lights", "an object", "an array of lights"}},
    {"length_unit_empty", {"/length_unit", "the string \"\"", "a unit of length"}},
    {"length_unit_unknown", {"/length_unit", "the string \"yd\"", "\"mm\", \"cm\", \"m\", \"km\", \"in\", \"ft\""}},
    {"schema_is_number", {"/$schema", "the number 1", "a string"}},
    {"unknown_key_in_scene", {"/fog", "the unknown key \"fog\"", "\"receivers\""}},
    {"unknown_key_in_light",
     {"/lights/0/radiancee", "light \"lamp\"", "the unknown key \"radiancee\"", "\"radiance\""}},
    {"unknown_key_in_blocker", {"/blockers/0/paint", "blocker \"table\"", "the unknown key \"paint\""}},
    // Elements and their names
    {"element_is_number", {"/blockers/0", "the number 7", "an object"}},
    {"no_name", {"/blockers/0/name", "no such key", "a name"}},
    {"empty_name", {"/blockers/0/name", "an empty name"}},
    {"name_is_number", {"/blockers/0/name", "the number 7", "a name (a string)"}},
    {"name_with_slash", {"/blockers/0/name", "a/b", "without '/'"}},
    {"name_with_hash", {"/blockers/0/name", "a#1", "'#'"}},
    {"name_dot_dot", {"/blockers/0/name", "\"..\""}},
    {"name_with_newline", {"/blockers/0/name", "a\\x0ab", "control characters"}},
    {"name_too_long", {"/blockers/0/name", "300 bytes", "at most 200"}},
    {"name_twice", {"/blockers/1/name", "blocker \"table\"", "earlier element", "a name of its own"}},
    {"no_shape", {"/blockers/0/shape", "blocker \"table\"", "no such key", "a shape"}},
    {"unknown_shape", {"/blockers/0/shape", "blocker \"ball\"", "the string \"sphere\"", "\"polytope\""}},
    {"unknown_light_shape", {"/lights/0/shape", "light \"lamp\"", "the string \"spot\"", "\"direction\""}},
    {"receiver_shape", {"/receivers/0/shape", "receiver \"floor\"", "the string \"segment\"", "\"polygon\""}},
    // Vertices
    {"no_vertices", {"/blockers/0/vertices", "blocker \"table\"", "no such key", "an array of points"}},
    {"vertices_is_text", {"/blockers/0/vertices", "the string \"0 0 1\"", "an array of points"}},
    {"vertex_of_two_coordinates", {"/blockers/0/vertices/2", "an array of 2", "a point of 3 coordinates"}},
    {"coordinate_is_text", {"/blockers/0/vertices/2/1", "the string \"1\"", "a coordinate"}},
    {"too_few_vertices", {"/blockers/0/vertices", "blocker \"table\"", "2 vertices", "at least 3"}},
    {"repeated_vertex", {"/blockers/0/vertices/3", "blocker \"table\"", "(0, 0, 1)", "repeats vertex 0"}},
    {"ring_runs_back", {"/blockers/0/vertices/3", "(1, 0, 1)", "repeats vertex 1"}},
    {"ring_goes_round_twice", {"/blockers/0/vertices/5", "goes round twice"}},
    {"all_collinear", {"/blockers/0/vertices", "blocker \"table\"", "all lie on one line", "an area"}},
    {"not_convex", {"/blockers/0/vertices/2", "turns the other way", "a convex polygon"}},
    {"concave_polygon_as_polygon", {"/blockers/0/vertices/2", "turns the other way", "the shape \"concave_polygon\""}},
    {"not_coplanar", {"/blockers/0/vertices/3", "blocker \"table\"", "0.5 away", "at most 1e-2", "triangles"}},
    {"not_coplanar_just_beyond", {"/blockers/0/vertices/3", "0.01415 away", "at most 1e-2"}},
    {"self_crossing", {"/blockers/0/vertices/1", "edges 0 and 2 meet", "a convex polygon"}},
    {"star_order", {"/blockers/0/vertices", "more than once", "edges 0 and 2 meet", "a convex polygon"}},
    {"spike", {"/blockers/0/vertices/2", "blocker \"table\"", "a convex polygon"}},
    // Lights
    {"segment_without_length", {"/lights/0/vertices/1", "light \"tube\"", "repeats vertex 0", "a length"}},
    {"segment_of_three_points", {"/lights/0/vertices", "an array of 3", "an array of 2 points"}},
    {"zero_direction", {"/lights/0/direction", "light \"sun\"", "the zero vector", "a direction"}},
    {"point_without_position", {"/lights/0/position", "light \"bulb\"", "no such key", "a point of 3 coordinates"}},
    {"negative_strength", {"/lights/0/radiance", "light \"lamp\"", "the number -1", "0 or more"}},
    {"strength_is_text", {"/lights/0/radiance", "the string \"bright\"", "a number"}},
    {"wrong_strength", {"/lights/0/radiance", "the unknown key \"radiance\"", "a point light", "\"intensity\""}},
    {"two_sided_is_number", {"/lights/0/two_sided", "the number 1", "true or false"}},
    // Blockers that are no convex polygons
    {"polytope_of_three_points", {"/blockers/0/vertices", "blocker \"post\"", "an array of 3", "at least 4"}},
    {"coplanar_polytope", {"/blockers/0/vertices", "blocker \"post\"", "in one plane", "a volume"}},
    {"concave_polygon_crosses_itself", {"/blockers/0/vertices", "edges 0 and 2 meet", "a simple polygon"}},
    {"concave_polygon_touches_itself", {"/blockers/0/vertices", "edges 0 and 2 meet", "a simple polygon"}},
    {"concave_polygon_not_planar", {"/blockers/0/vertices/", "blocker \"star\"", "away from", "at most 1e-2"}},
    // Holes
    {"hole_outside", {"/blockers/0/holes/0/0", "beside the outer one", "holes inside"}},
    {"hole_across", {"/blockers/0/vertices", "edges 2 and 6 meet", "a simple polygon"}},
    {"hole_in_hole", {"/blockers/0/holes/1/0", "a hole inside of another"}},
    {"hole_touches", {"/blockers/0/holes/0/0", "repeats vertex 0"}},
    {"hole_off_plane", {"/blockers/0/holes/0/2", "1 away"}},
    {"hole_of_two_points", {"/blockers/0/holes/0", "fewer than 3"}},
    {"hole_crosses_itself", {"/blockers/0/vertices", "edges 4 and 6 meet"}},
    {"holes_meet", {"/blockers/0/vertices", "edges 5 and 7 meet"}},
    {"holes_in_concave_polygon_as_polygon", {"/blockers/0/vertices", "not convex", "the shape \"concave_polygon\""}},
    {"mesh_missing", {"/blockers/0/file", "blocker \"vase\"", "no_such.obj", "no such file"}},
    {"mesh_absolute", {"/blockers/0/file", "/etc/passwd", "beside the scene"}},
    {"mesh_above", {"/blockers/0/file", "../vase.obj", "beside the scene"}},
    {"mesh_of_unknown_format", {"/blockers/0/file", "vase.blend", ".obj, .off, .ply or .stl"}},
    {"mesh_bad_index", {"/blockers/0/file", "bad_index.obj", "facet 0", "one of 3 vertices"}},
    // Dimension 2
    {"dimension_2_with_polygon", {"/lights/0/shape", "the string \"polygon\"", "\"segment\", \"point\""}},
    {"dimension_2_with_space_points", {"/blockers/0/vertices/0", "an array of 3", "a point of 2 coordinates"}},
    {"planar_segment_without_length", {"/lights/0/vertices/1", "light \"tube\"", "(1, 1)", "a length"}},
    {"planar_polyline_of_one_point", {"/blockers/0/vertices", "blocker \"wall\"", "an array of 1", "at least 2"}},
    {"planar_direction", {"/lights/0/shape", "light \"sun\"", "the string \"direction\""}},
};

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedWithFilePlaceNameFindingAndExpectation) {
  const std::string file = (folder / (GetParam().name + ".scene.json")).string();
  ASSERT_TRUE(std::filesystem::exists(file));
  try {
    read_scene(file);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file));
    EXPECT_THAT(error.what(), HasSubstr("found"));
    EXPECT_THAT(error.what(), HasSubstr("expected"));
    for (const std::string& part : GetParam().parts) EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BadScenes, testing::ValuesIn(bad_scenes),
                         [](const auto& instance) { return instance.param.name; });

TEST(BadSceneFiles, AreAllListed) {
  std::set<std::string> listed;
  for (const BadScene& scene : bad_scenes) listed.insert(scene.name + ".scene.json");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json") continue;
    EXPECT_TRUE(listed.contains(name)) << name;
  }
}

}  // namespace
}  // namespace gnomon
