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

/// The squared error of an estimate from k * k cells at each of the scene's points, added up.
double squared_error(EmbreeSampling& sampling, const TriangleScene& scene, const std::vector<double>& expected,
                     std::size_t k);

}  // namespace gnomon::benchmarks
