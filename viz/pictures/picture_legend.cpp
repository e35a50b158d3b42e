#include "viz/pictures/picture_legend.h"

#include <vtkActor2D.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <vector>

#include "viz/pictures/picture_items.h"
#include "viz/vtk/facet_groups.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

enum class Weight { plain, bold };

/// Part `share` of the colour, the rest white: how a translucent surface looks.
Color faint(const Color& color, double share) {
  Color mixed;
  std::ranges::transform(color, mixed.begin(), [&](double value) { return share * value + 1 - share; });
  return mixed;
}

/// The kind, with the name where there is only one.
std::string titled(const std::string& kind, const std::vector<PictureBlock>& blocks) {
  return blocks.size() == 1 ? kind + " (" + blocks.front().path.back() + ")" : kind + "s";
}

/// Where the legend is drawn, in pixels of its renderer.
class LegendPage {
 public:
  LegendPage(vtkRenderer& renderer, double pixel) : renderer_(renderer), pixel_(pixel) {}

  double width() const { return renderer_.GetSize()[0]; }
  double height() const { return renderer_.GetSize()[1]; }

  void swatch(double x, double y, double width, double height, const Color& color) {
    rectangle(x, y, width, height, color, palette.edge);
  }

  /// `y` is the middle of the line.
  void line(double x, double y, double width, const LegendEntry& entry) {
    const double thick = 2.5 * pixel_;
    const int parts = entry.mark == LegendMark::dashed ? 3 : 1;
    // Gaps are four fifths of a dash.
    const double dash = width / (parts + 0.8 * (parts - 1));
    for (int i = 0; i < parts; ++i) {
      rectangle(x + 1.8 * i * dash, y - thick / 2, dash, thick, entry.color, entry.color);
    }
  }

  /// `y` is the middle of the line of text.
  void text(const std::string& words, double x, double y, double size, Weight weight) {
    vtkNew<vtkTextActor> actor;
    actor->SetInput(words.c_str());
    actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    actor->SetPosition(x, y);
    vtkTextProperty* property = actor->GetTextProperty();
    property->SetFontFamilyToArial();
    property->SetFontSize(static_cast<int>(size));
    property->SetBold(weight == Weight::bold ? 1 : 0);
    property->SetColor(palette.edge[0], palette.edge[1], palette.edge[2]);
    property->SetVerticalJustificationToCentered();
    renderer_.AddActor2D(actor);
  }

 private:
  void rectangle(double x, double y, double width, double height, const Color& color, const Color& border_color) {
    const std::vector<Point3> corners = {{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}};
    vtkNew<vtkCellArray> inside;
    insert_cell(*inside, std::vector<int>{0, 1, 2, 3});
    vtkNew<vtkCellArray> border;
    insert_cell(*border, std::vector<int>{0, 1, 2, 3, 0});
    vtkNew<vtkPolyData> filled;
    filled->SetPoints(vtk_points(corners));
    filled->SetPolys(inside);
    add(filled, color);
    vtkNew<vtkPolyData> outline;
    outline->SetPoints(vtk_points(corners));
    outline->SetLines(border);
    add(outline, border_color);
  }

  void add(vtkPolyData* data, const Color& color) {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetLineWidth(static_cast<float>(pixel_));
    renderer_.AddActor2D(actor);
  }

  vtkRenderer& renderer_;
  double pixel_;
};

/// The letters' height with which everything fits the page.
double height_of_letters(const LegendPage& page, const Legend& legend) {
  // A letter of this typeface is a little more than half as wide as it is high.
  constexpr double letter = 0.57;
  double widest = letter * 1.2 * static_cast<double>(legend.title.size()) + 0.6;
  for (const LegendEntry& entry : legend.entries) {
    widest = std::max(widest, letter * static_cast<double>(entry.text.size()) + 3.2);
  }
  const double lines = 4 + 2.1 * static_cast<double>(legend.entries.size());
  return std::min({page.width() / widest, page.height() / lines, 0.08 * page.width()});
}

void add_once(std::vector<LegendEntry>& list, const LegendEntry& entry) {
  if (std::ranges::count(list, entry.text, &LegendEntry::text) == 0) list.push_back(entry);
}

std::string discontinuity_text(const std::string& order) {
  const std::string jumps = order == "D0" ? "jumps" : order == "D1" ? "has a kink" : "has a kinked slope";
  return order + ": light " + jumps;
}

std::string region_text(const std::string& region) {
  return region == "unresolved_eee" ? "umbra or penumbra, unresolved" : region + " on receiver";
}

/// Receivers that bear no regions of some light, or show their backs.
void add_plain_receivers(std::vector<LegendEntry>& list, const PictureScene& scene) {
  std::vector<std::string> names;
  for (const PictureReceiver& receiver : scene.receivers) names.push_back(receiver.name);
  for (const PictureBlock& mesh : scene.receiver_meshes) names.push_back(mesh.path.back());
  const auto undivided = [&](const std::string& receiver) {
    return scene.light_names.empty() || std::ranges::any_of(scene.light_names, [&](const std::string& light) {
             return !is_divided(scene, receiver, light);
           });
  };
  const auto has_back = [](const PictureReceiver& receiver) { return !receiver.ends_scene && !receiver.has_twin; };
  if (std::ranges::any_of(names, undivided)) {
    const std::string text = names.size() == 1 ? "receiver (" + names.front() + ")" : "receivers";
    list.push_back({text, palette.receiver, LegendMark::filled, "receiver"});
  } else if (std::ranges::any_of(scene.receivers, has_back)) {
    list.push_back({"back of receiver", palette.receiver, LegendMark::filled, "receiver"});
  }
}

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// Of receivers that are painted by irradiance the scale of each light, the largest value first.
void add_scales(std::vector<LegendEntry>& list, const PictureScene& scene) {
  if (scene.painted_receivers.empty()) return;
  for (const std::string& light : scene.light_names) {
    const RoundScale scale = irradiance_scale(scene, light);
    for (int k = scale.steps; k >= 0; --k) {
      const std::string number = short_number(k * scale.step) + " W/m²";
      list.push_back({k == scale.steps ? "irradiance " + number : number, colour_of_share(double(k) / scale.steps),
                      LegendMark::filled, "irradiance", light_mark(scene, light)});
    }
  }
}

/// What is seen of divided receivers and of discontinuities, every region and order once, in the order of their
/// numbers.
void add_divisions(std::vector<LegendEntry>& list, const PictureScene& scene) {
  std::map<std::string, Color> orders;
  std::vector<RegionFacets> regions;
  for (const PictureBlock& block : scene.divided_receivers) {
    if (is_painted(scene, block)) continue;
    for (const RegionFacets& part : region_facets(*block.data)) regions.push_back(part);
    for (const OrderedFacets& part : ordered_lines(*block.data)) orders.emplace(part.name, part.color);
  }
  for (const PictureBlock& block : scene.discontinuities) {
    for (const OrderedFacets& part : ordered_lines(*block.data)) orders.emplace(part.name, part.color);
    for (const OrderedFacets& part : ordered_surfaces(*block.data)) orders.emplace(part.name, part.color);
  }
  std::ranges::stable_sort(regions, {}, &RegionFacets::region);
  for (const RegionFacets& part : regions) {
    add_once(list, {region_text(part.name), part.color, LegendMark::filled, part.name});
  }
  add_scales(list, scene);
  for (const auto& [order, color] : orders) {
    add_once(list, {discontinuity_text(order), color, LegendMark::line, order});
  }
}

}  // namespace

std::string light_text(const std::string& name, std::size_t light_count) {
  if (light_count < 2) return "light (" + name + ")";
  return "light (" + name + "), one of " + std::to_string(light_count);
}

std::vector<LegendEntry> legend_entries(const PictureScene& scene) {
  std::vector<LegendEntry> list;
  const auto add = [&](const std::string& text, const Color& color, const std::string& layer,
                       const std::string& light = {}) {
    list.push_back({text, color, LegendMark::filled, layer, light});
  };
  const auto cells = [](const PictureBlock& block) { return block.data->GetNumberOfCells() > 0; };
  for (const std::string& light : scene.light_names) {
    add(light_text(light, scene.light_count), palette.light, "light", light_mark(scene, light));
  }
  if (!scene.blockers.empty()) add(titled("blocker", scene.blockers), palette.blocker, "blocker");
  if (std::ranges::any_of(scene.umbras, cells)) add("umbra volume", faint(palette.umbra, 0.72), "umbra volume");
  if (std::ranges::any_of(scene.penumbras, cells)) {
    add("penumbra volume", faint(palette.penumbra, 0.42), "penumbra volume");
  }
  add_plain_receivers(list, scene);
  add_divisions(list, scene);
  return list;
}

void add_legend(vtkRenderer& renderer, const Legend& legend, double pixel) {
  LegendPage page(renderer, pixel);
  const double size = height_of_letters(page, legend);
  double y = page.height() - 3 * size;
  page.text(legend.title, 0.3 * size, y, 1.15 * size, Weight::bold);
  for (const LegendEntry& entry : legend.entries) {
    y -= 2.1 * size;
    if (entry.mark == LegendMark::filled) {
      page.swatch(0.3 * size, y - 0.7 * size, 2 * size, 1.4 * size, entry.color);
    } else {
      page.line(0.3 * size, y, 2 * size, entry);
    }
    page.text(entry.text, 2.9 * size, y, size, Weight::plain);
  }
}

}  // namespace gnomon::viz
