#include "apps/proof/report/table_one.h"

#include <cmath>
#include <numbers>

#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/tables.h"
#include "geometry/scene/receiver_facets.h"
#include "shading/image/shaded_image.h"

namespace gnomon::report {
namespace {

using image::ShadedImage;

constexpr double pi = std::numbers::pi;
constexpr double above_floor = 1;

BlockerShape square() {
  return ConvexPolygon::from_points(
      {{-1, -1, above_floor}, {1, -1, above_floor}, {1, 1, above_floor}, {-1, 1, above_floor}});
}

BlockerShape cube() {
  Polytope cube;
  for (const double z : {above_floor, above_floor + 1.5}) {
    for (const auto& [x, y] : {std::pair{-.75, -.75}, {.75, -.75}, {.75, .75}, {-.75, .75}})
      cube.vertices.push_back({x, y, z});
  }
  return cube;
}

BlockerShape disk() {
  std::vector<Point3> corners;
  for (int k = 0; k < 32; ++k) {
    corners.push_back({1.1 * std::cos(k * pi / 16), 1.1 * std::sin(k * pi / 16), above_floor});
  }
  return ConvexPolygon::from_points(corners);
}

/// Triangles between the points of a grid, one side of which may be closed up.
Mesh grid_mesh(std::uint32_t rows, std::uint32_t columns, std::vector<Point3> points) {
  Mesh mesh{"grid", std::move(points), {}};
  for (std::uint32_t i = 0; i + 1 < rows; ++i) {
    for (std::uint32_t k = 0; k + 1 < columns; ++k) {
      const std::uint32_t a = i * columns + k, b = a + 1, c = a + columns, d = c + 1;
      mesh.facets.push_back({a, b, d});
      mesh.facets.push_back({a, d, c});
    }
  }
  return mesh;
}

BlockerShape sphere_of_triangles() {
  const ConvexSolid hull = [] {
    std::vector<Point3> points = {{0, 0, above_floor}, {0, 0, above_floor + 2}};
    for (int i = 1; i < 12; ++i) {
      for (int k = 0; k < 24; ++k) {
        const double a = i * pi / 12, b = k * pi / 12;
        points.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), above_floor + 1 - std::cos(a)});
      }
    }
    return ConvexSolid::hull_of(points);
  }();
  return Polytope{{hull.points().begin(), hull.points().end()}};
}

/// A sheet that bends up and down.
BlockerShape patch() {
  std::vector<Point3> points;
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 9; ++k) {
      const double x = i / 4.0 - 1, y = 1 - k / 4.0;
      points.push_back({x, y, above_floor + 0.3 + 0.3 * x * x - 0.3 * y * y});
    }
  }
  return grid_mesh(9, 9, std::move(points));
}

struct Primitive {
  std::string name;
  BlockerShape (*shape)();
};

constexpr std::uint32_t width = 96, height = 72;

/// As a blocker; or, alone, as a receiver, which hides nothing.
SpaceScene scene_of(const BlockerShape& shape, bool has_shadows) {
  SpaceScene scene;
  const auto material = [](const char* name, int n) {
    return SceneMaterial{name, {.specular = {.3, .3, .3}, .exponent = n, .model = ReflectionModel::phong_classic}};
  };
  scene.materials = {material("primitive", 64), material("floor", 32)};
  scene.lights.push_back({"tube", LinearLight{{-5, 0, above_floor + 5}, {5, 0, above_floor + 5}}});
  if (has_shadows) {
    scene.blockers.push_back({"primitive", shape, "primitive"});
  } else {
    scene.receivers = receiver_facets("primitive", shape, ReceiverSides::front);
    for (SceneReceiver& facet : scene.receivers) facet.material = "primitive";
  }
  scene.receivers.push_back(
      {"floor", ConvexPolygon::from_points({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}), "floor", "floor"});
  scene.receivers.back().material = "floor";
  scene.camera = SceneCamera{{0, -9, 6}, {0, 0, above_floor}, {0, 0, 1}, 36, width, height};
  return scene;
}

ShadedImage pictured(const SpaceScene& scene, std::uint32_t points) {
  return image::shaded_image(scene, {.points = points, .threads = 1}, [](std::size_t) {});
}

double seconds_of_picture(const SpaceScene& scene, std::uint32_t points, Effort effort) {
  const Care care{effort == Effort::quick ? 3U : 7U, 0.01};
  return time_per_result([&] { pictured(scene, points); }, std::size_t{width} * height, care).least;
}

double rms_of(const ShadedImage& a, const ShadedImage& b) {
  double sum = 0, most = 0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) {
    const double difference = a.pixels[k].radiance[0].value - b.pixels[k].radiance[0].value;
    sum += difference * difference;
    most = std::fmax(most, a.pixels[k].radiance[0].value);
  }
  return std::sqrt(sum / double(a.pixels.size())) / most;
}

/// A number of points, and what their picture is off by.
struct PointsTried {
  double count = 0, rms = 0;
};

/// Twice as many each time.
std::vector<PointsTried> points_tried(const SpaceScene& scene, const ShadedImage& exact, std::uint32_t most) {
  std::vector<PointsTried> tried;
  for (std::uint32_t l = 1; l <= most; l *= 2) tried.push_back({double(l), rms_of(exact, pictured(scene, l))});
  return tried;
}

/// How many points have this error from then on.
double points_for(const std::vector<PointsTried>& tried, double rms) {
  std::size_t k = tried.size() - 1;
  while (k > 1 && tried[k - 1].rms <= rms) --k;
  const PointsTried &few = tried[k - 1], &many = tried[k];
  return few.count *
         std::exp(std::log(rms / few.rms) / std::log(many.rms / few.rms) * std::log(many.count / few.count));
}

TableOneRow row_of(const Primitive& primitive, bool has_shadows, Effort effort) {
  const SpaceScene scene = scene_of(primitive.shape(), has_shadows);
  const double light = seconds_of_picture(scene, 0, effort);
  const double few = seconds_of_picture(scene, 2, effort) / light, many = seconds_of_picture(scene, 16, effort) / light;
  TableOneRow row{primitive.name, has_shadows, light};
  row.per_point = (many - few) / 14;
  row.constant = few - 2 * row.per_point;
  const auto equal = static_cast<std::uint32_t>(std::fmax(1, std::round(row.equal())));
  const ShadedImage exact = pictured(scene, 0);
  row.rms = rms_of(exact, pictured(scene, equal));
  row.most_tried = effort == Effort::quick ? 16 : 128;
  const std::vector<PointsTried> tried = points_tried(scene, exact, row.most_tried);
  row.points_at_256 = points_for(tried, 1.0 / 256);
  row.points_at_1000 = points_for(tried, 1.0 / 1000);
  return row;
}

}  // namespace

std::vector<TableOneRow> table_one(Effort effort) {
  const std::vector<Primitive> primitives = {
      {"square", square}, {"cube", cube}, {"sphere", sphere_of_triangles}, {"disk", disk}, {"patch", patch}};
  std::vector<TableOneRow> rows;
  for (const bool has_shadows : {false, true}) {
    for (const Primitive& primitive : primitives) rows.push_back(row_of(primitive, has_shadows, effort));
  }
  return rows;
}

Seconds sphere_picture(std::uint32_t side) {
  SpaceScene scene = scene_of(sphere_of_triangles(), true);
  scene.camera->width = scene.camera->height = side;
  return time_per_result([&] { pictured(scene, 0); }, 1, Care{1, 0});
}

const std::vector<PrintedRow>& printed_table_one() {
  static const std::vector<PrintedRow> rows = {{"square", false, .39, .14, 4.36}, {"cube", false, .34, .11, 6.00},
                                               {"sphere", false, .31, .11, 6.27}, {"disk", false, .40, .14, 4.29},
                                               {"patch", false, .50, .08, 6.25},  {"square", true, .16, .10, 8.35},
                                               {"cube", true, .15, .10, 8.50},    {"sphere", true, .16, .10, 8.40},
                                               {"disk", true, .09, .06, 16.28},   {"patch", true, .06, .04, 23.50}};
  return rows;
}

std::string table_one_section(const std::vector<TableOneRow>& rows) {
  if (rows.empty()) return {};
  std::vector<Row> table = {{"primitive", "a + b l", "equal at", "printed a + b l", "printed equal", "rms at our equal",
                             "points for 1/256", "for 1/1000", "time of a pixel"}};
  const auto points = [](const TableOneRow& row, double count) {
    return (count > row.most_tried ? "about " : "") + std::to_string(std::lround(count));
  };
  const auto fit = [](double a, double b) { return short_text(a) + " + " + short_text(b) + " l"; };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const TableOneRow& row = rows[k];
    const PrintedRow& printed = printed_table_one()[k];
    table.push_back({row.primitive + (row.has_shadows ? ", with shadows" : ", shading alone"),
                     fit(row.constant, row.per_point), short_text(row.equal()),
                     fit(printed.constant, printed.per_point), short_text(printed.equal), short_text(row.rms),
                     points(row, row.points_at_256), points(row, row.points_at_1000), time_text(row.pixel_seconds)});
  }
  return "\n## Table I of [PA90] and [P93]\n\n"
         "The time of a picture under l point lights over that under one linear light, as a + b l, and how many points "
         "cost\n"
         "as much; beside it what the papers print, of another ray tracer on a machine they do not name. What they "
         "leave out\n"
         "is the error at that number: the root of the mean square of what a picture under so many points differs by, "
         "as a\n"
         "share of its largest radiance, and how many points bring it down to a grey level or to a thousandth, from up "
         "to "
         "so many\n"
         "tried (128; 16 with `--quick`) or, beyond them, by how it falls. No number is of equal error: the linear "
         "light's own is\n"
         "bounded pixel by pixel, below 1e-11.\n\n" +
         markdown_table(table) + "\n";
}

}  // namespace gnomon::report
