#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/bodies/boxes.h"
#include "geometry/visibility/linear_search/occluder_index.h"
#include "geometry/visibility/prepared_obstacles.h"

namespace gnomon {
namespace {

/// The widest bound of a fraction that is handed on.
constexpr double widest_bound = 1e-6;

std::optional<Region> visible(FastPointVisibility& level, const Point3& p) {
  return level.region_from(p);
}

std::optional<Region> visible(FastPointVisibility& level, const ReceiverPoint& receiver) {
  return level.region_of(receiver);
}

template <class Level>
auto visible(Level& level, const Point3& p) {
  return level.visible_from(p);
}

template <class Level>
auto visible(Level& level, const ReceiverPoint& receiver) {
  return level.visible_by(receiver);
}

template <class Viewer>
std::optional<Visibility> visibility(FastPointVisibility& level, const Viewer& p) {
  const std::optional<Region> region = visible(level, p);
  if (!region) return std::nullopt;
  return Visibility{*region, *region == Region::lit ? 1.0 : 0.0, 0, *region == Region::unlit ? 0.0 : 1.0};
}

template <class Level, class Viewer>
std::optional<Visibility> visibility(Level& level, const Viewer& p) {
  const auto part = visible(level, p);
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

PreparedObstacles::Content::Content(Obstacles given) : obstacles(std::move(given)), blockers(obstacles.blockers) {
  for (const ClosedSurface& surface : obstacles.enclosures) {
    if (!surface.vertices.empty()) enclosures_.push_back(box_around(surface.vertices));
  }
}

bool PreparedObstacles::Content::may_enclose(const Point3& p) const {
  return std::any_of(enclosures_.begin(), enclosures_.end(), [&](const Box3& box) { return holds(box, p); });
}

PreparedObstacles::PreparedObstacles(Obstacles obstacles)
    : content_(std::make_shared<const Content>(std::move(obstacles))) {}

const Obstacles& PreparedObstacles::obstacles() const {
  return content_->obstacles;
}

std::shared_ptr<const viewpoint::OccluderIndex> PreparedObstacles::Content::occluders(
    const LinearLight& light, const LinearSearch& search) const {
  const std::lock_guard lock(making_);
  std::erase_if(made_, [](const Made& made) { return made.index.expired(); });
  for (const Made& made : made_) {
    if (made.start != light.start || made.end != light.end || made.search != search) continue;
    if (std::shared_ptr<const viewpoint::OccluderIndex> index = made.index.lock()) return index;
  }
  auto index = std::make_shared<const viewpoint::OccluderIndex>(light, blockers, search);
  made_.push_back({light.start, light.end, search, index});
  return index;
}

std::shared_ptr<PatientShadowTree> PreparedObstacles::Content::shadow_tree(const ShadowTree::SmallLight& light) const {
  const auto* sun = std::get_if<DirectionalLight>(&light);
  const Point3 place = sun ? sun->direction : std::get<PointLight>(light).position;
  const std::lock_guard lock(making_);
  std::erase_if(planted_, [](const Planted& planted) { return planted.tree.expired(); });
  for (const Planted& planted : planted_) {
    if (planted.is_sun != (sun != nullptr) || planted.place != place) continue;
    if (std::shared_ptr<PatientShadowTree> tree = planted.tree.lock()) return tree;
  }
  auto tree = std::make_shared<PatientShadowTree>(light, obstacles.blockers);
  planted_.push_back({sun != nullptr, place, tree});
  return tree;
}

FastLevel fast_level(const Light& light, const PreparedObstacles& obstacles, const LinearSearch& search, Trees trees) {
  const PreparedObstacles::Content& content = obstacles.content();
  const BlockerSet& blockers = content.blockers;
  const auto small = [&](const ShadowTree::SmallLight& small_light) {
    const bool grown = trees == Trees::grown;
    return FastPointVisibility(small_light, blockers, grown ? content.shadow_tree(small_light) : nullptr);
  };
  if (const auto* point = std::get_if<PointLight>(&light)) return small(*point);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return small(*sun);
  if (const auto* linear = std::get_if<LinearLight>(&light)) {
    return FastLinearVisibility(*linear, content.occluders(*linear, search));
  }
  return FastVisibility(std::get<AreaLight>(light), blockers);
}

class LightVisibility::Work {
 public:
  Work(Light light, PreparedObstacles obstacles, const LinearSearch& search)
      : light_(std::move(light)),
        obstacles_(std::move(obstacles)),
        fast_(fast_level(light_, obstacles_, search, Trees::grown)) {}

  template <class Viewer>
  Visibility answer(const Viewer& p) {
    if (const std::optional<Visibility> fast = fast_answer(p)) return *fast;
    ++exact_answers_;
    return exact_answer(light_, obstacles_.obstacles(), p);
  }

  std::size_t exact_answers() const { return exact_answers_; }

 private:
  template <class Viewer>
  std::optional<Visibility> fast_answer(const Viewer& p) {
    if (obstacles_.content().encloses(p)) return std::nullopt;
    const std::optional<Visibility> seen = std::visit([&](auto& level) { return visibility(level, p); }, fast_);
    if (!seen || !(seen->error_bound <= widest_bound)) return std::nullopt;
    return seen;
  }

  Light light_;
  PreparedObstacles obstacles_;
  FastLevel fast_;
  std::size_t exact_answers_ = 0;
};

LightVisibility::LightVisibility(Light light, PreparedObstacles obstacles, const LinearSearch& search)
    : work_(std::make_unique<Work>(std::move(light), std::move(obstacles), search)) {}
LightVisibility::LightVisibility(LightVisibility&&) noexcept = default;
LightVisibility& LightVisibility::operator=(LightVisibility&&) noexcept = default;
LightVisibility::~LightVisibility() = default;

Visibility LightVisibility::at(const Point3& p) {
  return work_->answer(p);
}

Visibility LightVisibility::received(const ReceiverPoint& receiver) {
  return work_->answer(receiver);
}

std::size_t LightVisibility::exact_answers() const {
  return work_->exact_answers();
}

Visibility light_visibility(const Light& light, const Obstacles& obstacles, const Point3& p) {
  return LightVisibility(light, PreparedObstacles(obstacles)).at(p);
}

}  // namespace gnomon
