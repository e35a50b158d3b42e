#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <string>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A folder of the running test's own, with one mesh file in it.
class MeshFile : public testing::Test {
 protected:
  MeshFile() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / ("gnomon_" + std::to_string(getpid()) + info->name());
    std::filesystem::create_directories(folder_);
  }
  ~MeshFile() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& file, const std::string& bytes) const {
    std::ofstream(folder_ / file, std::ios::binary) << bytes;
  }

  SpaceScene scene(const std::string& file, const std::string& bytes) const {
    write(file, bytes);
    const std::string text = R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "bulb", "shape": "point",)"
                             R"( "position": [0, 0, 9]}], "blockers": [{"name": "vase", "shape": "mesh", "file": ")" +
                             file + "\"}]}";
    return std::get<SpaceScene>(parse_scene(text, "test", folder_));
  }

  Mesh mesh(const std::string& file, const std::string& bytes) const {
    return std::get<Mesh>(scene(file, bytes).blockers[0].shape);
  }

  std::string refusal(const std::string& file, const std::string& bytes) const {
    try {
      scene(file, bytes);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "accepted";
  }

 private:
  std::filesystem::path folder_;
};

const std::vector<Point3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::vector<std::uint32_t>> facets = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string ply_head =
    " 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty double x\nproperty float weight\nproperty float y\n"
    "property float z\nelement face 4\nproperty uchar colour\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply =
    "ply\nformat ascii" + ply_head + "0 5 0 0\n1 5 0 0\n0 5 1 0\n0 5 0 1\n9 3 0 2 1\n9 3 0 1 3\n9 3 1 2 3\n9 3 0 3 2\n";

template <class Number>
void append(std::string& bytes, Number number, std::endian order) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.begin(), raw.end());
}

std::string binary_ply(std::endian order) {
  std::string bytes = std::string("ply\nformat ") +
                      (order == std::endian::little ? "binary_little_endian" : "binary_big_endian") + ply_head;
  for (const Point3& p : corners) {
    append(bytes, p.x, order);
    append(bytes, 5.0f, order);
    append(bytes, static_cast<float>(p.y), order);
    append(bytes, static_cast<float>(p.z), order);
  }
  for (const auto& facet : facets) {
    bytes += '\x09';
    bytes += '\x03';
    for (const std::uint32_t index : facet) append(bytes, index, order);
  }
  return bytes;
}

std::string binary_stl(const std::string& head = "binary") {
  std::string bytes = head;
  bytes.resize(80, ' ');
  append(bytes, std::uint32_t{4}, std::endian::little);
  for (const auto& facet : facets) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f, std::endian::little);
    for (const std::uint32_t index : facet) {
      append(bytes, static_cast<float>(corners[index].x), std::endian::little);
      append(bytes, static_cast<float>(corners[index].y), std::endian::little);
      append(bytes, static_cast<float>(corners[index].z), std::endian::little);
    }
    append(bytes, std::uint16_t{0}, std::endian::little);
  }
  return bytes;
}

std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& facet : facets) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t index : facet) {
      const Point3& p = corners[index];
      text += "   vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

/// The facets with the vertices' coordinates, since formats number vertices differently.
std::vector<std::vector<Point3>> facet_points(const Mesh& mesh) {
  std::vector<std::vector<Point3>> result;
  for (const auto& facet : mesh.facets) {
    result.emplace_back();
    for (const std::uint32_t index : facet) result.back().push_back(mesh.vertices[index]);
  }
  return result;
}

void expect_tetrahedron(const Mesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(facet_points(mesh), facet_points({"", corners, facets, true}));
  EXPECT_TRUE(mesh.closed);
}

TEST_F(MeshFile, IsTheSameTetrahedronInEveryFormat) {
  expect_tetrahedron(mesh("vase.obj", obj));
  expect_tetrahedron(mesh("vase.off", off));
  expect_tetrahedron(mesh("vase.ply", ply));
  expect_tetrahedron(mesh("le.ply", binary_ply(std::endian::little)));
  expect_tetrahedron(mesh("be.ply", binary_ply(std::endian::big)));
  expect_tetrahedron(mesh("vase.stl", ascii_stl()));
  expect_tetrahedron(mesh("binary.stl", binary_stl()));
  expect_tetrahedron(mesh("SOLID.STL", binary_stl("solid but binary")));
}

TEST_F(MeshFile, OfObjMayNumberBackwardsAndNameTexturesAndNormals) {
  const Mesh read =
      mesh("vase.obj", "v 0 0 0 1\nv 1 0 0\nvt 0 0\nv 0 1 0\nvn 0 0 1\no x\nf -3/1/1 -2//1 -1/1 # end\nl 1 2\n");
  EXPECT_THAT(read.facets, ElementsAre(ElementsAre(0, 1, 2)));
}

TEST_F(MeshFile, OfOffMayCarryColoursAndCountsInItsFirstLine) {
  const Mesh read =
      mesh("vase.off", "COFF 3 1 0\n0 0 0 255 0 0\n\n# remark\n1 0 0 0 0 0\n0 1 0 1 1 1\n3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_THAT(read.facets, ElementsAre(ElementsAre(0, 1, 2)));
}

TEST_F(MeshFile, WithABoundaryIsNotClosedAndGetsADoubt) {
  const SpaceScene read = scene("vase.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_FALSE(std::get<Mesh>(read.blockers[0].shape).closed);
  EXPECT_THAT(read.doubts, ElementsAre(AllOf(HasSubstr("blocker \"vase\""), HasSubstr("not closed"))));
}

TEST_F(MeshFile, WithAFacetWoundTheOtherWayIsNotClosed) {
  std::string turned = obj;
  turned.replace(turned.find("f 1 3 2"), 7, "f 1 2 3");
  EXPECT_FALSE(mesh("vase.obj", turned).closed);
}

TEST_F(MeshFile, WithAnEdgeOfFourFacetsIsNotClosed) {
  // Two tetrahedra that share the edge from vertex 1 to vertex 4.
  const std::string two = obj + "v 0 -1 0\nv -1 0 0\nf 1 6 5\nf 1 5 4\nf 5 6 4\nf 1 4 6\n";
  EXPECT_FALSE(mesh("vase.obj", two).closed);
  EXPECT_TRUE(mesh("vase.obj", obj).closed);
}

TEST_F(MeshFile, ReadsTheNearestDouble) {
  const Mesh read = mesh("vase.obj", "v 0.1 1e-400 4.9e-324\nv +1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read.vertices[0], (Point3{0.1, 0, 4.9e-324}));
}

TEST_F(MeshFile, TellsTheDeviationOfRoundedFacets) {
  const SpaceScene read = scene("vase.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1e-12\nv 0 1 0\nf 1 2 3 4\n");
  ASSERT_FALSE(read.doubts.empty());
  EXPECT_THAT(read.doubts[0], AllOf(HasSubstr("not exactly coplanar"), HasSubstr("1e-12 m")));
}

TEST_F(MeshFile, IsRefusedWithThePlaceInIt) {
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 nan 0\n"),
              AllOf(HasSubstr("a.obj"), HasSubstr("line 2"), HasSubstr("nan")));
  EXPECT_THAT(refusal("a.obj", "v 0 0 1e999\n"), AllOf(HasSubstr("line 1"), HasSubstr("1e999")));
  EXPECT_THAT(refusal("a.obj", "v 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\nf 0 1 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\nf -2 1 1\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\nf 1 1 1e3\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\n"), HasSubstr("no facet"));
  EXPECT_THAT(refusal("a.obj", "\n\nf 1 2 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"),
              AllOf(HasSubstr("line 3, facet 0"), HasSubstr("the vertex number 4"), HasSubstr("3 vertices")));
  EXPECT_THAT(refusal("a.obj", "v 0,5 0 0\n"), AllOf(HasSubstr("line 1"), HasSubstr("a point before its decimals")));
  EXPECT_THAT(refusal("a.obj", std::string("\xff\xfev\0 \0", 6)), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal("a.off", "OFF\n4000000000 1 0\n"), AllOf(HasSubstr("line 2"), HasSubstr("4000000000")));
  EXPECT_THAT(refusal("a.off", "OFF\n-1 1 0\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("a.off", "OFF BINARY\n"), HasSubstr("BINARY"));
  EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), HasSubstr("line 6"));
  EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9 0 1 2\n"), HasSubstr("line 6"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"),
              HasSubstr("end_header"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n"),
              HasSubstr("property y"));
  EXPECT_THAT(refusal("a.ply", ply.substr(0, ply.size() - 4)),
              AllOf(HasSubstr("line 20, face 3"), HasSubstr("the end of the file")));
  EXPECT_THAT(refusal("a.stl", "solid\nfacet\nvertex 0 0 0\nendfacet\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("3 vertices")));
  EXPECT_THAT(refusal("a.stl", "nothing of the kind"), HasSubstr("an STL file"));
  EXPECT_THAT(refusal("a.stl", binary_stl().substr(0, 200)), HasSubstr("an STL file"));
}

TEST_F(MeshFile, IsRefusedForFacetsThatAreNoPolygonsByTheirLine) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 1 1 1\n";
  EXPECT_THAT(refusal("a.obj", square + "f 1 2 3\nv -1 0 0\nv -1 1 0\nf 1 2 3 1 8 7\n"),
              AllOf(HasSubstr("line 10, facet 1"), HasSubstr("corner 3"), HasSubstr("repeats vertex 0")));
  EXPECT_THAT(refusal("a.obj", square + "f 1 3 2 4\n"), AllOf(HasSubstr("line 7"), HasSubstr("edges 0 and 2 meet")));
  EXPECT_THAT(refusal("a.obj", square + "f 1 2 6 4\n"),
              AllOf(HasSubstr("line 7, facet 0, corner 3"), HasSubstr("away from"), HasSubstr("triangles")));
}

TEST_F(MeshFile, LeavesOutFacetsWithoutAnAreaAndKeepsTheNumbersOfTheOthers) {
  const SpaceScene read =
      scene("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\nf 1 2 4\nf 1 1 4\nf 1 2\nf 1 2 4 4\n");
  const Mesh& read_mesh = std::get<Mesh>(read.blockers[0].shape);
  EXPECT_THAT(read_mesh.facets, ElementsAre(ElementsAre(0, 1, 3), ElementsAre(0, 1, 3)));
  EXPECT_THAT(read_mesh.facet_numbers, ElementsAre(1, 4));
  EXPECT_EQ(read_mesh.vertices.size(), 4u) << "the vertex in no facet counts";
  EXPECT_THAT(read.doubts, ElementsAre(AllOf(HasSubstr("2 facets (the first: line 8, facet 2)"), HasSubstr("repeat")),
                                       AllOf(HasSubstr("3 facets (the first: line 6, facet 0)"), HasSubstr("no area")),
                                       HasSubstr("not closed")));
}

TEST_F(MeshFile, IsClosedAlsoWhereAFacetWithoutAreaClosesTheGap) {
  // The lowest edge of the tetrahedron has a vertex in its middle on one side only.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.5 0 0\nf 1 3 2\nf 1 5 2\nf 1 4 5\nf 5 4 2\nf 2 4 3\nf 1 3 4\n";
  std::string turned = text;
  EXPECT_FALSE(mesh("a.obj", text).closed);
  turned = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.5 0 0\nf 1 3 2\nf 1 2 5\nf 1 5 4\nf 5 2 4\nf 2 3 4\nf 1 4 3\n";
  const Mesh closed = mesh("a.obj", turned);
  EXPECT_TRUE(closed.closed);
  EXPECT_EQ(closed.facets.size(), 5u);
}

TEST_F(MeshFile, TakesBentFacetsAsTrianglesWithOneDoubtThatTellsTheLargestDeviation) {
  const SpaceScene read =
      scene("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.001\nv 0 1 0\nv 0 2 0\nv 1 2 0.002\nf 1 2 3 4\nf 4 3 6 5\nf 1 2 3\n");
  EXPECT_THAT(read.doubts[0], AllOf(HasSubstr("2 facets (the first: line 7, facet 0) are bent"), HasSubstr("triangles"),
                                    HasSubstr("0.001")));
}

TEST_F(MeshFile, KeepsSeamsOfFacetsWithHoles) {
  const SpaceScene read = scene("wall.obj",
                                "v 0 0 0\nv 6 0 0\nv 6 0 3\nv 0 0 3\nv 2 0 1\nv 2 0 2\nv 4 0 2\nv 4 0 1\n"
                                "f 1 2 3 4 1 5 6 7 8 5\n");
  EXPECT_EQ(std::get<Mesh>(read.blockers[0].shape).facets[0].size(), 10u);
  EXPECT_THAT(read.doubts, ElementsAre(HasSubstr("not closed")));
}

TEST_F(MeshFile, ReadsPastByteOrderMarksLineEndsAndContinuedLinesWithADoubt) {
  const SpaceScene read = scene("a.obj", "\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 \\\r\n2 3\r\n");
  EXPECT_EQ(std::get<Mesh>(read.blockers[0].shape).vertices.size(), 3u);
  EXPECT_THAT(read.doubts[0], AllOf(HasSubstr("in \"a.obj\""), HasSubstr("a byte-order mark"),
                                    HasSubstr("carriage returns"), HasSubstr("a backslash")));
  expect_tetrahedron(mesh("vase.off", "\xef\xbb\xbf" + off));
  std::string returns = ply;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  expect_tetrahedron(mesh("vase.ply", returns));
  expect_tetrahedron(mesh("vase.stl", "\xef\xbb\xbf " + ascii_stl()));
  // In a binary file whose head ends with returns, a line feed is the first byte of the numbers.
  std::string binary = binary_ply(std::endian::little);
  const std::size_t head = binary.find("end_header\n") + 11;
  std::replace(binary.begin(), binary.begin() + std::ptrdiff_t(head), '\n', '\r');
  binary[head] = '\n';
  EXPECT_NE(mesh("le.ply", binary).vertices[0].x, 0);
}

TEST_F(MeshFile, PassesOverLinesOfUnknownWordsWithADoubtForEachWord) {
  const SpaceScene read = scene("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ncurv 0 1 1 2\ncurv 2 3\nl 1 2\nf 1 2 3\nend\n");
  EXPECT_THAT(read.doubts, ElementsAre(AllOf(HasSubstr("line 4"), HasSubstr("\"curv\"")),
                                       AllOf(HasSubstr("line 8"), HasSubstr("\"end\"")), HasSubstr("not closed")));
  EXPECT_THAT(scene("a.stl", "solid\n color 1 0 0\n" + ascii_stl().substr(18)).doubts,
              ElementsAre(AllOf(HasSubstr("line 2"), HasSubstr("\"color\""))));
}

TEST_F(MeshFile, AcceptsNumbersThatAreNotFiniteWhereTheyAreNotUsed) {
  std::string text = ply;
  text.replace(text.find("\n0 5 0 0"), 8, "\n0 nan 0 0");
  EXPECT_THAT(scene("a.ply", text).doubts, ElementsAre(HasSubstr("not finite in properties that are not used")));
  text.replace(text.find("0 nan 0 0"), 9, "nan 5 0 0");
  EXPECT_THAT(refusal("a.ply", text), AllOf(HasSubstr("line 13, vertex 0"), HasSubstr("not finite")));
  std::string normals = ascii_stl();
  normals.replace(normals.find("0 0 0"), 5, "nan 0 0");
  EXPECT_THAT(scene("a.stl", normals).doubts, ElementsAre(HasSubstr("normals that are not finite")));
}

TEST_F(MeshFile, OfStlIsReadByItsBytesWhateverItCallsItself) {
  expect_tetrahedron(mesh("a.stl", "solid cad" + binary_stl().substr(9) + "tail"));
  EXPECT_THAT(scene("a.stl", binary_stl() + "tail").doubts, ElementsAre(HasSubstr("4 bytes after the last facet")));
  std::string upper = ascii_stl();
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  expect_tetrahedron(mesh("a.stl", upper));
}

TEST_F(MeshFile, OfOffNeedsNeitherItsKeywordNorTheCountOfEdges) {
  expect_tetrahedron(mesh("a.off", off.substr(4)));
  expect_tetrahedron(mesh("a.off", "OFF\n4 4\n" + off.substr(10)));
}

TEST_F(MeshFile, DoubtsFacetsWhoseMaterialEmitsLight) {
  write("lamp.mtl", "newmtl wood\nKd 1 1 1\nKe 0 0 0\nnewmtl warm white\nKe 10 9 8\n");
  const std::string text =
      "mtllib none.mtl lamp.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\nusemtl warm white\nf 1 2 3\n";
  EXPECT_THAT(scene("a.obj", text).doubts,
              ElementsAre(AllOf(HasSubstr("\"warm white\""), HasSubstr("emit light")), HasSubstr("not closed")));
}

TEST_F(MeshFile, AcceptsConcaveFacets) {
  EXPECT_THAT(mesh("a.obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n").facets,
              ElementsAre(ElementsAre(0, 1, 2, 3)));
}

RC_GTEST_FIXTURE_PROP(MeshFile, NeverCrashesOnDamagedFiles, ()) {
  const auto [name, whole] = *rc::gen::element(
      std::pair<std::string, std::string>("a.obj", obj), std::pair<std::string, std::string>("a.off", off),
      std::pair<std::string, std::string>("a.ply", ply),
      std::pair<std::string, std::string>("a.ply", binary_ply(std::endian::little)),
      std::pair<std::string, std::string>("a.stl", ascii_stl()),
      std::pair<std::string, std::string>("a.stl", binary_stl()));
  std::string damaged = whole.substr(0, *rc::gen::inRange<std::size_t>(0, whole.size() + 1));
  const int changes = *rc::gen::inRange(0, 5);
  for (int i = 0; i < changes && !damaged.empty(); ++i) {
    damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] = *rc::gen::arbitrary<char>();
  }
  // Either a scene or a refusal; any other exception, or worse, fails.
  RC_ASSERT(!refusal(name, damaged).empty());
}

TEST_F(MeshFile, DoubtsWhatComesAfterAllThatTheHeadAnnounces) {
  EXPECT_THAT(scene("a.off", off).doubts, IsEmpty());
  EXPECT_THAT(scene("a.off", off + "3 0 1 2\n").doubts,
              ElementsAre(AllOf(HasSubstr("more than the 4 facets"), HasSubstr("line 11"))));
  EXPECT_THAT(scene("a.ply", ply).doubts, IsEmpty());
  EXPECT_THAT(scene("a.ply", ply + "9 3 0 1 2\n").doubts,
              ElementsAre(AllOf(HasSubstr("more than the elements"), HasSubstr("line 21"))));
  EXPECT_THAT(scene("a.ply", binary_ply(std::endian::big) + "tail").doubts,
              ElementsAre(HasSubstr("4 bytes after the last element")));
}

}  // namespace
}  // namespace gnomon
