#include "viz/picture.h"

#include <vtkCamera.h>
#include <vtkErrorCode.h>
#include <vtkImageShrink3D.h>
#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "geometry/errors.h"
#include "viz/block.h"
#include "viz/block_file.h"
#include "viz/display.h"
#include "viz/manifest.h"
#include "viz/picture_actors.h"
#include "viz/picture_legend.h"
#include "viz/planar_picture.h"
#include "viz/quiet_vtk.h"
#include "viz/staged_folder.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Drawn twice as large and averaged: edges are smooth, and depth peeling needs a window without multisampling.
int oversampling(const PictureOptions& options) {
  return std::max(options.width, options.height) <= 4096 ? 2 : 1;
}

/// The parts of the picture for the scene and for the legend: xmin, ymin, xmax, ymax, each from 0 to 1.
struct Layout {
  double scene[4];
  double legend[4];
};

Layout layout(const PictureOptions& options) {
  if (options.width >= options.height) return {{0, 0, 0.79, 1}, {0.79, 0, 1, 1}};
  return {{0, 0.3, 1, 1}, {0, 0, 1, 0.3}};
}

viz::DrawingSize drawing_size(const Layout& place, const PictureOptions& options) {
  return {(place.scene[2] - place.scene[0]) * options.width, (place.scene[3] - place.scene[1]) * options.height};
}

void add_spatial_scene(vtkRenderer& renderer, const viz::PictureScene& scene, const PictureOptions& options) {
  const viz::DrawingSize size = drawing_size(layout(options), options);
  const viz::PictureView view = viz::three_quarter_view(scene, size.width / size.height);
  renderer.SetUseDepthPeeling(1);
  renderer.SetMaximumNumberOfPeels(64);
  renderer.SetOcclusionRatio(0);
  viz::add_actors(renderer, scene, view, oversampling(options));
  vtkCamera* camera = renderer.GetActiveCamera();
  camera->SetPosition(view.position.x, view.position.y, view.position.z);
  camera->SetFocalPoint(view.focus.x, view.focus.y, view.focus.z);
  camera->SetViewUp(view.up.x, view.up.y, view.up.z);
  camera->SetViewAngle(view.angle);
  renderer.ResetCameraClippingRange();
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(&renderer);
}

/// Returns: the legend of what has been added.
viz::Legend add_scene(vtkRenderWindow& window, const viz::PictureSource& source, const PictureOptions& options) {
  Layout place = layout(options);
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(place.scene);
  renderer->SetBackground(1, 1, 1);
  window.AddRenderer(renderer);
  if (source.dimension == 2) {
    viz::add_planar_drawing(*renderer, source, drawing_size(place, options));
    return {source.title, viz::planar_legend(source)};
  }
  const viz::PictureScene scene = viz::picture_scene(source);
  add_spatial_scene(*renderer, scene, options);
  return {source.title, viz::legend_entries(scene)};
}

void add_legend(vtkRenderWindow& window, const viz::Legend& legend, const PictureOptions& options) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(layout(options).legend);
  renderer->SetBackground(1, 1, 1);
  window.AddRenderer(renderer);
  viz::add_legend(*renderer, legend, oversampling(options));
}

void write_png(vtkRenderWindow& window, int shrink, const fs::path& file) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(&window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> shrunk;
  shrunk->SetInputConnection(image->GetOutputPort());
  shrunk->SetShrinkFactors(shrink, shrink, 1);
  shrunk->MeanOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(shrunk->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError) {
    throw std::runtime_error(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
}

/// While this object lives, lines win over the polygons whose borders they are. VTK has one setting for all windows.
class LinesInFront {
 public:
  LinesInFront() : before_(vtkMapper::GetResolveCoincidentTopology()) {
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  }
  ~LinesInFront() { vtkMapper::SetResolveCoincidentTopology(before_); }
  LinesInFront(const LinesInFront&) = delete;
  LinesInFront& operator=(const LinesInFront&) = delete;

 private:
  int before_;
};

void draw(const viz::PictureSource& source, const fs::path& png, const PictureOptions& options) {
  const viz::QuietVtk quiet;
  const LinesInFront lines_in_front;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(oversampling(options) * options.width, oversampling(options) * options.height);
  const viz::Legend legend = add_scene(*window, source, options);
  add_legend(*window, legend, options);
  window->Render();

  viz::StagedFolder folder(png.parent_path());
  const viz::StagedFile file = folder.add(png.filename().string());
  try {
    write_png(*window, oversampling(options), file.temporary);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot write " + png.string() + ": " + error.what());
  }
  folder.publish();
}

/// Says what is wrong before anything is read or computed.
void check(const fs::path& png, const PictureOptions& options) {
  if (options.width < 64 || options.height < 64) throw PreconditionError("picture: width and height of at least 64");
  if (png.filename().empty()) throw std::runtime_error("cannot write " + png.string() + ": not the name of a file");
  viz::require_display();
}

std::string title(const std::string& scene) {
  std::string name = fs::path(scene).filename().string();
  for (const std::string ending : {".json", ".scene"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  return name;
}

}  // namespace

void render_scene(const ShadowResult& result, const fs::path& png, const PictureOptions& options) {
  if (result.scene == nullptr) throw PreconditionError("render_scene: a result without a scene");
  check(png, options);
  const bool complete = std::ranges::all_of(result.pairs, &PairResult::supported);
  viz::PictureSource source{title(result.scene->source), complete, result.scene->dimension, result.clip_box, {}};
  for (const viz::Block& block : viz::shadow_blocks(result)) {
    auto surface = vtkSmartPointer<vtkPolyData>(vtkPolyData::SafeDownCast(block.data));
    if (surface != nullptr && !block.empty()) source.blocks.push_back({block.path, block.kind, surface});
  }
  draw(source, png, options);
}

void render_result(const fs::path& directory, const fs::path& png, const PictureOptions& options) {
  check(png, options);
  const viz::ListedResult listed = viz::read_manifest(directory);
  viz::PictureSource source{title(listed.scene), listed.complete, listed.dimension, listed.clip_box, {}};
  for (const viz::ListedBlock& block : listed.blocks) {
    if (fs::path(block.file).extension() != ".vtp") continue;
    source.blocks.push_back({block.path, block.kind, viz::read_surface(directory / block.file)});
  }
  if (source.blocks.empty()) {
    throw std::runtime_error("cannot draw " + directory.string() +
                             ": it holds no surfaces; write it with `gnomon shadow --format vtm` or vtpc");
  }
  draw(source, png, options);
}

}  // namespace gnomon
