#include "viz/pictures/html_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "gnomon/picture.h"
#include "tests/viz/planar_sample.h"
#include "tests/viz/sample_result.h"
#include "tests/viz/temporary_folder.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// A stand-in for three.js in a folder of its own, so that these tests need no package.
class HtmlPage : public testing::Test {
 protected:
  HtmlPage() {
    std::filesystem::create_directories(folder_ / "examples/js/controls");
    write_file(folder_ / "three.min.js", "/* three */");
    write_file(folder_ / "examples/js/controls/OrbitControls.js", "/* controls */");
    ::setenv("GNOMON_THREE_JS", folder_.path().c_str(), 1);
  }
  ~HtmlPage() override { ::unsetenv("GNOMON_THREE_JS"); }

  std::string page_of(const ShadowResult& result) {
    render_scene(result, folder_ / "page.html");
    return file_text(folder_ / "page.html");
  }

  static nlohmann::json scene_of(const std::string& page) {
    const std::string open = "<script id=\"scene\" type=\"application/json\">";
    const std::size_t start = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
  }

  TemporaryFolder folder_;
};

TEST_F(HtmlPage, HoldsThreeJsItsControlsAndNoReferenceToAnythingElse) {
  const std::string page = page_of(SampleResult().result());
  EXPECT_THAT(page, AllOf(HasSubstr("/* three */"), HasSubstr("/* controls */"), HasSubstr("default-src 'none'")));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)\\s*=|https?://|import\\s|fetch\\(|url\\(")));
}

/// Names that end a script element for the parser, or keep it from ending, and what else a page could take for its own.
TEST_F(HtmlPage, HoldsNamesThatLookLikeMarkup) {
  for (const std::string name : {"<!--<script>", "<!--", "<script>", "]]>", "{{script}}", "&lt;", "\"'`${}", "--!>"}) {
    const std::string page = page_of(SampleResult(name).result());
    const std::size_t start = page.find("<script id=\"scene\"");
    const std::string inside =
        page.substr(page.find('>', start) + 1, page.find("</script>", start) - page.find('>', start) - 1);
    EXPECT_EQ(inside.find('<'), std::string::npos) << name;
    EXPECT_THAT(nlohmann::json::parse(inside).dump(), HasSubstr(nlohmann::json(name).dump().substr(1, 3))) << name;
  }
}

TEST_F(HtmlPage, NamesThePlaneOfEveryFacetOfAVolume) {
  const nlohmann::json scene = scene_of(page_of(SampleResult().result()));
  std::size_t volumes = 0;
  for (const auto& item : scene.at("items")) {
    if (item.at("name") != "umbra of table, lamp" && item.at("name") != "penumbra of table, lamp") continue;
    ++volumes;
    EXPECT_FALSE(item.at("names").empty());
    for (const std::string name : item.at("names")) {
      EXPECT_TRUE(std::regex_match(name, std::regex("separating plane: edge [0-3] of (table|lamp), vertex [0-3] of "
                                                    "(lamp|table)|supporting plane: edge [0-3] of table, vertex [0-3] "
                                                    "of lamp|clip box|plane of lamp")))
          << name;
    }
  }
  EXPECT_EQ(volumes, 2);
}

TEST_F(HtmlPage, KeepsNamesThatLookLikeMarkupInTheirPlace) {
  const std::string name = "</script><b>&\"";
  const std::string page = page_of(SampleResult("lamp", name).result());
  EXPECT_THAT(page, Not(HasSubstr(name)));
  std::vector<std::string> labels;
  const nlohmann::json scene = scene_of(page);
  for (const auto& label : scene.at("labels")) labels.push_back(label.at("text"));
  EXPECT_THAT(labels, Contains(name));
}

TEST_F(HtmlPage, HoldsNoMarkupInsideItsScene) {
  for (const std::string name : {"<!--<script>", "<!--", "<script>", "</script", "]]>", "<SCRIPT/>"}) {
    const std::string page = page_of(SampleResult(name, "table").result());
    const std::string open = "<script id=\"scene\" type=\"application/json\">";
    const std::size_t start = page.find(open) + open.size();
    const std::string scene = page.substr(start, page.find("</script>", start) - start);
    EXPECT_THAT(scene, Not(HasSubstr("<"))) << name;
    EXPECT_EQ(nlohmann::json::parse(scene).at("lights").at(0), name);
  }
}

TEST_F(HtmlPage, OfThePlaneIsTheDrawing) {
  EXPECT_THAT(page_of(PlanarSample().result()), AllOf(HasSubstr("<svg "), HasSubstr("supporting line: ")));
}

TEST_F(HtmlPage, SaysWhatToInstallWhereThreeJsIsMissingAndKeepsTheOldPage) {
  write_file(folder_ / "page.html", "old");
  std::filesystem::remove(folder_ / "three.min.js");
  const SampleResult sample;
  EXPECT_THAT([&] { render_scene(sample.result(), folder_ / "page.html"); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("three.min.js"), HasSubstr("libjs-three"))));
  EXPECT_EQ(file_text(folder_ / "page.html"), "old");
}

}  // namespace
}  // namespace gnomon
