/// What a hostile look at the program found, each with the rest of its kind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Attack : public Program {
 protected:
  Attack() { write("table.scene.json", table_scene); }
};

TEST_F(Attack, NoBoxMakesACommandCrash) {
  const std::string boxes[] = {"-1e308,-1e308,-1e308,1e308,1e308,1e308",
                               "-9e307,0,0,9e307,1,1",
                               "0,0,0,1.7976931348623157e308,1e308,1e308",
                               "0,0,0,5e-324,5e-324,5e-324",
                               "1e16,1e16,1e16,1.0000000000000002e16,1.0000000000000002e16,1.0000000000000002e16",
                               "-5e307,-5e307,-5e307,5e307,5e307,5e307",
                               "-1e200,-1,-1,1e200,1,1",
                               "0,0,0,2.2250738585072014e-308,1,1"};
  const std::string commands[] = {"grid table.scene.json --shape 3,3,3 --out g.vti",
                                  "grid table.scene.json --shape 1,1,1 --out g.vti",
                                  "shadow table.scene.json --out shadow --format vtm,vtpc,vtp,obj,stl,gltf",
                                  "discontinuities table.scene.json --out surfaces",
                                  "receivers examples/figure_4_22.scene.json --out floor",
                                  "render table.scene.json --out page.html",
                                  "render table.scene.json --out page.gltf"};
  for (const std::string& command : commands) {
    for (const std::string& box : boxes) {
      const Outcome run = gnomon(command + " --quiet --box=" + box);
      EXPECT_LE(run.code, 4) << command << " --box=" << box << '\n' << run.err;
      if (run.code == 0) continue;
      EXPECT_THAT(run.err, StartsWith("gnomon: ")) << command << " --box=" << box;
    }
  }
  const Outcome refused = gnomon("grid table.scene.json --shape 3,3,3 --out g.vti --box=" + boxes[0]);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("--box"), HasSubstr("diagonal")));
  const Outcome together = gnomon("grid table.scene.json --shape 9,9,9 --out g.vti --box=" + boxes[3]);
  EXPECT_EQ(together.code, 2);
  EXPECT_THAT(together.err, AllOf(HasSubstr("--shape"), HasSubstr("fall together")));
}

/// A lamp and a table as large as doubles go: what is made of their coordinates in doubles overflows.
std::string huge_scene(const std::string& size) {
  std::string text = R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-S,-S,S], [-S,S,S], [S,S,S], [S,-S,S]]},
               {"name": "tube", "shape": "segment", "vertices": [[-S,0,S], [S,0,S]]},
               {"name": "sun", "shape": "direction", "direction": [0,S,-S]},
               {"name": "bulb", "shape": "point", "position": [0,0,S]}],
    "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-S,-S,0], [S,-S,0], [S,S,0], [-S,S,0]]},
                 {"name": "post", "shape": "polytope", "vertices": [[S,0,0], [0,S,0], [0,0,S], [0,0,0]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-S,-S,-S], [S,-S,-S], [S,S,-S], [-S,S,-S]]}]})";
  for (std::size_t at = text.find('S'); at != std::string::npos; at = text.find('S')) text.replace(at, 1, size);
  return text;
}

TEST_F(Attack, NoCoordinateMakesACommandCrash) {
  for (const std::string size : {"1.7e308", "1e308", "1e200", "1e155", "1e-160", "1e-300", "5e-324"}) {
    write("huge.scene.json", huge_scene(size));
    write("points.csv", "x,y,z,nx,ny,nz\n0,0,-" + size + ",0,0," + size + "\n" + size + ",0,0,1,0,0\n0,0,0,0,0,1\n");
    for (const std::string command :
         {"check huge.scene.json", "shadow huge.scene.json --out out",
          "shadow huge.scene.json --json - --box -1,-1,-1,1,1,1", "regions huge.scene.json --at points.csv",
          "irradiance huge.scene.json --at points.csv", "irradiance huge.scene.json --on floor --shape 3,3",
          "grid huge.scene.json --shape 2,2,2 --out g.vti",
          "grid huge.scene.json --shape 2,2,2 --out g.vti --box -1,-1,-1,1,1,1", "receivers huge.scene.json",
          "discontinuities huge.scene.json --json -", "render huge.scene.json --out p.html",
          "render huge.scene.json --out p.gltf"}) {
      const Outcome run = gnomon(command);
      EXPECT_LE(run.code, 4) << command << " of size " << size << '\n' << run.err;
      if (run.code == 0) continue;
      EXPECT_THAT(run.err, StartsWith("gnomon: ")) << command << " of size " << size;
    }
  }
}

TEST_F(Attack, AMeshThatIsAPipeSocketOrDeviceIsRefused) {
  const auto checked = [&](const std::string& file) {
    write("mesh.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [],
      "blockers": [{"name": "m", "shape": "mesh", "file": ")" +
                                 file + R"("}]})");
    return shell("timeout 20 \"$GNOMON\" check mesh.scene.json");
  };
  ASSERT_EQ(
      shell("mkfifo m.obj m.stl m.off m.ply; ln -s m.obj link.obj; ln -s /dev/zero zero.obj; ln -s /dev/tty tty.ply;"
            "mkdir folder.obj")
          .code,
      0);
  for (const std::string file : {"m.obj", "m.stl", "m.off", "m.ply", "link.obj", "zero.obj", "tty.ply", "folder.obj"}) {
    const Outcome run = checked(file);
    EXPECT_EQ(run.code, 3) << file;
    EXPECT_THAT(run.err,
                AllOf(HasSubstr(file), HasSubstr(file == "folder.obj" ? "a folder" : "a pipe, socket or device")));
  }
}

TEST_F(Attack, AResultThatIsAPipeIsRefused) {
  ASSERT_EQ(shell("mkdir result; mkfifo result/manifest.json").code, 0);
  const Outcome run = shell("timeout 20 \"$GNOMON\" render result --out p.gltf");
  EXPECT_EQ(run.code, 3) << run.err;
}

TEST_F(Attack, AScenesOwnPipeIsStillRead) {
  EXPECT_EQ(shell("mkfifo pipe; cat table.scene.json > pipe & timeout 20 \"$GNOMON\" check pipe").code, 0);
}

/// The columns that Python's reader of CSV finds in each row.
constexpr const char* count_columns =
    R"(python3 -c 'import csv, sys; print(*sorted({len(row) for row in csv.reader(sys.stdin)}))')";

TEST_F(Attack, NoQuoteInATableMakesTheResultUnreadable) {
  const std::string ends[] = {
      "\"",       "\"a",         "a\"",     "\"a\"b",   "\"\"\"",   "a\"b,c\"d",          "\"a,b",
      " \"a,b\"", "\"a\" \"b\"", "\"a\"\"", "\"a, b\"", "5\" pipe", "\"say \"\"no\"\"\"", "plain",
      ""};
  std::string table = "x,y,z,note\n";
  for (const std::string& end : ends) table += "0,0,1," + end + "\n";
  write("points.csv", table + "0,0,1,last\n");
  for (const std::string command : {"regions table.scene.json --at points.csv"}) {
    const Outcome run = shell("\"$GNOMON\" " + command + " | " + count_columns);
    EXPECT_EQ(run.out, "8\n") << command;
    EXPECT_THAT(run.err, AllOf(HasSubstr("points.csv:2:"), HasSubstr("double quotes")));
    EXPECT_THAT(gnomon(command).out, HasSubstr("0,0,1,last,lamp,"));
  }
  write("header.csv", "x,y,z,\"note\n0,0,1,a\n");
  EXPECT_EQ(gnomon("regions table.scene.json --at header.csv").code, 3);
}

TEST_F(Attack, AControlCharacterInATableIsRefusedWithItsRow) {
  ASSERT_EQ(shell(R"(printf 'x,y,z,note\n0,0,1,a\0b\n0,0,1,\033[31m\n0,0,1,fine\n' > points.csv)").code, 0);
  const Outcome run = gnomon("regions table.scene.json --at points.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("points.csv:2:"), HasSubstr("points.csv:3:"), HasSubstr("control characters")));
  EXPECT_THAT(run.out, AllOf(HasSubstr("fine"), Not(HasSubstr("\033"))));
}

/// Names that are legal in a scene, and mean something to one format or another.
const char* const nasty_names[] = {
    "<!--<script>]]>&amp;",       "a\\\"b'c<b>,;", "\\ufffe\\u202e \xf0\x9f\x92\xa1", "--quiet", " ",
    "=1+1 {{scene}} %2e%2e $(id)"};

std::string nasty_scene(const std::string& name) {
  return R"({"gnomon": 1, "dimension": 3, "lights": [
    {"name": ")" +
         name + R"(", "shape": "polygon", "vertices": [[-1,-1,4],[-1,1,4],[1,1,4],[1,-1,4]]},
    {"name": "other", "shape": "point", "position": [0,0,5]}],
    "blockers": [{"name": ")" +
         name + R"(", "shape": "polygon", "vertices": [[-1,-1,2],[1,-1,2],[1,1,2]]}],
    "receivers": [{"name": ")" +
         name + R"(", "shape": "polygon", "vertices": [[-9,-9,0],[9,-9,0],[9,9,0],[-9,9,0]]}]})";
}

/// Reads every file of a folder as what its ending says, and the grid's arrays by their names.
constexpr const char* read_all = R"(python3 - "$@" <<'END'
import csv, json, pathlib, sys, xml.etree.ElementTree as tree
for file in sorted(pathlib.Path("out").rglob("*")):
    data = file.read_bytes() if file.is_file() else b""
    if file.suffix in (".vtp", ".vtu", ".vti"):
        data = data[:data.index(b"<AppendedData")] + b"</VTKFile>"
    if file.suffix in (".vtm", ".vtpc", ".vtp", ".vtu", ".vti", ".svg"):
        tree.fromstring(data)
    if file.suffix in (".json", ".gltf"):
        json.loads(data)
    if file.suffix == ".html":
        text = data.decode()
        scene = text[text.index('id="scene"'):]
        scene = scene[scene.index(">") + 1:scene.index("</script>")]
        assert "<" not in scene
        json.loads(scene)
    if file.suffix == ".csv":
        assert {len(row) for row in csv.reader(data.decode().splitlines())} == {int(file.stem)}, file
END
)";

TEST_F(Attack, NoNameMakesAFileUnreadable) {
  write("points.csv", "x,y,z\n0,0,0\n1,2,1\n");
  write("receivers.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n");
  for (const std::string name : nasty_names) {
    write("nasty.scene.json", nasty_scene(name));
    ASSERT_EQ(shell("rm -rf out; mkdir out").code, 0);
    for (const std::string command :
         {"check nasty.scene.json --json out/check.json --quiet",
          "shadow nasty.scene.json --out out/a --json out/a.json --format vtm,vtpc,vtp,obj,stl,gltf --quiet",
          "receivers nasty.scene.json --out out/b --json out/b.json --quiet",
          "discontinuities nasty.scene.json --out out/c --json out/c.json --quiet",
          "grid nasty.scene.json --shape 2,2,2 --out out/g.vti --quiet",
          "regions nasty.scene.json --at points.csv --out out/7.csv --json out/r.json --quiet",
          "irradiance nasty.scene.json --at receivers.csv --out out/9.csv --json out/i.json --quiet",
          "render nasty.scene.json --out out/p.html --quiet", "render nasty.scene.json --out out/p.gltf --quiet"}) {
      const Outcome run = gnomon(command);
      EXPECT_EQ(run.code, 0) << name << ": " << command << '\n' << run.err;
    }
    const Outcome reading = shell(read_all);
    EXPECT_EQ(reading.code, 0) << name << '\n' << reading.err;
  }
}

TEST_F(Attack, ASceneFileWhoseNameIsNoTextIsNamedInEveryFile) {
  write("points.csv", "x,y,z\n0,0,0\n");
  const std::string file = "\"$(printf 'caf\\351<&>.scene.json')\"";
  ASSERT_EQ(shell("mkdir out; cp table.scene.json " + file).code, 0);
  for (const std::string command :
       {"regions @ --at points.csv --json out/r.json", "shadow @ --out out/a --json out/a.json",
        "check @ --json out/c.json", "render @ --out out/p.html"}) {
    std::string words = command;
    const Outcome run = gnomon(words.replace(words.find('@'), 1, file) + " --quiet");
    EXPECT_EQ(run.code, 0) << command << '\n' << run.err;
  }
  const Outcome reading = shell(read_all);
  EXPECT_EQ(reading.code, 0) << reading.err;
}

/// From the origin the shelf hides 14 of the lamp's 45: what is seen is 31/45, whose nearest double is written in a
/// decimal that is off by more than the double is.
TEST_F(Attack, ThePrintedDecimalIsWithinThePrintedBound) {
  write("lamp.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[0,0,2],[0,1,2],[45,1,2],[45,0,2]]}],
    "blockers": [{"name": "shelf", "shape": "polygon", "vertices": [[0,0,1],[7,0,1],[7,1,1],[0,1,1]]}]})");
  write("points.csv", "x,y,z\n0,0,0\n");
  ASSERT_EQ(gnomon("regions lamp.scene.json --at points.csv --out 7.csv --json r.json").code, 0);
  const Outcome run = shell(R"(python3 - <<'END'
import csv, fractions, json
exact = fractions.Fraction(31, 45)
row = list(csv.DictReader(open("7.csv")))[0]
assert abs(fractions.Fraction(row["visible_fraction"]) - exact) <= fractions.Fraction(row["error_bound"]) < 1e-9, row
seen = json.loads(open("r.json").read(), parse_float=fractions.Fraction)["points"][0]["lights"][0]
assert abs(seen["visible_fraction"] - exact) <= seen["error_bound"] < 1e-9, seen
END
)");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(Attack, EndingsThatSayThatSomethingElseIsMeantAreRefused) {
  write("points.csv", "x,y,z\n0,0,0\n");
  const std::pair<const char*, const char*> cases[] = {
      {"shadow table.scene.json --out -", "a folder"},
      {"shadow table.scene.json --out result.vtm", "a folder"},
      {"receivers table.scene.json --out mesh.VTP", "a folder"},
      {"discontinuities table.scene.json --out surfaces.json", "a folder"},
      {"grid table.scene.json --shape 2,2,2 --out -", ".vti"},
      {"grid table.scene.json --shape 2,2,2 --out grid.vtk", ".vti"},
      {"regions table.scene.json --at points.csv --out seen.json", ".csv"},
      {"regions table.scene.json --at points.csv --json seen.csv", ".json"},
      {"regions table.scene.json --at points.csv --out - --json -", "name one place"},
      {"regions table.scene.json --at points.csv --out same --json ./same", "name one place"},
      {"shadow table.scene.json --json result.png", ".json"},
      {"check table.scene.json --json result.vtm", ".json"},
      {"render table.scene.json --out -", ".png"}};
  for (const auto& [command, expected] : cases) {
    const Outcome run = gnomon(command);
    EXPECT_EQ(run.code, 2) << command;
    EXPECT_THAT(run.err, HasSubstr(expected)) << command;
  }
  EXPECT_THAT(names_in("."), ElementsAre("examples", "points.csv", "table.scene.json"));
}

TEST_F(Attack, ADashIsStdoutWhereATableGoesThere) {
  write("points.csv", "x,y,z\n0,0,0\n");
  const Outcome plain = gnomon("regions table.scene.json --at points.csv");
  const Outcome dash = gnomon("regions table.scene.json --at points.csv --out -");
  EXPECT_EQ(dash.code, 0) << dash.err;
  EXPECT_EQ(dash.out, plain.out);
  EXPECT_FALSE(exists("-"));
}

}  // namespace
}  // namespace gnomon
