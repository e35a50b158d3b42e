#include "viz/picture_legend.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <vector>

#include "viz/palette.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

struct Entry {
  std::string text;
  Color color;
};

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

std::vector<Entry> entries(const PictureScene& scene) {
  std::vector<Entry> list;
  const auto cells = [](const auto& surface) { return surface->GetNumberOfCells() > 0; };
  const auto painted = [&](bool umbra) {
    return std::ranges::any_of(scene.shadows, [&](const PaintedShadow& shadow) { return shadow.umbra == umbra; });
  };
  if (!scene.lights.empty()) list.push_back({titled("light", scene.lights), palette.light});
  if (!scene.blockers.empty()) list.push_back({titled("blocker", scene.blockers), palette.blocker});
  if (std::ranges::any_of(scene.umbras, cells)) list.push_back({"umbra volume", faint(palette.umbra, 0.72)});
  if (std::ranges::any_of(scene.penumbras, cells)) list.push_back({"penumbra volume", faint(palette.penumbra, 0.42)});
  if (!scene.receivers.empty()) {
    list.push_back(
        {scene.receivers.size() == 1 ? "receiver (" + scene.receivers.front().name + "), lit" : "receivers, lit",
         palette.receiver});
  }
  if (painted(false)) list.push_back({"penumbra on receiver", palette.penumbra});
  if (painted(true)) list.push_back({"umbra on receiver", palette.umbra});
  return list;
}

/// A filled rectangle, or its border, in pixels.
void add_rectangle(vtkRenderer& renderer, double x, double y, double width, double height, const Color& color,
                   double line) {
  const std::vector<Point3> corners = {{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}};
  vtkNew<vtkCellArray> cells;
  insert_cell(*cells, line > 0 ? std::vector<int>{0, 1, 2, 3, 0} : std::vector<int>{0, 1, 2, 3});
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points(corners));
  line > 0 ? data->SetLines(cells) : data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(line > 0 ? line : 1));
  renderer.AddActor2D(actor);
}

void add_text(vtkRenderer& renderer, const std::string& text, double x, double y, double size, bool bold) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetDisplayPosition(static_cast<int>(x), static_cast<int>(y));
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(static_cast<int>(size));
  property->SetBold(bold ? 1 : 0);
  property->SetColor(palette.edge[0], palette.edge[1], palette.edge[2]);
  property->SetVerticalJustificationToCentered();
  renderer.AddActor2D(actor);
}

}  // namespace

void add_legend(vtkRenderer& renderer, const PictureScene& scene, double width, double height, double pixel) {
  const std::vector<Entry> list = entries(scene);
  const double size = std::min(0.075 * width, 0.03 * height);
  const double line = 2.1 * size;
  double y = height - 2.5 * size;
  add_text(renderer, scene.title, 0.5 * size, y, 1.15 * size, true);
  for (const Entry& entry : list) {
    y -= line;
    add_rectangle(renderer, 0.5 * size, y - 0.7 * size, 2 * size, 1.4 * size, entry.color, 0);
    add_rectangle(renderer, 0.5 * size, y - 0.7 * size, 2 * size, 1.4 * size, palette.edge, pixel);
    add_text(renderer, entry.text, 3.1 * size, y, size, false);
  }
}

}  // namespace gnomon::viz
