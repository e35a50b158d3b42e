#include "gnomon/light_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// Correctly rounded.
double part_area(const AreaLight& light) {
  ExactPolygon corners;
  for (const Point3& p : light.polygon.points()) corners.push_back(exact(p));
  const ExactVector doubled = doubled_area(corners);
  return nearest_root(Rational(dot(doubled, doubled))) / 2;
}

/// True if the polygon shows the point a side from which it shines.
bool shows_front(const AreaLight& light, const Point3& p) {
  const auto corner = [&](std::size_t k) { return light.polygon.points()[light.polygon.corners()[k]]; };
  const int side = exact_orientation(corner(0), corner(1), corner(2), p);
  return light.two_sided ? side != 0 : side > 0;
}

/// Adds up what is seen of the parts that take part.
class Sum {
 public:
  void add(double area, const Visibility& seen) {
    area_ += area;
    if (seen.region == Region::unlit) {
      all_before_ = false;
      return;
    }
    any_ = true;
    all_lit_ = all_lit_ && seen.region == Region::lit;
    all_hidden_ = all_hidden_ && seen.region == Region::umbra;
    all_before_ = all_before_ && seen.before_receiver == 1;
    visible_ += area * seen.fraction;
    before_ += area * seen.before_receiver;
    error_ += area * seen.error_bound;
  }

  /// Bound. Areas and shares are off by u of themselves, products by u more, and sums of n positive terms by n u: the
  /// quotient of two by less than 2 (n + 4) u, and it is at most 1.
  Visibility visibility(std::size_t count) const {
    if (!any_) return {Region::unlit, 0, 0, 0};
    const double rounded = 0x1p-52 * static_cast<double>(count + 4);
    const double before = all_before_ ? 1 : std::min(before_ / area_, 1.0);
    if (all_hidden_) return {Region::umbra, 0, 0, before};
    if (all_lit_) return {Region::lit, before, all_before_ ? 0 : rounded, before};
    return {Region::penumbra, std::clamp(visible_ / area_, 0.0, 1.0), 1.01 * error_ / area_ + rounded, before};
  }

 private:
  double area_ = 0, visible_ = 0, before_ = 0, error_ = 0;
  bool any_ = false, all_lit_ = true, all_hidden_ = true, all_before_ = true;
};

}  // namespace

class PartsVisibility::Work {
 public:
  Work(std::vector<Light> parts, const PreparedObstacles& obstacles, const LinearSearch& search) {
    if (parts.empty()) throw PreconditionError("a light has at least one part");
    for (Light& part : parts) {
      const auto* area = std::get_if<AreaLight>(&part);
      if (parts.size() > 1 && (!area || !area->polygon.is_flat())) {
        throw PreconditionError("parts of a light are flat polygons");
      }
      if (parts.size() > 1) areas_.push_back(part_area(*area));
      if (parts.size() > 1) shapes_.push_back(*area);
      seen_.emplace_back(std::move(part), obstacles, search);
    }
  }

  template <class Ask>
  Visibility answer(const Point3& place, const Ask& ask) {
    if (seen_.size() == 1) return ask(seen_.front());
    Sum sum;
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      if (shows_front(shapes_[k], place)) sum.add(areas_[k], ask(seen_[k]));
    }
    return sum.visibility(seen_.size());
  }

 private:
  std::vector<double> areas_;
  std::vector<AreaLight> shapes_;
  std::vector<LightVisibility> seen_;
};

PartsVisibility::PartsVisibility(std::vector<Light> parts, const PreparedObstacles& obstacles,
                                 const LinearSearch& search)
    : work_(std::make_unique<Work>(std::move(parts), obstacles, search)) {}
PartsVisibility::PartsVisibility(PartsVisibility&&) noexcept = default;
PartsVisibility& PartsVisibility::operator=(PartsVisibility&&) noexcept = default;
PartsVisibility::~PartsVisibility() = default;

Visibility PartsVisibility::at(const Point3& p) {
  return work_->answer(p, [&](LightVisibility& part) { return part.at(p); });
}

Visibility PartsVisibility::received(const ReceiverPoint& receiver) {
  return work_->answer(receiver.point, [&](LightVisibility& part) { return part.received(receiver); });
}

}  // namespace gnomon
