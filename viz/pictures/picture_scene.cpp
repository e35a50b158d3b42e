#include "viz/pictures/picture_scene.h"

#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>

#include "gnomon/shadow_volume.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

/// Lights without a place are drawn as arrows, which are lines beside the scene.
bool is_sun(const PictureBlock& block) {
  auto* shape = vtkStringArray::SafeDownCast(block.data->GetFieldData()->GetAbstractArray("shape"));
  return block.kind == "light" && shape != nullptr && shape->GetNumberOfValues() > 0 &&
         shape->GetValue(0) == "direction";
}

PictureSun sun(const PictureBlock& block) {
  const std::vector<Point3> points = points_of(*block.data);
  return {block.path.back(), unit(points.at(1) - points.at(0))};
}

std::vector<Point3> scene_points(const std::vector<PictureBlock>& blocks) {
  std::vector<Point3> points;
  for (const PictureBlock& block : blocks) {
    if (block.path.front() != "scene" || is_sun(block)) continue;
    const std::vector<Point3> more = points_of(*block.data);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

double diagonal(const std::vector<Point3>& points) {
  vtkBoundingBox box;
  for (const Point3& p : points) box.AddPoint(p.x, p.y, p.z);
  return box.IsValid() && box.GetDiagonalLength() > 0 ? box.GetDiagonalLength() : 1;
}

PictureReceiver receiver(const PictureBlock& block, const std::vector<Point3>& scene, double size) {
  PictureReceiver result{block.path.back(), points_of(*block.data), {}, false, false, false};
  result.plane = polygon_plane(result.polygon);
  const auto [low, high] = std::ranges::minmax(scene, {}, [&](const Point3& p) { return result.plane.distance(p); });
  // Walls of real rooms are not quite square.
  const double slack = 0.01 * size;
  const bool front = result.plane.distance(low) >= -slack;
  const bool back = result.plane.distance(high) <= slack;
  result.ends_scene = front != back;
  if (back && !front) {
    result.turned_away = true;
    result.plane.normal = -1 * result.plane.normal;
    std::ranges::reverse(result.polygon);
  }
  return result;
}

/// Receivers that are two sides of one polygon have the same points.
void find_twins(std::vector<PictureReceiver>& receivers) {
  using Key = std::vector<std::array<double, 3>>;
  const auto key = [](const PictureReceiver& receiver) {
    Key points;
    for (const Point3& p : receiver.polygon) points.push_back({p.x, p.y, p.z});
    std::ranges::sort(points);
    return points;
  };
  std::map<Key, int> counts;
  for (const PictureReceiver& receiver : receivers) ++counts[key(receiver)];
  for (PictureReceiver& receiver : receivers) receiver.has_twin = counts[key(receiver)] > 1;
}

/// The cells of the kinds given, with their arrays. Without the others nothing is drawn twice in one place: blockers
/// cover blocker faces, umbrae cover their boundary with the penumbra.
vtkSmartPointer<vtkPolyData> facets_of(vtkPolyData& surface, std::initializer_list<FacetKind> kinds) {
  vtkDataArray* kind = surface.GetCellData()->GetArray("facet_kind");
  auto facets = vtkSmartPointer<vtkPolyData>::New();
  facets->GetCellData()->CopyAllocate(surface.GetCellData());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < surface.GetNumberOfCells(); ++i) {
    const auto value = static_cast<FacetKind>(kind == nullptr ? 255 : static_cast<int>(kind->GetComponent(i, 0)));
    if (std::ranges::count(kinds, value) == 0) continue;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    surface.GetCellPoints(i, size, points);
    facets->GetCellData()->CopyData(surface.GetCellData(), i, cells->InsertNextCell(size, points));
  }
  facets->SetPoints(surface.GetPoints());
  facets->SetPolys(cells);
  return facets;
}

/// The part of the surface above every receiver that ends the scene, left open there: the receiver closes it.
vtkSmartPointer<vtkPolyData> ended(vtkSmartPointer<vtkPolyData> surface, const PictureScene& scene) {
  for (const PictureReceiver& end : scene.receivers) {
    if (!end.ends_scene) continue;
    const Point3 origin = end.plane.origin + 5e-4 * scene.size * end.plane.normal;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.x, origin.y, origin.z);
    plane->SetNormal(end.plane.normal.x, end.plane.normal.y, end.plane.normal.z);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(surface);
    clip->SetClipFunction(plane);
    clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    clip->Update();
    surface = vtkSmartPointer<vtkPolyData>::New();
    surface->ShallowCopy(clip->GetOutput());
  }
  // Points that no cell uses would be framed, and clipping leaves doubled points, which would look like edges.
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->SetTolerance(1e-9);
  clean->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clean->Update();
  auto cleaned = vtkSmartPointer<vtkPolyData>::New();
  cleaned->ShallowCopy(clean->GetOutput());
  return cleaned;
}

void add_volume(PictureScene& scene, const PictureBlock& block) {
  using enum FacetKind;
  if (block.path.back() == "umbra") {
    const auto facets = facets_of(*block.data, {separating_blocker_plane, separating_light_plane,
                                                supporting_blocker_plane, clip_box, light_plane});
    scene.umbras.push_back({block.path, block.kind, ended(facets, scene)});
  } else if (block.path.back() == "penumbra") {
    const auto facets =
        facets_of(*block.data, {separating_blocker_plane, separating_light_plane, clip_box, light_plane});
    scene.penumbras.push_back({block.path, block.kind, ended(facets, scene)});
  }
}

}  // namespace

PictureScene picture_scene(const PictureSource& source) {
  const std::vector<Point3> points = scene_points(source.blocks);
  PictureScene scene;
  scene.title = source.title;
  scene.size = diagonal(points);
  if (source.up == UpAxis::y) scene.up = {0, 1, 0};
  scene.light_names = source.lights;
  scene.light_count = source.light_count;
  for (const PictureBlock& block : source.blocks) {
    if (is_sun(block)) {
      scene.suns.push_back(sun(block));
    } else if (block.kind == "light") {
      scene.lights.push_back(block);
    }
    if (block.kind == "blocker") scene.blockers.push_back(block);
    if (block.kind == "receiver") scene.receivers.push_back(receiver(block, points, scene.size));
    if (block.kind == "receiver_mesh") scene.receiver_meshes.push_back(block);
    if (block.path.front() == "receivers") {
      const bool painted = block.kind == "receiver_irradiance";
      (painted ? scene.painted_receivers : scene.divided_receivers).push_back(block);
    }
    if (block.path.front() == "discontinuities") scene.discontinuities.push_back(block);
  }
  find_twins(scene.receivers);
  for (const PictureBlock& block : source.blocks) {
    if (block.kind == "volume") add_volume(scene, block);
  }
  return scene;
}

std::vector<Point3> visible_points(const PictureScene& scene) {
  std::vector<Point3> all;
  const auto add = [&](const std::vector<Point3>& points) { all.insert(all.end(), points.begin(), points.end()); };
  for (const PictureBlock& block : scene.lights) add(points_of(*block.data));
  for (const PictureBlock& block : scene.blockers) add(points_of(*block.data));
  for (const PictureReceiver& receiver : scene.receivers) add(receiver.polygon);
  for (const PictureBlock& block : scene.receiver_meshes) add(points_of(*block.data));
  for (const PictureBlock& block : scene.umbras) add(points_of(*block.data));
  for (const PictureBlock& block : scene.penumbras) add(points_of(*block.data));
  return all;
}

}  // namespace gnomon::viz
