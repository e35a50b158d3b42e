#include "apps/gnomon/light_path.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <variant>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/point_table.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

Point3 moved(const Point3& p, const Point3& first, const Point3& place) {
  return {p.x == first.x ? place.x : p.x + (place.x - first.x), p.y == first.y ? place.y : p.y + (place.y - first.y),
          p.z == first.z ? place.z : p.z + (place.z - first.z)};
}

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// A light at another place. Empty where rounding has made it another shape.
struct MovedLight {
  Point3 place;

  std::optional<Light> operator()(const PointLight&) const { return PointLight{place}; }
  std::optional<Light> operator()(const DirectionalLight&) const {
    throw UnsupportedError("--path: a directional light comes from infinitely far away, and cannot be moved");
  }
  std::optional<Light> operator()(const LinearLight& light) const {
    const Point3 end = moved(light.end, light.start, place);
    if (end == place || !is_finite(end)) return std::nullopt;
    return LinearLight{place, end, light.emission};
  }
  std::optional<Light> operator()(const AreaLight& light) const {
    std::vector<Point3> points;
    for (const Point3& p : light.polygon.points()) points.push_back(moved(p, light.polygon.points()[0], place));
    if (!std::ranges::all_of(points, is_finite) || ConvexPolygon::defect(points)) return std::nullopt;
    return AreaLight{ConvexPolygon::from_points(std::move(points)), light.two_sided};
  }
};

/// Moves a light; returns false where rounding would make it another shape.
bool move_to(SceneLight& light, const Point3& place) {
  auto shape = std::visit(MovedLight{place}, light.shape);
  if (shape) light.shape = std::move(*shape);
  return shape.has_value();
}

bool move_to(PlanarLight& light, const Point3& place) {
  const Point2 first = light.vertices.front();
  for (Point2& p : light.vertices) {
    const Point3 q = moved({p.x, p.y, 0}, {first.x, first.y, 0}, {place.x, place.y, 0});
    if (!is_finite(q)) return false;
    p = {q.x, q.y};
  }
  return light.vertices.size() == 1 || light.vertices[0] != light.vertices[1];
}

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& light) {
  throw SceneError(file + ':' + std::to_string(line) + ": found a position at which the vertices of " + light +
                   ", rounded to doubles, no longer are its shape; expected one nearer to the scene");
}

}  // namespace

std::vector<PathPlace> read_light_path(const std::string& file, int dimension) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw SceneError(file + ": cannot be read; expected a path, CSV with a header and one position a line");
  PointTable table(stream, file, dimension == 2 ? TableColumns::planar_points : TableColumns::points);
  std::vector<PathPlace> places;
  while (const auto row = table.next()) {
    if (const auto* bad = std::get_if<MalformedRow>(&*row)) {
      throw SceneError(file + ':' + std::to_string(bad->line) + ": " + bad->problem);
    }
    const auto& point = std::get<PointRow>(*row);
    places.push_back({point.line, {point.coordinates[0], point.coordinates[1], point.coordinates[2]}});
  }
  if (places.empty()) throw SceneError(file + ": found no position below the header, expected at least one");
  return places;
}

Scene with_light_at(const Scene& scene, const std::string& light, const PathPlace& place, const std::string& file) {
  Scene result = scene;
  const auto move_light = [&](auto& some) {
    for (auto& candidate : some.lights) {
      if (candidate.name == light && !move_to(candidate, place.position)) refuse(file, place.line, light);
    }
  };
  std::visit(move_light, result);
  return result;
}

}  // namespace gnomon
