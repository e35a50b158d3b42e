#include "geometry/scene/radiance_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "geometry/scene/mesh_facets.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RadianceScene radiance_of(std::string_view text) {
  const nlohmann::json document;
  const std::string source = "room.rad";
  const JsonNode node(document, source);
  return radiance_scene(text, {node, source});
}

std::string radiance_refusal(std::string_view text) {
  try {
    radiance_of(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "nothing";
}

constexpr std::string_view triangle_reals = " 0 0 9  0 0 0  1 0 0  0 1 0\n";

TEST(RadianceText, ReadsPolygonsWithTheMaterialsBeforeThem) {
  const RadianceScene scene = radiance_of(
      "\xef\xbb\xbf# all line ends\r\nvoid light a 0 0 3 1 2 3\r\rvoid glow b # words may stand anywhere\n0 0 4\n1 1 1 "
      "0\n"
      "void plastic c 0 0 5 .5 1 .25 .5 .5 void metal d 0 0 5 .5 1 .25 .5 .5\n"
      "a polygon p1 0 0 9 0.1 +1e0 -2 1E-400 0 0 0 1 0\nc polygon p2 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n");
  EXPECT_THAT(scene.names, ElementsAre("p1", "p2"));
  EXPECT_THAT(scene.soup.materials, ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(scene.soup.facet_materials, ElementsAre(0, 2));
  EXPECT_THAT(scene.soup.lines, ElementsAre(8, 9));
  EXPECT_EQ(scene.soup.vertices[0], (Point3{0.1, 1, -2}));
  EXPECT_EQ(scene.soup.vertices[1], (Point3{0, 0, 0}));
  EXPECT_EQ(scene.soup.facets[1], (std::vector<std::uint32_t>{3, 4, 5, 6}));
  EXPECT_EQ(scene.materials[0]->emission, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(scene.materials[1]->emission, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(scene.materials[2]->diffuse, (std::array{.25, .5, .125}));
  EXPECT_EQ(scene.materials[2]->specular, (std::array{.5, .5, .5}));
  EXPECT_EQ(scene.materials[3]->specular, (std::array{.25, .5, .125}));
  EXPECT_EQ(scene.materials[3]->exponent, 8);
  EXPECT_THAT(scene.soup.doubts, IsEmpty());
}

TEST(RadianceText, FindsMaterialsThroughAliasesPatternsAndNewDefinitions) {
  const RadianceScene scene =
      radiance_of(std::string("void light a 0 0 3 1 1 1\nvoid alias like a\nlike polygon p1") +
                  std::string(triangle_reals) + "a texfunc rough 4 dx dy dz file.cal 0 1 .1\n" + "rough polygon p2" +
                  std::string(triangle_reals) + "void light a 0 0 3 2 2 2\na polygon p3" + std::string(triangle_reals) +
                  "like polygon p4" + std::string(triangle_reals));
  EXPECT_THAT(scene.soup.facet_materials, ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("texfunc (1)")));
}

TEST(RadianceText, CountsWhatItLeavesOut) {
  const RadianceScene scene =
      radiance_of(std::string("void glow sky 0 0 4 1 1 1 -1\nvoid glass g 0 0 3 1 1 1\n") +
                  "g sphere s 0 0 4 0 0 0 1\ng sphere t 0 0 4 0 0 0 1\ng polygon p" + std::string(triangle_reals) +
                  "void polygon q" + std::string(triangle_reals) + "void plastic mirror 0 0 5 1 1 1 .5 0\n");
  EXPECT_FALSE(scene.materials[0]->emission);
  EXPECT_FALSE(scene.materials[1]);
  EXPECT_FALSE(scene.materials[2]->specular);
  EXPECT_THAT(scene.names, ElementsAre("p"));
  EXPECT_THAT(scene.soup.doubts, ElementsAre(HasSubstr("glass (1)"), HasSubstr("polygon of void (1)"),
                                             HasSubstr("specular share of roughness 0 (1)"), HasSubstr("sphere (2)")));
}

TEST(RadianceText, IsRefusedByLineWhereItIsWrong) {
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 1\n\n!xform -t 0 0 1 b.rad\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("!xform -t 0 0 1 b.rad")));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 1\na polygon p 0 0 8 1 2 3 4 5 6 7 8\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("8 numbers")));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 1\na polygon p 0 0 6 1 2 3 4 5 6\n"), HasSubstr("6 numbers"));
  EXPECT_THAT(radiance_refusal("b polygon p 0 0 9 1 2 3 4 5 6 7 8 9"), HasSubstr("the modifier \"b\""));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1"), HasSubstr("the end of the file"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 2 1 1"), HasSubstr("2 numbers"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 -1"), HasSubstr("a negative number"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 nan"), HasSubstr("\"nan\""));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 1e999"), HasSubstr("1e999"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 3 1 1 +-1"), HasSubstr("+-1"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 99999999999999999999 1"), HasSubstr("how many"));
  EXPECT_THAT(radiance_refusal("void light a 0 0 -3 1 1 1"), HasSubstr("how many"));
  EXPECT_THAT(radiance_refusal("void plastic a 0 0 5 1 1 1 1.5 0"), HasSubstr("more than 1"));
  EXPECT_THAT(radiance_refusal("void plastik a 0 0 0"), HasSubstr("plastik"));
  EXPECT_THAT(radiance_refusal("void alias a"), HasSubstr("the end of the file"));
}

TEST(RadianceText, SurvivesAnyText) {
  const std::string whole = std::string("void plastic grey 0 0 5 .5 .5 .5 .1 .05\nvoid light a\n0\n0\n3 1 1 1 # c\n") +
                            "void alias b grey\nb polygon p" + std::string(triangle_reals) + "a polygon q" +
                            std::string(triangle_reals) +
                            "void glow g 0 0 4 1 1 1 -1\ng ring r 0 0 8 0 0 0 0 0 1 0 1\n";
  std::mt19937 engine(20261202);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine); };
  const std::string letters("0159.-+eE#! \n\r\t\0void\xff", 22);
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole;
    for (std::size_t k = below(4); k-- > 0 && !text.empty();) {
      switch (below(3)) {
        case 0:
          text[below(text.size())] = letters[below(letters.size())];
          break;
        case 1:
          text.erase(below(text.size()), below(6));
          break;
        default:
          text.resize(below(text.size()) + 1);
      }
    }
    try {
      const RadianceScene scene = radiance_of(text);
      ++read;
      ASSERT_EQ(scene.soup.facets.size(), scene.names.size());
      ASSERT_EQ(scene.soup.materials.size(), scene.materials.size());
      for (const std::uint32_t material : scene.soup.facet_materials) ASSERT_LT(material, scene.materials.size());
    } catch (const SceneError&) {
    }
  }
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace gnomon
