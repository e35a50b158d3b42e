#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "geometry/scene/material_file.h"
#include "tests/apps/gnomon/program_fixture.h"
#include "tests/support/gltf_model.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// A table under a lamp, and a floor, in three materials.
class ImportCommand : public Program {
 protected:
  ImportCommand() {
    write("model.mtl",
          "newmtl wood\nKd .5 .25 .125\nKs .25\nNs 19.6\nmap_Kd a.png\nmap_Kd b.png\n"
          "newmtl lamp\r\nKe 10 5 10 # warm\nnewmtl floor\nKd 0.5\n");
    write("model.obj", std::string("mtllib model.mtl\n") + floor + table + lamp);
  }

  json imported(const std::string& options = "") {
    const Outcome run = gnomon("import model.obj --out scene.json --quiet " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return read_json("scene.json");
  }

  const std::string floor = "v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nusemtl floor\nf 1 2 3 4\n";
  const std::string table = "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nusemtl wood\nf -4 -3 -2 -1\n";
  const std::string lamp = "v 0.1 0 3\nv 0 1 3\nv 1 0 3\nusemtl lamp\nf 9/1 10//2 11\n";
};

TEST_F(ImportCommand, MakesLampsLightsAndAllElseBlockers) {
  const json scene = imported();
  ASSERT_EQ(scene["lights"].size(), 1u);
  EXPECT_EQ(scene["lights"][0], json::parse(R"({"name": "lamp", "shape": "polygon", "radiance": 10.0,
    "vertices": [[0.1, 0.0, 3.0], [0.0, 1.0, 3.0], [1.0, 0.0, 3.0]], "color": [1.0, 0.5, 1.0]})"));
  ASSERT_EQ(scene["blockers"].size(), 2u);
  EXPECT_EQ(scene["blockers"][1], json::parse(R"({"name": "wood", "shape": "mesh", "file": "model.obj",
    "usemtl": "wood", "material": "wood"})"));
  EXPECT_EQ(scene["materials"][1], json::parse(R"({"name": "wood", "model": "blinn", "diffuse": [0.5, 0.25, 0.125],
    "specular": 0.25, "exponent": 20})"));
  EXPECT_EQ(scene["length_unit"], "m");
  EXPECT_THAT(scene["receivers"], IsEmpty());
}

TEST_F(ImportCommand, GivesWhatTheSameSceneByHandGives) {
  imported("--receiver floor");
  json by_hand = read_json("scene.json");
  const auto polygon = [](const char* name, const char* vertices) {
    return json{{"name", name}, {"shape", "polygon"}, {"vertices", json::parse(vertices)}};
  };
  by_hand["blockers"] = {polygon("wood", "[[-1,-1,1],[1,-1,1],[1,1,1],[-1,1,1]]")};
  by_hand["receivers"] = {polygon("floor", "[[-4,-4,0],[4,-4,0],[4,4,0],[-4,4,0]]")};
  write("hand.scene.json", by_hand.dump());
  const auto areas = [&](const std::string& scene) {
    return json::parse(gnomon("receivers " + scene + " --json -").out)["receivers"].at(0)["areas"];
  };
  EXPECT_EQ(areas("scene.json"), areas("hand.scene.json"));
  EXPECT_GT(areas("scene.json")["penumbra"]["double"], 1.0);
}

TEST_F(ImportCommand, MakesTheLampOfAChairsModelALight) {
  write("mat.mtl", "newmtl wood\nKd .5 .5 .5\nnewmtl light\nKe 10 10 10\n");
  write(
      "mat.obj",
      "mtllib mat.mtl\no chair\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvt 0 0\nvn 0 0 1\nusemtl wood\nf 1/1/1 2/1/1 3/1/1 "
      "4/1/1\no lamp\nv 0 0 3\nv 1 0 3\nv 1 1 3\nusemtl light\nf -3//1 -2//1 -1//1\n");
  ASSERT_EQ(gnomon("import mat.obj --out mat.json --quiet").code, 0);
  const json scene = read_json("mat.json");
  EXPECT_EQ(scene["lights"], json::parse(R"([{"name": "light", "shape": "polygon", "radiance": 10.0,
    "vertices": [[0.0, 0.0, 3.0], [1.0, 0.0, 3.0], [1.0, 1.0, 3.0]]}])"));
  EXPECT_EQ(scene["blockers"].size(), 1u);
  EXPECT_THAT(gnomon("check mat.json").out, HasSubstr("radiance 10 W/(m^2 sr)"));
}

TEST_F(ImportCommand, TakesUnitAxisAndLightsAsTold) {
  const json scene = imported("--unit mm --up y --light wood=2.5 --receiver floor");
  EXPECT_EQ(scene["length_unit"], "mm");
  EXPECT_EQ(scene["up"], "y");
  EXPECT_EQ(scene["lights"].size(), 2u);
  EXPECT_EQ(scene["lights"][0]["radiance"], 2.5);
  EXPECT_EQ(scene["receivers"].size(), 1u);
}

TEST_F(ImportCommand, TellsWhatItPassesOver) {
  write("model.obj", "mtllib model.mtl nix.mtl\n" + floor + table + lamp + "usemtl glass\nf 1 2 5\nl 1 2\nhum 1\n");
  const Outcome run = gnomon("import model.obj --out scene.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("passed over 2 lines that begin with \"map_Kd\""),
                    HasSubstr("nix.mtl: found no such file"), HasSubstr("material \"glass\""), HasSubstr("hum")));
  EXPECT_THAT(run.out, HasSubstr("1 light, 3 blockers, 0 receivers"));
}

TEST_F(ImportCommand, LeavesFacetsOfLampsWithoutAreaOutAndNamesLinesOfWrongOnes) {
  write("model.obj", "mtllib model.mtl\n" + floor + table + lamp + "f 9 9 10\nf 9 10 10 11\n");
  const Outcome run = gnomon("import model.obj --out scene.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("no area"));
  EXPECT_EQ(read_json("scene.json")["lights"].size(), 2u);
  write("model.obj",
        "mtllib model.mtl\n" + floor + table + lamp + "v 4 4 0\nv 4 0 0\nv 0 4 0\nv 0 0 0\nf 12 13 14 15\n");
  const Outcome wrong = gnomon("import model.obj --out scene.json");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_THAT(wrong.err, AllOf(HasSubstr("model.obj"), HasSubstr("line 23")));
}

TEST_F(ImportCommand, KeepsNamesThatScenesDoNotAllowApart) {
  write("model.obj", "usemtl a/b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl a\\b\nf 3 2 1\nf 1 2 3\n");
  write("more.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl x\nf 3 2 1\n");
  const json scene = imported();
  EXPECT_EQ(scene["blockers"][0]["name"], "a_b");
  EXPECT_EQ(scene["blockers"][0]["usemtl"], "a/b");
  EXPECT_EQ(scene["blockers"][1]["name"], "a_b 2");
  ASSERT_EQ(gnomon("import more.obj --out more.json").code, 0);
  EXPECT_EQ(read_json("more.json")["blockers"][0]["usemtl"], "");
  EXPECT_THAT(gnomon("check more.json").out, HasSubstr("1 facet"));
}

TEST_F(ImportCommand, RefusesWhatItCannotUse) {
  const auto expect = [&](const std::string& words, int code, const std::string& text) {
    const Outcome run = gnomon("import " + words);
    EXPECT_EQ(run.code, code) << words << run.err;
    EXPECT_THAT(run.err, HasSubstr(text)) << words;
  };
  expect("model.fbx --out s.json", 4, "expected .gltf, .glb, .obj, .off, .ply, .rad or .stl");
  expect("nix.obj --out s.json", 3, "no such file");
  expect("model.obj --out model.obj", 2, "model.obj");
  expect("model.obj --out s.json --unit furlong", 2, "expected m, mm");
  expect("model.obj --out s.json --up x", 2, "expected y or z");
  expect("model.obj --out s.json --light wod=3", 2, "the nearest is 'wood'");
  expect("model.obj --out s.json --light wood", 2, "MATERIAL=RADIANCE");
  expect("model.obj --out s.json --light wood=-3", 2, "above 0");
  expect("model.obj --out s.json --light wood=nan", 2, "radiance");
  expect("model.obj --out s.json --receiver lamp", 2, "are lights");
  expect("model.obj --out sub/s.json", 2, "below it");
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  expect("bad.obj --out s.json", 3, "bad.obj");
  write("empty.obj", "v 0 0 0\n");
  expect("empty.obj --out s.json", 3, "no facet");
  write("crossed.obj", "v 0 0 0\nv 4 4 0\nv 4 0 0\nv 0 4 0\nf 1 2 3 4\n");
  expect("crossed.obj --out s.json", 3, "crossed.obj");
  EXPECT_EQ(gnomon("check s.json").code, 3);  // nothing was written
}

TEST_F(ImportCommand, JoinsFacetsOfALampToOneLightOnlyIfToldTo) {
  write("model.obj", "mtllib model.mtl\n" + floor + table + lamp + "v 1 1 3\nf 11 10 12\nv 5 5 5\nv 5 6 5\nv 6 5 5\n" +
                         "f 13 14 15\n");
  EXPECT_EQ(imported()["lights"].size(), 3u);
  const Outcome run = gnomon("import model.obj --out scene.json --merge-coplanar");
  EXPECT_THAT(run.out, AllOf(HasSubstr("3 facets of lamps"), HasSubstr("joined to 2 lights")));
  const json lights = read_json("scene.json")["lights"];
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0]["vertices"], json::parse("[[0.1,0,3],[0,1,3],[1,1,3],[1,0,3]]"));
  EXPECT_EQ(lights[1]["name"], "lamp 2");
}

TEST_F(ImportCommand, MakesOneLightOfTheHalvesOfASquare) {
  write("two.obj", "mtllib model.mtl\nusemtl lamp\nv 0 0 3\nv 0 1 3\nv 1 1 3\nv 1 0 3\nf 1 2 3\nf 1 3 4\n");
  write("one.obj", "mtllib model.mtl\nusemtl lamp\nv 0 0 3\nv 0 1 3\nv 1 1 3\nv 1 0 3\nf 1 2 3 4\n");
  write("board.obj", table);
  ASSERT_EQ(gnomon("import two.obj board.obj --out two.json --merge-coplanar --quiet").code, 0);
  ASSERT_EQ(gnomon("import one.obj board.obj --out one.json --quiet").code, 0);
  EXPECT_EQ(read_json("two.json"), read_json("one.json"));
}

TEST_F(ImportCommand, ReadsMeshesWithoutMaterialsByTheNamesOfTheirFiles) {
  write("lamp.off", "OFF\n4 2 0\n0 0 3\n1 0 3\n1 1 3\n0 1 3\n3 0 2 1\n3 0 3 2\n");
  write("ground.stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex -4 -4 0\nvertex 4 -4 0\nvertex 4 4 0\nendloop\n"
        "endfacet\nendsolid\n");
  write("board.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n");
  const Outcome run = gnomon(
      "import lamp.off ground.stl board.ply model.obj --out scene.json --light lamp=5 "
      "--receiver ground --merge-coplanar");
  ASSERT_EQ(run.code, 0) << run.err;
  const json scene = read_json("scene.json");
  EXPECT_EQ(scene["lights"].size(), 2u);  // that of the OBJ file has the same name, and the radiance that was told
  EXPECT_EQ(scene["lights"][0], json::parse(R"({"name": "lamp", "shape": "polygon", "radiance": 5.0,
    "vertices": [[0.0, 0.0, 3.0], [0.0, 1.0, 3.0], [1.0, 1.0, 3.0], [1.0, 0.0, 3.0]]})"));
  EXPECT_EQ(scene["lights"][1]["name"], "lamp 2");
  EXPECT_EQ(scene["lights"][1]["radiance"], 5.0);
  EXPECT_EQ(scene["receivers"], json::parse(R"([{"name": "ground", "shape": "mesh", "file": "ground.stl"}])"));
  EXPECT_EQ(scene["blockers"].size(), 4u);
  EXPECT_EQ(scene["blockers"][1]["file"], "board.ply");
  EXPECT_EQ(gnomon("check scene.json").code, 0);
}

TEST_F(ImportCommand, OfARadianceSceneIsTheSceneByHand) {
  write(
      "room.rad",
      "# a lamp of two halves over a board\nvoid plastic grey 0 0 5 .5 .5 .25 .25 .25\nvoid light bright\n0\n0\n3 "
      "100 50 100\ngrey polygon ground 0 0 12  -4 -4 0  4 -4 0  4 4 0  -4 4 0\nbright polygon half.1 0 0 9 0 0 3 0 1 3 "
      "1 1 3\nbright polygon half.2 0 0 9 0 0 3 1 1 3 1 0 3\ngrey polygon ell 0 0 18 0 0 1 2 0 1 2 1 1 1 1 1 1 2 1 0 "
      "2 1\nvoid polygon air 0 0 9 0 0 2 1 0 2 0 1 2\n");
  const Outcome run = gnomon("import room.rad --out scene.json --receiver grey --merge-coplanar");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("polygon of void (1)"));
  json scene = read_json("scene.json");
  EXPECT_EQ(scene["receivers"], scene["blockers"]);
  scene.erase("receivers");
  EXPECT_EQ(scene, json::parse(R"({"gnomon": 1, "dimension": 3, "length_unit": "m",
    "materials": [{"name": "grey", "model": "blinn", "diffuse": [0.375, 0.375, 0.1875], "specular": 0.25, "exponent": 32}],
    "lights": [{"name": "bright", "shape": "polygon", "radiance": 100.0, "color": [1.0, 0.5, 1.0],
      "vertices": [[0.0,0.0,3.0], [0.0,1.0,3.0], [1.0,1.0,3.0], [1.0,0.0,3.0]]}],
    "blockers": [{"name": "ground", "shape": "polygon", "material": "grey",
        "vertices": [[-4.0,-4.0,0.0], [4.0,-4.0,0.0], [4.0,4.0,0.0], [-4.0,4.0,0.0]]},
      {"name": "ell", "shape": "concave_polygon", "material": "grey",
        "vertices": [[0.0,0.0,1.0], [2.0,0.0,1.0], [2.0,1.0,1.0], [1.0,1.0,1.0], [1.0,2.0,1.0], [0.0,2.0,1.0]]}]})"));
}

TEST_F(ImportCommand, OfAGltfFileIsItsLampItsLightsAndItsMeshes) {
  GltfModel model;
  const auto square = [&](float size, float y, bool faces_up) {
    const std::vector<std::uint16_t> up = {0, 2, 1, 0, 3, 2}, down = {0, 1, 2, 0, 2, 3};
    const std::size_t places = model.points({-size, y, -size, size, y, -size, size, y, size, -size, y, size});
    return json{{"attributes", {{"POSITION", places}}},
                {"indices", model.add(faces_up ? up : down, 5123, "SCALAR", 1)}};
  };
  json light = square(0.5, 3, false), ground = square(4, 0, true), board = square(1, 1, true);
  light["material"] = 0, ground["material"] = 1;
  model.document["materials"] = {{{"name", "lamp"}, {"emissiveFactor", {1, 1, 0.5}}, {"doubleSided", true}},
                                 {{"name", "floor"}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}}};
  for (const json& one : {light, ground, board}) model.node({{"mesh", model.mesh(one)}});
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 5}},
                                                                   {{"type", "directional"}, {"name", "sun"}}};
  model.node({{"translation", {0, 2, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  model.node({{"rotation", {-0.5, 0, 0, 0.5}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  write("model.glb", model.binary());
  const Outcome run = gnomon("import model.glb --out scene.json --merge-coplanar --receiver floor --quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  const json scene = read_json("scene.json");
  EXPECT_EQ(scene["up"], "y");
  ASSERT_EQ(scene["lights"].size(), 3U);
  EXPECT_EQ(scene["lights"][0]["vertices"].size(), 4U);
  EXPECT_EQ(scene["lights"][0]["two_sided"], true);
  EXPECT_EQ(scene["lights"][0]["color"], (json{1, 1, 0.5}));
  EXPECT_EQ(scene["lights"][1]["position"], (json{0, 2, 0}));
  EXPECT_EQ(scene["lights"][2]["name"], "sun");
  ASSERT_EQ(scene["blockers"].size(), 2U);
  EXPECT_EQ(scene["blockers"][1]["name"], "model");
  EXPECT_EQ(scene["blockers"][1]["vertices"].size(), 4U);
  EXPECT_EQ(scene["receivers"][0]["name"], "floor");
  const Outcome check = gnomon("check scene.json");
  EXPECT_EQ(check.code, 0) << check.err;
  // The table hides the bulb, 2 above the floor, from what lies below it; 3 beside that it is seen.
  const Outcome lit = shell(
      "printf 'x,y,z,nx,ny,nz\\n0,0,0,0,1,0\\n3,0,0,0,1,0\\n' | \"$GNOMON\" irradiance scene.json "
      "--at - --light 'light 0' --quiet");
  ASSERT_EQ(lit.code, 0) << lit.err;
  const std::vector<std::string> rows = lines(lit.out);
  ASSERT_EQ(rows.size(), 3U) << lit.out;
  EXPECT_THAT(rows[1], HasSubstr("light 0,0,0"));
  EXPECT_NEAR(std::stod(rows[2].substr(rows[2].find("light 0,") + 8)), 5 * 2 / std::pow(13, 1.5), 1e-12);
}

TEST_F(ImportCommand, ReadsTheGltfFilesThatTheProgramWrites) {
  ASSERT_EQ(gnomon("render examples/figure_4_22.scene.json --out figure.gltf --quiet").code, 0);
  const Outcome run = gnomon("import figure.gltf --out scene.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(gnomon("check scene.json").code, 0);
}

TEST_F(ImportCommand, RefusesCommandsOfRadianceScenesByName) {
  write("command.rad", "void plastic a 0 0 5 1 1 1 0 0\n!genbox a box 1 1 1\n");
  const Outcome run = gnomon("import command.rad --out s.json");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, AllOf(HasSubstr("command.rad"), HasSubstr("line 2"), HasSubstr("!genbox a box 1 1 1")));
}

TEST_F(ImportCommand, TakesBentAndConcavePolygonsAsTheyAre) {
  write("bent.rad",
        "void light b 0 0 3 1 1 1\nvoid metal m 0 0 5 1 1 1 0 0\nb polygon lamp 0 0 12 0 0 3 0 1 3 1 1 3.0001 1 0 3\n"
        "m polygon frame 0 0 30 0 0 2 4 0 2 4 4 2 0 4 2 0 0 2 1 1 2 1 2 2 2 2 2 2 1 2 1 1 2\n");
  ASSERT_EQ(gnomon("import bent.rad --out scene.json --merge-coplanar").code, 0);
  const Outcome run = gnomon("check scene.json");
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 hole"), HasSubstr("it is bent")));
}

TEST_F(ImportCommand, TellsNamesThatAreNotUnicode) {
  const std::string facets = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gr\xfcn\nf 1 2 3\n";
  write("one.obj", facets);
  EXPECT_EQ(gnomon("import one.obj --out one.json").code, 0);
  write("two.obj", facets + "usemtl wood\nf 3 2 1\n");
  const Outcome run = gnomon("import two.obj --out two.json");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("no UTF-8"));
  EXPECT_EQ(gnomon("import two.obj --out two.json --light wood=1").code, 4);
  write("long.obj", "usemtl " + std::string(149, 'a') + "\xc3\xa4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(gnomon("import long.obj --out long.json").code, 0);
}

TEST_F(ImportCommand, ReadsNamesWithBlanksContinuedLinesAndEndsOfAnyKind) {
  write("odd.mtl", "\xef\xbb\xbfnewmtl the old wood\r\nKd 0.5\r\n");
  write("odd.obj",
        "\xef\xbb\xbfmtllib odd.mtl\r\no \r\ng\r\nusemtl the old wood\r\nv 0 0 0\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\n"
        "f -3 \\\r\n-2 -1\r\ng empty\r\n");
  const Outcome run = gnomon("import odd.obj --out odd.json --receiver 'the old wood'");
  ASSERT_EQ(run.code, 0) << run.err;
  const json scene = read_json("odd.json");
  EXPECT_EQ(scene["receivers"].size(), 1u);
  EXPECT_EQ(scene["blockers"][0]["material"], "the old wood");
}

TEST_F(ImportCommand, AMaterialThatNoFacetHasIsRefusedInAScene) {
  json scene = imported();
  scene["blockers"][1]["usemtl"] = "wod";
  write("wrong.json", scene.dump());
  const Outcome run = gnomon("check wrong.json");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("/blockers/1/usemtl"), HasSubstr("\"floor\", \"wood\", \"lamp\"")));
}

TEST(MaterialFile, TakesFiniteNumbersFromZeroOnAndCountsTheRest) {
  const MaterialFile file = material_file(
      "\xef\xbb\xbf"
      "Kd 1 1 1\nnewmtl two words\nKd 0.1\nKs nan 0 0\nKe -1 0 0\nNs 1e3\nd 0.5\nKd 1 2\n");
  ASSERT_EQ(file.materials.size(), 1u);
  const FileMaterial& material = file.materials.at("two words");
  EXPECT_EQ(material.diffuse, (std::array{0.1, 0.1, 0.1}));
  EXPECT_FALSE(material.specular);
  EXPECT_FALSE(material.emission);
  EXPECT_EQ(material.exponent, 1000);
  EXPECT_EQ(file.passed_over, (std::map<std::string, std::size_t>{{"Kd", 2}, {"Ks", 1}, {"Ke", 1}, {"d", 1}}));
}

TEST(MaterialFile, SurvivesAnyText) {
  std::mt19937 engine(20261201);
  const std::string alphabet = "newmtl KeKdKsNs 0123456789.eE+-#\\\r\n\t\0\xff";
  std::uniform_int_distribution<std::size_t> letter(0, alphabet.size() - 1);
  for (int i = 0; i < 2000; ++i) {
    std::string text = "newmtl a\n";
    for (int k = 0; k < 100; ++k) text += alphabet[letter(engine)];
    for (const auto& [name, material] : material_file(text).materials) {
      for (const auto& v : {material.emission, material.diffuse, material.specular}) {
        EXPECT_TRUE(!v || ((*v)[0] >= 0 && (*v)[1] >= 0 && (*v)[2] >= 0));
      }
    }
  }
}

}  // namespace
}  // namespace gnomon
