#include "viz/html_page.h"

#include <vtkBase64Utilities.h>
#include <vtkCellArrayIterator.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "viz/page_text.h"
#include "viz/picture_items.h"
#include "viz/svg.h"
#include "viz/vector.h"
#include "viz/xml.h"

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
                 {"positions", encoded(positions(*item.data, centre))},
                 {"faces", encoded(parts.faces)},
                 {"cells", encoded(item.cell_names.empty() ? std::vector<std::uint32_t>{} : parts.cells)},
                 {"names", item.cell_names},
                 {"lines", encoded(parts.lines)},
                 {"front", json(item.front, centre)}};
  return result;
}

Json json(const Legend& legend) {
  constexpr const char* marks[] = {"filled", "line", "dashed"};
  Json list = Json::array();
  for (const LegendEntry& entry : legend.entries) {
    const char* mark = marks[static_cast<std::size_t>(entry.mark)];
    list.push_back({{"text", entry.text}, {"color", json(entry.color)}, {"mark", mark}});
  }
  return list;
}

/// JSON inside a script element: "</" would end it, and "<!--" with "<script" keep it from ending, so no "<" stays one.
std::string in_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
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

}  // namespace

std::string html_page(const PictureScene& scene, const PictureView& view, const Legend& legend,
                      const std::vector<PictureLabel>& labels) {
  // Relative to the middle of the view, floats are fine enough.
  const Point3& centre = view.focus;
  Json data = {{"size", scene.size},
               {"view",
                {{"position", json(view.position - centre)},
                 {"focus", {0, 0, 0}},
                 {"up", json(view.up)},
                 {"angle", view.angle}}},
               {"legend", json(legend)},
               {"labels", Json::array()},
               {"items", Json::array()}};
  for (const PictureLabel& label : labels) {
    data["labels"].push_back(
        {{"at", json(label.at - centre)}, {"text", label.text}, {"front", json(label.front, centre)}});
  }
  for (const PictureItem& item : picture_items(scene)) data["items"].push_back(json(item, centre));
  return page({{"version", GNOMON_VERSION},
               {"title", xml_escaped(legend.title)},
               {"scene", in_script(data.dump(-1, ' ', false, Json::error_handler_t::replace))},
               {"three", contents("three.min.js")},
               {"controls", contents("examples/js/controls/OrbitControls.js")},
               {"script", std::string(page_script())}});
}

std::string html_page(const PlanarDrawing& drawing, const Legend& legend) {
  const std::string title = xml_escaped(legend.title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"generator\" "
         "content=\"gnomon " GNOMON_VERSION "\">\n<title>" +
         title +
         "</title>\n<style>body { margin: 0; } svg { display: block; width: 100vw; height: 100vh; }</style>\n"
         "</head>\n<body>\n" +
         svg_text(drawing, legend) + "</body>\n</html>\n";
}

}  // namespace gnomon::viz
