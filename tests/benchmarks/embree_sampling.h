#pragma once

#include <cstddef>
#include <memory>

#include "tests/benchmarks/triangle_scenes.h"

namespace gnomon::benchmarks {

/// Irradiance by shadow rays of Embree 3 to stratified samples of the light, one in each of k * k cells.
class EmbreeSampling {
 public:
  explicit EmbreeSampling(const TriangleScene& scene);
  ~EmbreeSampling();

  /// Irradiance of radiance 1 at the point, for the normal (0, 0, 1); an estimate that differs from call to call.
  double irradiance(const Point3& point, std::size_t k);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// The least k of 4, 6, 8, 12, 16, ... whose root mean square error over the scene's points is at most `relative` of
/// the mean of the expected values.
std::size_t cells_for_error(EmbreeSampling& sampling, const TriangleScene& scene, const std::vector<double>& expected,
                            double relative);

}  // namespace gnomon::benchmarks
