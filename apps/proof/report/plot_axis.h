#pragma once

#include <string>
#include <vector>

#include "apps/proof/report/svg_plot.h"

namespace gnomon::report {

/// A place on an axis that is labelled.
struct Tick {
  double place = 0;  ///< 0 at the axis' start, 1 at its end
  std::string label;
  std::string exponent;  ///< raised behind the label
};

/// Where values stand on an axis.
class AxisScale {
 public:
  /// Holds all values.
  AxisScale(Scale scale, const std::vector<double>& values);

  /// 0 at the axis' start, 1 at its end.
  double place(double value) const;

  std::vector<Tick> ticks() const;

 private:
  std::vector<Tick> decades() const;
  std::vector<Tick> steps() const;

  Scale scale_;
  double low_ = 0;  ///< of the logarithms to base 10, on a logarithmic axis
  double high_ = 1;
  bool has_shelf_ = false;  ///< for zeros, one decade below the others
};

}  // namespace gnomon::report
