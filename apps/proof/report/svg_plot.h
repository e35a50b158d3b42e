#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gnomon::report {

enum class Scale { linear, logarithmic };

struct Axis {
  std::string label;  ///< with its unit
  Scale scale = Scale::logarithmic;
};

/// Points of one kind, with a line through them or not.
struct Series {
  enum class Line { none, solid, dashed };

  std::string name;
  std::vector<std::pair<double, double>> points;
  Line line = Line::solid;
  bool has_markers = true;
  std::string color;  ///< as SVG has it; empty: the next of the palette
};

/// A drawing of numbers.
struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  std::vector<std::string> rows;  ///< names of the values 0, 1, ... on the y axis from the top down; empty: numbers
};

/// The plot as the text of an SVG file: black on white, with eight colours that the colour-blind tell apart (those of
/// Okabe and Ito) and a marker of its own for each series, so that it is read in grey as well.
///
/// Degenerate: on a logarithmic axis what is 0 or less stands on a shelf of its own, labelled 0.
/// Returns:    the same text for the same plot.
std::string svg_text(const Plot& plot);

}  // namespace gnomon::report
