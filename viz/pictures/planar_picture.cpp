#include "viz/pictures/planar_picture.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "viz/pictures/haloed_words.h"
#include "viz/vtk/vector.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

/// The dashes of a stroke along a segment, lengths in the scene's unit; a dash begins and ends it.
std::vector<Segment> dashes(const Segment& segment, double dash) {
  const Point3 way = segment.end - segment.start;
  const double gaps = dash > 0 ? std::min(std::floor(length(way) / (1.8 * dash)), 10000.0) : 0;
  const double period = 1 / (gaps + 1 / 1.8);
  std::vector<Segment> list;
  for (int k = 0; k <= static_cast<int>(gaps); ++k) {
    const double i = k;
    const double end = gaps > 0 ? i * period + period / 1.8 : 1;
    list.push_back({segment.start + i * period * way, segment.start + end * way});
  }
  return list;
}

Polygon ribbon(const Segment& segment, double width) {
  const Point3 way = unit(segment.end - segment.start);
  const Point3 aside = width / 2 * Point3{-way.y, way.x, 0};
  return {segment.start - aside, segment.end - aside, segment.end + aside, segment.start + aside};
}

vtkSmartPointer<vtkPolyData> polygon_data(const std::vector<Polygon>& polygons) {
  Polygon points;
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons) {
    std::vector<std::size_t> indices(polygon.size());
    std::iota(indices.begin(), indices.end(), points.size());
    insert_cell(*cells, indices);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetPolys(cells);
  return data;
}

/// A renderer as paper: every mark lies a little above the one before.
class Sheet {
 public:
  Sheet(vtkRenderer& renderer, const PlanarDrawing& drawing)
      : renderer_(renderer),
        unit_per_pixel_(drawing.unit_per_pixel),
        half_height_(drawing.unit_per_pixel * drawing.size.height / 2),
        step_(0.1 * half_height_ / static_cast<double>(2 * drawing.marks.size() + 1)),
        window_pixels_(renderer.GetSize()[1] / drawing.size.height),
        width_(drawing.size.width),
        middle_{std::midpoint(drawing.box.min.x, drawing.box.max.x),
                std::midpoint(drawing.box.min.y, drawing.box.max.y)} {
    set_camera();
  }

  void operator()(const Fill& mark) { add(polygon_data(mark.polygons), mark.color, mark.opacity); }

  void operator()(const Strokes& mark) {
    std::vector<Polygon> ribbons;
    for (const Segment& segment : mark.segments) {
      for (const Segment& part : dashes(segment, mark.dash * unit_per_pixel_)) {
        ribbons.push_back(ribbon(part, mark.width * unit_per_pixel_));
      }
      if (!mark.round_ends) continue;
      for (const Point3& end : {segment.start, segment.end}) disc(end, mark.width, mark.color);
    }
    add(polygon_data(ribbons), mark.color, 1);
  }

  void operator()(const Disc& mark) { disc(mark.centre, mark.diameter, mark.color); }

  void operator()(const Words& mark) {
    const double x = window_pixels_ * (width_ / 2 + (mark.at.x - middle_.x) / unit_per_pixel_);
    const double y =
        half_height_ / unit_per_pixel_ * window_pixels_ + window_pixels_ * (mark.at.y - middle_.y) / unit_per_pixel_;
    add_words(renderer_, {mark.text, x, y, letter_size * window_pixels_, mark.color});
  }

  void next() { height_ += step_; }

 private:
  void set_camera() {
    vtkCamera* camera = renderer_.GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half_height_);
    camera->SetFocalPoint(middle_.x, middle_.y, 0);
    camera->SetPosition(middle_.x, middle_.y, 4 * half_height_);
    camera->SetViewUp(0, 1, 0);
    camera->SetClippingRange(half_height_, 8 * half_height_);
  }

  void disc(const Point3& centre, double diameter, const Color& color) {
    vtkNew<vtkRegularPolygonSource> disc;
    disc->SetNumberOfSides(48);
    disc->GeneratePolylineOff();
    disc->SetCenter(centre.x, centre.y, 0);
    disc->SetRadius(diameter / 2 * unit_per_pixel_);
    disc->Update();
    add(disc->GetOutput(), color, 1);
  }

  void add(vtkPolyData* data, const Color& color, double opacity) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0, 0, height_);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->LightingOff();
    renderer_.AddActor(actor);
  }

  vtkRenderer& renderer_;
  double unit_per_pixel_;
  double half_height_;
  double step_;
  double window_pixels_;  ///< of the window for one of the finished picture
  double width_;          ///< of the finished picture
  Point2 middle_;
  double height_ = 0;
};

}  // namespace

void add_planar_drawing(vtkRenderer& renderer, const PlanarDrawing& drawing) {
  Sheet sheet(renderer, drawing);
  for (const Mark& mark : drawing.marks) {
    std::visit(sheet, mark.shape);
    sheet.next();
  }
}

}  // namespace gnomon::viz
