#include <cmath>
#include <utility>

#include "geometry/visibility/prepared_obstacles.h"
#include "geometry/visibility/visible_part.h"
#include "gnomon/errors.h"
#include "gnomon/reflection.h"
#include "shading/reflection/area_reflection.h"
#include "shading/reflection/linear_reflection.h"
#include "shading/reflection/small_reflection.h"

namespace gnomon {
namespace {

using shading::ReflectionQuery;

bool is_reflected(Region region) {
  return region == Region::lit || region == Region::penumbra;
}

ReflectionQuery visibility_of(const View& view, ReflectionModel model, int exponent) {
  const auto& [point, n, e] = view;
  const auto is_finite = [](const Point3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  if (!is_finite(point) || !is_finite(n) || !is_finite(e) || n == Point3{} || e == Point3{}) {
    throw PreconditionError("a view needs finite coordinates, a normal and a direction to the eye");
  }
  if (exponent < 0 || exponent > 10000) throw PreconditionError("a lobe's exponent is from 0 to 10000");
  return {point, shading::of_size_one({n.x, n.y, n.z}), shading::of_size_one({e.x, e.y, e.z}), {model, exponent}};
}

bool is_eye_above(const ReflectionQuery& query) {
  const auto& n = query.normal;
  const auto& e = query.to_eye;
  const shading::Bounded height =
      dot(Vector3<shading::Bounded>{n.x, n.y, n.z}, Vector3<shading::Bounded>{e.x, e.y, e.z});
  const int sign = shading::certain_sign(height);
  return sign != 2 ? sign > 0 : dot(shading::exact(n), shading::exact(e)) > 0;
}

Reflection without_size(const Light& light, const ReflectionQuery& query) {
  if (const auto* point = std::get_if<PointLight>(&light)) return shading::point_reflection(*point, query);
  return shading::directional_reflection(std::get<DirectionalLight>(light), query);
}

/// What the fast level sees of a light, and what is reflected of it. Nothing where doubles do not decide.
struct Reflected {
  const Light& light;
  const ReceiverPoint& receiver;
  const ReflectionQuery& query;

  std::optional<Reflection> operator()(FastPointVisibility& level) const {
    const std::optional<Region> region = level.region_of(receiver);
    if (!region) return std::nullopt;
    return is_reflected(*region) ? without_size(light, query) : Reflection{};
  }
  std::optional<Reflection> operator()(FastLinearVisibility& level) const {
    const std::optional<VisibleLinearLight> seen = level.visible_by(receiver);
    if (!seen) return std::nullopt;
    if (!is_reflected(seen->region)) return Reflection{};
    return shading::linear_reflection(std::get<LinearLight>(light), *seen, query);
  }
  std::optional<Reflection> operator()(FastVisibility& level) const {
    const std::optional<VisibleAreaLight> seen = level.visible_by(receiver);
    if (!seen) return std::nullopt;
    if (!is_reflected(seen->region)) return Reflection{};
    return shading::area_reflection(*seen, query);
  }
};

}  // namespace

class LightReflection::Work {
 public:
  Work(Light light, PreparedObstacles obstacles, const LinearSearch& search)
      : light_(std::move(light)),
        obstacles_(std::move(obstacles)),
        fast_(fast_level(light_, obstacles_, search, Trees::none)) {}

  std::size_t answers = 0, exact_answers = 0;

  Reflection answer(const ReceiverPoint& receiver, const ReflectionQuery& query) {
    ++answers;
    if (!is_eye_above(query) || obstacles_.content().encloses(receiver)) return {};
    const std::optional<Reflection> fast = std::visit(Reflected{light_, receiver, query}, fast_);
    if (fast) return *fast;
    ++exact_answers;
    return exact_answer(receiver, query);
  }

 private:
  Reflection exact_answer(const ReceiverPoint& receiver, const ReflectionQuery& query) const {
    const VisiblePart part = exact_visible_part(light_, obstacles_.obstacles(), receiver);
    if (!is_reflected(part.region)) return {};
    if (const auto* linear = std::get_if<LinearLight>(&light_)) {
      return shading::linear_reflection(*linear, part.intervals, query);
    }
    if (const auto* area = std::get_if<AreaLight>(&light_)) {
      return shading::area_reflection(part.facets, area->two_sided, query);
    }
    return without_size(light_, query);
  }

  Light light_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
};

bool eye_is_above(const View& view) {
  return is_eye_above(visibility_of(view, ReflectionModel::phong, 0));
}

LightReflection::LightReflection(Light light, PreparedObstacles obstacles, const LinearSearch& search)
    : work_(std::make_unique<Work>(std::move(light), std::move(obstacles), search)) {}
LightReflection::LightReflection(LightReflection&&) noexcept = default;
LightReflection& LightReflection::operator=(LightReflection&&) noexcept = default;
LightReflection::~LightReflection() = default;

std::size_t LightReflection::answers() const {
  return work_->answers;
}

std::size_t LightReflection::exact_answers() const {
  return work_->exact_answers;
}

Reflection LightReflection::received(const ReceiverPoint& receiver, const View& view, ReflectionModel model,
                                     int exponent) {
  return work_->answer(receiver, visibility_of(view, model, exponent));
}

Reflection LightReflection::at(const View& view, ReflectionModel model, int exponent) {
  return received({view.point, FacingNormal{view.normal}}, view, model, exponent);
}

RadianceRgb light_radiance(const Light& light, const Rgb& strength, const Obstacles& obstacles, const View& view,
                           const Material& material) {
  LightReflection reflection(light, PreparedObstacles(obstacles));
  return reflected_radiance(reflection.at(view, material.model, material.exponent), material, strength);
}

}  // namespace gnomon
