#include "viz/pictures/planar_drawing.h"

#include <algorithm>
#include <map>

#include "gnomon/shadow_volume.h"
#include "viz/pictures/label_layout.h"
#include "viz/vtk/palette.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

constexpr double edge_width = 1.5;
/// With more lines than this, names would cover the drawing.
constexpr std::size_t most_line_names = 12;
/// On shorter lines names would hide each other.
constexpr double shortest_labelled = 120;
constexpr double line_width = 2;
constexpr double line_dash = 9;

double unit_per_pixel(const Box3& box, const DrawingSize& size) {
  constexpr double margin = 1.05;
  const double along = (box.max.y / 2 - box.min.y / 2) / size.height;
  const double across = (box.max.x / 2 - box.min.x / 2) / size.width;
  return 2 * margin * std::max(along, across);
}

Polygon corners(const Box3& box) {
  return {{box.min.x, box.min.y, 0}, {box.max.x, box.min.y, 0}, {box.max.x, box.max.y, 0}, {box.min.x, box.max.y, 0}};
}

std::size_t count(const PictureSource& source, const std::string& kind) {
  return static_cast<std::size_t>(std::ranges::count(source.blocks, kind, &PictureBlock::kind));
}

/// The regions of a light behind all blockers together, where they are known; or those of every pair.
bool is_region(const PictureSource& source, const PictureBlock& block, const std::string& name) {
  return block.kind == (count(source, "region") > 0 ? "region" : "volume") && block.path.back() == name;
}

/// The mark of what is shown with one of several lights.
std::string light_mark(const PictureSource& source, const std::string& light) {
  return source.lights.size() > 1 ? light : std::string{};
}

void add_regions(PlanarDrawing& drawing, const PictureSource& source, const std::string& name, const Color& color) {
  for (const PictureBlock& block : source.blocks) {
    if (!is_region(source, block, name)) continue;
    drawing.marks.push_back({Fill{polygons_of(*block.data), color}, name, light_mark(source, block.path.at(1))});
  }
}

void add_frame(PlanarDrawing& drawing) {
  const Polygon box = corners(drawing.box);
  Strokes frame{{}, palette.edge, 1};
  for (std::size_t i = 0; i < 4; ++i) frame.segments.push_back({box[i], box[(i + 1) % 4]});
  drawing.marks.push_back({std::move(frame)});
}

Mark line_mark(const NamedLine& line, const std::string& name) {
  const bool separating = line.kind == FacetKind::separating_blocker_plane;
  const Color& color = separating ? palette.separating : palette.supporting;
  const std::string kind = separating ? "separating line" : "supporting line";
  return {Strokes{line.pieces, color, line_width, separating ? line_dash : 0, false, kind + ": " + name}, kind};
}

/// The lines of one name are one stroke, so that it can be called by it.
void add_lines(PlanarDrawing& drawing, const PictureSource& source, const std::string& light) {
  using enum FacetKind;
  const std::map<std::string, NamedLine> lines = named_lines(source, light);
  for (const FacetKind kind : {supporting_blocker_plane, separating_blocker_plane}) {
    for (const auto& [name, line] : lines) {
      if (line.kind != kind) continue;
      drawing.marks.push_back(line_mark(line, name));
      drawing.marks.back().light = light_mark(source, light);
    }
  }
}

/// Names at four fifths of their lines, pushed apart where they meet.
void add_names(PlanarDrawing& drawing, const PictureSource& source, const std::string& light) {
  const std::map<std::string, NamedLine> lines = named_lines(source, light);
  if (lines.size() > most_line_names) return;
  const double unit = drawing.unit_per_pixel;
  std::vector<Mark> marks;
  std::vector<LabelBox> boxes;
  for (const auto& [name, line] : lines) {
    const bool separating = line.kind == FacetKind::separating_blocker_plane;
    const Point3 way = line.segment.end - line.segment.start;
    if (length(way) < shortest_labelled * unit) continue;
    const Point3 at = line.segment.start + 0.8 * way - drawing.box.min;
    boxes.push_back(label_box(name, letter_size, at.x / unit, at.y / unit));
    const Color& color = separating ? palette.separating : palette.supporting;
    marks.push_back(
        {Words{{}, name, color}, separating ? "separating line" : "supporting line", light_mark(source, light)});
  }
  const Point3 size = drawing.box.max - drawing.box.min;
  for (const std::size_t i : pushed_apart(boxes, {size.x / unit, size.y / unit})) {
    std::get<Words>(marks[i].shape).at = drawing.box.min + Point3{unit * boxes[i].x, unit * boxes[i].y, 0};
    drawing.marks.push_back(std::move(marks[i]));
  }
}

/// A thick stroke with round ends and a dark edge; of a point light a disc.
void add_element(PlanarDrawing& drawing, const PictureBlock& block, const Color& color, double width,
                 const std::string& light) {
  const std::string& name = block.path.back();
  const std::vector<Segment> segments = segments_of(block);
  for (const double edge : {2 * edge_width, 0.0}) {
    const Color& shown = edge > 0 ? palette.edge : color;
    if (segments.empty()) {
      drawing.marks.push_back({Disc{points_of(*block.data).front(), 2 * width + edge, shown, name}, block.kind, light});
    } else {
      drawing.marks.push_back({Strokes{segments, shown, width + edge, 0, true, name}, block.kind, light});
    }
  }
}

void add_elements(PlanarDrawing& drawing, const PictureSource& source, const std::string& kind, const Color& color,
                  double width) {
  for (const PictureBlock& block : source.blocks) {
    const std::string light = kind == "light" ? light_mark(source, block.path.back()) : "";
    if (block.kind == kind) add_element(drawing, block, color, width, light);
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

PlanarDrawing planar_drawing(const PictureSource& source, const DrawingSize& size, Shown labels) {
  PlanarDrawing drawing{source.clip_box, size, unit_per_pixel(source.clip_box, size), {}};
  drawing.marks.push_back({Fill{{corners(source.clip_box)}, palette.lit}, "lit"});
  add_regions(drawing, source, "penumbra", palette.penumbra);
  add_regions(drawing, source, "umbra", palette.umbra);
  add_frame(drawing);
  for (const std::string& light : source.lights) add_lines(drawing, source, light);
  add_elements(drawing, source, "receiver", palette.receiver, 6);
  add_elements(drawing, source, "blocker", palette.blocker, 8);
  add_elements(drawing, source, "light", palette.light, 8);
  if (labels == Shown::no) return drawing;
  for (const std::string& light : source.lights) add_names(drawing, source, light);
  return drawing;
}

std::vector<LegendEntry> planar_legend(const PictureSource& source) {
  using enum FacetKind;
  std::vector<LegendEntry> list;
  const auto add = [&](const std::string& text, const Color& color, const std::string& layer,
                       LegendMark mark = LegendMark::filled) {
    list.push_back({text, color, mark, layer});
  };
  const auto shows = [&](const std::string& region) {
    return std::ranges::any_of(source.blocks,
                               [&](const PictureBlock& block) { return is_region(source, block, region); });
  };
  for (const std::string& light : source.lights) {
    add(light_text(light, source.light_count), palette.light, "light");
    list.back().light = light_mark(source, light);
  }
  if (count(source, "blocker") > 0) add(titled(source, "blocker"), palette.blocker, "blocker");
  if (count(source, "receiver") > 0) add(titled(source, "receiver"), palette.receiver, "receiver");
  if (source.complete) add("lit", palette.lit, "lit");
  if (shows("penumbra")) add("penumbra", palette.penumbra, "penumbra");
  if (shows("umbra")) add("umbra", palette.umbra, "umbra");
  if (has_line(source, separating_blocker_plane)) {
    add("separating line", palette.separating, "separating line", LegendMark::dashed);
  }
  if (has_line(source, supporting_blocker_plane)) {
    add("supporting line", palette.supporting, "supporting line", LegendMark::line);
  }
  return list;
}

}  // namespace gnomon::viz
