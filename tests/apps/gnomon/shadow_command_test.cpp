#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class ShadowCommand : public Program {
 protected:
  ShadowCommand() {
    write("table.scene.json", table_scene);
    write("mixed.scene.json", mixed_scene);
    write("bent_lamp.scene.json", bent_lamp_scene);
    write("bent_shelf.scene.json", bent_shelf_scene);
  }
};

TEST_F(ShadowCommand, WritesTheDefaultSceneForParaView) {
  const Outcome run = gnomon("shadow --out shadows");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_THAT(run.out, AllOf(HasSubstr("shadows/shadow.vtm"), HasSubstr("paraview --script=shadows/view.py"),
                             HasSubstr("umbra"), HasSubstr("penumbra"), HasSubstr("occlusion")));
  EXPECT_TRUE(exists("shadows/shadow.vtm"));
  EXPECT_TRUE(exists("shadows/manifest.json"));
  EXPECT_TRUE(exists("shadows/view.py"));
}

TEST_F(ShadowCommand, WritesTheCornellBoxWithEveryPair) {
  const Outcome run = gnomon("shadow examples/cornell_box.scene.json --out box");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(exists("box/shadow.vtm"));
  EXPECT_THAT(run.out, AllOf(HasSubstr("short_top"), HasSubstr("light_crosses_blocker_plane")));
  EXPECT_THAT(run.err, IsEmpty());
}

TEST_F(ShadowCommand, QuotesTheParaViewCommandForTheShell) {
  EXPECT_THAT(gnomon("shadow --out 'my shadows'").out, HasSubstr("paraview --script='my shadows/view.py'"));
}

TEST_F(ShadowCommand, PrintsTheJsonAloneOnStandardOutput) {
  const Outcome run = gnomon("shadow mixed.scene.json --json -");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(nlohmann::json::accept(run.out)) << run.out;
  EXPECT_THAT(names_in("."), Not(Contains(StartsWith(".gnomon"))));
}

TEST_F(ShadowCommand, WritesFolderAndJsonAtOnce) {
  const Outcome run = gnomon("shadow table.scene.json --out shadows --json result.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(exists("shadows/shadow.vtm"));
  EXPECT_EQ(read_json("result.json")["schema"], "gnomon/shadow/1");
}

TEST_F(ShadowCommand, AsksForSomethingToWrite) {
  const Outcome run = gnomon("shadow table.scene.json");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("--out"), HasSubstr("--json")));
}

TEST_F(ShadowCommand, PrintsAtMost40PairsOfAMeshAndHowManyMoreThereAre) {
  std::ostringstream mesh;
  for (int k = 0; k < 50; ++k) {
    mesh << "v " << k << " 0 0\nv " << k << ".5 0 0\nv " << k << " 1 0.25\nf " << 3 * k + 1 << ' ' << 3 * k + 2 << ' '
         << 3 * k + 3 << '\n';
  }
  write("many.obj", mesh.str());
  write("many.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "shape": "polygon",
    "vertices": [[0,0,9], [0,1,9], [1,0,9]]}], "blockers": [{"name": "strip", "shape": "mesh", "file": "many.obj"}]})");
  const Outcome run = gnomon("shadow many.scene.json --out many --json many.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("strip#39 "), Not(HasSubstr("strip#40 ")), HasSubstr("and 10 more; --json")));
  EXPECT_EQ(read_json("many.json")["pairs"].size(), 50U);
}

TEST_F(ShadowCommand, PrintsNothingWhenQuiet) {
  const Outcome run = gnomon("shadow table.scene.json --out shadows --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out + run.err, IsEmpty());
  EXPECT_TRUE(exists("shadows/shadow.vtm"));
}

TEST_F(ShadowCommand, WarnsOfUnsupportedPairsByNameEvenWhenQuiet) {
  const Outcome run = gnomon("shadow bent_lamp.scene.json --out shadows --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, AllOf(HasSubstr("1 of 2 pairs"), HasSubstr("lamp / shelf: "), HasSubstr("strictly apart")));
}

TEST_F(ShadowCommand, WritesConcavePolygonsPartByPartAndConvexMeshesAsOne) {
  const Outcome run = gnomon("shadow examples/../tests/data/scenes/good/everything_in_space.scene.json --out shadows");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("arrow#1"), HasSubstr("vase"), Not(HasSubstr("vase#")), HasSubstr("post"),
                             HasSubstr("sun")));
}

TEST_F(ShadowCommand, EndsWith4WhereNoPairIsSupported) {
  const Outcome run = gnomon("shadow bent_shelf.scene.json --out shadows --json -");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, AllOf(HasSubstr("lamp / shelf"), HasSubstr("coplanar")));
  EXPECT_FALSE(exists("shadows"));
  const auto pair = nlohmann::json::parse(run.out)["pairs"].at(0);
  EXPECT_EQ(pair["supported"], false);
  EXPECT_FALSE(pair.contains("umbra"));
}

TEST_F(ShadowCommand, EndsWith4WhereTheOnlyChosenPairIsUnsupported) {
  EXPECT_EQ(gnomon("shadow bent_lamp.scene.json --blocker table --json -").code, 0);
  EXPECT_EQ(gnomon("shadow bent_lamp.scene.json --blocker shelf --json -").code, 4);
}

TEST_F(ShadowCommand, TakesOneLightAndOneBlocker) {
  const Outcome run = gnomon("shadow mixed.scene.json --light lamp --blocker table --json -");
  const auto pairs = nlohmann::json::parse(run.out)["pairs"];
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0]["light"], "lamp");
  EXPECT_EQ(pairs[0]["blocker"], "table");
}

TEST_F(ShadowCommand, ListsTheKnownNamesWhereOneIsUnknown) {
  const Outcome light = gnomon("shadow mixed.scene.json --light moon --json -");
  EXPECT_EQ(light.code, 2);
  EXPECT_THAT(light.err, AllOf(HasSubstr("'moon'"), HasSubstr("'lamp'"), HasSubstr("'sun'")));
  const Outcome blocker = gnomon("shadow mixed.scene.json --blocker tree --json -");
  EXPECT_EQ(blocker.code, 2);
  EXPECT_THAT(blocker.err, AllOf(HasSubstr("'tree'"), HasSubstr("'table'"), HasSubstr("'wall'"), HasSubstr("'post'")));
  EXPECT_THAT(light.out + blocker.out, IsEmpty());
}

TEST_F(ShadowCommand, RefusesABoxThatIsNone) {
  for (const std::string box : {"1,2,3", "0,0,0,1,1,0", "0,0,0,1,1,-1", "0,0,0,1,1,inf", "0,0,0,1,1,nan",
                                "0,0,0,1,1,1e999", "0,0,0,1,1,", "0,0,0,1,1,1x", "0,0,0,1,1,1,1", "''"}) {
    const Outcome run = gnomon("shadow table.scene.json --json - --box " + box);
    EXPECT_EQ(run.code, 2) << box;
    EXPECT_THAT(run.err, HasSubstr("--box")) << box;
    EXPECT_THAT(run.out, IsEmpty()) << box;
  }
}

TEST_F(ShadowCommand, RefusesUnknownFormatsAndOptions) {
  const Outcome format = gnomon("shadow --out shadows --format vtm,doc");
  EXPECT_EQ(format.code, 2);
  EXPECT_THAT(format.err, AllOf(HasSubstr("'doc'"), HasSubstr("vtpc")));
  EXPECT_FALSE(exists("shadows"));
  for (const std::string options :
       {"--colour red", "--threads 0", "--threads two", "--json", "one two", "--light ''"}) {
    EXPECT_EQ(gnomon("shadow --out shadows " + options).code, 2) << options;
  }
}

TEST_F(ShadowCommand, MovesALightAlongAPath) {
  write("path.csv", "x,y,z\n-1,-1,4\n\n3,-1,4\n");
  const Outcome run = gnomon("shadow table.scene.json --path path.csv --out series");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("2 places"), HasSubstr("series/shadow.pvd")));
  EXPECT_THAT(names_in("series"),
              testing::ElementsAre("manifest.json", "shadow.pvd", "shadow_0000", "shadow_0001", "view.py"));
  EXPECT_THAT(read("series/shadow.pvd"), AllOf(HasSubstr("timestep=\"0\" part=\"0\" file=\"shadow_0000/shadow.vtm\""),
                                               HasSubstr("timestep=\"1\" part=\"0\" file=\"shadow_0001/shadow.vtm\"")));
  EXPECT_EQ(read_json("series/manifest.json").at("roots"), nlohmann::json{"shadow.pvd"});
}

TEST_F(ShadowCommand, LeavesNothingOfALongerSeries) {
  write("long.csv", "x,y,z\n-1,-1,4\n3,-1,4\n4,-1,4\n");
  write("short.csv", "x,y,z\n-1,-1,4\n");
  ASSERT_EQ(gnomon("shadow table.scene.json --path long.csv --out series").code, 0);
  ASSERT_EQ(gnomon("shadow table.scene.json --path short.csv --out series").code, 0);
  EXPECT_THAT(names_in("series"), testing::ElementsAre("manifest.json", "shadow.pvd", "shadow_0000", "view.py"));
}

TEST_F(ShadowCommand, RefusesAPathByFileAndLineAndLeavesTheSeriesAlone) {
  write("good.csv", "x,y,z\n-1,-1,4\n");
  ASSERT_EQ(gnomon("shadow table.scene.json --path good.csv --out series").code, 0);
  const std::string before = read("series/shadow.pvd");
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "path.csv: found an empty file, expected the header \"x,y,z\""},
      {"a;b;c\n", "path.csv:1: found \"a;b;c\", expected the header \"x,y,z\""},
      {"x,y,z\n", "path.csv: found no position below the header, expected at least one"},
      {"x,y,z\n1,2,3\n1,2\n", "path.csv:3: found 2 fields, expected 3"},
      {"x,y,z\n1,2,three\n", "path.csv:2: z: found \"three\", expected a finite number"},
      {"x,y,z\n1e300,1e300,1e300\n", "path.csv:2: found a position at which the vertices of lamp"}};
  for (const auto& [text, message] : bad) {
    write("path.csv", text);
    const Outcome run = gnomon("shadow table.scene.json --path path.csv --out series");
    EXPECT_EQ(run.code, 3) << text;
    EXPECT_THAT(run.err, HasSubstr(message));
  }
  EXPECT_EQ(gnomon("shadow table.scene.json --path missing.csv --out series").code, 3);
  EXPECT_EQ(read("series/shadow.pvd"), before);
}

TEST_F(ShadowCommand, MovesOneLightThatCanBeMoved) {
  write("mixed.scene.json", mixed_scene);
  write("path.csv", "x,y,z\n-1,-1,4\n");
  EXPECT_THAT(gnomon("shadow mixed.scene.json --path path.csv --out series").err, HasSubstr("--light"));
  EXPECT_EQ(gnomon("shadow mixed.scene.json --path path.csv --out series").code, 2);
  EXPECT_EQ(gnomon("shadow mixed.scene.json --path path.csv --out series --light sun").code, 4);
  EXPECT_EQ(gnomon("shadow mixed.scene.json --path path.csv --out series --light moon").code, 2);
  EXPECT_FALSE(exists("series"));
  EXPECT_EQ(gnomon("shadow mixed.scene.json --path path.csv --out series --light lamp").code, 0);
}

TEST_F(ShadowCommand, MovesALightOfThePlane) {
  write("path.csv", "x,y\n0,8\n1,8\n2,8\n");
  EXPECT_EQ(gnomon("shadow examples/figure_4_17.scene.json --path path.csv --out series").code, 0);
  EXPECT_TRUE(exists("series/shadow_0002/shadow.vtm"));
}

TEST_F(ShadowCommand, RefusesWhatDoesNotGoWithAPath) {
  write("path.csv", "x,y,z\n-1,-1,4\n");
  for (const std::string options : {"--json -", "--out series --format obj", "--out series --merge"}) {
    EXPECT_EQ(gnomon("shadow table.scene.json --path path.csv " + options).code, 2) << options;
  }
}

/// An L of area 3 at height 1.
const std::string angle_scene = R"({
  "gnomon": 1, "dimension": 3,
  "lights": [{"name": "sun", "shape": "direction", "direction": [0,0,-1]}],
  "blockers": [{"name": "angle", "shape": "concave_polygon",
                "vertices": [[0,0,1], [2,0,1], [2,1,1], [1,1,1], [1,2,1], [0,2,1]]}]
})";

TEST_F(ShadowCommand, MergeUnitesTheOcclusionsOfAConcaveBlockerAndSaysWhyUmbraeAreNot) {
  write("angle.scene.json", angle_scene);
  const Outcome run = gnomon("shadow angle.scene.json --merge --box -9,-9,0,9,9,9 --out shadows --json result.json");
  EXPECT_EQ(run.code, 0) << run.err;
  const nlohmann::json merged = read_json("result.json").at("merged");
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged[0].at("blocker"), "angle");
  EXPECT_EQ(merged[0].at("exact"), "3");
  const nlohmann::json manifest = read_json("shadows/manifest.json");
  EXPECT_THAT(manifest.at("merged").at("note").get<std::string>(), HasSubstr("Umbrae are not"));
  const auto is_merged = [](const nlohmann::json& block) {
    return block.at("path") == nlohmann::json{"volumes", "sun", "angle", "occlusion_merged"};
  };
  EXPECT_EQ(std::count_if(manifest.at("blocks").begin(), manifest.at("blocks").end(), is_merged), 1);
}

TEST_F(ShadowCommand, MergeAllUnitesTheOcclusionsOfAllBlockersOfALightWhichKeepTheirNames) {
  const std::string half = R"({"name": "half", "shape": "polygon", "vertices": [[1,1,2], [3,1,2], [3,3,2], [1,3,2]]})";
  std::string scene = angle_scene;
  scene.insert(scene.rfind("]"), ", " + half);
  write("both.scene.json", scene);
  const std::string rest = " --box -9,-9,0,9,9,9 --out shadows --json result.json";
  for (const std::string options :
       {"both.scene.json --merge all", "--merge=all both.scene.json", "--merge all both.scene.json"}) {
    const Outcome run = gnomon("shadow " + options + rest);
    EXPECT_EQ(run.code, 0) << run.err;
    const nlohmann::json merged = read_json("result.json").at("merged");
    ASSERT_EQ(merged.size(), 1u) << "one light";
    EXPECT_EQ(merged[0].at("light"), "sun");
    EXPECT_EQ(merged[0].at("blocker"), "all#blockers");
    EXPECT_EQ(merged[0].at("parts"), read_json("result.json").at("pairs").size());
    EXPECT_EQ(merged[0].at("exact"), "11") << "3 below the angle and 8 below the square, which do not overlap";
  }
  const nlohmann::json manifest = read_json("shadows/manifest.json");
  EXPECT_TRUE(std::ranges::any_of(manifest.at("blocks"), [](const nlohmann::json& block) {
    return block.at("path") == nlohmann::json{"volumes", "sun", "all#blockers", "occlusion_merged"};
  }));
}

TEST_F(ShadowCommand, MergeTakesAScenesNameForNoWordOfItsOwn) {
  write("angle.scene.json", angle_scene);
  EXPECT_EQ(gnomon("shadow --merge angle.scene.json --json - ").code, 0);
  const Outcome run = gnomon("shadow angle.scene.json --merge=every --json -");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--merge=every: expected --merge or --merge all"));
}

TEST_F(ShadowCommand, MergeAllNamesALightThatHasUnsupportedPairs) {
  write("bent.scene.json", bent_lamp_scene);
  const Outcome run = gnomon("shadow bent.scene.json --merge all --json -");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("light 'lamp' is left out"));
}

TEST_F(ShadowCommand, WithoutMergePartsAreWrittenOneByOne) {
  write("angle.scene.json", angle_scene);
  EXPECT_EQ(gnomon("shadow angle.scene.json --out shadows").code, 0);
  const nlohmann::json manifest = read_json("shadows/manifest.json");
  EXPECT_FALSE(manifest.contains("merged"));
  EXPECT_GE(manifest.at("pairs").size(), 2u);
}

TEST_F(ShadowCommand, MergeSaysWhereThereIsNothingToMerge) {
  const Outcome run = gnomon("shadow table.scene.json --merge --out shadows");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("--merge"));
  EXPECT_EQ(gnomon("shadow examples/figure_4_19.scene.json --merge --out plane").code, 4);
}

TEST_F(ShadowCommand, EndsWith3ForAMissingOrBrokenScene) {
  write("broken.json", "{ \"gnomon\": 1, ");
  write("empty.json", "");
  for (const std::string file : {"missing.json", "broken.json", "empty.json", "."}) {
    const Outcome run = gnomon("shadow " + file + " --out shadows");
    EXPECT_EQ(run.code, 3) << file;
    EXPECT_THAT(run.err, HasSubstr(file));
    EXPECT_THAT(run.out, IsEmpty());
  }
  EXPECT_FALSE(exists("shadows"));
}

TEST_F(ShadowCommand, OldOutputSurvivesAFailedRun) {
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --json result.json --quiet").code, 0);
  const std::string before = read("result.json");
  const std::vector<std::string> files = names_in("shadows");
  write("table.scene.json", "{}");
  EXPECT_EQ(gnomon("shadow table.scene.json --out shadows --json result.json").code, 3);
  EXPECT_EQ(read("result.json"), before);
  EXPECT_EQ(names_in("shadows"), files);
}

TEST_F(ShadowCommand, OldOutputSurvivesARunThatIsKilledWhileWriting) {
  ASSERT_EQ(gnomon("shadow table.scene.json --json result.json --quiet").code, 0);
  const std::string before = read("result.json");
  // The first write past the limit ends the program by a signal.
  const Outcome run = shell("ulimit -f 1; \"$GNOMON\" shadow mixed.scene.json --json result.json");
  EXPECT_GT(run.code, 128);
  EXPECT_EQ(read("result.json"), before);
  EXPECT_EQ(gnomon("shadow table.scene.json --json result.json --quiet").code, 0);
  EXPECT_THAT(names_in("."), Each(Not(StartsWith(".gnomon"))));
}

/// A scene of the plane whose thousands of files take much longer to write than a shell takes to see the first.
std::string many_walls() {
  std::string walls;
  for (int k = 0; k < 1000; ++k) {
    const std::string x = std::to_string(k);
    walls += std::string(k == 0 ? "" : ",") + R"({"name": "wall)" + x + R"(", "shape": "segment", "vertices": [[)" + x +
             ", 0], [" + x + ".5, 0]]}";
  }
  return R"({"gnomon": 1, "dimension": 2, "lights": [{"name": "bulb", "shape": "point", "position": [0, 9]}],
    "blockers": [)" +
         walls + "]}";
}

TEST_F(ShadowCommand, OldOutputSurvivesARunThatIsKilledWhileItWritesAFolder) {
  write("many.scene.json", many_walls());
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  ASSERT_EQ(shell("cp -r shadows before").code, 0);
  const Outcome run = shell(R"("$GNOMON" shadow many.scene.json --out shadows --quiet &
    until ls -d shadows/.gnomon-*; do kill -0 $! || exit 1; done
    kill -KILL $!; wait $!)");
  EXPECT_EQ(run.code, 128 + 9) << run.err;
  EXPECT_THAT(names_in("shadows"), Contains(StartsWith(".gnomon-"))) << "it was not writing when it was killed";
  const Outcome difference = shell("diff -r --exclude='.gnomon-*' before shadows");
  EXPECT_EQ(difference.code, 0) << difference.out;
  EXPECT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  EXPECT_THAT(names_in("shadows"), Each(Not(StartsWith(".gnomon"))));
}

TEST_F(ShadowCommand, LeavesFilesOfOthersInTheFolderAlone) {
  ASSERT_EQ(shell("mkdir shadows").code, 0);
  write("shadows/notes.txt", "mine");
  EXPECT_EQ(gnomon("shadow table.scene.json --out shadows").code, 0);
  EXPECT_EQ(read("shadows/notes.txt"), "mine");
}

TEST_F(ShadowCommand, NamesAPlaceThatCannotBeWritten) {
  write("file", "mine");
  const Outcome folder = gnomon("shadow table.scene.json --out file");
  EXPECT_EQ(folder.code, 1);
  EXPECT_THAT(folder.err, HasSubstr("file"));
  const Outcome result = gnomon("shadow table.scene.json --json file/result.json");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.err, HasSubstr("file"));
  const Outcome onto_folder = gnomon("shadow table.scene.json --json .");
  EXPECT_EQ(onto_folder.code, 1);
  EXPECT_EQ(read("file"), "mine");
}

TEST_F(ShadowCommand, WritesJsonToDevicesAndThroughLinks) {
  EXPECT_TRUE(nlohmann::json::accept(gnomon("shadow table.scene.json --quiet --json /dev/stdout | cat").out));
  EXPECT_EQ(gnomon("shadow table.scene.json --json /dev/full").code, 1);
  ASSERT_EQ(shell("touch target.json; ln -s target.json link.json").code, 0);
  EXPECT_EQ(gnomon("shadow table.scene.json --json link.json").code, 0);
  EXPECT_EQ(shell("test -L link.json").code, 0);
  EXPECT_EQ(read_json("target.json")["schema"], "gnomon/shadow/1");
}

TEST_F(ShadowCommand, WritesPlanarScenesForParaView) {
  const Outcome run = gnomon("shadow examples/figure_4_17.scene.json --out out");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("2 separating, 2 supporting"), HasSubstr("m^2 in the box"), Not(HasSubstr(" z "))));
  EXPECT_THAT(names_in("out"), ElementsAre("manifest.json", "shadow", "shadow.vtm", "view.py"));
  EXPECT_EQ(read_json("out/manifest.json")["dimension"], 2);
}

TEST_F(ShadowCommand, WritesPlanarScenesInEveryFormat) {
  const Outcome run = gnomon("shadow examples/figure_4_17.scene.json --out out --format vtm,vtpc,vtp,obj,stl,gltf");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const std::string ending : {"vtm", "vtpc", "vtp", "obj", "gltf"}) EXPECT_TRUE(exists("out/shadow." + ending));
  EXPECT_THAT(read("out/shadow/volumes/tube/wall/umbra.stl"), HasSubstr("facet normal 0 0 1"));
}

TEST_F(ShadowCommand, SupportsEveryPositionInThePlane) {
  write("crossed.scene.json", R"({"gnomon": 1, "dimension": 2,
    "lights": [{"name": "tube", "shape": "segment", "vertices": [[-1, 0], [1, 0]]}],
    "blockers": [
      {"name": "crossing", "shape": "segment", "vertices": [[0, -1], [0, 1]]},
      {"name": "along", "shape": "segment", "vertices": [[2, 0], [3, 0]]},
      {"name": "below", "shape": "segment", "vertices": [[0, -2], [0, -1]]}]})");
  const Outcome run = gnomon("shadow crossed.scene.json --json - --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const auto pairs = nlohmann::json::parse(run.out)["pairs"];
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0]["position"], "both_cross");
  EXPECT_EQ(pairs[1]["position"], "coplanar");
  EXPECT_EQ(pairs[2]["position"], "light_crosses_blocker_plane");
  for (const auto& pair : pairs) EXPECT_EQ(pair["supported"], true);
}

TEST_F(ShadowCommand, RefusesABoxOfSpaceInThePlane) {
  const Outcome run = gnomon("shadow examples/figure_4_17.scene.json --json - --box 0,0,0,1,1,1");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("xmin,ymin,xmax,ymax"));
}

TEST_F(ShadowCommand, DividesAReceiverWhoseVerticesWereRounded) {
  write("slope.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "shape": "polygon",
    "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}], "blockers": [], "receivers": [
    {"name": "floor", "shape": "polygon", "vertices": [[-5,-5,0], [5,-5,0], [5,5,0], [-5,5,0]]},
    {"name": "slope", "shape": "polygon", "vertices": [[-5,-5,0.1], [5,-5,0.7], [5,5,0.3333333333333333],
                                                       [-5,5,-0.26666666666666694]]}]})");
  const std::string said = gnomon("shadow slope.scene.json --out out").err;
  EXPECT_THAT(said, Not(HasSubstr("is left out")));
  EXPECT_EQ(said.find("count as rounded"), said.rfind("count as rounded")) << said;
  EXPECT_TRUE(exists("out/shadow/receivers/lamp/slope/faces.vtp"));
  const Outcome run = gnomon("receivers slope.scene.json --receiver slope");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("lit 100.00 %"));
}

/// An open sheet of n times n squares, each of two triangles, over the floor of table_scene.
std::string sheet_of(int n) {
  std::string text;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      text += "v " + std::to_string(4.0 * i / n - 2) + ' ' + std::to_string(4.0 * j / n - 2) + ' ' +
              std::to_string(2 + 0.125 * ((i * j) % 3)) + '\n';
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j + 1, b = a + n + 1;
      for (const auto& [p, q, r] : {std::array{a, b, b + 1}, std::array{a, b + 1, a + 1}}) {
        text += "f " + std::to_string(p) + ' ' + std::to_string(q) + ' ' + std::to_string(r) + '\n';
      }
    }
  }
  return text;
}

TEST_F(ShadowCommand, PartsBeyondAHundredShareOneFileAKind) {
  write("sheet.obj", sheet_of(8));
  write("sheet.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "shape": "polygon",
    "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}],
    "blockers": [{"name": "sheet", "shape": "mesh", "file": "sheet.obj"}]})");
  const Outcome run = gnomon("shadow sheet.scene.json --out out --json all.json --quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json manifest = read_json("out/manifest.json"), all = read_json("all.json");
  EXPECT_LT(manifest["files"].size(), 12u);
  ASSERT_EQ(all["pairs"].size(), 128u);
  for (const std::string volume : {"occlusion", "umbra", "penumbra"}) {
    const auto is_volume = [&](const nlohmann::json& block) {
      return block["path"] == nlohmann::json({"volumes", "lamp", "sheet#parts", volume});
    };
    const auto block = std::ranges::find_if(manifest["blocks"], is_volume);
    ASSERT_NE(block, manifest["blocks"].end()) << volume;
    EXPECT_EQ((*block)["more_cell_arrays"], nlohmann::json({"part_id"}));
    ASSERT_EQ((*block)["field_data"]["part_names"].size(), 128u);
    for (std::size_t i = 0; i < 128; ++i) {
      EXPECT_EQ((*block)["field_data"]["part_names"][i], all["pairs"][i]["blocker"]);
      EXPECT_EQ((*block)["field_data"]["volume_total"][i], all["pairs"][i][volume]["volume_in_box"]) << volume << i;
    }
  }
  EXPECT_EQ(gnomon("render out --volumes --out picture.gltf").code, 0);
}

}  // namespace
}  // namespace gnomon
