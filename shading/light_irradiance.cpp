#include "gnomon/irradiance.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/visibility/prepared_obstacles.h"
#include "geometry/visibility/visible_part.h"
#include "gnomon/errors.h"
#include "shading/exact_direction.h"
#include "shading/lambert.h"
#include "shading/reflection/linear_reflection.h"
#include "shading/small_lights.h"

namespace gnomon {
namespace {

using shading::unit;

/// The widest bound per strength that is taken from the fast level.
constexpr double widest_bound = 1e-6;

/// With coordinates that are each off by at most u times themselves; of no direction nothing is claimed.
VisibleDirection rounded(const ExactVector& v) {
  if (is_zero(v)) return {0, 0, 0, HUGE_VAL};
  const shading::Vector d = shading::direction_of(v);
  return {d.x, d.y, d.z, 1.01 * unit};
}

/// The boundary of one exact polygon; `turned` if it runs clockwise seen from p.
std::vector<BoundaryPiece> boundary_of(const ExactPolygon& polygon, const ExactVector& p, bool turned) {
  std::vector<BoundaryPiece> boundary;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    ExactVector from = polygon[k] - p;
    ExactVector to = polygon[(k + 1) % polygon.size()] - p;
    if (turned) std::swap(from, to);
    boundary.push_back({std::nullopt, 0, rounded(from), rounded(to), rounded(cross(from, to))});
  }
  return boundary;
}

Irradiance sum_of(const Irradiance& a, const Irradiance& b) {
  const double value = a.value + b.value;
  return {value, a.error_bound + b.error_bound + 2 * unit * value};
}

/// Of a facet's visible pieces, each added up for itself. A facet that turns its back gives nothing.
Irradiance facet_irradiance(const VisibleFacet& seen, bool two_sided, const ExactVector& p, const Point3& normal) {
  const ExactPlane plane = plane_through(seen.facet[0], seen.facet[1], seen.facet[2]);
  const int side = plane.height(p).sign();
  if (side == 0 || (side < 0 && !two_sided)) return {};
  Irradiance sum;
  for (const ExactPolygon& polygon : seen.visible) {
    // Counterclockwise from the front, a polygon has its planes' negative sides inside for who stands there.
    const std::vector<BoundaryPiece> boundary = boundary_of(polygon, p, side > 0);
    const VisibleDirection forward = rounded(Rational(-side) * plane.normal);
    sum = sum_of(sum, lambert_irradiance({Region::penumbra, 0, 0, boundary, forward}, normal, 1));
  }
  return sum;
}

Irradiance irradiance_without_size(const Light& light, const Point3& p, const Point3& normal) {
  if (const auto* point = std::get_if<PointLight>(&light)) return point_irradiance(*point, p, normal);
  return directional_irradiance(std::get<DirectionalLight>(light), normal);
}

/// What is positive, though rounding may have left nothing of it.
Irradiance positive(const Irradiance& e) {
  if (e.value > 0) return e;
  return {std::numeric_limits<double>::denorm_min(), shading::with_underflow(e.error_bound)};
}

/// A view of which only what is received counts.
shading::ReflectionQuery visibility_of_received(const Point3& p, const Point3& normal) {
  const shading::Vector n = shading::of_size_one({normal.x, normal.y, normal.z});
  return {p, n, n, {ReflectionModel::phong, 0}};
}

bool receives(Region region) {
  return region == Region::lit || region == Region::penumbra;
}

/// What the fast level sees of a light, and what it gives. Nothing also where rounding leaves nothing of what there is.
struct Received {
  const Light& light;
  const ReceiverPoint& receiver;
  const Point3& normal;

  std::optional<Irradiance> operator()(FastPointVisibility& level) const {
    const std::optional<Region> region = level.region_of(receiver);
    if (!region) return std::nullopt;
    return receives(*region) ? positive(irradiance_without_size(light, receiver.point, normal)) : Irradiance{};
  }
  std::optional<Irradiance> operator()(FastLinearVisibility& level) const {
    const std::optional<VisibleLinearLight> seen = level.visible_by(receiver);
    if (!seen) return std::nullopt;
    if (!receives(seen->region)) return Irradiance{};
    const auto& linear = std::get<LinearLight>(light);
    if (is_isotropic(linear.emission)) return if_positive(linear_irradiance(linear, *seen, receiver.point, normal));
    const auto reflected = shading::linear_reflection(linear, *seen, visibility_of_received(receiver.point, normal));
    return reflected ? std::optional(reflected->received) : std::nullopt;
  }
  std::optional<Irradiance> operator()(FastVisibility& level) const {
    const std::optional<VisibleAreaLight> seen = level.visible_by(receiver);
    if (!seen) return std::nullopt;
    if (!receives(seen->region)) return Irradiance{};
    return if_positive(lambert_irradiance(*seen, normal, 1));
  }

  static std::optional<Irradiance> if_positive(const Irradiance& e) {
    return e.value > 0 ? std::optional(e) : std::nullopt;
  }
};

Irradiance scaled(const Irradiance& e, double strength) {
  if (strength == 0) return {};
  if (e.value == 0 && e.error_bound == 0) return {};
  const double least = e.value > 0 ? std::numeric_limits<double>::denorm_min() : 0;
  const double value = std::fmax(strength * e.value, least);
  return {value, shading::with_underflow(1.001 * strength * e.error_bound + 2 * unit * value)};
}

}  // namespace

class LightIrradiance::Work {
 public:
  Work(Light light, double strength, PreparedObstacles obstacles, const LinearSearch& search)
      : light_(std::move(light)),
        strength_(strength),
        obstacles_(std::move(obstacles)),
        fast_(fast_level(light_, obstacles_, search, Trees::grown)) {}

  Irradiance answer(const ReceiverPoint& receiver, const Point3& normal) {
    const std::optional<Irradiance> fast = fast_answer(receiver, normal);
    return scaled(fast ? *fast : exact_answer(receiver, normal), strength_);
  }

 private:
  std::optional<Irradiance> fast_answer(const ReceiverPoint& receiver, const Point3& normal);
  Irradiance exact_answer(const ReceiverPoint& receiver, const Point3& normal) const;

  Light light_;
  double strength_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
};

std::optional<Irradiance> LightIrradiance::Work::fast_answer(const ReceiverPoint& receiver, const Point3& normal) {
  if (obstacles_.content().encloses(receiver)) return Irradiance{};
  const std::optional<Irradiance> e = std::visit(Received{light_, receiver, normal}, fast_);
  if (!e || !(e->error_bound >= 0 && e->error_bound <= widest_bound)) return std::nullopt;
  return e;
}

Irradiance LightIrradiance::Work::exact_answer(const ReceiverPoint& receiver, const Point3& normal) const {
  const Point3& p = receiver.point;
  const VisiblePart part = exact_visible_part(light_, obstacles_.obstacles(), receiver);
  if (!receives(part.region)) return {};
  if (std::holds_alternative<PointLight>(light_) || std::holds_alternative<DirectionalLight>(light_)) {
    return positive(irradiance_without_size(light_, p, normal));
  }
  if (const auto* linear = std::get_if<LinearLight>(&light_)) {
    if (is_isotropic(linear->emission)) return positive(linear_irradiance(*linear, part.intervals, p, normal));
    return shading::linear_reflection(*linear, part.intervals, visibility_of_received(p, normal)).received;
  }
  Irradiance sum;
  for (const VisibleFacet& seen : part.facets) {
    sum = sum_of(sum, facet_irradiance(seen, std::get<AreaLight>(light_).two_sided, exact(p), normal));
  }
  return positive(sum);
}

LightIrradiance::LightIrradiance(Light light, double strength, PreparedObstacles obstacles, const LinearSearch& search)
    : work_(std::make_unique<Work>(std::move(light), strength, std::move(obstacles), search)) {}
LightIrradiance::LightIrradiance(LightIrradiance&&) noexcept = default;
LightIrradiance& LightIrradiance::operator=(LightIrradiance&&) noexcept = default;
LightIrradiance::~LightIrradiance() = default;

Irradiance LightIrradiance::received(const ReceiverPoint& receiver, const Point3& normal) {
  if (normal == Point3{}) throw PreconditionError("the receiver's normal has no direction");
  return work_->answer(receiver, normal);
}

Irradiance LightIrradiance::at(const Point3& p, const Point3& normal) {
  return received({p, FacingNormal{normal}}, normal);
}

Irradiance light_irradiance(const Light& light, double strength, const Obstacles& obstacles, const Point3& p,
                            const Point3& normal) {
  return LightIrradiance(light, strength, PreparedObstacles(obstacles)).at(p, normal);
}

}  // namespace gnomon
