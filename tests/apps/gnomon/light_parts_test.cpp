#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string rest = R"("blockers": [{"name": "table", "shape": "polygon",
    "vertices": [[-1,-1,2], [1,-1,2], [1,1,2], [-1,1,2]]}],
  "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-9,-9,0], [9,-9,0], [9,9,0], [-9,9,0]]}],
  "materials": [{"name": "grey", "diffuse": 0.5, "specular": 0.25}],
  "camera": {"eye": [0, -9, 3], "look_at": [0, 0, 0], "width": 12, "height": 8}})";

/// A lamp like an L above a table, the same as two rectangles, a cube and a ball that shine.
class LightParts : public Program {
 protected:
  LightParts() {
    const std::string head = R"({"gnomon": 1, "dimension": 3, "lights": [)";
    write("letter.scene.json", head + R"({"name": "L", "shape": "polygon",
      "vertices": [[0,-3,4], [0,-1,4], [1,-1,4], [1,-2,4], [2,-2,4], [2,-3,4]]}], )" +
                                   rest);
    write("two.scene.json", head + R"(
      {"name": "long", "shape": "polygon", "vertices": [[0,-3,4], [0,-1,4], [1,-1,4], [1,-3,4]]},
      {"name": "short", "shape": "polygon", "vertices": [[1,-3,4], [1,-2,4], [2,-2,4], [2,-3,4]]}], )" +
                                rest);
    write("cube.scene.json",
          head + R"({"name": "cube", "shape": "mesh", "file": "cube.obj", "radiance": 2}], )" + rest);
    write("cube.obj", cube);
    write("points.csv", "x,y,z\n0,0,0\n0,1,0\n-1,2,1\n0.5,-2,0\n3,3,5\n");
  }

  /// Region, fraction and bound of each light, point by point.
  json seen(const std::string& scene, const std::string& options = "") const {
    return json::parse(gnomon("regions " + scene + " --at points.csv --json - " + options).out)["points"];
  }

  static constexpr const char* cube =
      "v 0 0 4\nv 1 0 4\nv 1 1 4\nv 0 1 4\nv 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
};

TEST_F(LightParts, OfAConcavePolygonAddTheirFractionsByArea) {
  const json letter = seen("letter.scene.json");
  const json two = seen("two.scene.json");
  ASSERT_EQ(letter.size(), 5u);
  for (std::size_t i = 0; i < letter.size(); ++i) {
    const json& parts = two[i]["lights"];
    const json& whole = letter[i]["lights"];
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0]["light"], "L");
    const double expected =
        (2 * parts[0]["visible_fraction"].get<double>() + parts[1]["visible_fraction"].get<double>()) / 3;
    EXPECT_NEAR(whole[0]["visible_fraction"].get<double>(), expected, 1e-14) << i;
    const std::string a = parts[0]["region"], b = parts[1]["region"];
    EXPECT_EQ(whole[0]["region"], a == b ? a : "penumbra") << i;
  }
}

TEST_F(LightParts, OfAConcavePolygonAddWhatTheyGive) {
  for (const std::string command : {"irradiance", "radiance"}) {
    const std::string options = " --on floor --shape 3,3 " +
                                std::string(command == "radiance" ? "--eye 0,-9,3 --material grey" : "--sum") +
                                " --json -";
    const Outcome run = gnomon(command + " letter.scene.json" + options);
    EXPECT_EQ(run.code, 0) << run.err;
    const json letter = json::parse(run.out)["points"];
    const json two = json::parse(gnomon(command + " two.scene.json" + options).out)["points"];
    ASSERT_EQ(letter.size(), 9u);
    for (std::size_t i = 0; i < letter.size(); ++i) {
      const json& parts = two[i]["lights"];
      const json whole = letter[i]["lights"][0][command];
      const auto number = [](const json& value) {
        return value.is_array() ? value[0].get<double>() : value.get<double>();
      };
      EXPECT_NEAR(number(whole), number(parts[0][command]) + number(parts[1][command]), 1e-13) << command << i;
      EXPECT_GT(number(whole), 0);
    }
  }
}

TEST_F(LightParts, AreOneLightInPictures) {
  for (const std::string scene : {"letter", "two"}) {
    EXPECT_EQ(gnomon("image " + scene + ".scene.json --out " + scene + ".pfm --quiet").code, 0);
  }
  EXPECT_EQ(read("letter.pfm").size(), read("two.pfm").size());
}

TEST_F(LightParts, OfAMeshTakePartWhereTheyShowTheirFront) {
  const json points = seen("cube.scene.json");
  EXPECT_EQ(points[0]["lights"][0]["region"], "umbra") << "behind the table";
  EXPECT_EQ(points[4]["lights"][0]["region"], "lit");
  EXPECT_EQ(points[4]["lights"][0]["visible_fraction"], 1) << "of the two faces that it sees";
  EXPECT_THAT(gnomon("check cube.scene.json").out,
              AllOf(HasSubstr("1 light,"), HasSubstr("cube  mesh  6 facets"), HasSubstr("flux 37.6991 W")));
}

TEST_F(LightParts, OfABallGiveNearlyWhatABallGives) {
  // A ball of radius 1 at the height 2 gives the floor below pi (1/2)^2 of its radiance; the table through its middle
  // hides none of the lower half.
  write("below.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n");
  const std::string scene = "'" + std::string(GNOMON_TEST_DATA) + "/reports/newcomers/mesh_light.scene.json'";
  const json below = json::parse(gnomon("irradiance " + scene + " --at below.csv --json -").out)["points"][0];
  EXPECT_NEAR(below["lights"][0]["irradiance"].get<double>(), std::acos(-1) / 4, 0.03);
  write("points.csv", "x,y,z\n0,0,0\n0,0,5\n1.5,0,1\n");
  const json points = seen(scene);
  EXPECT_EQ(points[0]["lights"][0]["region"], "lit");
  EXPECT_EQ(points[2]["lights"][0]["region"], "penumbra") << "the table hides the upper half's part";
}

TEST_F(LightParts, CanBeAskedForByTheirOwnNames) {
  EXPECT_THAT(lines(gnomon("regions letter.scene.json --at points.csv --light L#1").out)[1], StartsWith("0,0,0,L#1,"));
  EXPECT_THAT(lines(gnomon("regions letter.scene.json --at points.csv --light L").out)[1], StartsWith("0,0,0,L,"));
  const json shadow = json::parse(gnomon("shadow letter.scene.json --light L --json -").out);
  EXPECT_EQ(shadow["pairs"][0]["light"], "L#0");
  EXPECT_EQ(shadow["pairs"][1]["light"], "L#1");
  EXPECT_THAT(gnomon("regions letter.scene.json --at points.csv --light M").err, HasSubstr("no light 'M'"));
}

TEST_F(LightParts, OfAnOpenOrConcaveMeshAreNotAvailable) {
  write("cube.obj", std::string(cube).substr(0, std::string(cube).rfind("f 4 1")));
  Outcome run = gnomon("check cube.scene.json");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, AllOf(HasSubstr("/lights/0/file"), HasSubstr("light \"cube\""), HasSubstr("not closed"),
                             HasSubstr("not available in this version")));
  write("cube.obj",
        "v 0 0 4\nv 3 0 4\nv 0 3 4\nv 0 0 7\nv 0.5 0.5 4.5\n"  // a tetrahedron with a dented face
        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n");
  run = gnomon("check cube.scene.json");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("not convex"));
}

TEST_F(LightParts, OfAMeshTurnedInsideOutShineOutward) {
  const json outward = seen("cube.scene.json");
  write("cube.obj",
        "v 0 0 4\nv 1 0 4\nv 1 1 4\nv 0 1 4\nv 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n"
        "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
  EXPECT_EQ(seen("cube.scene.json"), outward);
  EXPECT_THAT(gnomon("check cube.scene.json").out, HasSubstr("run inward"));
}

}  // namespace
}  // namespace gnomon
