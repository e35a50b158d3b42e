#include "viz/picture_scene.h"

#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkNew.h>
#include <vtkPlane.h>

#include <algorithm>
#include <initializer_list>

#include "geometry/spatial/shadow_volume.h"
#include "viz/vector.h"

namespace gnomon::viz {
namespace {

std::vector<Point3> scene_points(const std::vector<PictureBlock>& blocks) {
  std::vector<Point3> points;
  for (const PictureBlock& block : blocks) {
    if (block.path.front() != "scene") continue;
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
  PictureReceiver result{block.path.back(), points_of(*block.data), {}, false};
  result.plane = polygon_plane(result.polygon);
  const auto [low, high] = std::ranges::minmax(scene, {}, [&](const Point3& p) { return result.plane.distance(p); });
  // Walls of real rooms are not quite square.
  const double slack = 0.01 * size;
  const bool front = result.plane.distance(low) >= -slack;
  const bool back = result.plane.distance(high) <= slack;
  result.ends_scene = front != back;
  if (back && !front) {
    result.plane.normal = -1 * result.plane.normal;
    std::ranges::reverse(result.polygon);
  }
  return result;
}

/// The cells of the kinds given. Without the others nothing is drawn twice in one place: blockers cover blocker faces,
/// umbrae cover their boundary with the penumbra.
vtkSmartPointer<vtkPolyData> facets_of(vtkPolyData& surface, std::initializer_list<FacetKind> kinds) {
  vtkDataArray* kind = surface.GetCellData()->GetArray("facet_kind");
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < surface.GetNumberOfCells(); ++i) {
    const auto value = static_cast<FacetKind>(kind == nullptr ? 255 : static_cast<int>(kind->GetComponent(i, 0)));
    if (std::ranges::count(kinds, value) == 0) continue;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    surface.GetCellPoints(i, size, points);
    cells->InsertNextCell(size, points);
  }
  auto facets = vtkSmartPointer<vtkPolyData>::New();
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
    scene.umbras.push_back(ended(facets, scene));
  } else if (block.path.back() == "penumbra") {
    const auto facets =
        facets_of(*block.data, {separating_blocker_plane, separating_light_plane, clip_box, light_plane});
    scene.penumbras.push_back(ended(facets, scene));
  }
}

/// The occlusion paints the penumbra, the umbra paints over it.
void add_shadows(PictureScene& scene, const PictureBlock& block) {
  const bool umbra = block.path.back() == "umbra";
  if (!umbra && block.path.back() != "occlusion") return;
  for (std::size_t i = 0; i < scene.receivers.size(); ++i) {
    const PictureReceiver& receiver = scene.receivers[i];
    Polygon shadow = clipped(section(*block.data, receiver.plane), receiver.polygon, receiver.plane.normal);
    if (!shadow.empty()) scene.shadows.push_back({i, umbra, std::move(shadow)});
  }
}

/// The cells whose array `region` has a value.
vtkSmartPointer<vtkPolyData> cells_of_region(vtkPolyData& surface, int region) {
  vtkDataArray* regions = surface.GetCellData()->GetArray("region");
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < surface.GetNumberOfCells(); ++i) {
    if (regions == nullptr || static_cast<int>(regions->GetComponent(i, 0)) != region) continue;
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    surface.GetCellPoints(i, size, points);
    cells->InsertNextCell(size, points);
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(surface.GetPoints());
  part->SetPolys(cells);
  return part;
}

/// A block `receivers/LIGHT/RECEIVER/faces` or `.../edges`.
void add_mesh(PictureScene& scene, const PictureBlock& block) {
  const auto named = [&](const PictureReceiver& receiver) { return receiver.name == block.path[2]; };
  const auto found = std::ranges::find_if(scene.receivers, named);
  if (found == scene.receivers.end()) return;
  const auto receiver = static_cast<std::size_t>(found - scene.receivers.begin());
  if (block.kind == "receiver_edges") {
    scene.meshes.push_back({receiver, -1, block.data});
    return;
  }
  for (const int region : {0, 1, 2, 3, 4}) {
    const auto part = cells_of_region(*block.data, region);
    if (part->GetNumberOfCells() > 0) scene.meshes.push_back({receiver, region, part});
  }
}

}  // namespace

PictureScene picture_scene(const PictureSource& source) {
  const std::vector<PictureBlock>& blocks = source.blocks;
  const std::vector<Point3> points = scene_points(blocks);
  PictureScene scene;
  scene.title = source.title;
  scene.complete = source.complete;
  scene.size = diagonal(points);
  for (const PictureBlock& block : blocks) {
    if (block.kind == "light") scene.lights.push_back(block);
    if (block.kind == "blocker") scene.blockers.push_back(block);
    if (block.kind == "receiver") scene.receivers.push_back(receiver(block, points, scene.size));
  }
  for (const PictureBlock& block : blocks) {
    if (block.kind == "receiver_faces" || block.kind == "receiver_edges") add_mesh(scene, block);
    if (block.kind == "discontinuities") scene.discontinuities.push_back(block);
    if (block.kind != "volume") continue;
    add_volume(scene, block);
    add_shadows(scene, block);
  }
  std::stable_partition(scene.shadows.begin(), scene.shadows.end(),
                        [](const PaintedShadow& shadow) { return !shadow.umbra; });
  return scene;
}

std::vector<Point3> visible_points(const PictureScene& scene) {
  std::vector<Point3> all;
  const auto add = [&](const std::vector<Point3>& points) { all.insert(all.end(), points.begin(), points.end()); };
  for (const PictureBlock& block : scene.lights) add(points_of(*block.data));
  for (const PictureBlock& block : scene.blockers) add(points_of(*block.data));
  for (const PictureReceiver& receiver : scene.receivers) add(receiver.polygon);
  for (const auto& surface : scene.umbras) add(points_of(*surface));
  for (const auto& surface : scene.penumbras) add(points_of(*surface));
  for (const PictureBlock& block : scene.discontinuities) add(points_of(*block.data));
  return all;
}

}  // namespace gnomon::viz
