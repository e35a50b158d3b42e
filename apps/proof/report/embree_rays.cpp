#include "apps/proof/report/embree_rays.h"

#include <embree3/rtcore.h>

#include <vector>

#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

/// Every triangle of the blockers; polygons as fans from their first corner.
std::vector<Point3> triangles(std::span<const ConvexBlocker> blockers) {
  std::vector<Point3> corners;
  const auto add_fan = [&](std::span<const Point3> points, std::span<const std::uint32_t> loop) {
    for (std::size_t k = 2; k < loop.size(); ++k) {
      for (const std::size_t i : {std::size_t{0}, k - 1, k}) corners.push_back(points[loop[i]]);
    }
  };
  for (const ConvexBlocker& blocker : blockers) {
    if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
      add_fan(polygon->points(), polygon->corners());
    } else {
      const auto& solid = std::get<ConvexSolid>(blocker);
      for (const ConvexSolid::Facet& facet : solid.facets()) add_fan(solid.points(), facet.loop);
    }
  }
  return corners;
}

bool count_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<std::size_t*>(total) += static_cast<std::size_t>(bytes);
  return true;
}

}  // namespace

struct EmbreeRays::Work {
  Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void build(const std::vector<Point3>& corners);

  std::size_t bytes = 0;
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCIntersectContext context{};
  RTCIntersectContext coherent{};  ///< for packets
};

void EmbreeRays::Work::build(const std::vector<Point3>& corners) {
  rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &bytes);
  rtcInitIntersectContext(&context);
  rtcInitIntersectContext(&coherent);
  coherent.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), corners.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const double coordinate : {corners[i].x, corners[i].y, corners[i].z}) {
      *vertices++ = static_cast<float>(coordinate);
    }
    indices[i] = static_cast<unsigned>(i);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
}

EmbreeRays::EmbreeRays(std::span<const ConvexBlocker> blockers) : work_(std::make_unique<Work>()) {
  work_->build(triangles(blockers));
}

EmbreeRays::EmbreeRays(EmbreeRays&&) noexcept = default;
EmbreeRays& EmbreeRays::operator=(EmbreeRays&&) noexcept = default;
EmbreeRays::~EmbreeRays() = default;

bool EmbreeRays::is_hidden(const Point3& p, const Point3& towards) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(p.x);
  ray.org_y = static_cast<float>(p.y);
  ray.org_z = static_cast<float>(p.z);
  ray.dir_x = static_cast<float>(towards.x);
  ray.dir_y = static_cast<float>(towards.y);
  ray.dir_z = static_cast<float>(towards.z);
  ray.tfar = 1;
  ray.mask = 0xFFFFFFFF;
  rtcOccluded1(work_->scene, &work_->context, &ray);
  return ray.tfar < 0;
}

unsigned EmbreeRays::hidden_of_eight(const Point3& p, std::span<const Point3> ends) {
  alignas(32) RTCRay8 packet{};
  alignas(32) int valid[8] = {};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point3 towards = difference(ends[i], p);
    valid[i] = -1;
    packet.org_x[i] = static_cast<float>(p.x);
    packet.org_y[i] = static_cast<float>(p.y);
    packet.org_z[i] = static_cast<float>(p.z);
    packet.dir_x[i] = static_cast<float>(towards.x);
    packet.dir_y[i] = static_cast<float>(towards.y);
    packet.dir_z[i] = static_cast<float>(towards.z);
    packet.tfar[i] = 1;
    packet.mask[i] = 0xFFFFFFFF;
  }
  rtcOccluded8(valid, work_->scene, &work_->coherent, &packet);
  unsigned hidden = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) hidden |= packet.tfar[i] < 0 ? 1U << i : 0U;
  return hidden;
}

std::size_t EmbreeRays::bytes() const {
  return work_->bytes;
}

}  // namespace gnomon::report
