#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Panels, a wall and the ground under suns at noon, behind the wall, level, and below the horizon.
const std::string suns_scene = R"({"gnomon": 1, "dimension": 3, "lights": [
  {"name": "below", "shape": "direction", "direction": [0, 0.3, 1], "irradiance": 1000},
  {"name": "behind", "shape": "direction", "direction": [0, -1, -0.2], "irradiance": 1000},
  {"name": "grazing", "shape": "direction", "direction": [1, 0, 0], "irradiance": 1000},
  {"name": "noon", "shape": "direction", "direction": [0, 1, -1], "irradiance": 1000}],
  "blockers": [
  {"name": "pv", "shape": "polygon", "vertices": [[0, 0, 1], [2, 0, 1], [2, 1, 2], [0, 1, 2]]},
  {"name": "side", "shape": "polygon", "vertices": [[0, 3, 0], [2, 3, 0], [2, 3, 2], [0, 3, 2]]}],
  "receivers": [
  {"name": "pv", "shape": "polygon", "vertices": [[0, 0, 1], [2, 0, 1], [2, 1, 2], [0, 1, 2]]},
  {"name": "ground", "shape": "polygon", "vertices": [[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]]}]})";

class ReceiverSides : public Program {};

TEST_F(ReceiverSides, ASunBelowTheHorizonOrBehindLightsNothing) {
  write("suns.scene.json", suns_scene);
  write("points.csv", "x,y,z,nx,ny,nz\n1,0.5,1.5,0,-1,1\n1,0.5,1.5,0,1,-1\n1,3,1,0,-1,0\n5,5,0,0,0,1\n5,5,0,0,0,-1\n");
  const Outcome run = gnomon("regions suns.scene.json --at points.csv --json regions.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_EQ(lines(run.out)[0], "x,y,z,nx,ny,nz,light,region,visible_fraction,error_bound,before_receiver");
  EXPECT_EQ(lines(run.out)[1], "1,0.5,1.5,0,-1,1,below,unlit,0,0,0");
  const std::array<std::array<std::string, 4>, 5> expected = {{
      {"unlit", "unlit", "unlit", "lit"},
      {"lit", "lit", "unlit", "unlit"},  // 0.2 is a little more than 1/5: the ray passes above the wall's upper edge
      {"lit", "unlit", "unlit", "lit"},
      {"unlit", "lit", "unlit", "lit"},
      {"lit", "unlit", "unlit", "unlit"},
  }};
  ASSERT_EQ(gnomon("irradiance suns.scene.json --at points.csv --json irradiance.json --out e.csv").code, 0);
  const json regions = read_json("regions.json")["points"];
  const json irradiance = read_json("irradiance.json")["points"];
  for (std::size_t p = 0; p < 5; ++p) {
    for (std::size_t l = 0; l < 4; ++l) {
      const json& seen = regions[p]["lights"][l];
      EXPECT_EQ(seen["region"], expected[p][l]) << p << ' ' << l;
      EXPECT_EQ(seen["before_receiver"], expected[p][l] == "unlit" ? 0 : 1) << p << ' ' << l;
      EXPECT_EQ(irradiance[p]["lights"][l]["irradiance"] > 0, expected[p][l] == "lit") << p << ' ' << l;
    }
  }
}

TEST_F(ReceiverSides, OfALampHalfBeforeTheReceiverHalfCounts) {
  write("table.scene.json", table_scene);
  write("wall.csv", "x,y,z,nx,ny,nz\n3,0,4.5,0,0,-1\n0,9,0,1,0,0\n0,9,0,1,0,1\n");
  EXPECT_THAT(lines(gnomon("regions table.scene.json --at wall.csv").out),
              ElementsAre(HasSubstr("before_receiver"), "3,0,4.5,0,0,-1,lamp,unlit,0,0,1",
                          StartsWith("0,9,0,1,0,0,lamp,lit,0.5,"), "0,9,0,1,0,1,lamp,lit,1,0,1"));
}

TEST_F(ReceiverSides, PointsWithoutNormalsHaveNoSide) {
  write("suns.scene.json", suns_scene);
  write("points.csv", "x,y,z\n5,5,0\n");
  EXPECT_THAT(lines(gnomon("regions suns.scene.json --at points.csv --light below").out),
              ElementsAre("x,y,z,light,region,visible_fraction,error_bound", "5,5,0,below,lit,1,0"));
}

TEST_F(ReceiverSides, CheckDoubtsReceiversThatAreTurnedFromEveryLight) {
  write("under.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "sun", "shape": "direction", "direction": [0, 0, -1]}],
    "blockers": [{"name": "b", "shape": "polygon", "vertices": [[0, 0, 1], [1, 0, 1], [0, 1, 1]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[0, 0, 0], [0, 1, 0], [1, 0, 0]]},
                  {"name": "wall", "shape": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [0, 0, 1]]},
                  {"name": "pane", "shape": "polygon", "vertices": [[0, 0, 0], [0, 1, 0], [1, 0, 0]],
                   "two_sided": true}]})");
  ASSERT_EQ(gnomon("check under.scene.json --json check.json").code, 0);
  const json doubts = read_json("check.json")["doubts"];
  ASSERT_EQ(doubts.size(), 2U);
  EXPECT_THAT(doubts[0], HasSubstr("receiver \"floor\": it is turned from every light"));
  EXPECT_THAT(doubts[1], HasSubstr("receiver \"wall\": no light is before it; one lies in its plane"));
}

TEST_F(ReceiverSides, CheckTellsWhetherTheReceiverIsTurnedAwayOrTheLamp) {
  write("back.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[0, 0, 4], [1, 0, 4], [0, 1, 4]]}],
    "blockers": [{"name": "b", "shape": "polygon", "vertices": [[0, 0, 5], [1, 0, 5], [0, 1, 5]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]},
                  {"name": "pane", "shape": "polygon", "vertices": [[0, 0, 1], [1, 0, 1], [0, 1, 1]], "two_sided": true},
                  {"name": "shelf", "shape": "polytope",
                   "vertices": [[0, 0, 6], [1, 0, 6], [0, 1, 6], [0, 0, 7]]}]})");
  const Outcome run = gnomon("check back.scene.json --json check.json");
  ASSERT_EQ(run.code, 0);
  EXPECT_THAT(run.out, testing::ContainsRegex("shelf +polytope"));
  const json doubts = read_json("check.json")["doubts"];
  ASSERT_EQ(doubts.size(), 2U);
  EXPECT_THAT(doubts[0],
              HasSubstr("receiver \"floor\": no light shines on it; a polygon light before it turns its back"));
  EXPECT_THAT(doubts[1],
              HasSubstr("receiver \"pane\": no light shines on it; a polygon light before it turns its back"));
}

TEST_F(ReceiverSides, AReceiverOfTwoSidesIsTwoByName) {
  write("pane.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4}], "blockers": [],
    "receivers": [{"name": "pane", "shape": "polygon", "two_sided": true,
                   "vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]}]})");
  const json result = json::parse(gnomon("receivers pane.scene.json --json -").out)["receivers"];
  ASSERT_EQ(result.size(), 2U);
  EXPECT_EQ(result[0]["name"], "pane/front");
  EXPECT_EQ(result[1]["name"], "pane/back");
  EXPECT_EQ(result[0]["areas"]["lit"]["exact"], "4");
  const Outcome run = gnomon("irradiance pane.scene.json --on pane --shape 1,1");
  EXPECT_THAT(lines(run.out),
              ElementsAre("x,y,z,nx,ny,nz,facet,light,irradiance,error_bound",
                          StartsWith("0,0,0,0,0,1,pane/front,bulb,1,"), StartsWith("0,0,0,0,0,-1,pane/back,bulb,0,0")));
  EXPECT_THAT(lines(gnomon("irradiance pane.scene.json --on pane/back --shape 1,1").out),
              ElementsAre(HasSubstr("irradiance"), "0,0,0,0,0,-1,bulb,0,0"));
}

/// A lumpy sheet of 2 n² triangles over the square [-5, 5]², with six digits.
std::string terrain(int n) {
  std::ostringstream obj;
  obj << std::fixed << std::setprecision(6);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = -5 + 10.0 * i / n, y = -5 + 10.0 * j / n;
      obj << "v " << x << ' ' << y << ' ' << 1.5 + 0.3 * std::sin(1.3 * x) * std::cos(1.7 * y) << '\n';
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i + 1, b = a + 1, c = a + n + 1, d = c + 1;
      obj << "f " << a << ' ' << b << ' ' << d << "\nf " << a << ' ' << d << ' ' << c << '\n';
    }
  }
  return obj.str();
}

class TerrainUnderALamp : public Program {
 protected:
  TerrainUnderALamp() {
    write("terrain.obj", terrain(12));
    write("terrain.scene.json", R"({"gnomon": 1, "dimension": 3,
      "lights": [{"name": "lamp", "shape": "polygon",
                  "vertices": [[-0.5, -0.5, 60], [-0.5, 0.5, 60], [0.5, 0.5, 60], [0.5, -0.5, 60]]}],
      "blockers": [{"name": "model", "shape": "mesh", "file": "terrain.obj"}],
      "receivers": [{"name": "model", "shape": "mesh", "file": "terrain.obj"}]})");
  }
};

TEST_F(TerrainUnderALamp, IsAskedOnItsFacetsAndNeverShadowsItself) {
  const Outcome run = gnomon("irradiance terrain.scene.json --on model --json on.json --out on.csv");
  ASSERT_EQ(run.code, 0) << run.err;
  const json points = read_json("on.json")["points"];
  ASSERT_EQ(points.size(), 288U);
  EXPECT_EQ(lines(read("on.csv"))[0], "x,y,z,nx,ny,nz,facet,light,irradiance,error_bound");
  EXPECT_THAT(lines(read("on.csv"))[288], HasSubstr(",model#287,lamp,"));
  for (const json& point : points) EXPECT_GT(point["lights"][0]["irradiance"], 0) << point;
}

TEST_F(TerrainUnderALamp, PointsComputedOnFacetsAreInUmbraOnlyWithoutNormals) {
  const json on = json::parse(gnomon("irradiance terrain.scene.json --on model --json -").out)["points"];
  std::ostringstream bare, facing;
  bare << std::setprecision(17) << "x,y,z\n";
  facing << std::setprecision(17) << "x,y,z,nx,ny,nz\n";
  for (const json& point : on) {
    const auto p = point["point"], n = point["normal"];
    for (std::ostringstream* table : {&bare, &facing}) {
      *table << p[0].get<double>() << ',' << p[1].get<double>() << ',' << p[2].get<double>();
    }
    facing << ',' << n[0].get<double>() << ',' << n[1].get<double>() << ',' << n[2].get<double>() << '\n';
    bare << '\n';
  }
  write("bare.csv", bare.str());
  write("facing.csv", facing.str());
  const Outcome without =
      gnomon("regions terrain.scene.json --at bare.csv --json bare.json --out bare_out.csv --quiet");
  EXPECT_THAT(without.err, HasSubstr("within rounding of a blocker"));
  EXPECT_GT(read_json("bare.json")["lights"][0]["umbra"], 20);
  const Outcome with = gnomon("regions terrain.scene.json --at facing.csv --json facing.json --out out.csv --quiet");
  EXPECT_THAT(with.err, testing::Not(HasSubstr("within rounding")));
  EXPECT_EQ(read_json("facing.json")["lights"][0]["lit"], 288);
  // The same light as on the facets themselves, and a little above them.
  const json at = json::parse(gnomon("irradiance terrain.scene.json --at facing.csv --json -").out)["points"];
  const json lifted =
      json::parse(gnomon("irradiance terrain.scene.json --at facing.csv --lift 1e-9 --json -").out)["points"];
  for (std::size_t i = 0; i < on.size(); ++i) {
    const double expected = on[i]["lights"][0]["irradiance"];
    EXPECT_NEAR(at[i]["lights"][0]["irradiance"], expected, 1e-15) << i;
    EXPECT_NEAR(lifted[i]["lights"][0]["irradiance"], expected, 1e-9) << i;
  }
}

TEST_F(TerrainUnderALamp, IsOneBlockAndOneRowOfAllFacets) {
  const Outcome run = gnomon("receivers terrain.scene.json --out mesh --json mesh.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json rows = read_json("mesh.json")["receivers"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["name"], "model");
  EXPECT_EQ(rows[0]["facets"], 288);
  EXPECT_EQ(rows[0]["areas"]["lit"]["double"], rows[0]["area"]);
  EXPECT_TRUE(exists("mesh/shadow/receivers/lamp/model/faces.vtp"));
  EXPECT_EQ(names_in("mesh/shadow/receivers/lamp").size(), 1U);
  EXPECT_EQ(names_in("mesh/shadow/scene/receivers").size(), 1U);
}

TEST_F(TerrainUnderALamp, TellsTheMeshOfEveryFacetByItsName) {
  const json model =
      json::parse(gnomon("receivers terrain.scene.json --mesh faces,edges --json -").out)["receivers"][0];
  EXPECT_FALSE(model.contains("mesh"));
  ASSERT_EQ(model["meshes"].size(), 288U);
  EXPECT_EQ(model["meshes"][287]["facet"], "model#287");
  std::size_t faces = 0, edges = 0, vertices = 0;
  for (const json& mesh : model["meshes"]) {
    faces += mesh["faces"].size();
    edges += mesh["edges"].size();
    vertices += mesh["vertices"].size();
  }
  EXPECT_EQ(model["faces"], faces);
  EXPECT_EQ(model["edges"], edges);
  EXPECT_EQ(model["vertices"], vertices);
}

TEST_F(ReceiverSides, AConcaveReceiverIsDividedExactly) {
  write("roof.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "sun", "shape": "direction", "direction": [0, 0, -1]}],
    "blockers": [{"name": "shade", "shape": "polygon", "vertices": [[-2, -2, 8], [2, -2, 8], [2, 22, 8], [-2, 22, 8]]}],
    "receivers": [{"name": "roof", "shape": "concave_polygon", "vertices": [
      [0, 0, 6], [36.25, 0, 6], [36.25, 20, 6], [30, 20, 6], [30, 20.5, 6], [25, 20.5, 6], [25, 20, 6], [0, 20, 6]]}]})");
  const json rows = json::parse(gnomon("receivers roof.scene.json --json -").out)["receivers"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["areas"]["umbra"]["exact"], "40");
  EXPECT_EQ(rows[0]["areas"]["lit"]["exact"], "1375/2");
}

TEST_F(ReceiverSides, APolytopeReceivesWithItsFacets) {
  write("box.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "sun", "shape": "direction", "direction": [0, 1, -0.5]}],
    "blockers": [{"name": "house", "shape": "polytope", "vertices": [[0, 0, 0], [100, 0, 0], [100, 40, 0], [0, 40, 0],
                  [0, 0, 4], [100, 0, 4], [100, 40, 4], [0, 40, 4]]}],
    "receivers": [{"name": "house", "shape": "polytope", "vertices": [[0, 0, 0], [100, 0, 0], [100, 40, 0], [0, 40, 0],
                  [0, 0, 4], [100, 0, 4], [100, 40, 4], [0, 40, 4]]},
                  {"name": "ground", "shape": "polygon",
                   "vertices": [[-200, -200, 0], [200, -200, 0], [200, 200, 0], [-200, 200, 0]]}]})");
  const json rows = json::parse(gnomon("receivers box.scene.json --json -").out)["receivers"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["facets"], 6);
  EXPECT_EQ(rows[1]["areas"]["umbra"]["exact"], "4800");
  write("points.csv",
        "x,y,z,nx,ny,nz\n50,44,0,0,0,1\n50,-4,0,0,0,1\n50,48,0,0,0,1\n50,48.0000001,0,0,0,1\n"
        "50,20,0,0,0,1\n50,20,4,0,0,1\n");
  const json points = json::parse(gnomon("regions box.scene.json --at points.csv --json -").out)["points"];
  // The third ray grazes the roof's edge; from just before the receiver it passes.
  const std::array<std::string, 6> expected = {"umbra", "lit", "lit", "lit", "umbra", "lit"};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(points[i]["lights"][0]["region"], expected[i]) << i;
}

/// 4 m² triangles on a sphere around (0, 0, 2), with nine digits: dents of a nanometre.
std::string sphere(int m) {
  std::ostringstream obj;
  obj << std::fixed << std::setprecision(9) << "v 0 0 3\n";
  const double pi = std::acos(-1.0);
  const int n = 2 * m;
  for (int i = 1; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double t = pi * i / m, p = 2 * pi * j / n;
      obj << "v " << std::sin(t) * std::cos(p) << ' ' << std::sin(t) * std::sin(p) << ' ' << 2 + std::cos(t) << '\n';
    }
  }
  obj << "v 0 0 1\n";
  const auto at = [&](int i, int j) { return 2 + (i - 1) * n + j % n; };
  for (int j = 0; j < n; ++j) {
    obj << "f 1 " << at(1, j) << ' ' << at(1, j + 1) << '\n';
    obj << "f " << 2 + (m - 1) * n << ' ' << at(m - 1, j + 1) << ' ' << at(m - 1, j) << '\n';
    for (int i = 1; i < m - 1; ++i) {
      obj << "f " << at(i, j) << ' ' << at(i + 1, j) << ' ' << at(i + 1, j + 1) << '\n';
      obj << "f " << at(i, j) << ' ' << at(i + 1, j + 1) << ' ' << at(i, j + 1) << '\n';
    }
  }
  return obj.str();
}

TEST_F(ReceiverSides, AConvexMeshIsOneSolidOfAFewFiles) {
  write("sphere.obj", sphere(16));
  write("sphere.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-0.5, -0.5, 6], [-0.5, 0.5, 6], [0.5, 0.5, 6], [0.5, -0.5, 6]]}],
    "blockers": [{"name": "ball", "shape": "mesh", "file": "sphere.obj"}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-6, -6, 0], [6, -6, 0], [6, 6, 0], [-6, 6, 0]]}]})");
  ASSERT_EQ(gnomon("shadow sphere.scene.json --out ball --json ball.json --quiet").code, 0);
  const json pairs = read_json("ball.json")["pairs"];
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0]["blocker"], "ball");
  const json doubts = json::parse(gnomon("check sphere.scene.json --json -").out)["doubts"];
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_THAT(doubts[0], HasSubstr("it is a convex solid but for dents"));
}

/// Turned by angles that leave no coordinate short, and rounded.
std::string turned(const std::vector<std::array<double, 2>>& ring, double by) {
  const double a = std::cos(by), b = std::sin(by), c = std::cos(by / 3), d = std::sin(by / 3);
  std::ostringstream text;
  text << std::setprecision(17) << '[';
  for (const auto& [u, v] : ring) {
    const double x = a * u - b * v, y = b * u + a * v;
    text << (text.tellp() > 1 ? ",[" : "[") << x << ',' << c * y << ',' << d * y << ']';
  }
  return text.str() + ']';
}

TEST_F(ReceiverSides, APlateWhoseVerticesWereRoundedDoesNotHideTheLightFromItself) {
  const std::vector<std::array<double, 2>> square = {{0, 0}, {2, 0}, {2, 1}, {0, 1}},
                                           l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                                           hole = {{.5, .25}, {.5, .75}, {1.5, .75}, {1.5, .25}};
  for (int k = 1; k <= 12; ++k) {
    const double by = 0.25 * k + 0.01;
    const std::string plates[] = {
        R"("shape": "polygon", "vertices": )" + turned(square, by),
        R"("shape": "concave_polygon", "vertices": )" + turned(l, by),
        R"("shape": "polygon", "vertices": )" + turned(square, by) + R"(, "holes": [)" + turned(hole, by) + "]"};
    for (const std::string& plate : plates) {
      write("plate.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [
        {"name": "bulb", "shape": "point", "position": [0, 0, 9]}], "blockers": [{"name": "plate", )" +
                                    plate + R"(}], "receivers": [{"name": "plate", "two_sided": true, )" + plate +
                                    "}]}");
      const Outcome divided = gnomon("receivers plate.scene.json");
      ASSERT_EQ(divided.code, 0) << divided.err;
      EXPECT_THAT(divided.out, HasSubstr("lit 100.00 %")) << k << plate;
      EXPECT_THAT(divided.out, HasSubstr("unlit 100.00 %")) << k << plate;
      const Outcome on = gnomon("irradiance plate.scene.json --on plate --out on.csv");
      ASSERT_EQ(on.code, 0) << on.err;
      const Outcome at = gnomon("regions plate.scene.json --at on.csv");
      std::istringstream rows(at.out);
      int lit = 0, unlit = 0;
      for (std::string row; std::getline(rows, row);) {
        EXPECT_THAT(row, Not(HasSubstr("umbra"))) << k << plate;
        lit += row.find(",lit,") != std::string::npos ? 1 : 0;
        unlit += row.find(",unlit,") != std::string::npos ? 1 : 0;
      }
      EXPECT_GT(lit, 0) << plate;
      EXPECT_EQ(lit, unlit) << plate;
    }
  }
}

/// The faces of a box, counterclockwise from outside.
constexpr int box_faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

TEST_F(ReceiverSides, AConvexSolidWhoseVerticesWereRoundedDoesNotHideTheLightFromItsFaces) {
  for (int k = 1; k <= 12; ++k) {
    const double by = 0.25 * k + 0.01, a = std::cos(by), b = std::sin(by), c = std::cos(by / 3), d = std::sin(by / 3);
    json vertices = json::array(), receivers = json::array();
    for (int v = 0; v < 8; ++v) {
      const double p = (v & 1) * 2 - 1, q = (v & 2) * 1.5 - 1, r = (v & 4) * 0.75;
      const double x = a * p - b * q, y = b * p + a * q;
      vertices.push_back({x, c * y - d * r, d * y + c * r});
    }
    for (const auto& face : box_faces) {
      const std::string name = "face " + std::to_string(receivers.size());
      json ring = json::array(), back = json::array();
      for (const int v : face) ring.push_back(vertices[v]);
      for (const int v : face) back.insert(back.begin(), vertices[v]);
      receivers.push_back({{"name", name}, {"shape", "polygon"}, {"vertices", ring}});
      receivers.push_back({{"name", name + " from inside"}, {"shape", "polygon"}, {"vertices", back}});
    }
    const json bulb = {{"name", "bulb"}, {"shape", "point"}, {"position", {1, 2, 99}}};
    const json box = {{"name", "box"}, {"shape", "polytope"}, {"vertices", vertices}};
    const json scene = {{"gnomon", 1},
                        {"dimension", 3},
                        {"lights", json::array({bulb})},
                        {"blockers", json::array({box})},
                        {"receivers", receivers}};
    write("box.scene.json", scene.dump());
    ASSERT_EQ(gnomon("receivers box.scene.json --json box.json --quiet").code, 0);
    int lit = 0;
    const json divided = read_json("box.json")["receivers"];
    ASSERT_EQ(divided.size(), 12U);
    for (const json& face : divided) {
      const bool is_inside = face["name"].get<std::string>().ends_with("inside");
      const json& areas = face["areas"];
      // From inside a face may stick out of the hull by what was rounded.
      const double sliver = is_inside ? 1e-14 : 0;
      const auto is_wholly = [&](const char* region) {
        return areas[region]["double"].get<double>() >= face["area"].get<double>() - sliver;
      };
      EXPECT_TRUE(is_wholly("unlit") || is_wholly(is_inside ? "umbra" : "lit")) << k << face;
      lit += is_wholly("lit") ? 1 : 0;
    }
    EXPECT_GE(lit, 1);
    EXPECT_LE(lit, 3);
  }
}

TEST_F(ReceiverSides, ALampFlushWithItsCeilingIsSeenInFrontOfIt) {
  write("ceiling.scene.json", R"({"gnomon": 1, "dimension": 3,
    "camera": {"eye": [2.5, -3, 1], "look_at": [1.5, 1.5, 3], "width": 3, "height": 3, "fov": 2},
    "lights": [{"name": "panel", "shape": "polygon", "vertices": [[1,1,3], [1,2,3], [2,2,3], [2,1,3]]}],
    "blockers": [{"name": "ceiling", "shape": "polygon", "vertices": [[0,0,3], [0,4,3], [5,4,3], [5,0,3]]}]})");
  ASSERT_EQ(gnomon("image ceiling.scene.json --out ceiling.pfm --json ceiling.json").code, 0);
  const std::string pixels = read("ceiling.pfm");
  float radiance = 0;
  ASSERT_GE(pixels.size(), 9 * 3 * sizeof radiance);
  std::memcpy(&radiance, pixels.data() + pixels.size() - 5 * 3 * sizeof radiance, sizeof radiance);
  EXPECT_EQ(radiance, 1.0F);
}

}  // namespace
}  // namespace gnomon
