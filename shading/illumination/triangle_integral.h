#pragma once

/// Irradiance integrated over triangles. Private to the libraries.

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "geometry/numbers/place_key.h"
#include "gnomon/irradiance.h"
#include "shading/illumination/hidden_exchange.h"

namespace gnomon::illumination {

using Triangle = std::array<Point3, 3>;

/// The integral of irradiance over triangles of a receiver, each without a discontinuity inside. Its error is an
/// estimate.
class TriangleIntegral {
 public:
  TriangleIntegral(const RestingPiece& receiver, LightIrradiance& irradiance, const HiddenEffort& effort);

  /// The triangles together may be off by the tolerance, each by its share of the area.
  void add(const std::vector<Triangle>& triangles);

  /// Divided by pi.
  shading::Bounded value() const;
  std::size_t evaluations() const { return evaluations_; }

 private:
  struct Result {
    double value = 0;
    double off = HUGE_VAL;  ///< estimated error of the rule
    double bound = 0;       ///< sum of the errors at its nodes
  };
  struct Rule;

  static const std::array<Rule, 4>& rules();
  static double error_after(std::size_t rule, std::size_t earlier, double error, double scale);
  void add(const Triangle& whole, std::size_t of);
  std::vector<Triangle> with_limits_apart(const Triangle& whole) const;
  Triangle with_limits_first(const Triangle& t) const;
  bool has_many_limits(const Point3& p) const { return many_limits_.contains(place_key(p)); }
  std::array<Triangle, 2> halves(const Triangle& t) const;
  Result integral(const Triangle& t, double tolerance);
  Irradiance at(const Triangle& t, double r, double q);
  Result by_rule(const Triangle& t, const Rule& rule);
  double missed_by(const Triangle& t, const Rule& rule, double value);

  ReceiverPoint receiver_;  ///< at the place that was asked last
  Point3 normal_;
  LightIrradiance& irradiance_;
  HiddenEffort effort_;
  std::map<PlaceKey, Point3> many_limits_;
  double tolerance_per_area_ = 0;
  double sum_ = 0;
  double error_ = 0;
  std::size_t evaluations_ = 0;
  std::vector<double> values_;  ///< at the nodes of the last rule
};

}  // namespace gnomon::illumination
