#include "gnomon/paint_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gnomon/irradiance.h"
#include "gnomon/point.h"

namespace gnomon {
namespace {

/// What strengths are multiplied by where the scene's unit is no metre.
double in_metres(double value, const Light& light, const SpaceScene& scene) {
  const LengthUnit unit = length_unit_named(scene.length_unit).value();
  return per_square_metre({value, 0}, light, unit).value;
}

Point3 way(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// The parts of an element are one light: their columns are added.
std::vector<const SceneLight*> parts_called(const SpaceScene& scene, const std::string& name) {
  std::vector<const SceneLight*> parts;
  for (const SceneLight& light : scene.lights) {
    if (light.name == name || light.element == name) parts.push_back(&light);
  }
  return parts;
}

void add_wanted(const PaintSample& sample, std::uint32_t channel, FitRow& row) {
  if (!sample.wanted.empty()) row.wanted = sample.wanted[channel];
  if (!sample.least.empty()) row.least = sample.least[channel];
  if (!sample.most.empty()) row.most = sample.most[channel];
}

PaintFit fitted_intensities(const Paint& paint, const SpaceScene& scene) {
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  std::vector<FitRow> rows(paint.samples.size());
  for (const std::string& name : paint.lights) {
    for (FitRow& row : rows) row.columns.push_back(0);
    for (const SceneLight* light : parts_called(scene, name)) {
      LightIrradiance irradiance(light->shape, 1, obstacles);
      for (std::size_t s = 0; s < rows.size(); ++s) {
        const PaintSample& sample = paint.samples[s];
        const double e =
            irradiance.received(resting_point(obstacles, sample.point, sample.normal), sample.normal).value;
        rows[s].columns.back() += in_metres(e, light->shape, scene);
      }
    }
  }
  PaintFit result;
  for (std::uint32_t channel = 0; channel < paint.channels; ++channel) {
    for (std::size_t s = 0; s < rows.size(); ++s) add_wanted(paint.samples[s], channel, rows[s]);
    result.channels.push_back(least_squares(rows, static_cast<std::uint32_t>(paint.lights.size()), std::nullopt));
  }
  return result;
}

/// Everything that a material's fit asks the scene for.
class MaterialFit {
 public:
  MaterialFit(const Paint& paint, const SpaceScene& scene)
      : paint_(paint), scene_(scene), obstacles_(scene_bodies(scene).obstacles) {
    for (const SceneLight& light : scene.lights) lights_.emplace_back(light.shape, obstacles_);
    for (const PaintSample& sample : paint.samples) {
      receivers_.push_back(resting_point(obstacles_, sample.point, sample.normal));
    }
    has_bounds_ = std::ranges::any_of(paint.samples, [](const PaintSample& s) { return s.wanted.empty(); });
  }

  /// Of each channel the fit for one exponent.
  std::vector<LinearFit> fits(std::uint32_t exponent) {
    std::vector<std::vector<FitRow>> rows(paint_.channels, std::vector<FitRow>(paint_.samples.size()));
    for (std::size_t s = 0; s < paint_.samples.size(); ++s) add_sample(s, exponent, rows);
    std::vector<LinearFit> result;
    for (const auto& channel : rows) {
      result.push_back(has_bounds_ ? within_bounds(channel, unknowns) : least_squares(channel, unknowns, 1.0));
    }
    return result;
  }

  static double cost(const std::vector<LinearFit>& fits) {
    double sum = 0;
    for (const LinearFit& fit : fits) {
      if (!fit.is_feasible) return HUGE_VAL;
      for (const double r : fit.residuals) sum += r * r;
    }
    return sum;
  }

 private:
  static constexpr std::uint32_t unknowns = 3;

  /// ka times ambient light, kd times E / pi, ks times the lobe.
  void add_sample(std::size_t s, std::uint32_t exponent, std::vector<std::vector<FitRow>>& rows) {
    const PaintSample& sample = paint_.samples[s];
    const View view{sample.point, sample.normal, way(sample.point, sample.eye)};
    for (std::uint32_t c = 0; c < paint_.channels; ++c) {
      rows[c][s].columns = {scene_.ambient_radiance[c], 0, 0};
      add_wanted(sample, c, rows[c][s]);
    }
    const double norm = lobe_norm(paint_.model, static_cast<int>(exponent));
    for (std::size_t l = 0; l < lights_.size(); ++l) {
      const SceneLight& light = scene_.lights[l];
      const Reflection seen = lights_[l].received(receivers_[s], view, paint_.model, static_cast<int>(exponent));
      const double received = in_metres(seen.received.value, light.shape, scene_) / std::numbers::pi;
      const double lobe = in_metres(seen.lobe.value, light.shape, scene_) * norm;
      for (std::uint32_t c = 0; c < paint_.channels; ++c) {
        rows[c][s].columns[1] += light.strength * light.color[c] * received;
        rows[c][s].columns[2] += light.strength * light.color[c] * lobe;
      }
    }
  }

  const Paint& paint_;
  const SpaceScene& scene_;
  PreparedObstacles obstacles_;
  std::vector<LightReflection> lights_;
  std::vector<ReceiverPoint> receivers_;
  bool has_bounds_ = false;
};

/// Exponents at equal steps of their logarithms, and then whole ones about the best.
class ExponentSearch {
 public:
  explicit ExponentSearch(MaterialFit& material) : material_(material) {}

  std::uint32_t best() {
    constexpr int steps = 40;
    costs(0);
    for (int k = 0; k <= steps; ++k) {
      costs(static_cast<std::uint32_t>(std::lround(std::pow(most_exponent, static_cast<double>(k) / steps))));
    }
    while (true) {
      const auto found = std::ranges::min_element(tried_, {}, &Tried::cost);
      const std::uint32_t low = found == tried_.begin() ? found->exponent : (found - 1)->exponent;
      const std::uint32_t high = found + 1 == tried_.end() ? found->exponent : (found + 1)->exponent;
      const std::uint32_t here = found->exponent;
      if (here - low <= 1 && high - here <= 1) return here;
      if (here - low > 1) costs(low + (here - low) / 2);
      if (high - here > 1) costs(here + (high - here) / 2);
    }
  }

  /// The least and the largest exponent tried whose cost is no more than that.
  std::pair<std::uint32_t, std::uint32_t> range(double most) const {
    std::pair<std::uint32_t, std::uint32_t> result{~0U, 0};
    for (const Tried& tried : tried_) {
      if (tried.cost > most) continue;
      result.first = std::min(result.first, tried.exponent);
      result.second = std::max(result.second, tried.exponent);
    }
    return result;
  }

 private:
  static constexpr double most_exponent = 10000;
  struct Tried {
    std::uint32_t exponent;
    double cost;
  };

  void costs(std::uint32_t exponent) {
    const auto place = std::ranges::lower_bound(tried_, exponent, {}, &Tried::exponent);
    if (place != tried_.end() && place->exponent == exponent) return;
    tried_.insert(place, {exponent, MaterialFit::cost(material_.fits(exponent))});
  }

  MaterialFit& material_;
  std::vector<Tried> tried_;  ///< ascending
};

double wanted_square(const Paint& paint) {
  double sum = 0;
  for (const PaintSample& sample : paint.samples) {
    for (const double w : sample.wanted) sum += w * w;
  }
  return sum;
}

PaintFit fitted_material(const Paint& paint, const SpaceScene& scene) {
  constexpr double as_well = 1e-9;
  MaterialFit material(paint, scene);
  PaintFit result;
  if (paint.exponent) {
    result.exponent = result.least_exponent = result.most_exponent = *paint.exponent;
  } else {
    ExponentSearch search(material);
    result.exponent = search.best();
    const double least = MaterialFit::cost(material.fits(result.exponent));
    const double near = std::sqrt(least) + as_well * std::sqrt(wanted_square(paint));
    std::tie(result.least_exponent, result.most_exponent) = search.range(near * near);
    result.least_exponent = std::min(result.least_exponent, result.exponent);
    result.most_exponent = std::max(result.most_exponent, result.exponent);
  }
  result.channels = material.fits(result.exponent);
  return result;
}

}  // namespace

PaintFit fitted(const Paint& paint, const SpaceScene& scene) {
  const auto has_bounds = [](const PaintSample& s) { return s.wanted.empty(); };
  const auto bounds = std::ranges::count_if(paint.samples, has_bounds);
  if (bounds != 0 && (bounds != std::ssize(paint.samples) || paint.fit == Paint::Fit::intensities)) {
    throw UnsupportedSceneError("bounds of samples are taken for materials, and for all samples or none");
  }
  return paint.fit == Paint::Fit::intensities ? fitted_intensities(paint, scene) : fitted_material(paint, scene);
}

}  // namespace gnomon
