#include "geometry/visibility/light_visibility.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

/// The widest bound of a fraction that is handed on.
constexpr double widest_bound = 1e-6;

Box3 box_around(const ClosedSurface& surface) {
  Box3 box{surface.vertices.front(), surface.vertices.front()};
  for (const Point3& p : surface.vertices) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

bool is_within(const Box3& box, const Point3& p) {
  return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z &&
         p.z <= box.max.z;
}

std::optional<Visibility> visibility(FastPointVisibility& level, const Point3& p) {
  const std::optional<Region> region = level.region_from(p);
  if (!region) return std::nullopt;
  return Visibility{*region, *region == Region::lit ? 1.0 : 0.0, 0};
}

template <class Level>
std::optional<Visibility> visibility(Level& level, const Point3& p) {
  const auto seen = level.seen_from(p);
  if (!seen) return std::nullopt;
  return Visibility{seen->region, seen->fraction, seen->error_bound};
}

}  // namespace

PreparedObstacles::PreparedObstacles(Obstacles obstacles)
    : obstacles_(std::make_shared<const Obstacles>(std::move(obstacles))), blockers_(obstacles_->blockers) {
  for (const ClosedSurface& surface : obstacles_->enclosures) {
    if (!surface.vertices.empty()) enclosures_.push_back(box_around(surface));
  }
}

bool PreparedObstacles::may_enclose(const Point3& p) const {
  return std::any_of(enclosures_.begin(), enclosures_.end(), [&](const Box3& box) { return is_within(box, p); });
}

FastLevel fast_level(const Light& light, const BlockerSet& blockers) {
  if (const auto* point = std::get_if<PointLight>(&light)) return FastPointVisibility(*point, blockers);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return FastPointVisibility(*sun, blockers);
  if (const auto* linear = std::get_if<LinearLight>(&light)) return FastLinearVisibility(*linear, blockers);
  return FastVisibility(std::get<AreaLight>(light), blockers);
}

LightVisibility::LightVisibility(Light light, PreparedObstacles obstacles)
    : light_(std::move(light)), obstacles_(std::move(obstacles)), fast_(fast_level(light_, obstacles_.blockers())) {}

std::optional<Visibility> LightVisibility::fast_answer(const Point3& p) {
  if (obstacles_.may_enclose(p)) return std::nullopt;
  const std::optional<Visibility> seen = std::visit([&](auto& level) { return visibility(level, p); }, fast_);
  if (!seen || !(seen->error_bound <= widest_bound)) return std::nullopt;
  return seen;
}

Visibility LightVisibility::at(const Point3& p) {
  if (const std::optional<Visibility> fast = fast_answer(p)) return *fast;
  ++exact_answers_;
  return exact_visibility(light_, obstacles_.obstacles(), p);
}

}  // namespace gnomon
