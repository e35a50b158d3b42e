#include "apps/proof/report/svg_plot.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "apps/proof/report/plot_axis.h"

namespace gnomon::report {
namespace {

constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

constexpr double plot_width = 520;
constexpr double legend_width = 250;
constexpr double row_height = 15;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? std::string("&lt;") : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string label(double x, double y, const std::string& anchor, const std::string& text, int size = 12) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" font-size=\"" +
         std::to_string(size) + "\">" + text + "</text>\n";
}

std::string segment(double x, double y, double to_x, double to_y, const std::string& color) {
  return "<path d=\"M" + number(x) + " " + number(y) + "L" + number(to_x) + " " + number(to_y) + "\" stroke=\"" +
         color + "\"/>\n";
}

/// A shape of its own for each series, 8 pixels wide.
std::string marker(std::size_t kind, double x, double y, const std::string& color) {
  constexpr std::array shapes{"M-4 0A4 4 0 1 0 4 0A4 4 0 1 0 -4 0Z",
                              "M-3.5 -3.5H3.5V3.5H-3.5Z",
                              "M0 -4.5L4.5 3.5H-4.5Z",
                              "M0 -5L5 0L0 5L-5 0Z",
                              "M0 4.5L4.5 -3.5H-4.5Z",
                              "M-4 -4L4 4M-4 4L4 -4",
                              "M-5 0H5M0 -5V5"};
  const std::size_t shape = kind % shapes.size();
  return "<path d=\"" + std::string(shapes[shape]) + "\" transform=\"translate(" + number(x) + " " + number(y) +
         ")\" fill=\"" + (shape > 4 ? "none" : color) + "\" stroke=\"" + color + "\" stroke-width=\"1.6\"/>\n";
}

class Drawing {
 public:
  explicit Drawing(const Plot& plot)
      : plot_(plot),
        left_(plot.rows.empty() ? 84 : 290),
        height_(plot.rows.empty() ? 360 : row_height * static_cast<double>(plot.rows.size())),
        x_(plot.x.scale, values(&std::pair<double, double>::first)),
        y_(plot.y.scale, values(&std::pair<double, double>::second)) {}

  std::string text() const {
    const double width = left_ + plot_width + legend_width, height = top + height_ + 60;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
                      number(height) + "\" viewBox=\"0 0 " + number(width) + " " + number(height) +
                      "\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += label(left_, 24, "start", escaped(plot_.title), 15) + frame();
    for (std::size_t k = 0; k < plot_.series.size(); ++k) svg += series(k) + legend(k);
    return svg + "</svg>\n";
  }

 private:
  static constexpr double top = 40;

  std::vector<double> values(double std::pair<double, double>::*coordinate) const {
    std::vector<double> all;
    for (const Series& one : plot_.series) {
      for (const auto& point : one.points) all.push_back(point.*coordinate);
    }
    return all;
  }

  double across(double share) const { return left_ + share * plot_width; }
  double down(double share) const { return top + (1 - share) * height_; }
  double at_x(double value) const { return across(x_.place(value)); }
  double at_y(double value) const {
    return plot_.rows.empty() ? down(y_.place(value)) : top + (value + 0.5) * row_height;
  }

  std::string frame() const {
    std::string svg;
    for (const Tick& tick : x_.ticks()) {
      const double x = across(tick.place);
      svg += segment(x, top, x, top + height_, "#dddddd") + label(x, top + height_ + 18, "middle", tick_text(tick));
    }
    svg += plot_.rows.empty() ? number_rows() : named_rows();
    svg += "<rect x=\"" + number(left_) + "\" y=\"" + number(top) + "\" width=\"" + number(plot_width) +
           "\" height=\"" + number(height_) + "\" fill=\"none\" stroke=\"black\"/>\n";
    return svg + label(across(0.5), top + height_ + 44, "middle", escaped(plot_.x.label), 13);
  }

  std::string number_rows() const {
    std::string svg;
    for (const Tick& tick : y_.ticks()) {
      const double y = down(tick.place);
      svg += segment(left_, y, left_ + plot_width, y, "#dddddd") + label(left_ - 8, y + 4, "end", tick_text(tick));
    }
    return svg + "<text transform=\"translate(22 " + number(down(0.5)) +
           ") rotate(-90)\" text-anchor=\"middle\" font-size=\"13\">" + escaped(plot_.y.label) + "</text>\n";
  }

  std::string named_rows() const {
    std::string svg;
    for (std::size_t k = 0; k < plot_.rows.size(); ++k) {
      const double y = at_y(static_cast<double>(k));
      svg += segment(left_, y, left_ + plot_width, y, "#dddddd") +
             label(left_ - 8, y + 4, "end", escaped(plot_.rows[k]), 11);
    }
    return svg;
  }

  static std::string tick_text(const Tick& tick) {
    if (tick.exponent.empty()) return tick.label;
    const std::string sign = tick.exponent.front() == '-' ? "\u2212" + tick.exponent.substr(1) : tick.exponent;
    return tick.label + "<tspan dy=\"-5\" font-size=\"9\">" + sign + "</tspan>";
  }

  std::string color(std::size_t k) const {
    return plot_.series[k].color.empty() ? palette[k % palette.size()] : plot_.series[k].color;
  }

  std::string series(std::size_t k) const {
    const Series& one = plot_.series[k];
    std::string line, markers;
    for (const auto& [x, y] : one.points) {
      line += (line.empty() ? "M" : "L") + number(at_x(x)) + " " + number(at_y(y));
      if (one.has_markers) markers += marker(k, at_x(x), at_y(y), color(k));
    }
    if (one.line == Series::Line::none || one.points.size() < 2) return markers;
    return stroke(line, one, color(k)) + markers;
  }

  static std::string stroke(const std::string& path, const Series& one, const std::string& color) {
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.6\"" +
           (one.line == Series::Line::dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n";
  }

  std::string legend(std::size_t k) const {
    const Series& one = plot_.series[k];
    const double x = left_ + plot_width + 16, y = top + 10 + 20 * static_cast<double>(k);
    std::string svg;
    if (one.line != Series::Line::none) {
      svg += stroke("M" + number(x) + " " + number(y) + "H" + number(x + 26), one, color(k));
    }
    if (one.has_markers) svg += marker(k, x + 13, y, color(k));
    return svg + label(x + 34, y + 4, "start", escaped(one.name));
  }

  const Plot& plot_;
  double left_;
  double height_;
  AxisScale x_;
  AxisScale y_;
};

}  // namespace

std::string svg_text(const Plot& plot) {
  return Drawing(plot).text();
}

}  // namespace gnomon::report
