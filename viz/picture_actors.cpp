#include "viz/picture_actors.h"

#include <vtkActor.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "viz/palette.h"

namespace gnomon::viz {
namespace {

constexpr double label_size = 12;
constexpr double opacity_from_behind = 0.35;

void add_actor(vtkRenderer& renderer, const PictureItem& item, double opacity, double pixel) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(item.data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(item.look.color[0], item.look.color[1], item.look.color[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(item.look.ambient);
  property->SetDiffuse(1 - item.look.ambient);
  property->SetSpecular(0);
  property->SetInterpolationToFlat();
  property->SetLineWidth(static_cast<float>(item.look.line_width * pixel));
  renderer.AddActor(actor);
}

}  // namespace

void add_actors(vtkRenderer& renderer, std::span<const PictureItem> items, const PictureView& view, double pixel) {
  for (const PictureItem& item : items) {
    const bool behind = item.front && item.front->distance(view.position) <= 0;
    const bool lines = item.data->GetNumberOfPolys() == 0;
    if (behind && !lines) continue;
    add_actor(renderer, item, behind ? opacity_from_behind : item.look.opacity, pixel);
  }
}

// In front of everything: what stands between camera and element hides no name.
void add_labels(vtkRenderer& renderer, std::span<const PictureLabel> labels, const PictureView& view, double pixel) {
  for (const PictureLabel& label : labels) {
    if (label.front && label.front->distance(view.position) <= 0) continue;
    vtkNew<vtkTextActor> actor;
    actor->SetInput(label.text.c_str());
    actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    actor->GetPositionCoordinate()->SetValue(label.at.x, label.at.y, label.at.z);
    vtkTextProperty* look = actor->GetTextProperty();
    look->SetFontSize(static_cast<int>(std::lround(label_size * pixel)));
    look->SetColor(palette.edge[0], palette.edge[1], palette.edge[2]);
    look->SetBackgroundColor(1, 1, 1);
    look->SetBackgroundOpacity(0.75);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToCentered();
    renderer.AddActor2D(actor);
  }
}

}  // namespace gnomon::viz
