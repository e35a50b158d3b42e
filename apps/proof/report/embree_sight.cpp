#include "apps/proof/report/embree_sight.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
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

/// A light as the image of a unit square that keeps areas in proportion.
class LightSquare {
 public:
  explicit LightSquare(const ConvexPolygon& polygon) {
    for (const std::uint32_t i : polygon.corners()) corners_.push_back(polygon.points()[i]);
    is_parallelogram_ = corners_.size() == 4 && sum(corners_[0], corners_[2]) == sum(corners_[1], corners_[3]);
    for (std::size_t k = 2; k < corners_.size(); ++k) {
      const Point3 area = cross(difference(corners_[k - 1], corners_[0]), difference(corners_[k], corners_[0]));
      shares_.push_back(length(area) + (shares_.empty() ? 0 : shares_.back()));
    }
    for (double& share : shares_) share /= shares_.back();
    shares_.back() = 1;
    normal_ = cross(difference(corners_[1], corners_[0]), difference(corners_[2], corners_[0]));
    area_ = 0;
    for (std::size_t k = 2; k < corners_.size(); ++k) {
      area_ += length(cross(difference(corners_[k - 1], corners_[0]), difference(corners_[k], corners_[0]))) / 2;
    }
    normal_ = scaled(1 / length(normal_), normal_);
  }

  Point3 at(double s, double t) const {
    if (is_parallelogram_) {
      return sum(corners_[0],
                 sum(scaled(s, difference(corners_[1], corners_[0])), scaled(t, difference(corners_[3], corners_[0]))));
    }
    std::size_t k = 0;
    while (s > shares_[k]) ++k;
    const double before = k == 0 ? 0 : shares_[k - 1];
    const double root = std::sqrt((s - before) / (shares_[k] - before));
    return between(corners_[0], between(corners_[k + 1], corners_[k + 2], t), root);
  }

  const Point3& normal() const { return normal_; }
  const Point3& corner() const { return corners_[0]; }
  double area() const { return area_; }

 private:
  std::vector<Point3> corners_;
  std::vector<double> shares_;  ///< of the area, up to each triangle of the fan
  bool is_parallelogram_ = false;
  Point3 normal_;
  double area_ = 0;
};

bool count_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<std::size_t*>(total) += static_cast<std::size_t>(bytes);
  return true;
}

}  // namespace

struct EmbreeSight::Work {
  explicit Work(const AreaLight& light) : square(light.polygon), two_sided(light.two_sided) {}
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void build(const std::vector<Point3>& corners);
  void place_points();
  bool is_hidden(const Point3& p, const Point3& towards);
  unsigned hidden_of_eight(const Point3& p, std::span<const Point3> ends);
  template <class Visit>
  void for_each_visible(const Point3& p, const Visit& visit);

  std::size_t bytes = 0;
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCIntersectContext context{};
  RTCIntersectContext coherent{};  ///< for packets
  LightSquare square;
  bool two_sided;
  Placing placing = Placing::regular;
  Rays rays = Rays::single;
  std::size_t k = 1;
  std::minstd_rand engine{1};
  std::vector<Point3> points;
};

void EmbreeSight::Work::build(const std::vector<Point3>& corners) {
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

void EmbreeSight::Work::place_points() {
  const double cell = 1.0 / static_cast<double>(k);
  const auto drawn = [&] { return placing == Placing::regular ? 0.5 : static_cast<double>(engine()) / 2147483647.0; };
  points.clear();
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const double s = (static_cast<double>(i) + drawn()) * cell;
      points.push_back(square.at(s, (static_cast<double>(j) + drawn()) * cell));
    }
  }
}

bool EmbreeSight::Work::is_hidden(const Point3& p, const Point3& towards) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(p.x);
  ray.org_y = static_cast<float>(p.y);
  ray.org_z = static_cast<float>(p.z);
  ray.dir_x = static_cast<float>(towards.x);
  ray.dir_y = static_cast<float>(towards.y);
  ray.dir_z = static_cast<float>(towards.z);
  ray.tfar = 1;
  ray.mask = 0xFFFFFFFF;
  rtcOccluded1(scene, &context, &ray);
  return ray.tfar < 0;
}

/// At most eight rays from one point. Returns: bit i if the ray to end i is hidden.
unsigned EmbreeSight::Work::hidden_of_eight(const Point3& p, std::span<const Point3> ends) {
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
  rtcOccluded8(valid, scene, &coherent, &packet);
  unsigned hidden = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) hidden |= packet.tfar[i] < 0 ? 1U << i : 0U;
  return hidden;
}

/// Calls with the way to every point of the light that is not hidden.
template <class Visit>
void EmbreeSight::Work::for_each_visible(const Point3& p, const Visit& visit) {
  if (rays == Rays::single) {
    for (const Point3& l : points) {
      const Point3 towards = difference(l, p);
      if (!is_hidden(p, towards)) visit(towards);
    }
    return;
  }
  for (std::size_t first = 0; first < points.size(); first += 8) {
    const auto ends = std::span<const Point3>(points).subspan(first, std::min<std::size_t>(8, points.size() - first));
    const unsigned hidden = hidden_of_eight(p, ends);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if ((hidden >> i & 1U) == 0) visit(difference(ends[i], p));
    }
  }
}

EmbreeSight::EmbreeSight(const AreaLight& light, std::span<const ConvexBlocker> blockers)
    : work_(std::make_unique<Work>(light)) {
  work_->build(triangles(blockers));
  place(Placing::regular, 1);
}

EmbreeSight::EmbreeSight(EmbreeSight&&) noexcept = default;
EmbreeSight& EmbreeSight::operator=(EmbreeSight&&) noexcept = default;
EmbreeSight::~EmbreeSight() = default;

void EmbreeSight::place(Placing placing, std::size_t k, Rays rays) {
  work_->placing = placing;
  work_->rays = rays;
  work_->k = k;
  work_->engine.seed(1);
  work_->place_points();
}

SightAnswer EmbreeSight::seen_from(const Point3& p, const Point3& normal) {
  if (work_->placing == Placing::stratified) work_->place_points();
  const LightSquare& square = work_->square;
  const double side = dot(difference(p, square.corner()), square.normal());
  if (side == 0 || (side < 0 && !work_->two_sided)) return {Region::unlit, 0, 0};
  std::size_t visible = 0;
  double sum = 0;
  work_->for_each_visible(p, [&](const Point3& towards) {
    ++visible;
    const double squared = dot(towards, towards);
    sum += dot(towards, normal) * std::fabs(dot(towards, square.normal())) / (squared * squared);
  });
  const auto count = static_cast<double>(work_->points.size());
  const Region region = visible == 0 ? Region::umbra : visible == work_->points.size() ? Region::lit : Region::penumbra;
  return {region, static_cast<double>(visible) / count, sum * square.area() / count / length(normal)};
}

std::size_t EmbreeSight::bytes() const {
  return work_->bytes;
}

}  // namespace gnomon::report
