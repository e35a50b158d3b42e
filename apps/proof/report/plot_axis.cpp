#include "apps/proof/report/plot_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gnomon::report {
namespace {

constexpr int most_labels = 10;

}  // namespace

AxisScale::AxisScale(Scale scale, const std::vector<double>& values) : scale_(scale) {
  bool first = true;
  for (const double value : values) {
    if (scale == Scale::logarithmic && !(value > 0)) {
      has_shelf_ = true;
      continue;
    }
    const double place = scale == Scale::logarithmic ? std::log10(value) : value;
    low_ = first ? place : std::min(low_, place);
    high_ = first ? place : std::max(high_, place);
    first = false;
  }
  if (scale == Scale::logarithmic) {
    low_ = std::floor(low_ - 0.05) - (has_shelf_ ? 1 : 0);
    high_ = std::max(std::ceil(high_ + 0.05), low_ + 1);
  } else {
    const double margin = high_ > low_ ? 0.04 * (high_ - low_) : 0.5;
    low_ -= margin;
    high_ += margin;
  }
}

double AxisScale::place(double value) const {
  if (scale_ == Scale::linear) return (value - low_) / (high_ - low_);
  return value > 0 ? (std::log10(value) - low_) / (high_ - low_) : 0;
}

std::vector<Tick> AxisScale::decades() const {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(low_) + (has_shelf_ ? 1 : 0), last = static_cast<int>(high_);
  const int step = (last - first + most_labels - 1) / most_labels;
  if (has_shelf_) ticks.push_back({0, "0", ""});
  for (int exponent = first; exponent <= last; exponent += step) {
    ticks.push_back({(exponent - low_) / (high_ - low_), "10", std::to_string(exponent)});
  }
  return ticks;
}

std::vector<Tick> AxisScale::steps() const {
  const double rough = (high_ - low_) / most_labels;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double nice : {5.0, 2.0, 1.0}) step = nice * decade >= rough ? nice * decade : step;
  std::vector<Tick> ticks;
  for (auto k = static_cast<long>(std::ceil(low_ / step)); static_cast<double>(k) * step <= high_; ++k) {
    const double value = static_cast<double>(k) * step;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    ticks.push_back({(value - low_) / (high_ - low_), text.data(), ""});
  }
  return ticks;
}

std::vector<Tick> AxisScale::ticks() const {
  return scale_ == Scale::logarithmic ? decades() : steps();
}

}  // namespace gnomon::report
