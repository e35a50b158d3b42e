#include "shading/image/light_source.h"

#include <cmath>
#include <numbers>

#include "shading/receiver_grid.h"
#include "shading/reflection/emission.h"
#include "shading/reflection/reflection_query.h"

namespace gnomon::image {
namespace {

using shading::Bounded;

Point3 between(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

std::vector<LightSample> samples_of(const LinearLight& light, std::uint32_t count) {
  std::vector<LightSample> samples;
  for (std::uint32_t i = 0; i < count; ++i) {
    samples.push_back({between(light.start, light.end, (i + 0.5) / count), distance(light.start, light.end) / count});
  }
  return samples;
}

/// Two numbers whose product is `count` and whose ratio is nearest to that of the sides.
std::array<std::uint32_t, 2> grid_shape(std::uint32_t count, double width, double height) {
  std::array<std::uint32_t, 2> best{count, 1};
  const auto deviation = [&](std::uint32_t u) { return std::fabs(std::log(double(u) * u / count * (height / width))); };
  for (std::uint32_t u = 1; u <= count; ++u) {
    if (count % u == 0 && deviation(u) < deviation(best[0])) best = {u, count / u};
  }
  return best;
}

/// The sides of the smallest rectangle along the first side: cells of a grid of one tell.
std::array<double, 2> sides_of(const ConvexPolygon& polygon) {
  const ReceiverGrid two(polygon, {2, 2});
  return {2 * distance(two.point(0), two.point(1)), 2 * distance(two.point(0), two.point(2))};
}

double polygon_area(const ConvexPolygon& polygon) {
  const auto& p = polygon.points();
  shading::Vector sum{0, 0, 0};
  const auto way = [&](std::size_t k) { return shading::Vector{p[k].x - p[0].x, p[k].y - p[0].y, p[k].z - p[0].z}; };
  for (std::size_t k = 2; k < p.size(); ++k) sum = sum + cross(way(k - 1), way(k));
  return shading::length(sum) / 2;
}

std::vector<LightSample> samples_of(const AreaLight& light, std::uint32_t count) {
  const auto [width, height] = sides_of(light.polygon);
  const ReceiverGrid grid(light.polygon, grid_shape(count, width, height));
  std::vector<LightSample> samples;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (grid.is_on_receiver(grid.point(i))) {
      samples.push_back({grid.point(i), 1, grid.normal(), true, light.two_sided});
    }
  }
  if (samples.empty()) samples.push_back({mean_of_corners(light.polygon), 1, grid.normal(), true, light.two_sided});
  for (LightSample& sample : samples) sample.weight = polygon_area(light.polygon) / double(samples.size());
  return samples;
}

/// What the emission of a linear light leaves of 1 from a place on it towards another one; shades are not asked.
double emission_towards(const LinearLight& light, const Point3& place, const Point3& p) {
  const shading::Vector axis{light.end.x - light.start.x, light.end.y - light.start.y, light.end.z - light.start.z};
  const shading::Vector way{p.x - place.x, p.y - place.y, p.z - place.z};
  const double across = shading::length(cross(axis, way)), along = std::fabs(dot(axis, way));
  if (across == 0 && along == 0) return 1;  // at the very place, where irradiance is infinite
  const double beta = std::atan2(along, across);
  const auto& [exponent, flaps, shade] = light.emission;
  if (flaps && beta > *flaps * std::numbers::pi / 180) return 0;
  return std::pow(std::cos(beta), exponent);
}

Bounded in_bounds(const Irradiance& e) {
  return {e.value, e.error_bound};
}

Irradiance sum_of(const Bounded& sum) {
  return {sum.value, shading::with_underflow(1.01 * sum.error)};
}

}  // namespace

std::vector<LightSample> light_samples(const Light& light, std::uint32_t count) {
  if (const auto* linear = std::get_if<LinearLight>(&light)) return samples_of(*linear, count);
  if (const auto* area = std::get_if<AreaLight>(&light)) return samples_of(*area, count);
  return {};
}

/// What the point shines towards another one.
double LightSource::weight_towards(const LightSample& sample, const Point3& p) const {
  if (shining_) return sample.weight * emission_towards(*shining_, sample.place, p);
  if (!sample.is_flat) return sample.weight;
  const double r = distance(sample.place, p);
  const auto& [place, weight, n, is_flat, two_sided] = sample;
  const double cosine = ((p.x - place.x) * n.x + (p.y - place.y) * n.y + (p.z - place.z) * n.z) / r;
  return weight * (two_sided ? std::fabs(cosine) : std::fmax(cosine, 0));
}

LightSource::LightSource(const SceneLight& light, const PreparedObstacles& obstacles, const ImageOptions& options) {
  if (options.points > 0) samples_ = light_samples(light.shape, options.points);
  const auto* linear = std::get_if<LinearLight>(&light.shape);
  if (linear && !samples_.empty() && !is_isotropic(linear->emission)) shining_ = *linear;
  if (samples_.empty()) reflections_.emplace_back(light.shape, obstacles, options.search);
  for (const LightSample& sample : samples_) reflections_.emplace_back(PointLight{sample.place}, obstacles);
}

Reflection LightSource::received(const ReceiverPoint& receiver, const View& view, ReflectionModel model, int exponent) {
  if (samples_.empty()) return reflections_.front().received(receiver, view, model, exponent);
  if (shining_ && !shading::is_shone_at(*shining_, view.point)) return {};
  Bounded lit, lobe;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double weight = weight_towards(samples_[i], view.point);
    if (weight == 0) continue;
    const Reflection r = reflections_[i].received(receiver, view, model, exponent);
    lit = lit + Bounded(weight) * in_bounds(r.received);
    lobe = lobe + Bounded(weight) * in_bounds(r.lobe);
  }
  return {sum_of(lit), sum_of(lobe)};
}

std::size_t LightSource::answers() const {
  std::size_t sum = 0;
  for (const LightReflection& r : reflections_) sum += r.answers();
  return sum;
}

std::size_t LightSource::exact_answers() const {
  std::size_t sum = 0;
  for (const LightReflection& r : reflections_) sum += r.exact_answers();
  return sum;
}

}  // namespace gnomon::image
