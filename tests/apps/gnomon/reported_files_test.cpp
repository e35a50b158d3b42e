#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

const std::string reports = GNOMON_TEST_DATA "/reports/";

/// Files as other programs write them, with what they are known to hold.
class ReportedFiles : public Program {
 protected:
  /// The areas of a region over all receivers: the exact text where there is one receiver, and the double.
  struct Area {
    std::string exact;
    double nearest = 0;
  };

  Area area(const std::string& scene, const std::string& region = "umbra") const {
    const Outcome run = gnomon("receivers " + scene + " --json -");
    EXPECT_EQ(run.code, 0) << scene << ": " << run.err;
    Area sum;
    const json document = json::parse(run.out);
    for (const json& receiver : document["receivers"]) {
      sum.nearest += receiver["areas"][region]["double"].get<double>();
      sum.exact = receiver["areas"][region].value("exact", "");
    }
    return sum;
  }

  /// A mesh under a vertical sun over level ground; the scene stands beside the file.
  std::string scene_of(const std::string& folder, const std::string& mesh) const {
    std::filesystem::copy_file(reports + folder + '/' + mesh, path_of(mesh),
                               std::filesystem::copy_options::overwrite_existing);
    write("mesh.scene.json", R"({"gnomon": 1, "dimension": 3,
      "lights": [{"name": "sun", "shape": "direction", "direction": [0, 0, -1], "irradiance": 1000.0}],
      "blockers": [{"name": "m", "shape": "mesh", "file": ")" +
                                 mesh + R"("}],
      "receivers": [{"name": "ground", "shape": "polygon", "vertices": [[-3,-3,0], [5,-3,0], [5,4,0], [-3,4,0]]}]})");
    return "mesh.scene.json";
  }

  void expect_shadow_of_two(const std::string& folder, const std::vector<std::string>& meshes) const {
    for (const std::string& mesh : meshes) EXPECT_EQ(area(scene_of(folder, mesh)).exact, "2") << mesh;
  }

  void expect_refusals(const std::string& folder, const std::map<std::string, std::string>& words_of) const {
    for (const auto& [mesh, words] : words_of) {
      const Outcome run = gnomon("check " + scene_of(folder, mesh));
      EXPECT_EQ(run.code, 3) << mesh;
      EXPECT_THAT(run.err, AllOf(HasSubstr(mesh), HasSubstr(words)));
    }
  }

  /// What `check` doubts.
  std::string doubts(const std::string& scene) const {
    const Outcome run = gnomon("check " + scene + " --json -");
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out)["doubts"].dump();
  }
};

TEST_F(ReportedFiles, OfObjGiveTheShadowOfTheirQuadrilateral) {
  expect_shadow_of_two(
      "14-obj-quirks",
      {"crlf.obj", "no_newline_at_end.obj", "spaces_tabs.obj", "continued.obj", "numbers.obj", "vertex_colours.obj",
       "weights.obj", "lines_points.obj", "slashes.obj", "slash_missing_vt.obj", "bom.obj", "bom_then_vertex.obj",
       "comment_after.obj", "repeated_face_vertex.obj", "degenerate_line.obj", "two_vertex_face.obj",
       "unreferenced_far.obj", "duplicate_faces.obj", "curv.obj"});
  scene_of("14-obj-quirks", "crlf.obj");
  write("huge.obj", "# " + std::string(70000, 'x') + "\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\nf 1 2 3 4\n");
  write("huge.scene.json", [&] {
    std::string text = read("mesh.scene.json");
    return text.replace(text.find("crlf.obj"), 8, "huge.obj");
  }());
  EXPECT_EQ(area("huge.scene.json").exact, "2");
}

TEST_F(ReportedFiles, OfObjThatAreWrongAreRefusedByLineAndItem) {
  expect_refusals("14-obj-quirks", {{"index_zero.obj", "line 5, \"0/0/0\""},
                                    {"nan.obj", "line 5, \"nan\""},
                                    {"nan_used.obj", "line 5, \"nan\""},
                                    {"nonplanar_quad.obj", "line 5, facet 0, corner 3, a vertex 0.25 away"},
                                    {"bowtie.obj", "line 5, facet 0, a boundary that crosses"},
                                    {"decimal_comma.obj", "line 1, \"0,0\""},
                                    {"only_vertices.obj", "no facet"},
                                    {"utf16.obj", "UTF-16"}});
}

TEST_F(ReportedFiles, OfScenesMayHaveAByteOrderMarkAndCarriageReturns) {
  scene_of("14-obj-quirks", "crlf.obj");
  for (const std::string scene : {"json_bom.scene.json", "json_crlf.scene.json"}) {
    write(scene, [&] {
      std::ifstream stream(reports + "14-obj-quirks/" + scene, std::ios::binary);
      return std::string{std::istreambuf_iterator<char>(stream), {}};
    }());
    EXPECT_EQ(area(scene).exact, "2");
  }
}

TEST_F(ReportedFiles, OfStlGiveTheShadowOfTheirTriangles) {
  expect_shadow_of_two("15-stl-quirks", {"solid_header.stl", "solid_then_newline.stl", "solid_binary_trailing.stl",
                                         "plain.stl", "attr.stl", "trailing_bytes.stl", "long_name.stl", "upper.stl",
                                         "crlf.stl", "two_solids.stl", "empty_solid.stl", "no_name.stl",
                                         "degenerate.stl", "no_endsolid.stl", "color_line.stl", "leading_space.stl"});
  expect_refusals("15-stl-quirks", {{"truncated.stl", "2 facets, which take 184 bytes, in a file of 154"},
                                    {"count_wrong.stl", "5 facets, which take 334 bytes, in a file of 184"},
                                    {"zero_triangles.stl", "no facet"},
                                    {"nan.stl", "facet 2, a coordinate that is not finite"}});
}

TEST_F(ReportedFiles, OfOffGiveTheShadowOfTheirFacets) {
  expect_shadow_of_two("17-off-quirks",
                       {"comments_colours.off", "one_line_header.off", "no_keyword.off", "coff.off", "noff.off",
                        "colour_index.off", "degtri_four.off", "no_edge_count.off", "crlf.off"});
  expect_refusals("17-off-quirks", {{"binary.off", "line 1, \"BINARY\""}});
  for (const std::string scene : {"schonhardt", "cube_rounded"}) {
    EXPECT_EQ(gnomon("check " + reports + "17-off-quirks/" + scene + ".scene.json").code, 0);
  }
}

TEST_F(ReportedFiles, OfATreeGiveTheShadowOfTrunkAndCrownHoweverItsRingIsTold) {
  const std::string folder = reports + "01-tree-silhouette/";
  for (const std::string scene : {"main", "clockwise", "closed_ring", "start_elsewhere", "twice", "utm"}) {
    EXPECT_EQ(area(folder + scene + ".scene.json").exact, "37/2") << scene;
    EXPECT_EQ(area(folder + scene + ".scene.json", "lit").exact, "27/2") << scene;
  }
  EXPECT_EQ(area(folder + "mm.scene.json").exact, "18500000");
  EXPECT_NEAR(area(folder + "turned_times5.scene.json").nearest, 25 * 18.5, 1e-9);
  EXPECT_EQ(area(folder + "mirrored.scene.json", "unlit").exact, "32") << "the sun stands behind the wall";
  EXPECT_THAT(gnomon("check " + folder + "mirrored.scene.json").out, HasSubstr("turned from every light"));
  const Outcome run = gnomon("check " + folder + "as_polygon.scene.json");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("/blockers/0/vertices/2"), HasSubstr("the shape \"concave_polygon\"")));
  EXPECT_THAT(doubts(folder + "closed_ring.scene.json"), HasSubstr("last vertex repeats the first"));
}

TEST_F(ReportedFiles, OfATreeBeforeALampAgreeWithItsPointsOneByOne) {
  const std::string scene = reports + "01-tree-silhouette/area_sun.scene.json";
  double sum = 0;
  for (const std::string region : {"lit", "penumbra", "umbra"}) sum += area(scene, region).nearest;
  EXPECT_NEAR(sum, 32, 1e-13);
  std::string points = "x,y,z,nx,ny,nz\n";
  constexpr int rows = 40;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < 2 * rows; ++j) {
      points += std::to_string(-3.95 + 0.1 * j) + ",0," + std::to_string(0.05 + 0.1 * i) + ",0,-1,0\n";
    }
  }
  write("wall.csv", points);
  std::map<std::string, double> counted;
  const json document = json::parse(gnomon("regions " + scene + " --at wall.csv --json -").out);
  for (const json& point : document["points"]) counted[point["lights"][0]["region"]] += 0.01;
  for (const std::string region : {"lit", "penumbra", "umbra"}) {
    EXPECT_NEAR(counted[region], area(scene, region).nearest, 0.3) << region << ", within half a cell of its borders";
  }
}

TEST_F(ReportedFiles, OfAPatchGiveTheTextbooksViewFactors) {
  const std::string folder = reports + "08-point-view-factor/";
  const double expected[] = {0.13853160599489298, 0.2394564704607735, 0.22296619703379386};
  const json points = json::parse(
      gnomon("irradiance " + folder + "main.scene.json --json - --at " + folder + "points.csv").out)["points"];
  ASSERT_EQ(points.size(), std::size(expected));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const json& light = points[i]["lights"][0];
    EXPECT_NEAR(light["irradiance"], expected[i], light["error_bound"].get<double>() + 1e-16) << i;
  }
  const auto mean = [&](const std::string& scene) {
    const Outcome run = gnomon("irradiance " + folder + scene + " --on floor --shape 64,64 --json -");
    return json::parse(run.out)["summary"]["sum"]["mean"]["irradiance"].get<double>();
  };
  EXPECT_NEAR(mean("main.scene.json"), 0.19982489569838, 1e-5) << "between two unit squares";
  EXPECT_NEAR(mean("with_obstacle.scene.json"), 0.11562060213242, 1e-5) << "with a screen between them";
}

TEST_F(ReportedFiles, OfABallOnATableAreReceivedFacetByFacet) {
  const std::string scene = reports + "newcomers/rec_mesh.scene.json";
  const json receiver = json::parse(gnomon("receivers " + scene + " --json -").out)["receivers"][0];
  const double half = receiver["area"].get<double>() / 2;
  EXPECT_EQ(receiver["facets"], 224);
  EXPECT_NEAR(receiver["areas"]["lit"]["double"], half, 1e-12) << "all that is above the table";
  EXPECT_EQ(receiver["areas"]["penumbra"]["double"], 0.0);
  EXPECT_EQ(gnomon("render " + scene + " --out ball.html").code, 0);
  EXPECT_THAT(read("ball.html"), HasSubstr("umbra on m"));
}

TEST_F(ReportedFiles, OfNewcomersStandUprightWhereverTheirLampsAre) {
  for (const std::string scene : {"side", "room"}) {
    EXPECT_EQ(gnomon("render " + reports + "newcomers/" + scene + ".scene.json --out page.html").code, 0);
    EXPECT_THAT(read("page.html"), HasSubstr("\"up\":[0.0,0.0,1.0]")) << scene;
  }
}

TEST_F(ReportedFiles, OfATableOfSixteenAndOfTwoLampsShowWhatReceiversTells) {
  const Area umbra = area(reports + "newcomers/sixteenths.scene.json");
  EXPECT_EQ(umbra.exact, "36");
  EXPECT_EQ(gnomon("render " + reports + "newcomers/sixteenths.scene.json --out page.html").code, 0);
  EXPECT_THAT(read("page.html"), HasSubstr("umbra on floor"));
  EXPECT_EQ(gnomon("render " + reports + "newcomers/two_lamps.scene.json --out page.html").code, 0);
  EXPECT_THAT(read("page.html"), HasSubstr(", one of 2"));
}

TEST_F(ReportedFiles, OfADitheredRoofGiveItsOwnShapeAsShadowAndAsReceiver) {
  const std::string folder = reports + "02-dithered-roof/";
  EXPECT_EQ(area(folder + "main.scene.json").exact, "204082770397865865/281474976710656");
  EXPECT_NEAR(area(folder + "roof_as_concave_receiver.scene.json").nearest, 725.04765, 1e-9);
  EXPECT_EQ(area(folder + "roof_as_concave_receiver.scene.json", "lit").nearest, 0);
  EXPECT_THAT(gnomon("check " + folder + "roof_as_receiver.scene.json").err, HasSubstr("concave_polygon"));
}

TEST_F(ReportedFiles, OfAFootprintGiveTheShadowOnTheSideAwayFromTheSun) {
  const std::string folder = reports + "10-footprint-shadow/";
  for (const std::string scene : {"main", "polytope_closed", "ground_closed", "utm"}) {
    EXPECT_EQ(area(folder + scene + ".scene.json").exact, "4800") << scene;
  }
  EXPECT_EQ(area(folder + "ring_closed.scene.json").exact, "4000") << "of the roof alone";
  const Outcome run = gnomon("regions " + folder + "main.scene.json --json - --at " + folder + "points.csv");
  std::vector<std::string> regions;
  const json document = json::parse(run.out);
  for (const json& point : document["points"]) regions.push_back(point["lights"][0]["region"]);
  EXPECT_EQ(regions, (std::vector<std::string>{"umbra", "lit", "umbra", "lit"}));
  EXPECT_THAT(gnomon("check " + folder + "sun_by_angles.scene.json").err, HasSubstr("unknown key \"altitude\""));
}

TEST_F(ReportedFiles, OfAWallWithAWindowLetTheSunThroughHoweverTheHoleIsTold) {
  const std::string folder = reports + "12-window-hole-seam/";
  for (const std::string scene : {"main", "seam_mesh", "four_parts"}) {
    EXPECT_EQ(area(folder + scene + ".scene.json").exact, "16") << scene;
  }
  write("hole.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "sun", "shape": "direction", "direction": [0.5, 1, -1]}],
    "blockers": [{"name": "wall", "shape": "polygon", "vertices": [[0,0,0], [6,0,0], [6,0,3], [0,0,3]],
                  "holes": [[[2,0,1], [4,0,1], [4,0,2], [2,0,2]]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-5,0,0], [15,0,0], [15,10,0], [-5,10,0]],
                   "holes": [[[-4,1,0], [-3,1,0], [-3,2,0]]]}]})");
  EXPECT_NEAR(area("hole.scene.json").nearest, 16, 1e-12);
  EXPECT_NEAR(area("hole.scene.json", "lit").nearest, 200 - 0.5 - 16, 1e-12);
}

TEST_F(ReportedFiles, InUtmCoordinatesGiveWhatTheyGiveAtTheOrigin) {
  const std::string folder = reports + "19-utm-coordinates/";
  for (const std::string region : {"lit", "penumbra", "umbra"}) {
    const std::string near_origin = area(folder + "near_origin.scene.json", region).exact;
    EXPECT_FALSE(near_origin.empty());
    for (const std::string scene : {"main", "as_reported_closed"}) {
      EXPECT_EQ(area(folder + scene + ".scene.json", region).exact, near_origin) << scene;
    }
  }
  std::vector<double> expected(25, 1);
  expected[8] = 361.0 / 16128, expected[12] = expected[13] = 0, expected[14] = 359.0 / 384;
  expected[16] = 11.0 / 16, expected[17] = 49.0 / 33792, expected[18] = 33167.0 / 33792;
  const Outcome run = gnomon("regions " + folder + "main.scene.json --json - --at " + folder + "points.csv");
  const json points = json::parse(run.out)["points"];
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const json& seen = points[i]["lights"][0];
    EXPECT_NEAR(seen["visible_fraction"], expected[i], seen["error_bound"].get<double>() + 1e-16) << i;
  }
  for (const std::string scene : {"tilted_roof", "tilted_turned_roof_mm"}) {
    EXPECT_EQ(gnomon("check " + folder + scene + ".scene.json").code, 0) << scene;
  }
}

TEST_F(ReportedFiles, OfABuildingOnAMillimetreGridAreUsedAsTriangles) {
  const std::string folder = reports + "27-gable-house-mm/";
  const Area house = area(folder + "main.scene.json");
  EXPECT_NEAR(house.nearest, 124.85906600050139, 1e-12);
  EXPECT_EQ(house.exact, area(folder + "triangles.scene.json").exact);
  EXPECT_THAT(doubts(folder + "main.scene.json"), AllOf(HasSubstr("bent and taken as triangles"), HasSubstr("line 1")));
  EXPECT_THAT(gnomon("check " + folder + "main.scene.json").out, HasSubstr("closed"));
  EXPECT_GT(area(folder + "roof_polygon.scene.json").nearest, 0);
  EXPECT_GT(area(folder + "roof_receiver.scene.json", "lit").nearest, 0);
  const json points =
      json::parse(gnomon("regions " + folder + "main.scene.json --json - --at " + folder + "points.csv").out)["points"];
  EXPECT_EQ(points[2]["lights"][0]["region"], "lit") << "on the side of the sun";
}

TEST_F(ReportedFiles, OfNewcomersAreReadWithDoubts) {
  const std::string folder = reports + "newcomers/";
  EXPECT_THAT(doubts(folder + "degen.scene.json"), AllOf(HasSubstr("no area"), HasSubstr("line 5")));
  EXPECT_THAT(doubts(folder + "nonplanar.scene.json"), AllOf(HasSubstr("bent"), HasSubstr("0.0009")));
  EXPECT_THAT(doubts(folder + "mat.scene.json"), AllOf(HasSubstr("\\\"light\\\""), HasSubstr("emit light")));
  EXPECT_EQ(gnomon("check " + folder + "room_hole.scene.json").code, 0);
}

TEST_F(ReportedFiles, GiveTheSameIrradianceInMetresAndMillimetres) {
  write("m.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n1,2,0,0,0,1\n");
  write("mm.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n1000,2000,0,0,0,1\n");
  const auto irradiances = [&](const std::string& unit) {
    const Outcome run =
        gnomon("irradiance " + reports + "newcomers/bulb_" + unit + ".scene.json --json - --at " + unit + ".csv");
    return json::parse(run.out);
  };
  const json in_m = irradiances("m"), in_mm = irradiances("mm");
  EXPECT_EQ(in_mm["length_unit"], "mm");
  EXPECT_EQ(in_mm["irradiance_unit"], "W/m^2");
  EXPECT_EQ(in_m["points"][0]["lights"][0]["irradiance"], 0.0625);
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t l = 0; l < 2; ++l) {
      const json& a = in_m["points"][p]["lights"][l];
      const json& b = in_mm["points"][p]["lights"][l];
      EXPECT_NEAR(a["irradiance"], b["irradiance"], a["error_bound"].get<double>() + b["error_bound"].get<double>());
      EXPECT_LT(b["error_bound"], 1e-12);
    }
  }
}

}  // namespace
}  // namespace gnomon
