#include "viz/picture_items.h"

#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <algorithm>

#include "viz/path_text.h"
#include "viz/picture_facets.h"
#include "viz/vector.h"
#include "viz/vtk_cells.h"

namespace gnomon::viz {
namespace {

using Items = std::vector<PictureItem>;

constexpr std::size_t most_labels = 8;

enum class Edges { all, creases };

vtkSmartPointer<vtkPolyData> output(vtkPolyDataAlgorithm& filter) {
  filter.Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(filter.GetOutput());
  return data;
}

/// Borders and creases, not the diagonals of a triangulation.
vtkSmartPointer<vtkPolyData> edges_of(vtkPolyData* data, Edges which) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(data);
  edges->SetFeatureAngle(0.5);
  edges->SetBoundaryEdges(which == Edges::all);
  edges->ColoringOff();
  return output(*edges);
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

PicturePlane turned(const PicturePlane& plane) {
  return {plane.origin, -1 * plane.normal};
}

/// The sides from which what lies on a receiver is seen.
std::vector<PicturePlane> fronts(const PictureReceiver& receiver) {
  if (receiver.ends_scene) return {receiver.plane};
  return {receiver.plane, turned(receiver.plane)};
}

Polygon facing(Polygon polygon, const PictureReceiver& receiver, const PicturePlane& front) {
  if (dot(front.normal, receiver.plane.normal) < 0) std::ranges::reverse(polygon);
  return polygon;
}

void add_receivers(Items& items, const PictureScene& scene) {
  for (const PictureReceiver& receiver : scene.receivers) {
    for (const PicturePlane& front : fronts(receiver)) {
      const Polygon polygon = facing(receiver.polygon, receiver, front);
      items.push_back({receiver.name, polygon_data(polygon, {}), {palette.receiver, 1, 0.8}, front});
    }
    PictureItem outline{"", outline_data(receiver.polygon, {}), {palette.edge, 1, 1, 1}};
    if (receiver.ends_scene) outline.front = receiver.plane;
    items.push_back(std::move(outline));
  }
}

void add_shadows(Items& items, const PictureScene& scene) {
  for (const PaintedShadow& shadow : scene.shadows) {
    const PictureReceiver& receiver = scene.receivers[shadow.receiver];
    const Color& color = shadow.umbra ? palette.umbra : palette.penumbra;
    const std::string name = (shadow.umbra ? "umbra on " : "penumbra on ") + receiver.name;
    for (const PicturePlane& front : fronts(receiver)) {
      const double layer = scene.size * (shadow.umbra ? 3e-4 : 1e-4);
      const Polygon polygon = facing(shadow.polygon, receiver, front);
      items.push_back({name, polygon_data(polygon, layer * front.normal), {color, 1, 0.9}, front});
      const Point3 lift = (layer + 1e-4 * scene.size) * front.normal;
      items.push_back({"", outline_data(polygon, lift), {palette.edge, 1, 1, 1}, front});
    }
  }
}

/// The receiver that a block under `receivers/` divides; nothing if the scene does not draw it.
const PictureReceiver* receiver_of(const PictureScene& scene, const PictureBlock& block) {
  const auto found = std::ranges::find_if(scene.receivers, [&](const PictureReceiver& receiver) {
    return std::ranges::count(block.path, receiver.name) > 0;
  });
  return found == scene.receivers.end() ? nullptr : &*found;
}

vtkSmartPointer<vtkPolyData> lifted(vtkPolyData& data, const Point3& shift) {
  std::vector<Point3> points = points_of(data);
  for (Point3& p : points) p = p + shift;
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(&data);
  moved->SetPoints(vtk_points(points));
  return moved;
}

void add_divided_receiver(Items& items, const PictureScene& scene, const PictureBlock& block) {
  const PictureReceiver* receiver = receiver_of(scene, block);
  const std::vector<PicturePlane> sides = receiver == nullptr ? std::vector<PicturePlane>{{}} : fronts(*receiver);
  for (const PicturePlane& side : sides) {
    const auto data = lifted(*block.data, 1e-4 * scene.size * side.normal);
    const auto front = receiver == nullptr ? std::nullopt : std::optional(side);
    for (const RegionFacets& part : region_facets(*data)) {
      items.push_back({joined(block.path) + ": " + part.name, part.data, {part.color, 1, 0.9}, front});
    }
    const auto above = lifted(*block.data, 2e-4 * scene.size * side.normal);
    for (const OrderedFacets& part : ordered_lines(*above)) {
      items.push_back({part.name, part.data, {part.color, 1, 1, 2}, front});
    }
  }
}

void add_discontinuities(Items& items, const PictureScene& scene) {
  for (const PictureBlock& block : scene.discontinuities) {
    for (const OrderedFacets& part : ordered_surfaces(*block.data)) {
      items.push_back({joined(block.path) + ": " + part.name, part.data, {part.color, 0.4, 0.6}});
      items.push_back({"", edges_of(part.data, Edges::all), {part.color, 0.9, 1, 1.5}});
    }
    for (const OrderedFacets& part : ordered_lines(*block.data)) {
      items.push_back({part.name, part.data, {part.color, 1, 1, 2}});
    }
  }
}

std::vector<std::string> plane_names(const PictureBlock& volume) {
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < volume.data->GetNumberOfCells(); ++i) names.push_back(plane_name(volume, i));
  return names;
}

// The borders of volumes are drawn already: they are edges of blockers and of painted shadows.
void add_volumes(Items& items, const std::vector<PictureBlock>& volumes, const Color& color, double opacity) {
  for (const PictureBlock& block : volumes) {
    const std::string name = block.path.back() + " of " + block.path.at(2) + ", " + block.path.at(1);
    items.push_back({name, block.data, {color, opacity, 0.6}, {}, plane_names(block)});
    items.push_back({"", edges_of(block.data, Edges::creases), {color, 0.9, 1, 1.5}});
  }
}

vtkSmartPointer<vtkPolyData> rod(vtkPolyData* line, double radius) {
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(radius);
  tube->SetNumberOfSides(24);
  tube->CappingOn();
  return output(*tube);
}

vtkSmartPointer<vtkPolyData> ball(const Point3& centre, double radius) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(24);
  return output(*sphere);
}

void add_light(Items& items, const PictureBlock& light, double size) {
  const std::string& name = light.path.back();
  const Look look{palette.light, 1, 0.9};
  if (light.data->GetNumberOfPolys() > 0) {
    items.push_back({name, light.data, look});
    items.push_back({"", edges_of(light.data, Edges::all), {palette.edge, 1, 1, 1.5}});
  } else if (light.data->GetNumberOfLines() > 0) {
    items.push_back({name, rod(light.data, 0.006 * size), look});
  } else {
    items.push_back({name, ball(points_of(*light.data).front(), 0.012 * size), look});
  }
}

void add_labels(std::vector<PictureLabel>& labels, const std::vector<PictureBlock>& blocks, const Point3& lift) {
  if (blocks.size() > most_labels) return;
  for (const PictureBlock& block : blocks) {
    const std::vector<Point3> points = points_of(*block.data);
    Point3 middle;
    double top = dot(points.front(), lift);
    for (const Point3& p : points) {
      middle = middle + 1 / static_cast<double>(points.size()) * p;
      top = std::max(top, dot(p, lift));
    }
    const double climb = (top - dot(middle, lift)) / std::max(dot(lift, lift), 1e-300);
    labels.push_back({middle + (climb + 1) * lift, block.path.back()});
  }
}

}  // namespace

std::vector<PictureItem> picture_items(const PictureScene& scene) {
  Items items;
  add_receivers(items, scene);
  add_shadows(items, scene);
  for (const PictureBlock& block : scene.divided_receivers) add_divided_receiver(items, scene, block);
  for (const PictureBlock& light : scene.lights) add_light(items, light, scene.size);
  for (const PictureBlock& blocker : scene.blockers) {
    items.push_back({blocker.path.back(), blocker.data, {palette.blocker, 1, 0.6}});
    items.push_back({"", edges_of(blocker.data, Edges::all), {palette.edge, 1, 1, 1.5}});
  }
  add_discontinuities(items, scene);
  add_volumes(items, scene.umbras, palette.umbra, 0.5);
  add_volumes(items, scene.penumbras, palette.penumbra, 0.33);
  return items;
}

std::vector<PictureLabel> picture_labels(const PictureScene& scene, const Point3& up) {
  std::vector<PictureLabel> labels;
  const Point3 lift = 0.02 * scene.size * up;
  add_labels(labels, scene.lights, lift);
  add_labels(labels, scene.blockers, lift);
  if (scene.receivers.size() > most_labels) return labels;
  for (const PictureReceiver& receiver : scene.receivers) {
    // In a corner, where no shadow is likely to be.
    const Point3& corner = receiver.polygon.front();
    const Point3& opposite = receiver.polygon[receiver.polygon.size() / 2];
    PictureLabel label{corner + 0.08 * (opposite - corner), receiver.name};
    if (receiver.ends_scene) label.front = receiver.plane;
    labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace gnomon::viz
