#include "viz/planar_picture.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>

#include "geometry/spatial/shadow_volume.h"
#include "viz/palette.h"
#include "viz/planar_lines.h"
#include "viz/vector.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

/// From the paper up.
enum class Layer { lit, penumbra, umbra, frame, line, receiver, blocker, light };

/// How strokes look; lengths in pixels of the finished picture.
struct Stroke {
  Color color;
  double width;
  double dash = 0;  ///< length of a dash, and a little more than that of a gap; 0: no gaps
};

constexpr double edge_width = 1.5;
constexpr double label_size = 11;
/// With more lines than this, names would cover the drawing.
constexpr std::size_t most_labels = 12;
/// On shorter lines names would hide each other.
constexpr double shortest_labelled = 120;
constexpr Stroke separating_stroke{palette.separating, 2, 9};
constexpr Stroke supporting_stroke{palette.supporting, 2};
constexpr Stroke blocker_stroke{palette.blocker, 8};
constexpr Stroke light_stroke{palette.light, 8};
constexpr Stroke receiver_stroke{palette.receiver, 6};

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

/// A renderer as paper: layers above one another, each of one colour.
class Sheet {
 public:
  Sheet(vtkRenderer& renderer, const Box3& box, const DrawingSize& size)
      : renderer_(renderer), box_(box), half_height_(framed_half_height(box, size)) {
    unit_per_pixel_ = 2 * half_height_ / size.height;
    window_pixels_ = renderer.GetSize()[1] / size.height;
    set_camera();
  }

  void fill(vtkPolyData* data, const Color& color, Layer layer, double opacity = 1) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    add(mapper, color, layer, opacity);
  }

  void fill_box(const Color& color) { fill(quads({box_corners()}), color, Layer::lit); }

  void frame_box(const Color& color) {
    const Polygon corners = box_corners();
    std::vector<Segment> sides;
    for (std::size_t i = 0; i < 4; ++i) sides.push_back({corners[i], corners[(i + 1) % 4]});
    stroke(sides, {color, 1}, Layer::frame);
  }

  void stroke(const std::vector<Segment>& segments, const Stroke& look, Layer layer) {
    const double dash = look.dash * unit_per_pixel_;
    std::vector<Polygon> ribbons;
    for (const Segment& segment : segments) {
      for (const Segment& part : dashes(segment, dash)) ribbons.push_back(ribbon(part, look.width * unit_per_pixel_));
    }
    if (!ribbons.empty()) fill(quads(ribbons), look.color, layer);
  }

  double pixels(double length) const { return length / unit_per_pixel_; }

  /// Words about a point, of one size whatever the scale.
  void label(const Point3& at, const std::string& text, const Color& color) {
    vtkNew<vtkBillboardTextActor3D> actor;
    actor->SetInput(text.c_str());
    actor->SetPosition(at.x, at.y, 0.01 * half_height_ * (static_cast<double>(Layer::light) + 1));
    vtkTextProperty* look = actor->GetTextProperty();
    look->SetFontSize(std::max(6, static_cast<int>(std::lround(label_size * window_pixels_))));
    look->SetColor(color[0], color[1], color[2]);
    look->SetBackgroundColor(1, 1, 1);
    look->SetBackgroundOpacity(0.75);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToCentered();
    renderer_.AddActor(actor);
  }

  void disc(const Point3& centre, double diameter, const Color& color, Layer layer) {
    vtkNew<vtkRegularPolygonSource> disc;
    disc->SetNumberOfSides(48);
    disc->GeneratePolylineOff();
    disc->SetCenter(centre.x, centre.y, 0);
    disc->SetRadius(diameter / 2 * unit_per_pixel_);
    disc->Update();
    fill(disc->GetOutput(), color, layer);
  }

 private:
  static double framed_half_height(const Box3& box, const DrawingSize& size) {
    constexpr double margin = 1.05;
    const double across = (box.max.x / 2 - box.min.x / 2) * size.height / size.width;
    return margin * std::max(box.max.y / 2 - box.min.y / 2, across);
  }

  void set_camera() {
    const double x = std::midpoint(box_.min.x, box_.max.x);
    const double y = std::midpoint(box_.min.y, box_.max.y);
    vtkCamera* camera = renderer_.GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half_height_);
    camera->SetFocalPoint(x, y, 0);
    camera->SetPosition(x, y, 4 * half_height_);
    camera->SetViewUp(0, 1, 0);
    camera->SetClippingRange(half_height_, 8 * half_height_);
  }

  Polygon box_corners() const {
    return {{box_.min.x, box_.min.y, 0},
            {box_.max.x, box_.min.y, 0},
            {box_.max.x, box_.max.y, 0},
            {box_.min.x, box_.max.y, 0}};
  }

  static Polygon ribbon(const Segment& segment, double width) {
    const Point3 way = unit(segment.end - segment.start);
    const Point3 aside = width / 2 * Point3{-way.y, way.x, 0};
    return {segment.start - aside, segment.end - aside, segment.end + aside, segment.start + aside};
  }

  static vtkSmartPointer<vtkPolyData> quads(const std::vector<Polygon>& polygons) {
    Polygon points;
    vtkNew<vtkCellArray> cells;
    for (const Polygon& polygon : polygons) {
      insert_cell(*cells, std::vector<int>{0, 1, 2, 3}, static_cast<vtkIdType>(points.size()));
      points.insert(points.end(), polygon.begin(), polygon.end());
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(vtk_points(points));
    data->SetPolys(cells);
    return data;
  }

  void add(vtkPolyDataMapper* mapper, const Color& color, Layer layer, double opacity) {
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0, 0, 0.01 * half_height_ * (static_cast<double>(layer) + 0.01 * next_++));
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->LightingOff();
    renderer_.AddActor(actor);
  }

  vtkRenderer& renderer_;
  Box3 box_;
  double half_height_;
  double unit_per_pixel_ = 1;
  double window_pixels_ = 1;  ///< of the window for one of the finished picture
  double next_ = 0;           ///< what is drawn later lies above what is drawn earlier, within one layer
};

/// The regions of a light behind all blockers together, where they are known; or those of every pair.
bool is_region(const PictureSource& source, const PictureBlock& block, const std::string& name) {
  const bool together = std::ranges::count(source.blocks, "region", &PictureBlock::kind) > 0;
  return block.kind == (together ? "region" : "volume") && block.path.back() == name;
}

std::size_t count(const PictureSource& source, const std::string& kind) {
  return static_cast<std::size_t>(std::ranges::count(source.blocks, kind, &PictureBlock::kind));
}

/// Where shadows of several lights lie above one another, all are to be seen.
double region_opacity(const PictureSource& source) {
  return count(source, "light") > 1 ? 0.6 : 1;
}

/// How a region looks on lit paper.
Color region_color(const PictureSource& source, const Color& color) {
  const double share = region_opacity(source);
  Color mixed;
  for (std::size_t k = 0; k < 3; ++k) mixed[k] = share * color[k] + (1 - share) * palette.lit[k];
  return mixed;
}

// Drawn in the order of the layers, as translucent colours must be where depth is not peeled.
void draw_regions(Sheet& sheet, const PictureSource& source, const std::string& name, const Color& color, Layer layer) {
  for (const PictureBlock& block : source.blocks) {
    if (is_region(source, block, name)) sheet.fill(block.data, color, layer, region_opacity(source));
  }
}

void draw_lines(Sheet& sheet, const PictureSource& source) {
  for (const PictureBlock& block : source.blocks) {
    if (!is_line_block(source, block)) continue;
    sheet.stroke(segments_of(block, FacetKind::supporting_blocker_plane), supporting_stroke, Layer::line);
    sheet.stroke(segments_of(block, FacetKind::separating_blocker_plane), separating_stroke, Layer::line);
  }
}

void draw_labels(Sheet& sheet, const PictureSource& source) {
  const std::map<std::string, NamedLine> labels = named_lines(source);
  if (labels.size() > most_labels) return;
  for (const auto& [name, label] : labels) {
    const bool separating = label.kind == FacetKind::separating_blocker_plane;
    const Point3 way = label.segment.end - label.segment.start;
    if (sheet.pixels(length(way)) < shortest_labelled) continue;
    sheet.label(label.segment.start + 0.8 * way, name, separating ? palette.separating : palette.supporting);
  }
}

/// A thick stroke with round ends and a dark edge; of a point light a disc.
void draw_element(Sheet& sheet, const PictureBlock& block, const Stroke& look, Layer layer) {
  const std::vector<Segment> segments = segments_of(block);
  const double end = segments.empty() ? 2 * look.width : look.width;
  for (const double edge : {2 * edge_width, 0.0}) {
    const Color& color = edge > 0 ? palette.edge : look.color;
    sheet.stroke(segments, {color, look.width + edge}, layer);
    for (const Point3& p : points_of(*block.data)) sheet.disc(p, end + edge, color, layer);
  }
}

void draw_elements(Sheet& sheet, const PictureSource& source) {
  for (const PictureBlock& block : source.blocks) {
    if (block.kind == "receiver") draw_element(sheet, block, receiver_stroke, Layer::receiver);
    if (block.kind == "blocker") draw_element(sheet, block, blocker_stroke, Layer::blocker);
    if (block.kind == "light") draw_element(sheet, block, light_stroke, Layer::light);
  }
}

/// The kind, with the name where there is only one.
std::string titled(const PictureSource& source, const std::string& kind) {
  if (count(source, kind) != 1) return kind + "s";
  return kind + " (" + std::ranges::find(source.blocks, kind, &PictureBlock::kind)->path.back() + ")";
}

bool has_line(const PictureSource& source, FacetKind kind) {
  return std::ranges::any_of(source.blocks, [&](const PictureBlock& block) {
    return is_line_block(source, block) && !segments_of(block, kind).empty();
  });
}

}  // namespace

void add_planar_drawing(vtkRenderer& renderer, const PictureSource& source, const DrawingSize& size) {
  Sheet sheet(renderer, source.clip_box, size);
  sheet.fill_box(palette.lit);
  draw_regions(sheet, source, "penumbra", palette.penumbra, Layer::penumbra);
  draw_regions(sheet, source, "umbra", palette.umbra, Layer::umbra);
  sheet.frame_box(palette.edge);
  draw_lines(sheet, source);
  draw_elements(sheet, source);
  draw_labels(sheet, source);
}

std::vector<LegendEntry> planar_legend(const PictureSource& source) {
  using enum FacetKind;
  std::vector<LegendEntry> list;
  const auto shows = [&](const std::string& region) {
    return std::ranges::any_of(source.blocks,
                               [&](const PictureBlock& block) { return is_region(source, block, region); });
  };
  if (count(source, "light") > 0) list.push_back({titled(source, "light"), palette.light});
  if (count(source, "blocker") > 0) list.push_back({titled(source, "blocker"), palette.blocker});
  if (count(source, "receiver") > 0) list.push_back({titled(source, "receiver"), palette.receiver});
  if (source.complete) list.push_back({"lit", palette.lit});
  if (shows("penumbra")) list.push_back({"penumbra", region_color(source, palette.penumbra)});
  if (shows("umbra")) list.push_back({"umbra", region_color(source, palette.umbra)});
  if (has_line(source, separating_blocker_plane)) {
    list.push_back({"separating line", palette.separating, LegendMark::dashed});
  }
  if (has_line(source, supporting_blocker_plane)) {
    list.push_back({"supporting line", palette.supporting, LegendMark::line});
  }
  return list;
}

}  // namespace gnomon::viz
