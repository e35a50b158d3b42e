#include "tests/benchmarks/embree_sampling.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <random>

namespace gnomon::benchmarks {

struct EmbreeSampling::Work {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  std::minstd_rand engine{1};

  ~Work() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

EmbreeSampling::EmbreeSampling(const TriangleScene& scene) : work_(std::make_unique<Work>()) {
  const std::size_t n = scene.blockers.size();
  RTCGeometry geometry = rtcNewGeometry(work_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), n));
  for (std::size_t i = 0; i < n; ++i) {
    for (const Point3& p : std::get<ConvexPolygon>(scene.blockers[i]).points()) {
      for (const double coordinate : {p.x, p.y, p.z}) *vertices++ = static_cast<float>(coordinate);
    }
    for (std::size_t k = 0; k < 3; ++k) indices[3 * i + k] = static_cast<unsigned>(3 * i + k);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(work_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(work_->scene);
}

EmbreeSampling::~EmbreeSampling() = default;

double EmbreeSampling::irradiance(const Point3& point, std::size_t k) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const double cell = 1.0 / static_cast<double>(k);
  const auto jittered = [&](std::size_t i) {
    return (static_cast<double>(i) + static_cast<double>(work_->engine()) / 2147483647.0) * cell - 0.5;
  };
  double sum = 0;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const double x = jittered(i) - point.x;
      const double y = jittered(j) - point.y;
      RTCRay ray{};
      ray.org_x = static_cast<float>(point.x);
      ray.org_y = static_cast<float>(point.y);
      ray.org_z = static_cast<float>(point.z);
      ray.dir_x = static_cast<float>(x);
      ray.dir_y = static_cast<float>(y);
      ray.dir_z = 4;
      ray.tfar = 1;
      ray.mask = 0xFFFFFFFF;
      rtcOccluded1(work_->scene, &context, &ray);
      const double squared = x * x + y * y + 16;
      if (ray.tfar > 0) sum += 16 / (squared * squared);
    }
  }
  return sum * cell * cell;
}

double squared_error(EmbreeSampling& sampling, const TriangleScene& scene, const std::vector<double>& expected,
                     std::size_t k) {
  double squares = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const double error = sampling.irradiance(scene.points[i], k) - expected[i];
    squares += error * error;
  }
  return squares;
}

}  // namespace gnomon::benchmarks
