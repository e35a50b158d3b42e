#include "gnomon/picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "gnomon/errors.h"
#include "viz/pictures/html_page.h"
#include "viz/pictures/picture_png.h"
#include "viz/pictures/picture_selection.h"
#include "viz/pictures/svg.h"
#include "viz/vtk/block.h"
#include "viz/vtk/manifest.h"
#include "viz/vtk/staged_folder.h"
#include "viz/vtk/surface_files.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> format_endings = {".png", ".svg", ".gltf", ".html"};
constexpr std::array<std::string_view, 7> preset_names = {"three-quarter", "front", "back",  "left",
                                                          "right",         "top",   "bottom"};

/// Vectors need no pixels: the drawing is as large as the picture, its legend stands beside it.
viz::DrawingSize drawing_size(const PictureOptions& options) {
  return {static_cast<double>(options.width), static_cast<double>(options.height)};
}

viz::Legend planar_legend(const viz::PictureSource& source, const PictureOptions& options) {
  viz::Legend legend{source.title, {}};
  if (options.legend == Shown::yes) legend.entries = viz::planar_legend(source);
  return legend;
}

viz::PlanarDrawing planar_drawing(const viz::PictureSource& source, const PictureOptions& options) {
  return viz::planar_drawing(source, drawing_size(options), options.labels);
}

std::string html_text(const viz::PictureSource& source, const PictureOptions& options) {
  if (source.dimension == 2) {
    return viz::html_page(planar_drawing(source, options), planar_legend(source, options), source.lights);
  }
  const viz::PictureScene scene = viz::picture_scene(source);
  const viz::PictureView view = viz::picture_view(scene, options.camera, drawing_size(options));
  viz::Legend legend{source.title, {}};
  if (options.legend == Shown::yes) legend.entries = viz::legend_entries(scene);
  std::vector<viz::PictureLabel> labels;
  if (options.labels == Shown::yes) labels = viz::picture_labels(scene, view.position);
  return viz::html_page(scene, view, legend, labels);
}

std::string gltf_text(const viz::PictureSource& source) {
  std::vector<viz::Block> blocks;
  for (const viz::PictureBlock& block : source.blocks) blocks.push_back({block.path, block.kind, {}, block.data});
  return viz::gltf_text(blocks, viz::model_frame(source.clip_box, source.dimension, source.up, source.length_unit));
}

/// A scene so small or so large that floats and what draws them lose it, made larger or smaller by a power of two.
void bring_into_range(viz::PictureSource& source, PictureOptions& options) {
  const Box3& box = source.clip_box;
  const double size = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  if (!(size > 0) || (size > 0x1p-16 && size < 0x1p24)) return;
  const double scale = std::exp2(-std::ilogb(size));
  const auto scaled = [&](const Point3& p) { return Point3{scale * p.x, scale * p.y, scale * p.z}; };
  source.clip_box = {scaled(box.min), scaled(box.max)};
  for (viz::PictureBlock& block : source.blocks) {
    std::vector<Point3> points;
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i) {
      double p[3];
      block.data->GetPoint(i, p);
      points.push_back(scaled({p[0], p[1], p[2]}));
    }
    // The block may be shared with the result.
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(block.data);
    data->SetPoints(viz::vtk_points(points));
    block.data = data;
  }
  if (auto* camera = std::get_if<CameraPlace>(&options.camera)) {
    camera->position = scaled(camera->position);
    if (camera->focus) camera->focus = scaled(*camera->focus);
  }
}

void draw(viz::PictureSource source, const fs::path& file, PictureOptions options) {
  const PictureFormat format = *picture_format(file);
  using enum viz::LightsShown;
  source = selected(std::move(source), options.selection, format == PictureFormat::html ? all_in_turn : first);
  if (options.up) source.up = *options.up;
  if (format == PictureFormat::svg && source.dimension != 2)
    throw PreconditionError("picture: SVG of a scene in space");
  if (format != PictureFormat::gltf) bring_into_range(source, options);
  viz::StagedFolder folder(file.parent_path());
  const std::string name = file.filename().string();
  switch (format) {
    case PictureFormat::png:
      try {
        viz::write_png(source, options, folder.add(name).temporary);
      } catch (const viz::PngError& error) {
        throw std::runtime_error("cannot write " + file.string() + ": " + error.what());
      }
      break;
    case PictureFormat::svg:
      folder.add_text(name, viz::svg_text(planar_drawing(source, options), planar_legend(source, options)));
      break;
    case PictureFormat::gltf:
      folder.add_text(name, gltf_text(source));
      break;
    case PictureFormat::html:
      folder.add_text(name, html_text(source, options));
      break;
  }
  folder.publish();
}

/// Says what is wrong before anything is read or computed.
void check(const fs::path& file, const PictureOptions& options) {
  if (options.width < 64 || options.height < 64) throw PreconditionError("picture: width and height of at least 64");
  if (file.filename().empty()) throw std::runtime_error("cannot write " + file.string() + ": not the name of a file");
  if (!picture_format(file)) throw PreconditionError("picture: a file ending in .png, .svg, .gltf or .html");
}

}  // namespace

std::optional<PictureFormat> picture_format(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto found = std::ranges::find(format_endings, ending);
  if (found == format_endings.end()) return std::nullopt;
  return static_cast<PictureFormat>(found - format_endings.begin());
}

std::optional<CameraPreset> camera_preset(std::string_view name) {
  const auto found = std::ranges::find(preset_names, name);
  if (found == preset_names.end()) return std::nullopt;
  return static_cast<CameraPreset>(found - preset_names.begin());
}

void render_scene(const ShadowResult& result, const fs::path& file, const PictureOptions& options) {
  if (result.scene == nullptr) throw PreconditionError("render_scene: a result without a scene");
  check(file, options);
  draw(viz::picture_source(result), file, options);
}

void render_result(const fs::path& directory, const fs::path& file, const PictureOptions& options) {
  check(file, options);
  draw(viz::picture_source(directory), file, options);
}

ResultNames result_names(const fs::path& directory) {
  return viz::names_in(viz::picture_source(directory));
}

int result_dimension(const fs::path& directory) {
  return viz::read_manifest(directory).dimension;
}

}  // namespace gnomon
