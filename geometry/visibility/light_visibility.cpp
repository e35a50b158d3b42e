#include "geometry/visibility/light_visibility.h"

#include <algorithm>
#include <utility>

#include "geometry/boxes.h"

namespace gnomon {
namespace {

/// The widest bound of a fraction that is handed on.
constexpr double widest_bound = 1e-6;

std::optional<Region> seen(FastPointVisibility& level, const Point3& p) {
  return level.region_from(p);
}

std::optional<Region> seen(FastPointVisibility& level, const ReceiverPoint& receiver) {
  return level.region_of(receiver);
}

template <class Level>
auto seen(Level& level, const Point3& p) {
  return level.seen_from(p);
}

template <class Level>
auto seen(Level& level, const ReceiverPoint& receiver) {
  return level.seen_by(receiver);
}

template <class Looking>
std::optional<Visibility> visibility(FastPointVisibility& level, const Looking& p) {
  const std::optional<Region> region = seen(level, p);
  if (!region) return std::nullopt;
  return Visibility{*region, *region == Region::lit ? 1.0 : 0.0, 0, *region == Region::unlit ? 0.0 : 1.0};
}

template <class Level, class Looking>
std::optional<Visibility> visibility(Level& level, const Looking& p) {
  const auto part = seen(level, p);
  if (!part) return std::nullopt;
  return Visibility{part->region, part->fraction, part->error_bound, part->before_receiver};
}

Visibility exact_answer(const Light& light, const Obstacles& obstacles, const Point3& p) {
  return exact_visibility(light, obstacles, p);
}

Visibility exact_answer(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver) {
  return exact_received(light, obstacles, receiver);
}

}  // namespace

PreparedObstacles::PreparedObstacles(Obstacles obstacles)
    : obstacles_(std::make_shared<const Obstacles>(std::move(obstacles))), blockers_(obstacles_->blockers) {
  for (const ClosedSurface& surface : obstacles_->enclosures) {
    if (!surface.vertices.empty()) enclosures_.push_back(box_around(surface.vertices));
  }
}

bool PreparedObstacles::may_enclose(const Point3& p) const {
  return std::any_of(enclosures_.begin(), enclosures_.end(), [&](const Box3& box) { return holds(box, p); });
}

FastLevel fast_level(const Light& light, const BlockerSet& blockers) {
  if (const auto* point = std::get_if<PointLight>(&light)) return FastPointVisibility(*point, blockers);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return FastPointVisibility(*sun, blockers);
  if (const auto* linear = std::get_if<LinearLight>(&light)) return FastLinearVisibility(*linear, blockers);
  return FastVisibility(std::get<AreaLight>(light), blockers);
}

LightVisibility::LightVisibility(Light light, PreparedObstacles obstacles)
    : light_(std::move(light)), obstacles_(std::move(obstacles)), fast_(fast_level(light_, obstacles_.blockers())) {}

template <class Looking>
std::optional<Visibility> LightVisibility::fast_answer(const Looking& p) {
  if (obstacles_.encloses(p)) return std::nullopt;
  const std::optional<Visibility> seen = std::visit([&](auto& level) { return visibility(level, p); }, fast_);
  if (!seen || !(seen->error_bound <= widest_bound)) return std::nullopt;
  return seen;
}

template <class Looking>
Visibility LightVisibility::answer(const Looking& p) {
  if (const std::optional<Visibility> fast = fast_answer(p)) return *fast;
  ++exact_answers_;
  return exact_answer(light_, obstacles_.obstacles(), p);
}

Visibility LightVisibility::at(const Point3& p) {
  return answer(p);
}

Visibility LightVisibility::received(const ReceiverPoint& receiver) {
  return answer(receiver);
}

}  // namespace gnomon
