#include "apps/proof/report/svg_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "apps/proof/report/plot_axis.h"

namespace gnomon::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(AxisScale, PlacesDecadesAtEqualDistances) {
  const AxisScale axis(Scale::logarithmic, {2e-3, 5});
  EXPECT_NEAR(axis.place(1e-3), 0, 1e-12);
  EXPECT_NEAR(axis.place(1e-1), 0.5, 1e-12);
  EXPECT_NEAR(axis.place(10), 1, 1e-12);
  EXPECT_EQ(axis.ticks().size(), 5u);
  EXPECT_EQ(axis.ticks().front().exponent, "-3");
}

TEST(AxisScale, PutsZerosOnAShelfBelowTheSmallestDecade) {
  const AxisScale axis(Scale::logarithmic, {0, 2e-3, 5});
  EXPECT_EQ(axis.place(0), 0);
  EXPECT_NEAR(axis.place(1e-3), 0.2, 1e-12);
  EXPECT_EQ(axis.ticks().front().label, "0");
  EXPECT_EQ(axis.ticks().front().place, 0);
}

TEST(AxisScale, LabelsRoundNumbersOnALinearAxis) {
  const AxisScale axis(Scale::linear, {0, 10});
  EXPECT_NEAR(axis.place(5), 0.5, 1e-12);
  std::set<std::string> labels;
  for (const Tick& tick : axis.ticks()) labels.insert(tick.label);
  EXPECT_THAT(labels, testing::IsSupersetOf({"0", "2", "10"}));
}

TEST(AxisScaleDegenerate, OneValueHasAnAxis) {
  for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
    const AxisScale axis(scale, {3});
    EXPECT_GT(axis.place(3), 0);
    EXPECT_LT(axis.place(3), 1);
  }
}

Plot two_series() {
  Plot plot{"errors < 1 & times", {"time [s]"}, {"error [1]"}, {}, {}};
  plot.series.push_back({"a", {{1e-6, 1e-2}, {1e-4, 1e-3}}, Series::Line::solid, true, ""});
  plot.series.push_back({"b", {{1e-5, 1e-16}}, Series::Line::dashed, true, ""});
  return plot;
}

TEST(SvgPlot, NamesItsAxesWithUnitsAndItsSeries) {
  const std::string svg = svg_text(two_series());
  EXPECT_THAT(svg, testing::StartsWith("<svg xmlns="));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  for (const char* text : {"time [s]", "error [1]", ">a<", ">b<", "errors &lt; 1 &amp; times"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

TEST(SvgPlot, TellsSeriesApartByMarkerAndByColour) {
  const std::string svg = svg_text(two_series());
  // Each point has a marker, and so has each series in the legend.
  EXPECT_EQ(count(svg, "A4 4"), 2u * (2 + 1));
  EXPECT_EQ(count(svg, "H3.5V3.5H-3.5Z"), 1u + 1u);
  EXPECT_THAT(svg, testing::AllOf(HasSubstr("#0072b2"), HasSubstr("#d55e00")));
}

TEST(SvgPlot, NamesRowsInPlaceOfNumbers) {
  Plot plot{"cases", {"share"}, {"", Scale::linear}, {}, {"first case", "second case"}};
  plot.series.push_back({"wrong", {{0, 0}, {0.5, 1}}, Series::Line::none, true, ""});
  const std::string svg = svg_text(plot);
  EXPECT_THAT(svg,
              testing::AllOf(HasSubstr("first case"), HasSubstr("second case"), Not(HasSubstr("stroke-dasharray"))));
}

}  // namespace
}  // namespace gnomon::report
