#include "viz/planar_drawing.h"

#include <algorithm>
#include <map>

#include "geometry/spatial/shadow_volume.h"
#include "viz/palette.h"
#include "viz/vector.h"

namespace gnomon::viz {
namespace {

constexpr double edge_width = 1.5;
/// With more lines than this, names would cover the drawing.
constexpr std::size_t most_names = 12;
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

void add_regions(PlanarDrawing& drawing, const PictureSource& source, const std::string& name, const Color& color) {
  for (const PictureBlock& block : source.blocks) {
    if (!is_region(source, block, name)) continue;
    drawing.marks.emplace_back(Fill{polygons_of(*block.data), color, region_opacity(source)});
  }
}

void add_frame(PlanarDrawing& drawing) {
  const Polygon box = corners(drawing.box);
  Strokes frame{{}, palette.edge, 1};
  for (std::size_t i = 0; i < 4; ++i) frame.segments.push_back({box[i], box[(i + 1) % 4]});
  drawing.marks.emplace_back(std::move(frame));
}

void add_line(PlanarDrawing& drawing, std::vector<Segment> segments, FacetKind kind, const std::string& name) {
  if (segments.empty()) return;
  const bool separating = kind == FacetKind::separating_blocker_plane;
  const Color& color = separating ? palette.separating : palette.supporting;
  const std::string title = (separating ? "separating line: " : "supporting line: ") + name;
  drawing.marks.emplace_back(Strokes{std::move(segments), color, line_width, separating ? line_dash : 0, false, title});
}

/// The lines of one name are one stroke, so that it can be called by it.
void add_lines(PlanarDrawing& drawing, const PictureSource& source) {
  using enum FacetKind;
  for (const FacetKind kind : {supporting_blocker_plane, separating_blocker_plane}) {
    for (const auto& [name, line] : named_lines(source)) {
      if (line.kind == kind) add_line(drawing, line.pieces, kind, name);
    }
  }
}

void add_names(PlanarDrawing& drawing, const PictureSource& source) {
  const std::map<std::string, NamedLine> lines = named_lines(source);
  if (lines.size() > most_names) return;
  for (const auto& [name, line] : lines) {
    const bool separating = line.kind == FacetKind::separating_blocker_plane;
    const Point3 way = line.segment.end - line.segment.start;
    if (length(way) < shortest_labelled * drawing.unit_per_pixel) continue;
    const Color& color = separating ? palette.separating : palette.supporting;
    drawing.marks.emplace_back(Words{line.segment.start + 0.8 * way, name, color});
  }
}

/// A thick stroke with round ends and a dark edge; of a point light a disc.
void add_element(PlanarDrawing& drawing, const PictureBlock& block, const Color& color, double width) {
  const std::string& name = block.path.back();
  const std::vector<Segment> segments = segments_of(block);
  for (const double edge : {2 * edge_width, 0.0}) {
    const Color& shown = edge > 0 ? palette.edge : color;
    if (segments.empty()) {
      drawing.marks.emplace_back(Disc{points_of(*block.data).front(), 2 * width + edge, shown, name});
    } else {
      drawing.marks.emplace_back(Strokes{segments, shown, width + edge, 0, true, name});
    }
  }
}

void add_elements(PlanarDrawing& drawing, const PictureSource& source, const std::string& kind, const Color& color,
                  double width) {
  for (const PictureBlock& block : source.blocks) {
    if (block.kind == kind) add_element(drawing, block, color, width);
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
  drawing.marks.emplace_back(Fill{{corners(source.clip_box)}, palette.lit});
  add_regions(drawing, source, "penumbra", palette.penumbra);
  add_regions(drawing, source, "umbra", palette.umbra);
  add_frame(drawing);
  add_lines(drawing, source);
  add_elements(drawing, source, "receiver", palette.receiver, 6);
  add_elements(drawing, source, "blocker", palette.blocker, 8);
  add_elements(drawing, source, "light", palette.light, 8);
  if (labels == Shown::yes) add_names(drawing, source);
  return drawing;
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
