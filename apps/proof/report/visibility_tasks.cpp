#include "apps/proof/report/visibility_tasks.h"

#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/plain_visibility.h"
#include "apps/proof/report/polygon_set_visibility.h"
#include "apps/proof/report/triangle_scenes.h"
#include "gnomon/irradiance.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {

constexpr Point3 up{0, 0, 1};
constexpr int true_bits = 256;
constexpr int exact_bits = 128;

/// A scene with some of its points, and what is true of them.
struct Looked {
  TriangleScene scene;
  Obstacles obstacles;
  std::vector<VisibilityTruth> truths;
};

enum class Quantity { visible_fraction, irradiance };

/// A number as a method gives it. A bound below 0 means that none is claimed.
struct Value {
  double value = 0;
  double bound = -1;
  Region region = Region::lit;
};

/// A method that has been made ready for one scene: what it says of a point.
using Ask = std::function<Value(const Point3&)>;

struct Method {
  std::string name;
  std::size_t samples = 0;
  std::size_t points = 0;  ///< at most so many points are asked of each scene
  bool tells_region = true;
  std::function<Ask(const Looked&)> prepare;
};

/// How many results there are to compare for n blockers, how many of the slow methods, and how finely the light is
/// sampled at most: about as finely as relative errors of 1e-3 take.
struct Counts {
  std::size_t points;
  std::size_t slow_points;
  std::size_t cells;
};

Counts counts(std::size_t n, Effort effort) {
  if (effort == Effort::quick) return n <= 16 ? Counts{64, 16, 16} : Counts{32, 8, 16};
  if (n <= 16) return {512, 128, 64};
  return n <= 64 ? Counts{256, 32, 64} : n <= 256 ? Counts{64, 8, 128} : Counts{16, 2, 256};
}

std::vector<Looked> looked_scenes(std::size_t n, std::size_t points) {
  std::vector<Looked> all;
  std::vector<TriangleScene> scenes = triangle_scenes(n);
  for (TriangleScene& scene : scenes) {
    Looked looked{std::move(scene), {}, {}};
    looked.scene.points.resize(std::min(looked.scene.points.size(), points / scenes.size()));
    looked.obstacles.blockers = looked.scene.blockers;
    for (const Point3& p : looked.scene.points) {
      looked.truths.push_back(visibility_truth(looked.scene.light, looked.obstacles, p, up, true_bits));
    }
    all.push_back(std::move(looked));
  }
  return all;
}

Value value_of(const VisibilityAnswer& answer, Quantity quantity) {
  return {quantity == Quantity::irradiance ? answer.irradiance : answer.fraction, -1, answer.region};
}

Ask exact_level(const Looked& looked, Quantity quantity) {
  if (quantity == Quantity::visible_fraction) {
    return [&](const Point3& p) -> Value {
      const Visibility seen = exact_visibility(looked.scene.light, looked.obstacles, p);
      return {seen.fraction, seen.error_bound, seen.region};
    };
  }
  return [&](const Point3& p) -> Value {
    const TrueValue e = true_irradiance(looked.scene.light, looked.obstacles, p, up, exact_bits);
    const double middle = e.low + (e.high - e.low) / 2;
    return {middle, std::max(e.high - middle, middle - e.low), Region::lit};
  };
}

Ask certified_level(const Looked& looked, Quantity quantity) {
  if (quantity == Quantity::visible_fraction) {
    const auto level = std::make_shared<LightVisibility>(looked.scene.light, PreparedObstacles(looked.obstacles));
    return [level](const Point3& p) -> Value {
      const Visibility seen = level->at(p);
      return {seen.fraction, seen.error_bound, seen.region};
    };
  }
  const auto level = std::make_shared<LightIrradiance>(looked.scene.light, 1, PreparedObstacles(looked.obstacles));
  return [level](const Point3& p) -> Value {
    const Irradiance e = level->at(p, up);
    return {e.value, e.error_bound, Region::lit};
  };
}

Ask plain_doubles(const Looked& looked, Quantity quantity) {
  const auto visibility = std::make_shared<PlainVisibility>(looked.scene.light, looked.scene.blockers);
  return [visibility, quantity](const Point3& p) { return value_of(visibility->visible_from(p, up), quantity); };
}

Ask polygon_set(const Looked& looked, Quantity quantity) {
  return [&looked, quantity](const Point3& p) {
    return value_of(polygon_set_visibility(looked.scene.light, looked.scene.blockers, p, up), quantity);
  };
}

Ask embree(const Looked& looked, Quantity quantity, Placing placing, std::size_t k, Rays rays) {
  const auto visibility = std::make_shared<EmbreeVisibility>(looked.scene.light, looked.scene.blockers);
  visibility->place(placing, k, rays);
  return [visibility, quantity](const Point3& p) { return value_of(visibility->visible_from(p, up), quantity); };
}

std::vector<Method> methods(Quantity quantity, const Counts& count) {
  const bool regions = quantity == Quantity::visible_fraction;
  const auto with = [quantity](Ask (*prepare)(const Looked&, Quantity)) {
    return [=](const Looked& looked) { return prepare(looked, quantity); };
  };
  std::vector<Method> all = {{"exact", 0, count.slow_points, regions, with(exact_level)},
                             {"gnomon", 0, count.points, regions, with(certified_level)},
                             {"plain_doubles", 0, count.points, true, with(plain_doubles)},
                             {"polygon_set_2", 0, count.slow_points, true, with(polygon_set)}};
  const std::tuple<std::string, Placing, Rays> samplings[] = {{"embree_regular", Placing::regular, Rays::single},
                                                              {"embree_jittered", Placing::jittered, Rays::single},
                                                              {"embree_stratified", Placing::stratified, Rays::single},
                                                              {"embree_packets", Placing::stratified, Rays::packets}};
  for (const auto& [name, placing, rays] : samplings) {
    for (std::size_t k = 2; k <= count.cells; k *= 2) {
      const auto prepare = [=, placed = placing, handed = rays](const Looked& looked) {
        return embree(looked, quantity, placed, k, handed);
      };
      all.push_back({name, k * k, count.points, true, prepare});
    }
  }
  return all;
}

Errors errors(const std::vector<Looked>& scenes, const Method& method, Quantity quantity, std::size_t per_scene) {
  Errors result;
  for (const Looked& looked : scenes) {
    const Ask ask = method.prepare(looked);
    for (std::size_t i = 0; i < std::min(per_scene, looked.truths.size()); ++i) {
      const VisibilityTruth& truth = looked.truths[i];
      const TrueValue& expected = quantity == Quantity::irradiance ? truth.irradiance : truth.fraction;
      const Value found = ask(looked.scene.points[i]);
      result.add(expected.error_of(found.value), expected.low);
      if (found.bound >= 0) {
        result.bound = std::max(result.bound.value_or(0), found.bound);
        result.outside_bound += expected.is_within(found.value, found.bound) ? 0 : 1;
      }
      result.wrong_regions += method.tells_region && found.region != truth.region ? 1 : 0;
    }
  }
  result.finish();
  return result;
}

Measurement measured(const std::vector<Looked>& scenes, const Method& method, Quantity quantity, Effort effort) {
  const std::size_t per_scene = std::max<std::size_t>(method.points / scenes.size(), 1);
  Measurement result;
  result.task = quantity == Quantity::irradiance ? "irradiance" : "visible_fraction";
  result.method = method.name;
  result.samples = method.samples;
  result.bytes = memory_growth([&] { result.errors = errors(scenes, method, quantity, per_scene); });
  std::vector<Ask> asks;
  for (const Looked& looked : scenes) asks.push_back(method.prepare(looked));
  volatile double used = 0;
  const auto pass = [&] {
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      for (std::size_t i = 0; i < std::min(per_scene, scenes[s].truths.size()); ++i) {
        used = used + asks[s](scenes[s].scene.points[i]).value;
      }
    }
  };
  const Care care = effort == Effort::quick ? Care{3, 0.002} : Care{5, 0.02};
  result.seconds = time_per_result(pass, result.errors.results, care);
  return result;
}

std::vector<Measurement> visibility_measurements(std::size_t n, Effort effort) {
  const Counts count = counts(n, effort);
  const std::vector<Looked> scenes = looked_scenes(n, count.points);
  std::vector<Measurement> all;
  for (const Quantity quantity : {Quantity::visible_fraction, Quantity::irradiance}) {
    for (const Method& method : methods(quantity, count)) {
      all.push_back(measured(scenes, method, quantity, effort));
      all.back().size = n;
    }
  }
  return all;
}

}  // namespace

std::vector<Task> visibility_tasks(Effort effort) {
  const std::vector<std::size_t> sizes =
      effort == Effort::quick ? std::vector<std::size_t>{1, 16, 64} : std::vector<std::size_t>{1, 4, 16, 64, 256, 1024};
  std::vector<Task> tasks;
  for (const std::size_t n : sizes) {
    tasks.push_back({std::to_string(n) + " triangles", [=] { return visibility_measurements(n, effort); }});
  }
  return tasks;
}

}  // namespace gnomon::report
