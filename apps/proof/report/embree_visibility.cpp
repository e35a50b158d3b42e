#include "apps/proof/report/embree_visibility.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "apps/proof/report/embree_rays.h"
#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

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

}  // namespace

struct EmbreeVisibility::Work {
  Work(const AreaLight& light, std::span<const ConvexBlocker> blockers)
      : shadow_rays(blockers), square(light.polygon), two_sided(light.two_sided) {}

  void place_points();
  template <class Visit>
  void for_each_visible(const Point3& p, const Visit& visit);

  EmbreeRays shadow_rays;
  LightSquare square;
  bool two_sided;
  Placing placing = Placing::regular;
  Rays rays = Rays::single;
  std::size_t k = 1;
  std::minstd_rand engine{1};
  std::vector<Point3> points;
};

void EmbreeVisibility::Work::place_points() {
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

/// Calls with the way to every point of the light that is not hidden.
template <class Visit>
void EmbreeVisibility::Work::for_each_visible(const Point3& p, const Visit& visit) {
  if (rays == Rays::single) {
    for (const Point3& l : points) {
      const Point3 towards = difference(l, p);
      if (!shadow_rays.is_hidden(p, towards)) visit(towards);
    }
    return;
  }
  for (std::size_t first = 0; first < points.size(); first += 8) {
    const auto ends = std::span<const Point3>(points).subspan(first, std::min<std::size_t>(8, points.size() - first));
    const unsigned hidden = shadow_rays.hidden_of_eight(p, ends);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if ((hidden >> i & 1U) == 0) visit(difference(ends[i], p));
    }
  }
}

EmbreeVisibility::EmbreeVisibility(const AreaLight& light, std::span<const ConvexBlocker> blockers)
    : work_(std::make_unique<Work>(light, blockers)) {
  place(Placing::regular, 1);
}

EmbreeVisibility::EmbreeVisibility(EmbreeVisibility&&) noexcept = default;
EmbreeVisibility& EmbreeVisibility::operator=(EmbreeVisibility&&) noexcept = default;
EmbreeVisibility::~EmbreeVisibility() = default;

void EmbreeVisibility::place(Placing placing, std::size_t k, Rays rays) {
  work_->placing = placing;
  work_->rays = rays;
  work_->k = k;
  work_->engine.seed(1);
  work_->place_points();
}

VisibilityAnswer EmbreeVisibility::visible_from(const Point3& p, const Point3& normal) {
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

std::size_t EmbreeVisibility::bytes() const {
  return work_->shadow_rays.bytes();
}

}  // namespace gnomon::report
