#include <cmath>

#include "apps/proof/report/timings.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/fast_visibility.h"
#include "shading/lambert.h"
#include "shading/reflection/area_reflection.h"
#include "shading/reflection/linear_reflection.h"
#include "shading/reflection/small_reflection.h"
#include "shading/small_lights.h"

namespace gnomon::report {
namespace {

constexpr std::size_t repetitions = 64;

/// A point of a floor, and an eye above and before it, as in [PA90].
shading::ReflectionQuery floor_query(ReflectionModel model, int exponent) {
  return {{0.3, 0.2, 0}, {0, 0, 1}, shading::of_size_one({0.1, -1, 0.8}), {model, exponent}};
}

/// 10 long, 5 above the floor.
LinearLight long_tube() {
  return {{-5, 1, 5}, {5, 1.25, 5}};
}

AreaLight long_lamp() {
  return {ConvexPolygon::from_points({{-5, 0, 5}, {-5, 2, 5}, {5, 2, 5}, {5, 0, 5}})};
}

/// Adds the time of one evaluation.
struct Clock {
  std::vector<Timing>& all;
  Care care;

  template <class Way>
  void time(const char* task, int exponent, const Way& way) const {
    const auto pass = [&] {
      for (std::size_t i = 0; i < repetitions; ++i) way();
    };
    all.push_back({task, static_cast<std::size_t>(exponent), time_per_result(pass, repetitions, care)});
  }
};

void time_points(const Clock& clock) {
  const PointLight bulb{{0, 1, 5}};
  const Point3 p = floor_query(ReflectionModel::phong, 1).point;
  clock.time("point_diffuse", 1, [&] { point_irradiance(bulb, p, {0, 0, 1}); });
  for (const int n : {1, 10, 50, 200, 10000}) {
    const shading::ReflectionQuery query = floor_query(ReflectionModel::phong, n);
    clock.time("point_phong", n, [&] { shading::point_reflection(bulb, query); });
  }
}

void time_lines(const Clock& clock) {
  const LinearLight tube = long_tube();
  const Point3 p = floor_query(ReflectionModel::phong, 1).point;
  const auto seen = FastLinearVisibility(tube, BlockerSet({})).visible_from(p);
  if (!seen) return;
  clock.time("line_diffuse", 1, [&] { linear_irradiance(tube, *seen, p, {0, 0, 1}); });
  for (const int n : {10, 50, 200, 10000}) {
    const shading::ReflectionQuery query = floor_query(ReflectionModel::phong, n);
    clock.time("line_phong", n, [&] { shading::linear_reflection(tube, *seen, query); });
  }
  const shading::ReflectionQuery blinn = floor_query(ReflectionModel::blinn, 50);
  clock.time("line_blinn", 50, [&] { shading::linear_reflection(tube, *seen, blinn); });
}

void time_lamps(const Clock& clock) {
  FastVisibility visibility(long_lamp(), BlockerSet({}));
  const auto seen = visibility.visible_from(floor_query(ReflectionModel::phong, 1).point);
  if (!seen) return;
  clock.time("lamp_lambert", 1, [&] { lambert_irradiance(*seen, {0, 0, 1}, 1); });
  for (const int n : {1, 50, 200}) {
    const shading::ReflectionQuery query = floor_query(ReflectionModel::phong, n);
    clock.time("lamp_phong", n, [&] { shading::area_reflection(*seen, query); });
  }
  const shading::ReflectionQuery blinn = floor_query(ReflectionModel::blinn, 50);
  clock.time("lamp_blinn", 50, [&] { shading::area_reflection(*seen, blinn); });
}

}  // namespace

std::vector<Timing> reflection_timings(Effort effort) {
  std::vector<Timing> all;
  const Clock clock{all, effort == Effort::quick ? Care{3, 0.005} : Care{5, 0.05}};
  time_points(clock);
  time_lines(clock);
  time_lamps(clock);
  return all;
}

}  // namespace gnomon::report
