#include "viz/pictures/html_page.h"

#include <vtkBase64Utilities.h>
#include <vtkCellArrayIterator.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "viz/pictures/picture_items.h"
#include "viz/pictures/svg.h"
#include "viz/vtk/vector.h"
#include "viz/vtk/xml.h"

namespace gnomon::viz {
namespace {

using Json = nlohmann::ordered_json;

std::string contents(const std::string& file) {
  const char* elsewhere = std::getenv("GNOMON_THREE_JS");
  const bool is_set = elsewhere != nullptr && *elsewhere != '\0';
  const std::string path = (is_set ? elsewhere : std::string(three_js_folder())) + "/" + file;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error("cannot make a page: " + path +
                             " cannot be read; install three.js (Debian package libjs-three)");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Value>
std::string encoded(const std::vector<Value>& values) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  const std::size_t length = values.size() * sizeof(Value);
  std::string text(4 * ((length + 2) / 3) + 4, '\0');
  text.resize(vtkBase64Utilities::Encode(bytes, length, reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

Json json(const Point3& p) {
  return {p.x, p.y, p.z};
}

Json json(const Color& color) {
  return {color[0], color[1], color[2]};
}

std::vector<float> positions(vtkPolyData& data, const Point3& centre) {
  std::vector<float> values;
  for (const Point3& p : points_of(data)) {
    for (const double x : {p.x - centre.x, p.y - centre.y, p.z - centre.z}) values.push_back(static_cast<float>(x));
  }
  return values;
}

std::vector<std::uint8_t> levels(const std::vector<Color>& colors) {
  std::vector<std::uint8_t> values;
  for (const Color& color : colors) {
    for (const double c : color) values.push_back(static_cast<std::uint8_t>(std::lround(255 * c)));
  }
  return values;
}

/// Convex cells as fans of triangles, and of every triangle its cell; lines as pairs.
struct Simplices {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> lines;
};

Simplices simplices(vtkPolyData& data) {
  Simplices result;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    data.GetCellPoints(i, size, points);
    const auto add = [&](std::vector<std::uint32_t>& list, vtkIdType k) {
      list.push_back(static_cast<std::uint32_t>(points[k]));
    };
    const int type = data.GetCellType(i);
    if (type == VTK_LINE || type == VTK_POLY_LINE) {
      for (vtkIdType k = 1; k < size; ++k) add(result.lines, k - 1), add(result.lines, k);
    } else if (type == VTK_TRIANGLE_STRIP) {
      for (vtkIdType k = 2; k < size; ++k) add(result.faces, k - 2), add(result.faces, k - 1), add(result.faces, k);
    } else {
      for (vtkIdType k = 2; k < size; ++k) {
        add(result.faces, 0), add(result.faces, k - 1), add(result.faces, k);
        result.cells.push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
  return result;
}

Json json(const std::optional<PicturePlane>& front, const Point3& centre) {
  if (!front) return nullptr;
  return {{"origin", json(front->origin - centre)}, {"normal", json(front->normal)}};
}

Json json(const PictureItem& item, const Point3& centre) {
  const Simplices parts = simplices(*item.data);
  Json result = {{"name", item.name},
                 {"color", json(item.look.color)},
                 {"opacity", item.look.opacity},
                 {"ambient", item.look.ambient},
                 {"width", item.look.line_width},
                 {"colors", encoded(levels(item.point_colors))},
                 {"positions", encoded(positions(*item.data, item.in_corner ? Point3{} : centre))},
                 {"faces", encoded(parts.faces)},
                 {"cells", encoded(item.cell_names.empty() ? std::vector<std::uint32_t>{} : parts.cells)},
                 {"names", item.cell_names},
                 {"lines", encoded(parts.lines)},
                 {"front", json(item.front, centre)},
                 {"layer", item.layer},
                 {"light", item.light},
                 {"corner", item.in_corner}};
  return result;
}

Json json(const Legend& legend) {
  constexpr const char* marks[] = {"filled", "line", "dashed"};
  Json list = Json::array();
  for (const LegendEntry& entry : legend.entries) {
    const char* mark = marks[static_cast<std::size_t>(entry.mark)];
    list.push_back({{"text", entry.text},
                    {"color", json(entry.color)},
                    {"mark", mark},
                    {"layer", entry.layer},
                    {"light", entry.light}});
  }
  return list;
}

/// JSON inside a script element, where some words that begin with "<" end the script or begin a comment. Outside of its
/// texts JSON has no "<".
std::string in_script(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    c == '<' ? text += "\\u003c" : text += c;
  }
  return text;
}

Json json(const PictureLabel& label, const Point3& centre) {
  Json places = Json::array();
  for (const Point3& place : label.places) places.push_back(json(place - centre));
  return {{"text", label.text},   {"places", std::move(places)},        {"layer", label.layer},
          {"light", label.light}, {"front", json(label.front, centre)}, {"corner", label.in_corner}};
}

std::string script(const std::string& text) {
  return "<script>" + text + "</script>\n";
}

std::string page(const std::map<std::string, std::string>& parts) {
  std::string text;
  std::string_view rest = page_template();
  for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    const std::size_t close = rest.find("}}", open);
    text += rest.substr(0, open);
    text += parts.at(std::string(rest.substr(open + 2, close - open - 2)));
    rest.remove_prefix(close + 2);
  }
  return text.append(rest);
}

Json space_json(const PictureScene& scene, const PictureView& view, const Legend& legend,
                const std::vector<PictureLabel>& labels) {
  // Relative to the middle of the view, floats are fine enough.
  const Point3& centre = view.focus;
  const bool along_axis = length(cross(unit(view.position - view.focus), scene.up)) < 1e-3;
  const Point3& axis = along_axis || view.up == scene.up ? scene.up : view.up;
  Json data = {{"size", scene.size},
               {"view",
                {{"position", json(view.position - centre)},
                 {"focus", {0, 0, 0}},
                 {"up", json(view.up)},
                 {"axis", json(axis)},
                 {"angle", view.angle}}},
               {"lights", scene.light_names},
               {"legend", json(legend)},
               {"keys", "drag or arrows: turn\nwheel, + and -: larger, smaller\nR: reset view"},
               {"labels", Json::array()},
               {"items", Json::array()}};
  for (const PictureLabel& label : labels) data["labels"].push_back(json(label, centre));
  for (const PictureItem& item : picture_items(scene)) data["items"].push_back(json(item, centre));
  return data;
}

}  // namespace

std::string html_page(const PictureScene& scene, const PictureView& view, const Legend& legend,
                      const std::vector<PictureLabel>& labels) {
  return page(
      {{"version", GNOMON_VERSION},
       {"title", xml_escaped(legend.title)},
       {"kind", "space"},
       {"picture", "<canvas id=\"picture\"></canvas>\n<svg id=\"leaders\"></svg>"},
       {"scene", in_script(space_json(scene, view, legend, labels))},
       {"libraries", script(contents("three.min.js")) + script(contents("examples/js/controls/OrbitControls.js"))},
       {"panel", std::string(page_panel_script())},
       {"script", std::string(page_space_script())}});
}

std::string html_page(const PlanarDrawing& drawing, const Legend& legend, const std::vector<std::string>& lights) {
  const Json data = {{"lights", lights},
                     {"legend", json(legend)},
                     {"keys", "drag or arrows: move\nwheel, + and -: larger, smaller\nR: reset view"}};
  return page({{"version", GNOMON_VERSION},
               {"title", xml_escaped(legend.title)},
               {"kind", "plane"},
               {"picture", svg_in_page(drawing)},
               {"scene", in_script(data)},
               {"libraries", ""},
               {"panel", std::string(page_panel_script())},
               {"script", std::string(page_plane_script())}});
}

}  // namespace gnomon::viz
