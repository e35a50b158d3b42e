#include "apps/proof/report/pareto.h"

#include <algorithm>
#include <cmath>

#include "apps/proof/report/selection.h"

namespace gnomon::report {
namespace {

/// The value at a share of the way from one positive number to another, on a logarithmic scale.
double interpolated(double low, double high, double share) {
  return std::exp((1 - share) * std::log(low) + share * std::log(high));
}

/// The measurements of one method, by ascending number of samples.
std::vector<Measurement> of_method(std::span<const Measurement> all, const Measurement& like,
                                   const std::string& method) {
  std::vector<Measurement> found;
  for (const Measurement& m : all) {
    if (m.task == like.task && m.size == like.size && m.method == method) found.push_back(m);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.samples < b.samples; });
  return found;
}

}  // namespace

std::vector<Measurement> pareto_front(std::span<const Measurement> measurements) {
  std::vector<Measurement> sorted(measurements.begin(), measurements.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.seconds.median < b.seconds.median; });
  std::vector<Measurement> front;
  for (const Measurement& m : sorted) {
    if (front.empty() || m.errors.rms < front.back().errors.rms) front.push_back(m);
  }
  return front;
}

std::vector<Equivalent> equivalents(std::span<const Measurement> measurements) {
  std::vector<Equivalent> all;
  for (const Measurement& gnomon : measurements) {
    if (gnomon.method != "gnomon") continue;
    for (const char* method : sampling_methods) {
      const std::vector<Measurement> sampled = of_method(measurements, gnomon, method);
      if (sampled.size() < 2) continue;
      std::size_t k = 1;
      while (k + 1 < sampled.size() && sampled[k].seconds.median < gnomon.seconds.median) ++k;
      const Measurement &low = sampled[k - 1], &high = sampled[k];
      const double share =
          std::log(gnomon.seconds.median / low.seconds.median) / std::log(high.seconds.median / low.seconds.median);
      const double samples = interpolated(static_cast<double>(low.samples), static_cast<double>(high.samples), share);
      const double rms = interpolated(low.errors.rms, high.errors.rms, std::clamp(share, 0.0, 1.0));
      all.push_back({gnomon.task, method, gnomon.size, samples, rms});
    }
  }
  return all;
}

std::optional<double> seconds_for_error(std::span<const Measurement> measurements, const Measurement& like,
                                        ErrorScale scale, double wanted) {
  const std::vector<Measurement> sampled = of_method(measurements, like, like.method);
  if (sampled.size() < 2) return std::nullopt;
  const auto error = [&](std::size_t k) {
    const Errors& e = sampled[k].errors;
    return scale == ErrorScale::own_value ? e.relative_rms : e.rms / e.largest;
  };
  std::size_t k = 1;
  while (k + 1 < sampled.size() && error(k) > wanted) ++k;
  const double share = std::log(wanted / error(k - 1)) / std::log(error(k) / error(k - 1));
  return interpolated(sampled[k - 1].seconds.median, sampled[k].seconds.median, share);
}

}  // namespace gnomon::report
