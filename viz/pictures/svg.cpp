#include "viz/pictures/svg.h"

#include <charconv>
#include <cmath>
#include <numeric>

#include "viz/vtk/xml.h"

namespace gnomon::viz {
namespace {

constexpr double legend_size = 13;

/// At most three decimals, and none that say nothing.
std::string number(double value) {
  const double rounded = std::round(1000 * value) / 1000 + 0.0;
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, rounded).ptr;
  return {text, end};
}

std::string color_text(const Color& color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const double value : color) {
    const auto byte = static_cast<unsigned>(std::lround(255 * value));
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

std::string titled(const std::string& name) {
  return name.empty() ? "" : "<title>" + xml_escaped(name) + "</title>";
}

std::string words(double x, double y, double size, const std::string& attributes, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"" + number(size) + "\"" + attributes + ">" +
         xml_escaped(text) + "</text>\n";
}

/// From the scene's coordinates to pixels from the upper left corner.
class Page {
 public:
  explicit Page(const PlanarDrawing& drawing)
      : unit_(drawing.unit_per_pixel),
        middle_{std::midpoint(drawing.box.min.x, drawing.box.max.x),
                std::midpoint(drawing.box.min.y, drawing.box.max.y), 0},
        size_(drawing.size) {}

  /// A thin edge of the same colour closes the seams between neighbours; opacity counts once, for all of it.
  std::string operator()(const Fill& mark) const {
    std::string path;
    for (const Polygon& polygon : mark.polygons) {
      for (std::size_t i = 0; i < polygon.size(); ++i) path += (i == 0 ? "M" : "L") + place(polygon[i]);
      path += "Z";
    }
    const std::string color = color_text(mark.color);
    return "<path d=\"" + path + "\" fill=\"" + color + "\" stroke=\"" + color +
           "\" stroke-width=\"0.5\" stroke-linejoin=\"round\" opacity=\"" + number(mark.opacity) + "\"/>\n";
  }

  std::string operator()(const Strokes& mark) const {
    std::string path;
    for (const Segment& segment : mark.segments) path += "M" + place(segment.start) + "L" + place(segment.end);
    std::string dash;
    if (mark.dash > 0) dash = " stroke-dasharray=\"" + number(mark.dash) + " " + number(0.8 * mark.dash) + "\"";
    const char* cap = mark.round_ends ? " stroke-linecap=\"round\"" : "";
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + color_text(mark.color) + "\" stroke-width=\"" +
           number(mark.width) + "\"" + dash + cap + ">" + titled(mark.name) + "</path>\n";
  }

  std::string operator()(const Disc& mark) const {
    return "<circle cx=\"" + number(x(mark.centre)) + "\" cy=\"" + number(y(mark.centre)) + "\" r=\"" +
           number(mark.diameter / 2) + "\" fill=\"" + color_text(mark.color) + "\">" + titled(mark.name) +
           "</circle>\n";
  }

  std::string operator()(const Words& mark) const {
    return words(x(mark.at), y(mark.at) + 0.35 * letter_size, letter_size,
                 " text-anchor=\"middle\" paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\" fill=\"" +
                     color_text(mark.color) + "\"",
                 mark.text);
  }

 private:
  double x(const Point3& p) const { return size_.width / 2 + (p.x - middle_.x) / unit_; }
  double y(const Point3& p) const { return size_.height / 2 - (p.y - middle_.y) / unit_; }
  std::string place(const Point3& p) const { return number(x(p)) + " " + number(y(p)); }

  double unit_;
  Point3 middle_;
  DrawingSize size_;
};

std::string legend_mark(const LegendEntry& entry, double x, double y) {
  if (entry.mark == LegendMark::filled) {
    return "<rect x=\"" + number(x) + "\" y=\"" + number(y - 8) + "\" width=\"24\" height=\"16\" fill=\"" +
           color_text(entry.color) + "\" stroke=\"" + color_text(palette.edge) + "\"/>\n";
  }
  const std::string dash = entry.mark == LegendMark::dashed ? " stroke-dasharray=\"6 3\"" : "";
  return "<path d=\"M" + number(x) + " " + number(y) + "h24\" stroke=\"" + color_text(entry.color) +
         "\" stroke-width=\"2.5\"" + dash + "/>\n";
}

std::string legend_text(const Legend& legend, double x) {
  const std::string ink = " fill=\"" + color_text(palette.edge) + "\"";
  double y = 40;
  std::string text = words(x, y, 1.15 * legend_size, ink + " font-weight=\"bold\"", legend.title);
  for (const LegendEntry& entry : legend.entries) {
    y += 2.1 * legend_size;
    text += legend_mark(entry, x, y);
    text += words(x + 34, y + 0.35 * legend_size, legend_size, ink, entry.text);
  }
  return text;
}

double legend_width(const Legend& legend) {
  std::size_t letters = 1 + legend.title.size();
  for (const LegendEntry& entry : legend.entries) letters = std::max(letters, entry.text.size());
  return 48 + 0.57 * 1.15 * legend_size * static_cast<double>(letters);
}

}  // namespace

std::string svg_text(const PlanarDrawing& drawing, const Legend& legend) {
  const bool has_legend = !legend.entries.empty();
  const double width = drawing.size.width + (has_legend ? legend_width(legend) : 0);
  const std::string size = number(width) + " " + number(drawing.size.height);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" + number(width) +
                     "\" height=\"" + number(drawing.size.height) + "\" font-family=\"sans-serif\">\n<title>" +
                     xml_escaped(legend.title) + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const Mark& mark : drawing.marks) text += std::visit(Page(drawing), mark.shape);
  if (has_legend) text += legend_text(legend, drawing.size.width + 8);
  return text + "</svg>\n";
}

std::string svg_in_page(const PlanarDrawing& drawing) {
  std::string text = "<svg id=\"picture\" viewBox=\"0 0 " + number(drawing.size.width) + " " +
                     number(drawing.size.height) + "\" font-family=\"sans-serif\">\n";
  for (const Mark& mark : drawing.marks) {
    text += "<g data-layer=\"" + xml_escaped(mark.layer) + "\" data-light=\"" + xml_escaped(mark.light) + "\">" +
            std::visit(Page(drawing), mark.shape) + "</g>\n";
  }
  return text + "</svg>\n";
}

}  // namespace gnomon::viz
