#include "viz/pictures/picture_actors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "viz/pictures/haloed_words.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

constexpr double opacity_from_behind = 0.35;

vtkSmartPointer<vtkPolyData> with_colors(vtkPolyData& data, const std::vector<Color>& colors) {
  vtkNew<vtkUnsignedCharArray> levels;
  levels->SetNumberOfComponents(3);
  for (const Color& color : colors) {
    for (const double c : color) levels->InsertNextValue(static_cast<unsigned char>(std::lround(255 * c)));
  }
  auto coloured = vtkSmartPointer<vtkPolyData>::New();
  coloured->ShallowCopy(&data);
  coloured->GetPointData()->SetScalars(levels);
  return coloured;
}

vtkSmartPointer<vtkActor> actor_of(const PictureItem& item, double opacity, double pixel) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(item.data);
  mapper->ScalarVisibilityOff();
  if (!item.point_colors.empty()) {
    mapper->SetInputData(with_colors(*item.data, item.point_colors));
    mapper->SetScalarVisibility(1);
    mapper->SetScalarModeToUsePointData();
    mapper->SetColorModeToDirectScalars();
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(item.look.color[0], item.look.color[1], item.look.color[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(item.look.ambient);
  property->SetDiffuse(1 - item.look.ambient);
  property->SetSpecular(0);
  property->SetInterpolationToFlat();
  property->SetLineWidth(static_cast<float>(item.look.line_width * pixel));
  return actor;
}

/// How far the nearest thing with a place is, along the view.
double nearest_depth(std::span<const PictureItem> items, const PictureView& view) {
  const Point3 ahead = unit(view.focus - view.position);
  double nearest = length(view.focus - view.position);
  for (const PictureItem& item : items) {
    if (item.in_corner) continue;
    for (const Point3& p : points_of(*item.data)) {
      const double depth = dot(p - view.position, ahead);
      if (depth > 0) nearest = std::min(nearest, depth);
    }
  }
  return nearest;
}

/// Moves an arrow of length 1 to the upper right corner, before everything else, an eighth as long as the picture is
/// high.
void put_in_corner(vtkActor& actor, double depth, const PictureView& view, const DrawingSize& size) {
  const Point3 ahead = unit(view.focus - view.position);
  const Point3 right = unit(cross(ahead, view.up));
  const Point3 up = cross(right, ahead);
  const double half = depth * std::tan(view.angle / 2 * std::acos(-1.0) / 180);
  const Point3 place =
      view.position + depth * ahead + half * (size.width / size.height - 0.2) * right + 0.8 * half * up;
  actor.SetScale(0.24 * half);
  actor.SetPosition(place.x, place.y, place.z);
}

}  // namespace

void add_actors(vtkRenderer& renderer, std::span<const PictureItem> items, const PictureView& view,
                const DrawingSize& size, double pixel) {
  for (const PictureItem& item : items) {
    const bool behind = item.front && item.front->distance(view.position) <= 0;
    const bool lines = item.data->GetNumberOfPolys() == 0;
    if (behind && !lines) continue;
    const auto actor = actor_of(item, behind ? opacity_from_behind : item.look.opacity, pixel);
    if (item.in_corner) put_in_corner(*actor, 0.9 * nearest_depth(items, view), view, size);
    renderer.AddActor(actor);
  }
}

void add_labels(vtkRenderer& renderer, std::span<const PlacedLabel> labels, const DrawingSize& size, double pixel) {
  for (const PlacedLabel& label : labels) {
    const double x = pixel * label.box.x;
    const double y = pixel * (size.height - label.box.y);
    if (label.is_led) {
      add_leader(renderer, pixel * label.from_x, pixel * (size.height - label.from_y), x, y, pixel);
    }
    add_words(renderer, {label.text, x, y, label_letter * pixel});
  }
}

}  // namespace gnomon::viz
