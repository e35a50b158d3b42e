#include "gnomon/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

namespace gnomon {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path scenes = std::filesystem::path(GNOMON_TEST_DATA) / "scenes";

SpaceScene good_scene(const std::string& name) {
  return std::get<SpaceScene>(read_scene(scenes / "good" / (name + ".scene.json")));
}

SpaceScene space_scene(const std::string& text) {
  return std::get<SpaceScene>(parse_scene(text, "test", {}));
}

std::string message_of(const std::string& text) {
  try {
    parse_scene(text, "test.scene.json", {});
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

std::string scene_with_table(const std::string& vertices) {
  return R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [{"name": "table", "shape": "polygon", "vertices": )" +
         vertices + "}]}";
}

TEST(SceneReader, ReadsEveryShapeOfSpace) {
  const SpaceScene scene = good_scene("everything_in_space");
  EXPECT_EQ(dimension(scene), 3);
  EXPECT_EQ(scene.length_unit, "cm");
  ASSERT_EQ(scene.lights.size(), 4u);
  const auto& lamp = std::get<AreaLight>(scene.lights[0].shape);
  EXPECT_TRUE(lamp.two_sided);
  EXPECT_EQ(lamp.polygon.points()[1], (Point3{-1, 1, 4}));
  EXPECT_EQ(scene.lights[0].strength, 2.5);
  EXPECT_EQ(std::get<LinearLight>(scene.lights[1].shape).end, (Point3{3, 0, 5}));
  EXPECT_EQ(std::get<PointLight>(scene.lights[2].shape).position, (Point3{0, 0, 5}));
  EXPECT_EQ(std::get<DirectionalLight>(scene.lights[3].shape).direction, (Point3{0, 0, -1}));
  EXPECT_EQ(scene.lights[3].strength, 0.5);
  ASSERT_EQ(scene.blockers.size(), 4u);
  EXPECT_THAT(std::get<ConvexPolygon>(scene.blockers[0].shape).corners(), ElementsAre(0, 2, 3, 4));
  EXPECT_EQ(std::get<Polytope>(scene.blockers[1].shape).vertices.size(), 4u);
  EXPECT_EQ(std::get<ConcavePolygon>(scene.blockers[2].shape).vertices.size(), 4u);
  EXPECT_TRUE(std::get<Mesh>(scene.blockers[3].shape).closed);
  ASSERT_EQ(scene.receivers.size(), 1u);
  EXPECT_EQ(scene.receivers[0].name, "floor");
  EXPECT_THAT(scene.doubts, IsEmpty());
}

TEST(SceneReader, ReadsEveryShapeOfThePlane) {
  const Scene read = read_scene(scenes / "good" / "everything_in_the_plane.scene.json");
  EXPECT_EQ(dimension(read), 2);
  const auto& scene = std::get<PlaneScene>(read);
  EXPECT_EQ(scene.length_unit, "m");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_THAT(scene.lights[0].vertices, ElementsAre(Point2{0, 5}, Point2{3, 5}));
  EXPECT_EQ(scene.lights[0].strength, 1.5);
  EXPECT_THAT(scene.lights[1].vertices, ElementsAre(Point2{0, 5}));
  ASSERT_EQ(scene.blockers.size(), 2u);
  EXPECT_EQ(scene.blockers[1].vertices.size(), 4u);
  EXPECT_EQ(scene.receivers.size(), 1u);
  EXPECT_THAT(scene.doubts, IsEmpty());
}

TEST(SceneReader, AcceptsARoundedPolygonWithADoubtThatTellsItsDeviation) {
  const SpaceScene scene = good_scene("rounded_polygon");
  EXPECT_FALSE(std::get<ConvexPolygon>(scene.blockers[0].shape).is_flat());
  EXPECT_THAT(scene.doubts, Contains(AllOf(HasSubstr("blocker \"table\""), HasSubstr("deviate"), HasSubstr("e-17 m"))));
}

TEST(SceneReader, AcceptsABentPolygonAsTrianglesWithADoubtThatTellsItsDeviation) {
  const SpaceScene scene = good_scene("bent_polygon");
  EXPECT_EQ(std::get<ConcavePolygon>(scene.blockers[0].shape).shape, "polygon");
  EXPECT_THAT(scene.doubts, ElementsAre(AllOf(HasSubstr("blocker \"table\""), HasSubstr("up to 2e-09 m"),
                                              HasSubstr("taken as triangles, table#0"))));
}

TEST(SceneReader, MendsHarmlessDefectsWithADoubtEach) {
  const SpaceScene scene = good_scene("mended");
  EXPECT_EQ(std::get<ConvexPolygon>(scene.blockers[0].shape).points().size(), 3u);
  EXPECT_EQ(std::get<ConcavePolygon>(scene.blockers[1].shape).vertices.size(), 4u);
  EXPECT_THAT(std::get<ConcavePolygon>(scene.blockers[2].shape).rings, ElementsAre(ElementsAre(0, 1, 4)));
  EXPECT_THAT(scene.doubts, ElementsAre(AllOf(HasSubstr("\"closed\""), HasSubstr("last vertex repeats the first")),
                                        AllOf(HasSubstr("\"stutter\""), HasSubstr("1 vertex repeating a neighbour")),
                                        AllOf(HasSubstr("\"spike\""), HasSubstr("along an edge and back"))));
}

TEST(SceneReader, PassesOverAByteOrderMarkWithADoubt) {
  const SpaceScene scene = space_scene("\xef\xbb\xbf" + std::string(default_scene_text()));
  EXPECT_THAT(scene.doubts, ElementsAre(HasSubstr("byte-order mark")));
}

TEST(SceneReader, AcceptsTheAddressOfASchema) {
  const Scene scene =
      parse_scene(R"({"$schema": "x", "gnomon": 1, "dimension": 2, "lights": [], "blockers": []})", "test", {});
  EXPECT_TRUE(std::holds_alternative<PlaneScene>(scene));
}

TEST(SceneReader, ReadsHolesAsRingsAndAsSeams) {
  const SpaceScene scene = good_scene("holes");
  EXPECT_THAT(std::get<ConcavePolygon>(scene.blockers[0].shape).rings,
              ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6), ElementsAre(7, 8, 9)));
  EXPECT_THAT(std::get<ConcavePolygon>(scene.blockers[1].shape).rings,
              ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(5, 6, 7)));
  EXPECT_THAT(scene.doubts, ElementsAre(HasSubstr("last vertex repeats the first")));
}

TEST(SceneReader, TakesBentLightsAndReceiversAsTrianglesAndConcaveReceiversAsConvexPolygons) {
  const std::string bent = R"("shape": "polygon", "vertices": [[0,0,1],[1,0,1],[1,1,1],[0,1,1.001]]})";
  const SpaceScene scene = space_scene(R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "radiance": 2, )" +
                                       bent + R"(], "blockers": [], "receivers": [{"name": "roof", )" + bent +
                                       R"(, {"name": "yard", "shape": "concave_polygon", "vertices":
                                           [[0,0,0],[2,0,0],[2,1,0],[1,1,0],[1,2,0],[0,2,0]]}]})");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[1].name, "lamp#1");
  EXPECT_EQ(scene.lights[1].strength, 2);
  EXPECT_EQ(std::get<AreaLight>(scene.lights[1].shape).polygon.points()[2], (Point3{0, 1, 1.001}));
  std::vector<std::string> names;
  for (const SceneReceiver& receiver : scene.receivers) {
    EXPECT_TRUE(receiver.shape.is_flat());
    names.push_back(receiver.name);
  }
  EXPECT_THAT(names, ElementsAre("roof#0", "roof#1", "yard#0", "yard#1"));
}

TEST(SceneReader, TakesAConcaveLightAsItsConvexParts) {
  const auto lights = [](const std::string& light) {
    const Scene scene = parse_scene(
        R"({"gnomon": 1, "dimension": 3, "blockers": [], "lights": [{"name": "lamp", )" + light + "}]}", "test", {});
    return std::get<SpaceScene>(scene).lights;
  };
  for (const char* shape : {"polygon", "concave_polygon"}) {
    const auto parts = lights(R"("shape": ")" + std::string(shape) +
                              R"(", "radiance": 3, "vertices": [[0,0,0],[4,0,0],[1,1,0],[0,4,0]])");
    ASSERT_EQ(parts.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(parts[k].name, "lamp#" + std::to_string(k));
      EXPECT_EQ(parts[k].element, "lamp");
      EXPECT_EQ(parts[k].form, shape);
      EXPECT_EQ(parts[k].strength, 3);
      EXPECT_TRUE(parts[k].is_part());
    }
  }
  EXPECT_EQ(lights(R"("shape": "polygon", "vertices": [[0,0,0],[9,0,0],[9,9,0],[0,9,0]],
                      "holes": [[[3,3,0],[6,3,0],[6,6,0],[3,6,0]]])")
                .size(),
            4u);
  const auto whole = lights(R"("shape": "polygon", "vertices": [[0,0,0],[4,0,0],[0,4,0]])");
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_FALSE(whole[0].is_part());
  try {
    lights(R"("shape": "polygon", "vertices": [[0,0,0],[4,4,0],[4,0,0],[0,4,0]])");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edges 0 and 2 meet"));
  }
}

TEST(SceneReader, DoubtsWhatLooksLikeAMistake) {
  const SpaceScene scene = good_scene("doubtful");
  EXPECT_THAT(scene.doubts,
              Contains(AllOf(HasSubstr("light \"wrong_way_round\""), HasSubstr("no blocker is in front"))));
  EXPECT_THAT(scene.doubts, Contains(AllOf(HasSubstr("light \"off\""), HasSubstr("strength is 0"))));
  EXPECT_THAT(scene.doubts, Contains(AllOf(HasSubstr("blocker \"copy\""), HasSubstr("those of blocker \"table\""))));
  EXPECT_THAT(scene.doubts, Contains(AllOf(HasSubstr("blocker \"sheet\""), HasSubstr("not closed"))));
  EXPECT_EQ(scene.doubts.size(), 4u);
}

TEST(SceneReader, TakesZToBeUpUnlessTheSceneSaysYAndRefusesOtherAxesByName) {
  const auto scene = [](const std::string& keys) {
    return R"({"gnomon": 1, )" + keys + R"( "lights": [], "blockers": []})";
  };
  EXPECT_EQ(space_scene(scene(R"("dimension": 3,)")).up, UpAxis::z);
  EXPECT_EQ(space_scene(scene(R"("dimension": 3, "up": "z",)")).up, UpAxis::z);
  EXPECT_EQ(space_scene(scene(R"("dimension": 3, "up": "y",)")).up, UpAxis::y);
  for (const std::string wrong : {R"("x")", R"("Y")", R"("")", "1", "[0,0,1]", "null"}) {
    EXPECT_THAT(message_of(scene(R"("dimension": 3, "up": )" + wrong + ",")),
                AllOf(HasSubstr("/up"), HasSubstr("\"z\" or \"y\"")))
        << wrong;
  }
  EXPECT_THAT(message_of(scene(R"("dimension": 2, "up": "y",)")), AllOf(HasSubstr("/up"), HasSubstr("of the plane")));
}

TEST(SceneReader, AcceptsASceneOfNothingWithDoubts) {
  EXPECT_THAT(good_scene("nothing_in_it").doubts, ElementsAre(HasSubstr("no blocker"), HasSubstr("no light")));
}

TEST(SceneReader, RemembersTheFileAsTheUserNamedIt) {
  const auto file = scenes / "good" / "nothing_in_it.scene.json";
  EXPECT_EQ(facts(read_scene(file)).source, file.string());
}

TEST(SceneReader, TheDefaultSceneIsATriangleAboveARectangleAboveAFloorWithoutDoubts) {
  const auto scene = std::get<SpaceScene>(parse_scene(default_scene_text(), "default", {}));
  EXPECT_EQ(scene.source, "default");
  ASSERT_EQ(scene.lights.size(), 1u);
  ASSERT_EQ(scene.blockers.size(), 1u);
  ASSERT_EQ(scene.receivers.size(), 1u);
  const auto& light = std::get<AreaLight>(scene.lights[0].shape).polygon;
  const auto& blocker = std::get<ConvexPolygon>(scene.blockers[0].shape);
  EXPECT_EQ(light.corners().size(), 3u);
  EXPECT_EQ(blocker.corners().size(), 4u);
  EXPECT_GT(light.points()[0].z, blocker.points()[0].z);
  EXPECT_GT(blocker.points()[0].z, scene.receivers[0].shape.points()[0].z);
  EXPECT_THAT(scene.doubts, IsEmpty());
}

TEST(SceneReader, ReadsTheExampleScenes) {
  const std::filesystem::path examples = std::filesystem::path(GNOMON_TEST_DATA) / ".." / ".." / "examples";
  const auto box = std::get<SpaceScene>(read_scene(examples / "cornell_box.scene.json"));
  EXPECT_EQ(box.blockers.size(), 10u);
  EXPECT_EQ(box.receivers.size(), 3u);
  const auto figure = std::get<SpaceScene>(read_scene(examples / "figure_4_22.scene.json"));
  EXPECT_EQ(figure.blockers.size(), 1u);
}

RC_GTEST_PROP(SceneReaderProperty, ReadsEveryFiniteDoubleAsItself, ()) {
  const double x = *rc::gen::suchThat(
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
      [](double value) { return std::isfinite(value); });
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", x);
  const std::string text =
      std::string(R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "bulb", "shape": "point",)") +
      R"("position": [)" + digits.data() + R"(, 0, 1]}], "blockers": []})";
  RC_ASSERT(std::get<PointLight>(space_scene(text).lights[0].shape).position.x == x);
}

TEST(SceneReader, ReadsTheNearestDoubleOfLongAndTinyNumbers) {
  const auto first = [](const std::string& number) {
    const std::string text =
        R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "bulb", "shape": "point", "position": [)" + number +
        R"(, 0, 1]}], "blockers": []})";
    return std::get<PointLight>(space_scene(text).lights[0].shape).position.x;
  };
  EXPECT_EQ(first("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(first("123456789012345678901234567890"), 123456789012345678901234567890.0);
  EXPECT_EQ(first("-9223372036854775808"), -0x1p63);
  EXPECT_EQ(first("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(first("1e-400"), 0);
  EXPECT_EQ(first("0.1"), 0.1);
}

TEST(SceneReader, RefusesARepeatedVertexByNameAndIndex) {
  EXPECT_THAT(message_of(scene_with_table("[[0,0,1],[1,0,1],[1,1,1],[1,0,1]]")),
              AllOf(HasSubstr("test.scene.json"), HasSubstr("/blockers/0/vertices/3"), HasSubstr("blocker \"table\""),
                    HasSubstr("(1, 0, 1)"), HasSubstr("vertex 1")));
}

TEST(SceneReader, RefusesAHundredThousandNestedBrackets) {
  const std::size_t depth = 100000;
  const std::string opening(depth, '[');
  EXPECT_THAT(message_of(opening), HasSubstr("nested more than"));
  EXPECT_THAT(message_of(opening + std::string(depth, ']')), HasSubstr("nested more than"));
  std::string objects = R"({"gnomon": 1, "lights": )";
  for (std::size_t i = 0; i < depth; ++i) objects += R"({"a":)";
  EXPECT_THAT(message_of(objects), AllOf(HasSubstr("/lights/a/a"), HasSubstr("nested more than")));
}

TEST(SceneReader, EscapesWhatIsNotPrintableInMessages) {
  EXPECT_THAT(message_of(R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [], "a\u001b[31m/b~": 1})"),
              AllOf(HasSubstr("/a\\x1b[31m~1b~0"), Not(HasSubstr("\x1b"))));
}

TEST(SceneReader, CutsLongTextsInMessages) {
  const std::string name(100000, 'n');
  EXPECT_LT(message_of(R"({"gnomon": 1, ")" + name + R"(": 1, "dimension": 3})").size(), 500u);
  EXPECT_LT(message_of("[" + name).size(), 500u);
  EXPECT_LT(message_of("[\"" + name).size(), 500u);
}

TEST(SceneReader, RefusesAFileThatIsTooLargeWithoutReadingItAll) {
  const auto file =
      std::filesystem::temp_directory_path() / ("gnomon_large_" + std::to_string(getpid()) + ".scene.json");
  { std::ofstream(file) << ' '; }
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30);  // sparse: it takes no room
  try {
    read_scene(file);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a file of more than 64 MiB"));
  }
  std::filesystem::remove(file);
}

TEST(SceneReader, RefusesAMissingFileAndAFolder) {
  try {
    read_scene(scenes / "no_such.scene.json");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no_such.scene.json"), HasSubstr("no such file")));
  }
  try {
    read_scene(scenes);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a folder"));
  }
}

}  // namespace
}  // namespace gnomon
