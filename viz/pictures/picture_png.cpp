#include "viz/pictures/picture_png.h"

#include <vtkCamera.h>
#include <vtkDepthPeelingPass.h>
#include <vtkErrorCode.h>
#include <vtkImageShrink3D.h>
#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTranslucentPass.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "viz/pictures/display.h"
#include "viz/pictures/picture_actors.h"
#include "viz/pictures/picture_legend.h"
#include "viz/pictures/planar_picture.h"
#include "viz/vtk/quiet_vtk.h"

namespace gnomon::viz {
namespace {

// Drawn twice as large and averaged: edges are smooth, and depth peeling needs a window without multisampling.
int oversampling(const PictureOptions& options) {
  return std::max(options.width, options.height) <= 4096 ? 2 : 1;
}

/// Layers of translucent surfaces that are put in their order. Each costs as much as all that is opaque, and what lies
/// behind a dozen is hardly seen.
constexpr int most_peels = 12;

/// The parts of the picture for the scene and for the legend: xmin, ymin, xmax, ymax, each from 0 to 1.
struct Layout {
  double scene[4];
  double legend[4];
};

Layout layout(const PictureOptions& options) {
  if (options.legend == Shown::no) return {{0, 0, 1, 1}, {0, 0, 0, 0}};
  if (options.width >= options.height) return {{0, 0, 0.79, 1}, {0.79, 0, 1, 1}};
  return {{0, 0.3, 1, 1}, {0, 0, 1, 0.3}};
}

DrawingSize drawing_size(const PictureOptions& options) {
  const Layout place = layout(options);
  return {(place.scene[2] - place.scene[0]) * options.width, (place.scene[3] - place.scene[1]) * options.height};
}

/// VTK's own choice, peeling from both sides, drops all layers but the outermost ones in pictures of some sizes.
void peel_translucent_layers(vtkRenderer& renderer) {
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(translucent);
  peeling->SetMaximumNumberOfPeels(most_peels);
  peeling->SetOcclusionRatio(2e-5);  // a layer of a hundred of five million dots is not seen
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(peeling);
  renderer.SetPass(steps);
}

void add_spatial_scene(vtkRenderer& renderer, const PictureScene& scene, const PictureOptions& options) {
  const DrawingSize size = drawing_size(options);
  const PictureView view = picture_view(scene, options.camera, size);
  const std::vector<PictureItem> items = picture_items(scene);
  peel_translucent_layers(renderer);
  add_actors(renderer, items, view, size, oversampling(options));
  if (options.labels == Shown::yes) {
    const std::vector<PictureLabel> labels = picture_labels(scene, view.position);
    add_labels(renderer, placed_labels(labels, items, scene, view, size, label_letter), size, oversampling(options));
  }
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
Legend add_scene(vtkRenderWindow& window, const PictureSource& source, const PictureOptions& options) {
  Layout place = layout(options);
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(place.scene);
  renderer->SetBackground(1, 1, 1);
  window.AddRenderer(renderer);
  if (source.dimension == 2) {
    add_planar_drawing(*renderer, planar_drawing(source, drawing_size(options), options.labels));
    return {source.title, planar_legend(source)};
  }
  const PictureScene scene = picture_scene(source);
  add_spatial_scene(*renderer, scene, options);
  return {source.title, legend_entries(scene)};
}

void add_legend(vtkRenderWindow& window, const Legend& legend, const PictureOptions& options) {
  if (options.legend == Shown::no) return;
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(layout(options).legend);
  renderer->SetBackground(1, 1, 1);
  window.AddRenderer(renderer);
  add_legend(*renderer, legend, oversampling(options));
}

void write_window(vtkRenderWindow& window, int shrink, const std::filesystem::path& file) {
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
    throw PngError(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
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

}  // namespace

void write_png(const PictureSource& source, const PictureOptions& options, const std::filesystem::path& file) {
  const Display display;
  const QuietVtk quiet;
  const LinesInFront lines_in_front;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(oversampling(options) * options.width, oversampling(options) * options.height);
  const Legend legend = add_scene(*window, source, options);
  add_legend(*window, legend, options);
  window->Render();
  write_window(*window, oversampling(options), file);
}

}  // namespace gnomon::viz
