#include "viz/pictures/picture_items.h"

#include <vtkArrowSource.h>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>

#include "viz/pictures/plane_name.h"
#include "viz/vtk/block.h"
#include "viz/vtk/facet_groups.h"
#include "viz/vtk/vector.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using Items = std::vector<PictureItem>;

enum class Edges { all, creases, borders };

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
  edges->SetBoundaryEdges(which != Edges::creases);
  edges->SetFeatureEdges(which != Edges::borders);
  edges->SetNonManifoldEdges(which != Edges::borders);
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

Polygon reversed(Polygon polygon) {
  std::ranges::reverse(polygon);
  return polygon;
}

/// Lights of which each shows a receiver in its own way; one without a name where there are none.
std::vector<std::string> lights_of(const PictureScene& scene) {
  return scene.light_names.empty() ? std::vector<std::string>{""} : scene.light_names;
}

/// A side of a receiver that bears no regions.
void add_plain_side(Items& items, const PictureScene& scene, const PictureReceiver& receiver, const std::string& light,
                    const PicturePlane& front) {
  const bool back = dot(front.normal, receiver.plane.normal) < 0;
  const Polygon polygon = back ? reversed(receiver.polygon) : receiver.polygon;
  items.push_back({back ? "back of " + receiver.name : receiver.name,
                   polygon_data(polygon, {}),
                   {palette.receiver, 1, 0.8},
                   "receiver",
                   light_mark(scene, light),
                   front});
}

void add_receiver(Items& items, const PictureScene& scene, const PictureReceiver& receiver) {
  if (receiver.turned_away && receiver.has_twin) return;
  PictureItem outline{"", outline_data(receiver.polygon, {}), {palette.edge, 1, 1, 1}, "outline"};
  if (receiver.ends_scene) outline.front = receiver.plane;
  items.push_back(std::move(outline));
  const bool has_back = !receiver.ends_scene && !receiver.has_twin;
  for (const std::string& light : lights_of(scene)) {
    if (!is_divided(scene, receiver.name, light)) add_plain_side(items, scene, receiver, light, receiver.plane);
    if (has_back) add_plain_side(items, scene, receiver, light, turned(receiver.plane));
  }
}

/// A receiver of several facets, where it bears no regions.
void add_receiver_mesh(Items& items, const PictureScene& scene, const PictureBlock& mesh) {
  items.push_back({"", edges_of(mesh.data, Edges::all), {palette.edge, 1, 1, 1}, "outline"});
  for (const std::string& light : lights_of(scene)) {
    if (is_divided(scene, mesh.path.back(), light)) continue;
    items.push_back({mesh.path.back(), mesh.data, {palette.receiver, 1, 0.8}, "receiver", light_mark(scene, light)});
  }
}

/// Where what is painted on a receiver is moved to, point by point, and the side that it is seen from; none if the
/// scene does not draw the receiver.
struct PaintedSide {
  std::vector<Point3> normals;
  std::optional<PicturePlane> front = {};
};

/// The facets of one receiver share no points, so that each point has one normal. Faces and edges have the same points.
PaintedSide side_of_facets(const PictureScene& scene, const PictureBlock& block) {
  const auto bears_faces = [&](const PictureBlock& other) {
    return other.path.at(1) == block.path.at(1) && other.path.at(2) == block.path.at(2) &&
           other.data->GetNumberOfPolys() > 0;
  };
  const std::vector<Point3> points = points_of(*block.data);
  PaintedSide side{std::vector<Point3>(points.size())};
  const auto faces = std::ranges::find_if(scene.divided_receivers, bears_faces);
  if (!bears_faces(block) && faces == scene.divided_receivers.end()) return side;
  vtkPolyData& data = *(bears_faces(block) ? block : *faces).data;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    data.GetCellPoints(i, ids);
    Polygon polygon;
    for (const vtkIdType id : *ids) polygon.push_back(points.at(static_cast<std::size_t>(id)));
    const Point3 normal = polygon_plane(polygon).normal;
    for (const vtkIdType id : *ids) side.normals.at(static_cast<std::size_t>(id)) = normal;
  }
  return side;
}

/// The side of the receiver that a block under `receivers/` divides.
std::optional<PaintedSide> painted_side(const PictureScene& scene, const PictureBlock& block) {
  const std::string& name = block.path.at(2);
  const auto found = std::ranges::find(scene.receivers, name, &PictureReceiver::name);
  if (found != scene.receivers.end()) {
    if (found->turned_away && found->has_twin) return {};
    return PaintedSide{std::vector<Point3>(points_of(*block.data).size(), found->plane.normal), found->plane};
  }
  const auto is_called = [&](const PictureBlock& mesh) { return mesh.path.back() == name; };
  if (std::ranges::none_of(scene.receiver_meshes, is_called)) return {};
  return side_of_facets(scene, block);
}

vtkSmartPointer<vtkPolyData> lifted(vtkPolyData& data, const PaintedSide& side, double height) {
  std::vector<Point3> points = points_of(data);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = points[i] + height * side.normals.at(i);
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(&data);
  moved->SetPoints(vtk_points(points));
  return moved;
}

/// Regions with their borders, in the colours of the legend whatever the light of the picture.
void add_regions(Items& items, const PictureScene& scene, const PictureBlock& block, const PaintedSide& side) {
  const std::string light = light_mark(scene, block.path.at(1));
  for (const RegionFacets& part : region_facets(*lifted(*block.data, side, 1e-4 * scene.size))) {
    const std::string name = part.name + " on " + block.path.at(2);
    items.push_back({name, part.data, {part.color, 1, 1}, part.name, light, side.front});
  }
  for (const RegionFacets& part : region_facets(*lifted(*block.data, side, 2e-4 * scene.size))) {
    items.push_back({"", edges_of(part.data, Edges::borders), {palette.edge, 1, 1, 1}, part.name, light, side.front});
  }
}

/// The colours of irradiances that are all finite but at lights themselves.
std::vector<Color> irradiance_colors(vtkPolyData& data, const RoundScale& scale) {
  vtkDataArray* values = data.GetPointData()->GetArray("irradiance");
  std::vector<Color> colors;
  for (vtkIdType i = 0; values != nullptr && i < values->GetNumberOfTuples(); ++i) {
    colors.push_back(colour_of_share(values->GetComponent(i, 0) / scale.top()));
  }
  return colors;
}

void add_painted_receiver(Items& items, const PictureScene& scene, const PictureBlock& block) {
  const std::optional<PaintedSide> side = painted_side(scene, block);
  if (!side) return;
  const std::string& light = block.path.at(1);
  PictureItem item{"irradiance on " + block.path.at(2),
                   lifted(*block.data, *side, 1e-4 * scene.size),
                   {palette.lit, 1, 1},
                   "irradiance",
                   light_mark(scene, light),
                   side->front};
  item.point_colors = irradiance_colors(*block.data, irradiance_scale(scene, light));
  items.push_back(std::move(item));
}

void add_divided_receiver(Items& items, const PictureScene& scene, const PictureBlock& block) {
  const std::optional<PaintedSide> side = painted_side(scene, block);
  if (!side || is_painted(scene, block)) return;
  add_regions(items, scene, block, *side);
  for (const OrderedFacets& part : ordered_lines(*lifted(*block.data, *side, 3e-4 * scene.size))) {
    items.push_back(
        {part.name, part.data, {part.color, 1, 1, 2}, part.name, light_mark(scene, block.path.at(1)), side->front});
  }
}

void add_discontinuities(Items& items, const PictureScene& scene) {
  for (const PictureBlock& block : scene.discontinuities) {
    const std::string light = light_mark(scene, block.path.at(1));
    for (const OrderedFacets& part : ordered_surfaces(*block.data)) {
      items.push_back({joined(block.path) + ": " + part.name, part.data, {part.color, 0.4, 0.6}, part.name, light});
      items.push_back({"", edges_of(part.data, Edges::all), {part.color, 0.9, 1, 1.5}, part.name, light});
    }
    for (const OrderedFacets& part : ordered_lines(*block.data)) {
      items.push_back({part.name, part.data, {part.color, 1, 1, 2}, part.name, light});
    }
  }
}

std::vector<std::string> plane_names(const PictureBlock& volume) {
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < volume.data->GetNumberOfCells(); ++i) names.push_back(plane_name(volume, i));
  return names;
}

// The borders of volumes are drawn already: they are edges of blockers and of regions on receivers.
void add_volumes(Items& items, const PictureScene& scene, const std::vector<PictureBlock>& volumes, const Color& color,
                 double opacity) {
  for (const PictureBlock& block : volumes) {
    const std::string light = light_mark(scene, block.path.at(1));
    const std::string layer = block.path.back() + " volume";
    const std::string name = block.path.back() + " of " + block.path.at(2) + ", " + block.path.at(1);
    items.push_back({name, block.data, {color, opacity, 0.6}, layer, light, {}, plane_names(block)});
    items.push_back({"", edges_of(block.data, Edges::creases), {color, 0.9, 1, 1.5}, layer, light});
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

void add_light(Items& items, const PictureScene& scene, const PictureBlock& light) {
  const std::string& name = light.path.back();
  const std::string mark = light_mark(scene, name);
  const Look look{palette.light, 1, 0.9};
  if (light.data->GetNumberOfPolys() > 0) {
    // One that is flush with a ceiling or a wall is seen from its front.
    const std::vector<Point3> points = points_of(*light.data);
    const PaintedSide side{std::vector<Point3>(points.size(), polygon_plane(points).normal)};
    const auto data = lifted(*light.data, side, 4e-4 * scene.size);
    items.push_back({name, data, look, "light", mark});
    items.push_back({"", edges_of(data, Edges::all), {palette.edge, 1, 1, 1.5}, "light", mark});
  } else if (light.data->GetNumberOfLines() > 0) {
    items.push_back({name, rod(light.data, 0.006 * scene.size), look, "light", mark});
  } else {
    items.push_back({name, ball(points_of(*light.data).front(), ball_radius * scene.size), look, "light", mark});
  }
}

/// An arrow of length 1 along x, about the origin.
vtkSmartPointer<vtkPolyData> arrow_along(const Point3& direction) {
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(24);
  arrow->SetShaftResolution(24);
  arrow->SetTipRadius(0.16);
  arrow->SetTipLength(0.4);
  arrow->SetShaftRadius(0.05);
  arrow->Update();
  const Point3 up = unit(cross(direction, std::abs(direction.z) < 0.9 ? Point3{0, 0, 1} : Point3{1, 0, 0}));
  const Point3 aside = cross(direction, up);
  std::vector<Point3> points;
  for (const Point3& p : points_of(*arrow->GetOutput())) {
    points.push_back((p.x - 0.5) * direction + p.y * up + p.z * aside);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetPolys(arrow->GetOutput()->GetPolys());
  return data;
}

void add_sun(Items& items, const PictureScene& scene, const PictureSun& sun) {
  PictureItem item{sun.name, arrow_along(sun.direction), {palette.light, 1, 0.7}, "light", light_mark(scene, sun.name)};
  item.in_corner = true;
  items.push_back(std::move(item));
}

}  // namespace

std::string light_mark(const PictureScene& scene, const std::string& light) {
  return scene.light_names.size() > 1 ? light : std::string{};
}

bool is_divided(const PictureScene& scene, const std::string& receiver, const std::string& light) {
  const auto bears = [&](const PictureBlock& block) {
    return block.path.at(1) == light && block.path.at(2) == receiver && block.data->GetNumberOfPolys() > 0;
  };
  return std::ranges::any_of(scene.divided_receivers, bears) || std::ranges::any_of(scene.painted_receivers, bears);
}

bool is_painted(const PictureScene& scene, const PictureBlock& block) {
  return std::ranges::any_of(scene.painted_receivers, [&](const PictureBlock& other) {
    return other.path.at(1) == block.path.at(1) && other.path.at(2) == block.path.at(2);
  });
}

RoundScale irradiance_scale(const PictureScene& scene, const std::string& light) {
  double largest = 0;
  for (const PictureBlock& block : scene.painted_receivers) {
    vtkDataArray* values = block.path.at(1) == light ? block.data->GetPointData()->GetArray("irradiance") : nullptr;
    for (vtkIdType i = 0; values != nullptr && i < values->GetNumberOfTuples(); ++i) {
      const double value = values->GetComponent(i, 0);
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  }
  return round_scale(largest);
}

std::vector<PictureItem> picture_items(const PictureScene& scene) {
  Items items;
  for (const PictureReceiver& receiver : scene.receivers) add_receiver(items, scene, receiver);
  for (const PictureBlock& mesh : scene.receiver_meshes) add_receiver_mesh(items, scene, mesh);
  for (const PictureBlock& block : scene.divided_receivers) add_divided_receiver(items, scene, block);
  for (const PictureBlock& block : scene.painted_receivers) add_painted_receiver(items, scene, block);
  for (const PictureBlock& light : scene.lights) add_light(items, scene, light);
  for (const PictureSun& sun : scene.suns) add_sun(items, scene, sun);
  for (const PictureBlock& blocker : scene.blockers) {
    items.push_back({blocker.path.back(), blocker.data, {palette.blocker, 1, 0.6}, "blocker"});
    items.push_back({"", edges_of(blocker.data, Edges::all), {palette.edge, 1, 1, 1.5}, "blocker"});
  }
  add_discontinuities(items, scene);
  add_volumes(items, scene, scene.umbras, palette.umbra, 0.5);
  add_volumes(items, scene, scene.penumbras, palette.penumbra, 0.33);
  return items;
}

}  // namespace gnomon::viz
