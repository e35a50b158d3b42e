#include "gnomon/irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

double rounded_up(double value) {
  return std::nextafter(value, no_limit);
}

double rounded_down(double value) {
  return std::nextafter(value, -no_limit);
}

/// What rounding has taken from a + b: exact, unless something overflows.
double lost_in_sum(double a, double b, double sum) {
  const double of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b);
}

/// Bounds that are sums of exact errors stay exact: nothing is lost where nothing is rounded.
double bound_of_sum(double a, double b, double lost) {
  return lost == 0 && (a == 0 || b == 0) ? a + b : rounded_up(rounded_up(a + b) + std::fabs(lost));
}

Irradiance bounded_sum(const Irradiance& a, const Irradiance& b) {
  const double value = a.value + b.value;
  if (!std::isfinite(value)) return {no_limit, no_limit};
  return {value, bound_of_sum(a.error_bound, b.error_bound, lost_in_sum(a.value, b.value, value))};
}

/// A value of which the exact one lies from low to high.
Irradiance enclosed(double value, double low, double high) {
  if (!std::isfinite(value)) return {no_limit, no_limit};
  if (low == value && high == value) return {value, 0};
  return {value, rounded_up(std::max(value - low, high - value))};
}

double lower_end(const Irradiance& e) {
  return e.error_bound == 0 ? e.value : rounded_down(e.value - e.error_bound);
}

double upper_end(const Irradiance& e) {
  return e.error_bound == 0 ? e.value : rounded_up(e.value + e.error_bound);
}

}  // namespace

Irradiance total_irradiance(std::span<const Irradiance> parts) {
  Irradiance total;
  for (const Irradiance& part : parts) total = bounded_sum(total, part);
  return total;
}

void IrradianceSummary::add(const Irradiance& irradiance) {
  const bool is_first = count_++ == 0;
  sum_ = bounded_sum(sum_, irradiance);
  // Infinite values with infinite bounds: what is known is that they are infinite.
  const bool is_infinite = !std::isfinite(irradiance.value);
  const double low = is_infinite ? no_limit : lower_end(irradiance);
  const double high = is_infinite ? no_limit : upper_end(irradiance);
  least_ = is_first ? irradiance.value : std::min(least_, irradiance.value);
  least_low_ = is_first ? low : std::min(least_low_, low);
  least_high_ = is_first ? high : std::min(least_high_, high);
  largest_ = is_first ? irradiance.value : std::max(largest_, irradiance.value);
  largest_low_ = is_first ? low : std::max(largest_low_, low);
  largest_high_ = is_first ? high : std::max(largest_high_, high);
}

Irradiance IrradianceSummary::mean() const {
  if (count_ == 0) throw PreconditionError("IrradianceSummary: the mean of nothing");
  if (!std::isfinite(sum_.value)) return sum_;
  const auto n = static_cast<double>(count_);
  const double value = sum_.value / n;
  const double lost = std::fabs(std::fma(-value, n, sum_.value)) / n;
  if (lost == 0 && sum_.error_bound == 0) return {value, 0};
  return {value, rounded_up(rounded_up(sum_.error_bound / n) + rounded_up(lost))};
}

Irradiance IrradianceSummary::least() const {
  return enclosed(least_, least_low_, least_high_);
}

Irradiance IrradianceSummary::largest() const {
  return enclosed(largest_, largest_low_, largest_high_);
}

}  // namespace gnomon
