#include "viz/pictures/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "gnomon/picture.h"
#include "gnomon/writer.h"
#include "tests/viz/planar_sample.h"
#include "tests/viz/temporary_folder.h"
#include "viz/pictures/picture_selection.h"

namespace gnomon::viz {
namespace {

using testing::Contains;
using testing::HasSubstr;

vtkSmartPointer<vtkXMLDataElement> parsed(const std::string& text) {
  return vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromString(text.c_str()));
}

std::vector<std::string> titles(vtkXMLDataElement& svg) {
  std::vector<std::string> names;
  for (int i = 0; i < svg.GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* title = svg.GetNestedElement(i)->FindNestedElementWithName("title");
    if (title != nullptr) names.emplace_back(title->GetCharacterData());
  }
  return names;
}

std::string svg_of(const PictureSource& source) {
  const PictureSource shown = selected(source, {}, LightsShown::first);
  return svg_text(planar_drawing(shown, {400, 300}, Shown::yes), {shown.title, planar_legend(shown)});
}

TEST(Svg, OfThePlaneIsXmlThatNamesElementsAndLines) {
  const PlanarSample sample;
  const auto svg = parsed(svg_of(picture_source(sample.result())));
  ASSERT_NE(svg, nullptr);
  EXPECT_STREQ(svg->GetName(), "svg");
  const std::vector<std::string> names = titles(*svg);
  const auto& scene = std::get<PlaneScene>(*sample.result().scene);
  for (const PlanarLight& light : scene.lights) EXPECT_THAT(names, Contains(light.name));
  EXPECT_THAT(names, Contains(HasSubstr("separating line: ")));
  EXPECT_THAT(names, Contains(HasSubstr("supporting line: ")));
}

TEST(Svg, HoldsEveryPointOfARegionWhereItBelongs) {
  PictureSource source;
  source.dimension = 2;
  source.clip_box = {{-10, -5, 0}, {10, 5, 0}};
  const PlanarDrawing drawing{source.clip_box, {200, 100}, 0.1, {{Fill{{{{-10, -5, 0}, {10, -5, 0}, {0, 5, 0}}}, {}}}}};
  EXPECT_THAT(svg_text(drawing, {}), HasSubstr("d=\"M0 100L200 100L100 0Z\""));
}

TEST(Svg, EscapesNames) {
  const PlanarDrawing drawing{
      {{-1, -1, 0}, {1, 1, 0}}, {100, 100}, 0.02, {{Disc{{0, 0, 0}, 4, {}, "a<b>&\"c\""}}, {Words{{}, "<&>", {}}}}};
  const std::string text = svg_text(drawing, {"<title>", {{"&", {}}}});
  const auto svg = parsed(text);
  ASSERT_NE(svg, nullptr) << text;
  EXPECT_THAT(titles(*svg), Contains("a<b>&\"c\""));
}

TEST(Svg, IsTheSameFromAFolder) {
  const TemporaryFolder folder;
  const PlanarSample sample;
  write_shadow(sample.result(), folder / "result");
  render_scene(sample.result(), folder / "one.svg");
  render_result(folder / "result", folder / "two.svg");
  EXPECT_EQ(file_text(folder / "one.svg"), file_text(folder / "two.svg"));
}

}  // namespace
}  // namespace gnomon::viz
