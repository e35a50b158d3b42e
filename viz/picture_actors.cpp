#include "viz/picture_actors.h"

#include <vtkActor.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include "viz/palette.h"
#include "viz/vector.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

/// How a surface or line looks.
struct Look {
  Color color;
  double opacity = 1;
  double ambient = 0.55;
  double line_width = 1;
};

vtkActor* add_actor(vtkRenderer& renderer, vtkPolyDataMapper* mapper, const Look& look) {
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(look.color[0], look.color[1], look.color[2]);
  property->SetOpacity(look.opacity);
  property->SetAmbient(look.ambient);
  property->SetDiffuse(1 - look.ambient);
  property->SetSpecular(0);
  property->SetInterpolationToFlat();
  property->SetLineWidth(static_cast<float>(look.line_width));
  renderer.AddActor(actor);
  return actor;
}

void add_data(vtkRenderer& renderer, vtkPolyData* data, const Look& look) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  add_actor(renderer, mapper, look);
}

void add_filter(vtkRenderer& renderer, vtkAlgorithm& filter, const Look& look) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(filter.GetOutputPort());
  add_actor(renderer, mapper, look);
}

enum class Edges { all, creases };

/// Borders and creases, not the diagonals of a triangulation.
void add_edges(vtkRenderer& renderer, vtkPolyData* data, const Look& look, Edges which = Edges::all) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(data);
  edges->SetFeatureAngle(0.5);
  edges->SetBoundaryEdges(which == Edges::all);
  edges->ColoringOff();
  add_filter(renderer, *edges, look);
}

vtkSmartPointer<vtkPolyData> polygon_data(const Polygon& polygon, const Point3& shift) {
  Polygon moved;
  std::vector<std::size_t> indices;
  for (const Point3& p : polygon) {
    indices.push_back(moved.size());
    moved.push_back(p + shift);
  }
  vtkNew<vtkCellArray> cells;
  insert_cell(*cells, indices);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(moved));
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> outline_data(const Polygon& polygon, const Point3& shift) {
  auto data = polygon_data(polygon, shift);
  vtkNew<vtkCellArray> line;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i <= polygon.size(); ++i) indices.push_back(i % polygon.size());
  insert_cell(*line, indices);
  data->SetPolys(nullptr);
  data->SetLines(line);
  return data;
}

void add_receivers(vtkRenderer& renderer, const PictureScene& scene, const PictureView& view, double pixel) {
  for (const PictureReceiver& receiver : scene.receivers) {
    const bool filled = is_seen_from_inside(receiver, view);
    if (filled) add_data(renderer, polygon_data(receiver.polygon, {}), {palette.receiver, 1, 0.8});
    const Look outline{palette.edge, filled ? 1 : 0.35, 1, pixel};
    add_data(renderer, outline_data(receiver.polygon, {}), outline);
  }
}

// Each layer lies a little above the one below it, less than a pixel of the picture.
void add_shadows(vtkRenderer& renderer, const PictureScene& scene, const PictureView& view, double pixel) {
  for (const PaintedShadow& shadow : scene.shadows) {
    const PictureReceiver& receiver = scene.receivers[shadow.receiver];
    if (!is_seen_from_inside(receiver, view)) continue;
    const double side = receiver.plane.distance(view.position) > 0 ? 1 : -1;
    const double layer = side * scene.size * (shadow.umbra ? 3e-4 : 1e-4);
    const Color& color = shadow.umbra ? palette.umbra : palette.penumbra;
    add_data(renderer, polygon_data(shadow.polygon, layer * receiver.plane.normal), {color, 1, 0.9});
    const Point3 lift = (layer + side * 1e-4 * scene.size) * receiver.plane.normal;
    add_data(renderer, outline_data(shadow.polygon, lift), {palette.edge, 1, 1, pixel});
  }
}

// Triangles lie a little above the receiver, lines a little above these.
void add_meshes(vtkRenderer& renderer, const PictureScene& scene, const PictureView& view, double pixel) {
  for (const PaintedMesh& mesh : scene.meshes) {
    const PictureReceiver& receiver = scene.receivers[mesh.receiver];
    if (!is_seen_from_inside(receiver, view)) continue;
    const double side = receiver.plane.distance(view.position) > 0 ? 1 : -1;
    const Point3 lift = side * scene.size * (mesh.region < 0 ? 4e-4 : 2e-4) * receiver.plane.normal;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh.data);
    const double width = mesh.region < 0 ? 0.5 * pixel : 1;
    vtkActor* actor = add_actor(renderer, mapper, {region_color(mesh.region), 1, 0.9, width});
    actor->SetPosition(lift.x, lift.y, lift.z);
  }
}

void add_discontinuities(vtkRenderer& renderer, const PictureScene& scene, double pixel) {
  for (const PictureBlock& block : scene.discontinuities) {
    const Color color = order_color(block.path.back().back() - '0');
    add_data(renderer, block.data, {color, 0.12, 0.8});
    add_edges(renderer, block.data, {color, 0.5, 1, 0.5 * pixel});
  }
}

// The borders of volumes are drawn already: they are edges of blockers and of painted shadows.
void add_volumes(vtkRenderer& renderer, const PictureScene& scene, double pixel) {
  for (const auto& surface : scene.umbras) {
    add_data(renderer, surface, {palette.umbra, 0.5, 0.6});
    add_edges(renderer, surface, {palette.umbra, 0.9, 1, 1.5 * pixel}, Edges::creases);
  }
  for (const auto& surface : scene.penumbras) {
    add_data(renderer, surface, {palette.penumbra, 0.33, 0.6});
    add_edges(renderer, surface, {palette.penumbra, 0.9, 1, 1.5 * pixel}, Edges::creases);
  }
}

/// A light may have no extent: a point becomes a ball, a segment a rod.
void add_light(vtkRenderer& renderer, const PictureBlock& light, double size, double pixel) {
  const Look look{palette.light, 1, 0.9};
  if (light.data->GetNumberOfPolys() > 0) {
    add_data(renderer, light.data, look);
    add_edges(renderer, light.data, {palette.edge, 1, 1, 1.5 * pixel});
  } else if (light.data->GetNumberOfLines() > 0) {
    vtkNew<vtkTubeFilter> rod;
    rod->SetInputData(light.data);
    rod->SetRadius(0.006 * size);
    rod->SetNumberOfSides(24);
    rod->CappingOn();
    add_filter(renderer, *rod, look);
  } else {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(light.data->GetPoint(0));
    ball->SetRadius(0.012 * size);
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(24);
    add_filter(renderer, *ball, look);
  }
}

}  // namespace

void add_actors(vtkRenderer& renderer, const PictureScene& scene, const PictureView& view, double pixel) {
  add_receivers(renderer, scene, view, pixel);
  add_shadows(renderer, scene, view, pixel);
  add_meshes(renderer, scene, view, pixel);
  add_discontinuities(renderer, scene, pixel);
  for (const PictureBlock& light : scene.lights) add_light(renderer, light, scene.size, pixel);
  for (const PictureBlock& blocker : scene.blockers) {
    add_data(renderer, blocker.data, {palette.blocker, 1, 0.6});
    add_edges(renderer, blocker.data, {palette.edge, 1, 1, 1.5 * pixel});
  }
  add_volumes(renderer, scene, pixel);
}

}  // namespace gnomon::viz
