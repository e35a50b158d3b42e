#include "shading/image/shaded_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include "shading/image/camera.h"
#include "shading/image/first_hit.h"
#include "shading/image/scene_radiance.h"
#include "shading/image/surfaces.h"
#include "tests/shading/image/image_scenes.h"

namespace gnomon::image {
namespace {

using test_support::image_lights;
using test_support::image_scene;

SpaceScene scene_under(const std::string& lights) {
  return std::get<SpaceScene>(parse_scene(image_scene(lights), "test", "."));
}

ShadedImage painted(const SpaceScene& scene, const ImageOptions& options = {}) {
  return shaded_image(scene, options, [](std::size_t) {});
}

class ShadedImages : public ::testing::TestWithParam<std::string> {};

bool are_equal(const ShadedImage& a, const ShadedImage& b) {
  if (a.pixels.size() != b.pixels.size() || a.exact_answers != b.exact_answers) return false;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) {
    const ImagePixel &p = a.pixels[k], &q = b.pixels[k];
    for (std::size_t c = 0; c < 3; ++c) {
      if (p.radiance[c].value != q.radiance[c].value || p.radiance[c].error_bound != q.radiance[c].error_bound) {
        return false;
      }
    }
    if (p.irradiance.value != q.irradiance.value || p.depth != q.depth || p.facet != q.facet) return false;
  }
  return true;
}

TEST_P(ShadedImages, AreTheSameForAnyNumberOfThreads) {
  const SpaceScene scene = scene_under(GetParam());
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    const ShadedImage one = painted(scene, {.shading = mode, .samples = 2, .threads = 1});
    for (const unsigned threads : {2u, 7u}) {
      EXPECT_TRUE(are_equal(one, painted(scene, {.shading = mode, .samples = 2, .threads = threads})));
    }
  }
}

/// What `gnomon radiance` answers for the same point, normal and eye.
RadianceRgb radiance_at(const SpaceScene& scene, const PreparedObstacles& obstacles, const Facet& facet,
                        const Hit& hit) {
  const Point3& n = facet.normal;
  const Point3& e = scene.camera->eye;
  const View view{hit.place,
                  hit.is_front ? n : Point3{-n.x, -n.y, -n.z},
                  {e.x / 2 - hit.place.x / 2, e.y / 2 - hit.place.y / 2, e.z / 2 - hit.place.z / 2}};
  const ReceiverPoint receiver = resting_point(obstacles, view.point, view.normal);
  std::vector<RadianceRgb> parts;
  for (const SceneLight& light : scene.lights) {
    LightReflection reflection(light.shape, obstacles);
    const Reflection r = reflection.received(receiver, view, facet.material->model, facet.material->exponent);
    parts.push_back(reflected_radiance(light, r, *facet.material, *length_unit_named("m")));
  }
  parts.push_back(ambient_radiance(*facet.material, scene.ambient_radiance));
  return total_radiance(parts);
}

TEST_P(ShadedImages, ShowWhatRadianceAnswersForTheSamePoints) {
  const SpaceScene scene = scene_under(GetParam());
  const ShadedImage image = painted(scene);
  const Surfaces surfaces = surfaces_of(scene);
  const FirstHit hits(surfaces.facets);
  const Camera camera(*scene.camera);
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  std::size_t shown = 0;
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const auto i = double(k % image.width), j = std::floor(double(k) / image.width);
    const std::optional<Hit> hit = hits.along(camera.ray(i + 0.5, j + 0.5));
    if (!hit || surfaces.facets[hit->facet].light) continue;
    const RadianceRgb expected = radiance_at(scene, obstacles, surfaces.facets[hit->facet], *hit);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(image.pixels[k].radiance[c].value, expected[c].value) << k;
      ASSERT_LT(image.pixels[k].radiance[c].error_bound, 1e-8);
    }
    ++shown;
  }
  EXPECT_GT(shown, 250u);
}

/// Light by chance: an estimate of a pixel's radiance and its standard deviation, from the definition and plain
/// doubles.
class Chance {
 public:
  Chance(const SpaceScene& scene, const Surfaces& surfaces) : scene_(scene), surfaces_(surfaces) {}

  struct Estimate {
    double mean = 0, deviation = 0;
  };

  /// Of red.
  Estimate radiance(const Facet& facet, const Hit& hit, int draws) {
    double sum = 0, squares = 0;
    for (int d = 0; d < draws; ++d) {
      double value = facet.material->ambient[0] * scene_.ambient_radiance[0];
      for (const SceneLight& light : scene_.lights) value += one(facet, hit, light);
      sum += value, squares += value * value;
    }
    const double mean = sum / draws;
    return {mean, std::sqrt(std::fmax(squares / draws - mean * mean, 0) / draws)};
  }

 private:
  using V = std::array<double, 3>;
  static V v(const Point3& p) { return {p.x, p.y, p.z}; }
  static V minus(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static V sum(const V& a, double s, const V& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
  static double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static V cross(const V& a, const V& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static V unit(const V& a) { return sum({0, 0, 0}, 1 / std::sqrt(dot(a, a)), a); }
  double share() { return std::uniform_real_distribution<double>()(engine_); }

  /// Irradiance across the way to a drawn point of the light, and that way.
  struct Drawn {
    V way{};
    double across = 0;
  };

  Drawn drawn(const SceneLight& light, const V& p) {
    if (const auto* point = std::get_if<PointLight>(&light.shape)) {
      const V way = minus(v(point->position), p);
      return {way, light.strength / dot(way, way)};
    }
    if (const auto* sun = std::get_if<DirectionalLight>(&light.shape)) {
      return {sum({0, 0, 0}, -100, v(sun->direction)), light.strength};
    }
    if (const auto* tube = std::get_if<LinearLight>(&light.shape)) return of_tube(*tube, light.strength, p);
    return of_lamp(std::get<AreaLight>(light.shape), light.strength, p);
  }
  Drawn of_tube(const LinearLight& tube, double k, const V& p) {
    const V a = v(tube.start), along = minus(v(tube.end), a), way = minus(sum(a, share(), along), p);
    const double sine = dot(unit(way), unit(along)), cosine = std::sqrt(1 - sine * sine);
    const bool is_dark =
        tube.emission.flaps && std::asin(std::fabs(sine)) > *tube.emission.flaps * std::numbers::pi / 180;
    const double emitted = is_dark ? 0 : std::pow(cosine, tube.emission.exponent);
    return {way, k * emitted * std::sqrt(dot(along, along)) / dot(way, way)};
  }
  Drawn of_lamp(const AreaLight& lamp, double radiance, const V& p) {
    const auto& c = lamp.polygon.points();
    std::vector<double> areas;
    const auto edge = [&](std::size_t k) { return minus(v(c[k]), v(c[0])); };
    V normal{};
    for (std::size_t k = 2; k < c.size(); ++k) {
      const V n = cross(edge(k - 1), edge(k));
      areas.push_back(std::sqrt(dot(n, n)) / 2);
      normal = unit(n);
    }
    double total = 0, at = 0;
    for (const double area : areas) total += area;
    double place = share() * total;
    std::size_t k = 0;
    while (k + 1 < areas.size() && (at += areas[k]) < place) ++k;
    double x = share(), y = share();
    if (x + y > 1) x = 1 - x, y = 1 - y;
    const V way = minus(sum(sum(v(c[0]), x, edge(k + 1)), y, edge(k + 2)), p);
    double cosine = -dot(unit(way), normal);
    if (lamp.two_sided) cosine = std::fabs(cosine);
    return {way, radiance * total * std::fmax(cosine, 0) / dot(way, way)};
  }
  bool is_hidden(const V& p, const V& way) const {
    for (const Facet& facet : surfaces_.facets) {
      if (!facet.blocker) continue;
      const auto& c = facet.shape.points();
      for (std::size_t k = 2; k < c.size(); ++k) {
        const V a = v(c[0]), ab = minus(v(c[k - 1]), a), ac = minus(v(c[k]), a), o = minus(p, a);
        const double volume = dot(way, cross(ac, ab));
        if (volume == 0) continue;
        const double t = dot(o, cross(ab, ac)) / volume, x = dot(way, cross(ac, o)) / volume,
                     y = dot(way, cross(o, ab)) / volume;
        if (t > 1e-9 && t < 1 && x >= 0 && y >= 0 && x + y <= 1) return true;
      }
    }
    return false;
  }
  double one(const Facet& facet, const Hit& hit, const SceneLight& light) {
    const V p = v(hit.place), n = sum({0, 0, 0}, hit.is_front ? 1 : -1, v(facet.normal));
    const auto [way, across] = drawn(light, p);
    const V l = unit(way), e = unit(minus(v(scene_.camera->eye), p));
    const double cosine = dot(n, l);
    if (cosine <= 0 || across == 0 || is_hidden(p, way)) return 0;
    const Material& m = *facet.material;
    const bool halfway = m.model == ReflectionModel::blinn;
    const V r = sum(sum({0, 0, 0}, 2 * dot(n, e), n), -1, e);
    double lobe = std::pow(std::fmax(halfway ? dot(n, unit(sum(l, 1, e))) : dot(r, l), 0), m.exponent);
    if (m.model != ReflectionModel::phong_classic) lobe *= cosine;
    const double x = m.exponent;
    const double norm = halfway ? (x + 2) * (x + 4) / (8 * std::numbers::pi * (x + std::pow(2, -x / 2)))
                        : m.model == ReflectionModel::phong ? (x + 2) / (2 * std::numbers::pi)
                                                            : 1;
    return light.color[0] * across * (m.diffuse[0] / std::numbers::pi * cosine + m.specular[0] * norm * lobe);
  }

  const SpaceScene& scene_;
  const Surfaces& surfaces_;
  std::mt19937_64 engine_{73};
};

TEST_P(ShadedImages, AgreeWithLightByChance) {
  const SpaceScene scene = scene_under(GetParam());
  const ShadedImage image = painted(scene);
  const Surfaces surfaces = surfaces_of(scene);
  const FirstHit hits(surfaces.facets);
  const Camera camera(*scene.camera);
  Chance chance(scene, surfaces);
  int tried = 0, beyond = 0;
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const auto i = double(k % image.width), j = std::floor(double(k) / image.width);
    const std::optional<Hit> hit = hits.along(camera.ray(i + 0.5, j + 0.5));
    if (!hit || surfaces.facets[hit->facet].light) continue;
    const Chance::Estimate estimate = chance.radiance(surfaces.facets[hit->facet], *hit, 1500);
    const double away = std::fabs(estimate.mean - image.pixels[k].radiance[0].value);
    ++tried;
    beyond += away > 3 * estimate.deviation + 1e-12;
    EXPECT_LE(away, 5 * estimate.deviation + 1e-12) << "pixel " << k << ": " << image.pixels[k].radiance[0].value
                                                    << " for " << estimate.mean << " +- " << estimate.deviation;
  }
  EXPECT_GT(tried, 250);
  EXPECT_LE(beyond, tried / 50) << "0.3 % are expected beyond 3 sigma";
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadedImages, ::testing::ValuesIn(image_lights));

TEST(ShadedImage, ShowsALampItsRadianceAndNothingElsewhere) {
  auto scene =
      std::get<SpaceScene>(parse_scene(R"({"gnomon": 1, "dimension": 3, "blockers": [], "lights": [{"name": "lamp",
    "shape": "polygon", "vertices": [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]], "radiance": 3, "color": [1, 0.5, 0]}],
    "camera": {"eye": [0,0,4], "look_at": [0,0,0], "up": [0,1,0], "width": 9, "height": 9, "fov": 60}})",
                                       "test", "."));
  const ShadedImage front = painted(scene);
  EXPECT_EQ(front.pixels[40].radiance[0].value, 3);
  EXPECT_EQ(front.pixels[40].radiance[1].value, 1.5);
  EXPECT_EQ(front.pixels[40].depth, 4);
  EXPECT_EQ(front.elements, std::vector<std::string>{"lamp"});
  EXPECT_EQ(front.pixels[0].element, -1);
  EXPECT_EQ(front.pixels[0].radiance[0].value, 0);
  EXPECT_TRUE(std::isinf(front.pixels[0].depth));
  scene.camera->eye.z = -4;
  EXPECT_EQ(painted(scene).pixels[40].element, -1) << "from behind";
}

/// Squared differences of a picture under so many points for each light and under the lights themselves, pixel by
/// pixel.
double square_apart(const SpaceScene& scene, const ShadedImage& exact, std::uint32_t points) {
  const ShadedImage image = painted(scene, {.points = points});
  double square = 0;
  for (std::size_t k = 0; k < exact.pixels.size(); ++k) {
    square += std::pow(image.pixels[k].radiance[0].value - exact.pixels[k].radiance[0].value, 2);
  }
  return square;
}

TEST(ShadedImage, OfManyPointsForALightComesCloseToTheLight) {
  const SpaceScene scene = scene_under(image_lights[0]);
  const ShadedImage exact = painted(scene);
  double last = HUGE_VAL;
  for (const std::uint32_t points : {4u, 36u, 400u}) {
    const double square = square_apart(scene, exact, points);
    EXPECT_LT(square, last / 4) << points;
    last = square;
  }
}

/// By a cosine, between flaps, into half-planes that leave out part of the floor, and all of it together.
TEST(ShadedImage, OfManyPointsForALightHasTheLightsEmission) {
  for (
      const std::string emission :
      {R"("emission": {"profile": "cosine", "exponent": 3})", R"("flaps": {"angle": 35})",
       R"("shade": {"from": [0, -1, -0.2], "to": [0, 1, -1]})",
       R"("emission": {"profile": "cosine"}, "flaps": {"angle": 50}, "shade": {"from": [0, -1, -1], "to": [0, 1, 0]})"}) {
    const SpaceScene scene = scene_under(R"({"name": "tube", "shape": "segment", "vertices": [[-1, 0, 3], [1, 0.5, 3]],
                                             "intensity_per_length": 3, )" +
                                         emission + "}");
    const ShadedImage exact = painted(scene);
    double all = 0;
    for (const ImagePixel& pixel : exact.pixels) all += std::pow(pixel.radiance[0].value, 2);
    EXPECT_LT(square_apart(scene, exact, 256), 1e-4 * all) << emission;
    EXPECT_GT(square_apart(scene, exact, 2), 1e-4 * all) << "or it shows nothing: " << emission;
  }
}

}  // namespace
}  // namespace gnomon::image
