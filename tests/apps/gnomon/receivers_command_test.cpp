#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The table of table_scene over a floor of side 40; below it umbra has side 2 (2 + 2/2) and occlusion 2 (2 + 3).
const std::string floor_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}],
  "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-2,-2,2], [2,-2,2], [2,2,2], [-2,2,2]]}],
  "receivers": [
    {"name": "floor", "shape": "polygon", "vertices": [[-20,-20,0], [20,-20,0], [20,20,0], [-20,20,0]]},
    {"name": "ceiling", "shape": "polygon", "vertices": [[-2,-2,4], [-2,2,4], [2,2,4], [2,-2,4]]}]
})";

class ReceiversCommand : public Program {
 protected:
  ReceiversCommand() { write("floor.scene.json", floor_scene); }
};

TEST_F(ReceiversCommand, TellsTheExactAreasOfRegionsAsJson) {
  const Outcome run = gnomon("receivers floor.scene.json --receiver floor --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result["schema"], "gnomon/receivers/1");
  ASSERT_EQ(result["receivers"].size(), 1U);
  const json& floor = result["receivers"][0];
  EXPECT_EQ(floor["name"], "floor");
  EXPECT_EQ(floor["light"], "lamp");
  EXPECT_EQ(floor["area"], 1600.0);
  EXPECT_EQ(floor["areas"]["umbra"]["exact"], "36");
  EXPECT_EQ(floor["areas"]["penumbra"]["exact"], "64");
  EXPECT_EQ(floor["areas"]["lit"]["double"], 1500.0);
  EXPECT_EQ(floor["areas"]["unresolved_eee"]["exact"], "0");
  EXPECT_GT(floor["faces"], 2);
}

/// The area inside cycles of vertices in the plane z = 0, holes counted off.
double area_of(const json& cycles, const json& vertices) {
  double doubled = 0;
  for (const json& cycle : cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const json& p = vertices.at(cycle.at(i).get<std::size_t>());
      const json& q = vertices.at(cycle.at((i + 1) % cycle.size()).get<std::size_t>());
      doubled += p[0].get<double>() * q[1].get<double>() - p[1].get<double>() * q[0].get<double>();
    }
  }
  return doubled / 2;
}

TEST_F(ReceiversCommand, TellsArcsThatBoundAnUmbra) {
  const Outcome run = gnomon("receivers examples/four_umbrae.scene.json --mesh faces,edges --out out --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json floor = json::parse(run.out)["receivers"].at(0);
  EXPECT_NEAR(floor["areas"]["umbra"]["double"].get<double>(), 3.106195091019361, 1e-12);
  EXPECT_EQ(floor["areas"]["unresolved_eee"]["double"], 0.0);
  const json& mesh = floor["mesh"];
  int arcs = 0, triple_edges = 0;
  for (const json& edge : mesh["edges"]) arcs += edge.contains("arc") ? 1 : 0;
  for (const json& event : mesh["events"]) triple_edges += event["kind"] == "triple_edge" && event["edges"].size() == 3;
  EXPECT_GE(arcs, 2);
  EXPECT_GE(triple_edges, 2);
}

TEST_F(ReceiversCommand, TellsWhichEdgesBoundAFaceWhereAnArcAndItsChordHaveTheSameEnds) {
  const Outcome run = gnomon("receivers examples/four_umbrae.scene.json --mesh faces,edges,polygons --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json mesh = json::parse(run.out)["receivers"].at(0)["mesh"];
  for (const char* parts : {"faces", "polygons"}) {
    for (const json& part : mesh[parts]) {
      ASSERT_EQ(part["edge_cycles"].size(), part["cycles"].size());
      for (std::size_t c = 0; c < part["cycles"].size(); ++c) {
        const json &cycle = part["cycles"][c], &edges = part["edge_cycles"][c];
        ASSERT_EQ(edges.size(), cycle.size());
        for (std::size_t k = 0; k < cycle.size(); ++k) {
          const json& ends = mesh["edges"][edges[k].get<std::size_t>()]["vertices"];
          const json from = cycle[k], to = cycle[(k + 1) % cycle.size()];
          EXPECT_TRUE(ends == json({from, to}) || ends == json({to, from})) << parts;
        }
      }
    }
  }
}

TEST_F(ReceiversCommand, TellsTheMeshOnRequest) {
  const Outcome run = gnomon("receivers floor.scene.json --receiver floor --mesh faces,edges,polygons --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json floor = json::parse(run.out)["receivers"].at(0);
  const json& mesh = floor["mesh"];
  EXPECT_EQ(mesh["vertices"].size(), floor["vertices"]);
  EXPECT_EQ(mesh["faces"].size(), floor["faces"]);
  EXPECT_EQ(mesh["edges"].size(), floor["edges"]);
  EXPECT_EQ(mesh["polygons"].size(), floor["regions"]);
  for (const char* parts : {"faces", "polygons"}) {
    std::map<std::string, double> areas;
    for (const json& part : mesh[parts]) areas[part["region"]] += area_of(part["cycles"], mesh["vertices"]);
    EXPECT_EQ(areas, (std::map<std::string, double>{{"lit", 1500}, {"penumbra", 64}, {"umbra", 36}})) << parts;
  }
  for (const json& edge : mesh["edges"]) {
    EXPECT_LT(edge["vertices"].at(1).get<std::size_t>(), mesh["vertices"].size());
    EXPECT_TRUE(edge["left"].is_null() || edge["left"].get<std::size_t>() < mesh["faces"].size());
    EXPECT_FALSE(edge["events"].empty());
    for (const json& event : edge["events"]) EXPECT_LT(event.get<std::size_t>(), mesh["events"].size());
  }
  EXPECT_EQ(mesh["events"].at(0)["kind"], "border");
  EXPECT_EQ(mesh["events"].at(0)["edge"]["of"], "receiver:floor");
}

TEST_F(ReceiversCommand, TellsOnlyWhatIsAskedForOfTheMesh) {
  const json polygons = json::parse(gnomon("receivers floor.scene.json --mesh polygons --json -").out)["receivers"][0];
  EXPECT_TRUE(polygons["mesh"].contains("polygons"));
  EXPECT_FALSE(polygons["mesh"].contains("faces"));
  EXPECT_FALSE(json::parse(gnomon("receivers floor.scene.json --json -").out)["receivers"][0].contains("mesh"));
  EXPECT_EQ(gnomon("receivers floor.scene.json --mesh polygons").code, 2);
  EXPECT_EQ(gnomon("receivers floor.scene.json --mesh corners --json -").code, 2);
}

TEST_F(ReceiversCommand, TellsWhatVerticesReceiveAndReflectToAnEye) {
  write("lamp.scene.json", R"({"gnomon": 1, "dimension": 3, "blockers": [], "materials": [{"name": "chalk"}],
    "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 1], "intensity": 4}],
    "receivers": [{"name": "floor", "shape": "polygon", "material": "chalk",
                   "vertices": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]}]})");
  ASSERT_EQ(gnomon("receivers lamp.scene.json --json r.json --mesh faces --out out --eye 0,0,9").code, 0);
  const nlohmann::json mesh = read_json("r.json")["receivers"][0]["mesh"];
  ASSERT_EQ(mesh["vertices"].size(), 4);
  for (std::size_t v = 0; v < 4; ++v) {
    const double x = mesh["vertices"][v][0], y = mesh["vertices"][v][1];
    const double e = 4 / std::pow(x * x + y * y + 1, 1.5);
    EXPECT_LE(std::fabs(mesh["irradiance"][v].get<double>() - e),
              mesh["irradiance_error_bound"][v].get<double>() + 1e-16);
    EXPECT_NEAR(mesh["radiance"][v][1].get<double>(), e / (2 * std::numbers::pi), 1e-15);
    EXPECT_GT(mesh["radiance_error_bound"][v][1].get<double>(), 0);
  }
  const std::string faces = read("out/shadow/receivers/bulb/floor/faces.vtp");
  for (const std::string array : {"irradiance", "irradiance_error_bound", "radiance", "radiance_error_bound"}) {
    EXPECT_THAT(faces, HasSubstr("Name=\"" + array + "\"")) << array;
  }
  EXPECT_EQ(gnomon("receivers lamp.scene.json --json r.json --mesh faces").code, 0);
  EXPECT_THAT(read("r.json"), Not(HasSubstr("irradiance")));
}

TEST_F(ReceiversCommand, WantsAPlaceForWhatAnEyeSees) {
  EXPECT_EQ(gnomon("receivers examples/figure_4_22.scene.json --eye 0,0,9").code, 2);
  EXPECT_EQ(gnomon("receivers examples/figure_4_22.scene.json --out out --material chalk").code, 2);
  EXPECT_THAT(gnomon("receivers examples/figure_4_22.scene.json --out out --eye camera").err, HasSubstr("no camera"));
}

TEST_F(ReceiversCommand, CallsAReceiverInTheLightsPlaneUnlit) {
  const json result = json::parse(gnomon("receivers floor.scene.json --receiver ceiling --json -").out);
  EXPECT_EQ(result["receivers"][0]["areas"]["unlit"]["exact"], "16");
}

TEST_F(ReceiversCommand, WritesFacesAndEdgesOfEveryReceiver) {
  const Outcome run = gnomon("receivers floor.scene.json --out mesh --format vtm,vtpc");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("floor, light lamp"));
  for (const std::string file : {"receivers.vtm", "receivers.vtpc", "view.py", "shadow/receivers/lamp/floor/faces.vtp",
                                 "shadow/receivers/lamp/floor/edges.vtp", "shadow/scene/blockers/table.vtp"}) {
    EXPECT_TRUE(exists("mesh/" + file)) << file;
  }
  const json manifest = read_json("mesh/manifest.json");
  EXPECT_EQ(manifest["roots"], json({"receivers.vtm", "receivers.vtpc"}));
}

TEST_F(ReceiversCommand, RemovesItsOwnOldFilesAndNothingElse) {
  ASSERT_EQ(gnomon("receivers floor.scene.json --out mesh").code, 0);
  write("mesh/notes.txt", "mine");
  ASSERT_EQ(gnomon("discontinuities floor.scene.json --out mesh").code, 0);
  EXPECT_TRUE(exists("mesh/shadow/receivers/lamp/floor/faces.vtp"));
  ASSERT_EQ(gnomon("receivers floor.scene.json --receiver ceiling --format vtpc --out mesh").code, 0);
  EXPECT_FALSE(exists("mesh/receivers.vtm"));
  EXPECT_FALSE(exists("mesh/shadow/receivers/lamp/floor/faces.vtp"));
  EXPECT_TRUE(exists("mesh/discontinuities.vtm"));
  EXPECT_TRUE(exists("mesh/notes.txt"));
}

TEST_F(ReceiversCommand, RefusesNamesAndFormatsThatAreNotThere) {
  EXPECT_EQ(gnomon("receivers floor.scene.json --receiver roof").code, 2);
  EXPECT_EQ(gnomon("receivers floor.scene.json --light roof").code, 2);
  EXPECT_EQ(gnomon("receivers floor.scene.json --format obj").code, 2);
  EXPECT_EQ(gnomon("receivers missing.scene.json").code, 3);
}

TEST_F(ReceiversCommand, EndsWith4WhereNothingIsSupported) {
  write("bent.scene.json", bent_lamp_scene);
  const Outcome bent = gnomon("receivers bent.scene.json");
  EXPECT_EQ(bent.code, 4);
  EXPECT_THAT(bent.err, HasSubstr("exactly coplanar"));
  const Outcome planar = gnomon("receivers examples/figure_4_17.scene.json");
  EXPECT_EQ(planar.code, 4);
  EXPECT_THAT(planar.err, HasSubstr("dimension 3"));
}

TEST_F(ReceiversCommand, RefusesCoordinatesWhoseProductsVanishOrOverflow) {
  for (const std::string tiny : {"5e-324", "-1e-61", "1e61"}) {
    write("tiny.scene.json", R"({"gnomon": 1, "dimension": 3,
      "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[0, 0, 5], [0, 1, 5], [9, )" +
                                 tiny + R"(, 5]]}],
      "blockers": [{"name": "board", "shape": "polygon", "vertices": [[1, 0, 1], [2, 0, 1], [2, 1, 1]]}],
      "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]]}]})");
    const Outcome run = gnomon("receivers tiny.scene.json --json -");
    EXPECT_EQ(run.code, 4) << run.err;
    EXPECT_THAT(run.err, HasSubstr("light 'lamp' has a coordinate")) << tiny;
    EXPECT_EQ(gnomon("discontinuities tiny.scene.json --json -").code, 0) << tiny;
  }
}

TEST_F(ReceiversCommand, TellsTheSameWithAnyNumberOfThreads) {
  const Outcome one = gnomon("receivers examples/cornell_box.scene.json --light ceiling_lamp --threads 1 --json -");
  const Outcome three = gnomon("receivers examples/cornell_box.scene.json --light ceiling_lamp --threads 3 --json -");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, three.out);
  EXPECT_THAT(one.err, IsEmpty());
}

TEST_F(ReceiversCommand, RunsItsOwnExamples) {
  const std::vector<std::string> examples = examples_of(gnomon("receivers --help").out);
  ASSERT_FALSE(examples.empty());
  for (const std::string& example : examples) EXPECT_EQ(gnomon(example).code, 0) << example;
}

}  // namespace
}  // namespace gnomon
