#include <algorithm>
#include <cmath>

#include "viz/pictures/picture_items.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

constexpr std::size_t most_names = 8;

Point3 middle_of(const std::vector<Point3>& points) {
  Point3 sum;
  for (const Point3& p : points) sum = sum + p;
  return 1 / static_cast<double>(std::max<std::size_t>(points.size(), 1)) * sum;
}

/// The middle of a polygon, and places toward its corners.
std::vector<Point3> places_on(const Polygon& polygon) {
  const Point3 middle = middle_of(polygon);
  std::vector<Point3> places = {middle};
  const std::size_t step = std::max<std::size_t>(1, polygon.size() / 8);
  for (std::size_t i = 0; i < polygon.size(); i += step) places.push_back(middle + 0.7 * (polygon[i] - middle));
  return places;
}

/// Of the middles of all cells the outermost in each of the 26 directions of a cube's corners, edges and faces: one of
/// them is on the viewer's side, wherever the viewer is. The one that is most so comes first.
std::vector<Point3> places_on(const std::vector<Polygon>& cells, const Point3& viewer) {
  std::vector<Point3> middles;
  for (const Polygon& cell : cells) middles.push_back(middle_of(cell));
  std::vector<Point3> places;
  for (int k = 0; k < 27; ++k) {
    const Point3 way{k / 9 - 1.0, k / 3 % 3 - 1.0, k % 3 - 1.0};
    const Point3& outermost = *std::ranges::max_element(middles, {}, [&](const Point3& p) { return dot(p, way); });
    if (k != 13 && std::ranges::count(places, outermost) == 0) places.push_back(outermost);
  }
  const Point3 toward = unit(viewer - middle_of(middles));
  std::ranges::stable_sort(places, std::greater<>{}, [&](const Point3& p) { return dot(p, toward); });
  return places;
}

/// A point is drawn as a ball: the place over it in the picture, in front of all of it.
Point3 place_over(const Point3& point, const Point3& viewer, const PictureScene& scene) {
  const Point3 toward = unit(viewer - point);
  Point3 above = scene.up - dot(scene.up, toward) * toward;
  if (dot(above, above) < 1e-6) above = cross(toward, std::abs(toward.x) < 0.5 ? Point3{1, 0, 0} : Point3{0, 1, 0});
  return point + ball_radius * scene.size * (1.1 * toward + 2.6 * unit(above));
}

std::vector<Point3> places_on(vtkPolyData& element, const Point3& viewer, const PictureScene& scene) {
  const bool is_point = element.GetNumberOfPolys() == 0 && element.GetNumberOfLines() == 0;
  if (is_point) return {place_over(points_of(element).front(), viewer, scene)};
  const std::vector<Polygon> cells = polygons_of(element);
  if (cells.size() == 1 && cells.front().size() > 2) return places_on(cells.front());
  if (element.GetNumberOfPolys() > 0) return places_on(cells, viewer);
  std::vector<Point3> places;
  for (const Polygon& cell : cells) {
    for (const double share : {0.5, 0.25, 0.75}) {
      places.push_back(cell.front() + share * (cell.back() - cell.front()));
    }
  }
  return places;
}

/// Toward a corner, where no shadow is likely to be; then elsewhere.
std::vector<Point3> places_on(const PictureReceiver& receiver) {
  const Point3 middle = middle_of(receiver.polygon);
  std::vector<Point3> places;
  for (const double share : {0.82, 0.55}) {
    for (const Point3& corner : receiver.polygon) places.push_back(middle + share * (corner - middle));
  }
  places.push_back(middle);
  return places;
}

}  // namespace

std::vector<PictureLabel> picture_labels(const PictureScene& scene, const Point3& viewer) {
  std::vector<PictureLabel> labels;
  for (const PictureBlock& light : scene.lights) {
    const std::string& name = light.path.back();
    labels.push_back({name, places_on(*light.data, viewer, scene), "light", light_mark(scene, name)});
  }
  for (const PictureSun& sun : scene.suns) {
    labels.push_back({sun.name, {}, "light", light_mark(scene, sun.name), {}, true});
  }
  if (scene.blockers.size() <= most_names) {
    for (const PictureBlock& blocker : scene.blockers) {
      labels.push_back({blocker.path.back(), places_on(*blocker.data, viewer, scene), "blocker"});
    }
  }
  if (scene.receivers.size() > most_names) return labels;
  for (const PictureReceiver& receiver : scene.receivers) {
    PictureLabel label{receiver.name, places_on(receiver), "receiver"};
    if (receiver.ends_scene) label.front = receiver.plane;
    labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace gnomon::viz
