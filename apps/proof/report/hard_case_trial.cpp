#include "apps/proof/report/hard_case_trial.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "apps/proof/report/divided_blockers.h"
#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/plain_visibility.h"
#include "apps/proof/report/truth.h"
#include "geometry/parallel.h"
#include "gnomon/irradiance.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {

constexpr int bits = 256;
constexpr std::size_t rays_along_side = 16;
constexpr std::size_t most_timed_points = 200;

std::vector<Visibility> true_answers(const HardCase& hard, std::span<const Point3> points) {
  const Obstacles obstacles{divided(hard.blockers), {}};
  std::vector<Visibility> answers(points.size());
  for_all(points.size(), thread_count(0),
          [&](std::size_t i, std::size_t) { answers[i] = exact_visibility(hard.light, obstacles, points[i]); });
  return answers;
}

void judge_gnomon(HardCaseResult& result, const Visibility& found, const Visibility& truth) {
  const double error = std::fabs(found.fraction - truth.fraction);
  result.wrong_gnomon += found.region != truth.region ? 1 : 0;
  result.outside_bound += error > found.error_bound + truth.error_bound ? 1 : 0;
  result.most_error = std::max(result.most_error, error);
  result.most_bound = std::max(result.most_bound, found.error_bound);
}

void tell_focus(HardCaseResult& result, const HardCase& hard, const PreparedObstacles& obstacles) {
  result.focus = LightVisibility(hard.light, obstacles).at(hard.focus);
  result.irradiance = LightIrradiance(hard.light, 1, obstacles).at(hard.focus, hard.normal);
  const TrueValue truth = true_irradiance(hard.light, obstacles.obstacles(), hard.focus, hard.normal, bits);
  result.irradiance_is_right = truth.is_within(result.irradiance.value, result.irradiance.error_bound);
}

void time_answers(HardCaseResult& result, const HardCase& hard, const PreparedObstacles& obstacles,
                  std::span<const Point3> points, Effort effort) {
  LightVisibility gnomon(hard.light, obstacles);
  const std::span<const Point3> timed = points.first(std::min(points.size(), most_timed_points));
  const auto pass = [&] {
    for (const Point3& p : timed) gnomon.at(p);
  };
  result.seconds = time_per_result(pass, timed.size(), effort == Effort::quick ? Care{3, 0.0005} : Care{5, 0.01});
}

}  // namespace

HardCaseResult hard_case_trial(const HardCase& hard, Effort effort) {
  HardCaseResult result;
  result.name = hard.name;
  result.about = hard.about;
  const PreparedObstacles obstacles(Obstacles{hard.blockers, {}});
  const std::vector<Point3> points = points_around(hard, effort == Effort::quick ? 200 : 10000);
  const std::vector<Visibility> truths = true_answers(hard, points);
  LightVisibility gnomon(hard.light, obstacles);
  PlainVisibility plain(hard.light, hard.blockers);
  EmbreeVisibility embree(hard.light, hard.blockers);
  embree.place(Placing::regular, rays_along_side);
  result.points = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Region region = truths[i].region;
    ++result.regions[static_cast<std::size_t>(region)];
    result.wrong_doubles += plain.visible_from(points[i], hard.normal).region != region ? 1 : 0;
    result.wrong_embree += embree.visible_from(points[i], hard.normal).region != region ? 1 : 0;
    judge_gnomon(result, gnomon.at(points[i]), truths[i]);
  }
  result.exact_answers = gnomon.exact_answers();
  tell_focus(result, hard, obstacles);
  time_answers(result, hard, obstacles, points, effort);
  return result;
}

}  // namespace gnomon::report
