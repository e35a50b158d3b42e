#include "viz/pictures/haloed_words.h"

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
#include <cmath>
#include <vector>

#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

void add_text(vtkRenderer& renderer, const HaloedWords& words, double dx, double dy, const Color& color) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.text.c_str());
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  actor->SetPosition(words.x + dx, words.y + dy);
  vtkTextProperty* look = actor->GetTextProperty();
  look->SetFontFamilyToArial();
  look->SetFontSize(std::max(6, static_cast<int>(std::lround(words.letter))));
  look->SetColor(color[0], color[1], color[2]);
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToCentered();
  renderer.AddActor2D(actor);
}

}  // namespace

void add_words(vtkRenderer& renderer, const HaloedWords& words) {
  const double halo = std::max(1.0, 0.11 * words.letter);
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::acos(-1.0) / 4;
    add_text(renderer, words, halo * std::cos(angle), halo * std::sin(angle), {1, 1, 1});
  }
  add_text(renderer, words, 0, 0, words.color);
}

void add_leader(vtkRenderer& renderer, double x, double y, double to_x, double to_y, double width) {
  vtkNew<vtkCellArray> line;
  insert_cell(*line, std::vector<int>{0, 1});
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtk_points(std::vector<Point3>{{x, y, 0}, {to_x, to_y, 0}}));
  data->SetLines(line);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(palette.edge[0], palette.edge[1], palette.edge[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  renderer.AddActor2D(actor);
}

}  // namespace gnomon::viz
