#include "apps/proof/report/reflection_peers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "apps/proof/report/embree_rays.h"
#include "apps/proof/report/vectors.h"
#include "gnomon/irradiance.h"
#include "gnomon/reflection.h"
#include "gnomon/visibility.h"

namespace gnomon::report {
namespace {
namespace peers {

constexpr Point3 up{0, 0, 1}, eye{0, -1, 6};
constexpr double half_length = 5, half_width = 1, height = 6;  ///< of the light

/// A number of a place.
struct Answer {
  double value = 0;
  double bound = 0;
};

using Ask = std::function<Answer(const Point3&)>;

std::vector<ConvexBlocker> square() {
  return {ConvexPolygon::from_points({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}})};
}

Light tube() {
  return LinearLight{{-half_length, 0, height}, {half_length, 0, height}};
}

Light lamp() {
  return AreaLight{ConvexPolygon::from_points({{-half_length, -half_width, height},
                                               {-half_length, half_width, height},
                                               {half_length, half_width, height},
                                               {half_length, -half_width, height}})};
}

/// Places on the floor from which part of the light is hidden, or any where nothing is there to hide it.
std::vector<Point3> places(const Light& light, const std::vector<ConvexBlocker>& blockers, std::size_t count) {
  LightVisibility visibility(light, PreparedObstacles({blockers, {}}));
  std::mt19937 engine(23);
  const auto drawn = [&](double half) { return half * (static_cast<double>(engine()) / 2147483648.0 - 1); };
  std::vector<Point3> found;
  while (found.size() < count) {
    const Point3 p{drawn(2.3), drawn(1.5), 0};
    if (blockers.empty() || visibility.at(p).region == Region::penumbra) found.push_back(p);
  }
  return found;
}

double power(double base, int exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) result *= base;
  }
  return result;
}

/// What is asked of places: light, and the exponent of the lobe, or 0 for irradiance.
struct Task {
  std::string name;
  Light light;
  std::vector<ConvexBlocker> blockers;
  int exponent = 0;
  std::vector<double> parts;  ///< for an rms of 1 / part
};

Ask gnomon_asks(const Task& task) {
  const PreparedObstacles obstacles({task.blockers, {}});
  if (task.exponent == 0) {
    const auto irradiance = std::make_shared<LightIrradiance>(task.light, 1, obstacles);
    return [irradiance](const Point3& p) {
      const Irradiance e = irradiance->at(p, up);
      return Answer{e.value, e.error_bound};
    };
  }
  const auto reflection = std::make_shared<LightReflection>(task.light, obstacles);
  return [reflection, n = task.exponent](const Point3& p) {
    const Irradiance lobe = reflection->at({p, up, difference(eye, p)}, ReflectionModel::phong, n).lobe;
    return Answer{lobe.value, lobe.error_bound};
  };
}

/// Points on the light, in equal parts of it: in the middles, or drawn anew for each place.
class Samples {
 public:
  Samples(const Task& task, std::size_t count)
      : task_(task), is_flat_(std::holds_alternative<AreaLight>(task.light)), columns_(count), rays_(task.blockers) {
    if (is_flat_) {  // cells like squares
      rows_ = static_cast<std::size_t>(
          std::fmax(1, std::round(std::sqrt(static_cast<double>(count) * half_width / half_length))));
      columns_ = std::max<std::size_t>(1, count / rows_);
    }
    place([] { return 0.5; });
    const double measure = is_flat_ ? 4 * half_length * half_width : 2 * half_length;
    weight_ = measure / static_cast<double>(ends_.size());
  }

  std::size_t size() const { return ends_.size(); }

  Answer at(const Point3& p) {
    if (task_.exponent > 0 && !task_.blockers.empty()) {
      place([this] { return static_cast<double>(engine_()) / 2147483647.0; });
    }
    const Point3 mirrored = mirrored_eye(p);
    double sum = 0;
    for (std::size_t first = 0; first < ends_.size(); first += 8) {
      const auto ends = std::span<const Point3>(ends_).subspan(first, std::min<std::size_t>(8, ends_.size() - first));
      const unsigned hidden = task_.blockers.empty() ? 0 : rays_.hidden_of_eight(p, ends);
      for (std::size_t i = 0; i < ends.size(); ++i) {
        if ((hidden >> i & 1U) == 0) sum += given(difference(ends[i], p), mirrored);
      }
    }
    return {weight_ * sum, 0};
  }

 private:
  template <class Drawn>
  void place(const Drawn& drawn) {
    ends_.clear();
    for (std::size_t j = 0; j < rows_; ++j) {
      const double y =
          is_flat_ ? half_width * (2 * (static_cast<double>(j) + drawn()) / static_cast<double>(rows_) - 1) : 0;
      for (std::size_t i = 0; i < columns_; ++i) {
        ends_.push_back(
            {half_length * (2 * (static_cast<double>(i) + drawn()) / static_cast<double>(columns_) - 1), y, height});
      }
    }
  }

  /// Of length one.
  static Point3 mirrored_eye(const Point3& p) {
    const Point3 e = difference(eye, p);
    return scaled(1 / length(e), {-e.x, -e.y, e.z});
  }

  double given(const Point3& towards, const Point3& mirrored) const {
    const double squared = dot(towards, towards), over = 1 / std::sqrt(squared);
    double value = towards.z * over / squared;
    if (is_flat_) value *= towards.z * over;
    if (task_.exponent == 0) return value;
    const double lobe = dot(towards, mirrored) * over;
    return lobe > 0 ? value * power(lobe, task_.exponent) : 0;
  }

  const Task& task_;
  bool is_flat_;
  std::size_t columns_, rows_ = 1;
  EmbreeRays rays_;
  std::minstd_rand engine_{1};
  std::vector<Point3> ends_;
  double weight_ = 0;
};

/// What so many points on the light take, and by how much they are off.
struct Trial {
  std::size_t count = 0;
  double rms = 0;
  Seconds seconds{};
};

Seconds time_of(const Ask& ask, const std::vector<Point3>& places, Effort effort) {
  const auto pass = [&] {
    for (const Point3& p : places) ask(p);
  };
  return time_per_result(pass, places.size(), effort == Effort::quick ? Care{3, 0.005} : Care{5, 0.02});
}

Trial trial(const Task& task, std::size_t count, const std::vector<Point3>& places, const std::vector<Answer>& truth,
            Effort effort) {
  Samples samples(task, count);
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += std::pow(samples.at(places[i]).value - truth[i].value, 2);
    largest = std::fmax(largest, truth[i].value);
  }
  return {samples.size(), std::sqrt(sum / static_cast<double>(places.size())) / largest,
          time_of([&](const Point3& p) { return samples.at(p); }, places, effort)};
}

double on_the_line(double x, double x0, double y0, double x1, double y1) {
  return std::exp(std::log(y0) + std::log(x / x0) / std::log(x1 / x0) * std::log(y1 / y0));
}

/// What an error takes, between the last two trials that have it between them.
std::optional<Timing> timing_at(const Task& task, const std::vector<Trial>& trials, double part) {
  const double rms = 1 / part;
  for (std::size_t k = trials.size(); k-- > 1;) {
    const Trial &few = trials[k - 1], &many = trials[k];
    if (!(few.rms > rms && many.rms <= rms)) continue;
    const auto at = [&](double a, double b) { return on_the_line(rms, few.rms, a, many.rms, b); };
    const auto count = static_cast<std::size_t>(at(static_cast<double>(few.count), static_cast<double>(many.count)));
    return Timing{task.name + "_at_" + std::to_string(static_cast<int>(part)),
                  count,
                  {at(few.seconds.median, many.seconds.median), at(few.seconds.least, many.seconds.least),
                   at(few.seconds.most, many.seconds.most)}};
  }
  return {};
}

void add_peers(std::vector<Timing>& all, const Task& task, Effort effort) {
  const bool quick = effort == Effort::quick;
  const std::vector<Point3> points = places(task.light, task.blockers, quick ? 64 : 256);
  const Ask ask = gnomon_asks(task);
  std::vector<Answer> truth;
  double largest = 0, widest = 0;
  for (const Point3& p : points) {
    truth.push_back(ask(p));
    largest = std::fmax(largest, truth.back().value);
    widest = std::fmax(widest, truth.back().bound);
  }
  if (widest > 1e-9 * largest) return;
  all.push_back({task.name, 1, time_of(ask, points, effort)});
  std::vector<Trial> trials;
  const std::size_t most = quick ? 2048 : 32768;
  for (std::size_t count = 4; count <= most && (trials.empty() || trials.back().rms > 1 / task.parts.back());
       count *= 2) {
    trials.push_back(trial(task, count, points, truth, effort));
  }
  for (const double part : task.parts) {
    if (const auto timing = timing_at(task, trials, part)) all.push_back(*timing);
  }
}

}  // namespace peers
}  // namespace

std::vector<Timing> reflection_peers(Effort effort) {
  using namespace peers;
  std::vector<Timing> all;
  add_peers(all, {"penumbra_tube", tube(), square(), 0, {256, 10000}}, effort);
  add_peers(all, {"penumbra_tube_lobe", tube(), square(), 50, {256, 1000}}, effort);
  add_peers(all, {"penumbra_lamp_lobe", lamp(), square(), 50, {256, 1000}}, effort);
  add_peers(all, {"open_tube_lobe", tube(), {}, 64, {10000}}, effort);
  return all;
}

}  // namespace gnomon::report
