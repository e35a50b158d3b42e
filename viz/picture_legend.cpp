#include "viz/picture_legend.h"

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
#include <vector>

#include "viz/vtk_cells.h"

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

/// Where the shadows of some pairs are not known, nothing is called lit.
std::string receiver_text(const PictureScene& scene) {
  const bool one = scene.receivers.size() == 1;
  const std::string text = one ? "receiver (" + scene.receivers.front().name + ")" : "receivers";
  return scene.complete ? text + ", lit" : text;
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
double letter_size(const LegendPage& page, const Legend& legend) {
  // A letter of this typeface is a little more than half as wide as it is high.
  constexpr double letter = 0.57;
  double widest = letter * 1.2 * static_cast<double>(legend.title.size()) + 0.6;
  for (const LegendEntry& entry : legend.entries) {
    widest = std::max(widest, letter * static_cast<double>(entry.text.size()) + 3.2);
  }
  const double lines = 4 + 2.1 * static_cast<double>(legend.entries.size());
  return std::min({page.width() / widest, page.height() / lines, 0.08 * page.width()});
}

}  // namespace

std::vector<LegendEntry> legend_entries(const PictureScene& scene) {
  std::vector<LegendEntry> list;
  const auto cells = [](const auto& surface) { return surface->GetNumberOfCells() > 0; };
  const auto painted = [&](bool umbra) {
    return std::ranges::any_of(scene.shadows, [&](const PaintedShadow& shadow) { return shadow.umbra == umbra; });
  };
  if (!scene.lights.empty()) list.push_back({titled("light", scene.lights), palette.light});
  if (!scene.blockers.empty()) list.push_back({titled("blocker", scene.blockers), palette.blocker});
  if (std::ranges::any_of(scene.umbras, cells)) list.push_back({"umbra volume", faint(palette.umbra, 0.72)});
  if (std::ranges::any_of(scene.penumbras, cells)) list.push_back({"penumbra volume", faint(palette.penumbra, 0.42)});
  if (!scene.receivers.empty()) list.push_back({receiver_text(scene), palette.receiver});
  if (painted(false)) list.push_back({"penumbra on receiver", palette.penumbra});
  if (painted(true)) list.push_back({"umbra on receiver", palette.umbra});
  const char* regions[] = {"lit", "penumbra", "umbra", "unlit", "three edges in line"};
  for (const int region : {0, 1, 2, 3, 4}) {
    const auto has_region = [&](const PaintedMesh& mesh) { return mesh.region == region; };
    if (std::ranges::any_of(scene.meshes, has_region)) list.push_back({regions[region], region_color(region)});
  }
  for (const PictureBlock& block : scene.discontinuities) {
    const int order = block.path.back().back() - '0';
    list.push_back({"discontinuity D" + std::to_string(order), faint(order_color(order), 0.5)});
  }
  return list;
}

void add_legend(vtkRenderer& renderer, const Legend& legend, double pixel) {
  LegendPage page(renderer, pixel);
  const double size = letter_size(page, legend);
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
