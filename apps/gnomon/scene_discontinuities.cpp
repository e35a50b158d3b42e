#include "apps/gnomon/scene_discontinuities.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "apps/gnomon/console.h"
#include "apps/gnomon/receiver_rows.h"
#include "geometry/parallel.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

std::vector<ConvexPolygon> receivers_of(const DivisionPlan& plan) {
  std::vector<ConvexPolygon> receivers;
  for (const std::uint32_t r : plan.receivers) receivers.push_back(plan.space->receivers[r].shape);
  return receivers;
}

}  // namespace

void tell_left_out(const DivisionPlan& plan) {
  if (!plan.refusal.empty()) throw UnsupportedError(plan.space->source + ": " + plan.refusal);
  for (const std::string& sentence : plan.left_out) print_warning(sentence);
}

DiscontinuityResult divided_receivers(const DivisionPlan& plan, VertexFractions fractions, const Effort& effort) {
  using enum Progress::Visibility;
  const std::vector<ConvexPolygon> receivers = receivers_of(plan);
  DiscontinuityResult result{plan.scene, {}, plan.bodies.names, plan.bodies.blocker_ids};
  Progress progress("receiver", plan.lights.size() * receivers.size(), effort.shows_progress ? automatic : hidden);
  // Receivers are shared among threads, and few receivers each among several.
  const unsigned threads = thread_count(effort.threads);
  const unsigned for_each = std::max(1U, threads / static_cast<unsigned>(std::max<std::size_t>(1, receivers.size())));
  for (const std::uint32_t l : plan.lights) {
    const SceneLight& light = plan.space->lights[l];
    const ReceiverDivision division(light.shape, plan.bodies.obstacles.blockers, receivers, threads,
                                    plan.bodies.obstacles.enclosures);
    std::vector<std::optional<ReceiverResult>> made(receivers.size());
    for_all(receivers.size(), threads, [&](std::size_t i, std::size_t) {
      const auto r = static_cast<std::uint32_t>(i);
      const SceneReceiver& receiver = plan.space->receivers[plan.receivers[i]];
      made[i] = ReceiverResult{l,  plan.receivers[i], light.name, receiver.name, division.mesh(r, for_each),
                               {}, receiver.side};
      if (fractions == VertexFractions::worked_out) {
        made[i]->visible_fractions = division.visible_fractions(r, made[i]->mesh, for_each);
      }
      progress.step();
    });
    for (auto& one : made) result.receivers.push_back(std::move(*one));
  }
  return result;
}

std::vector<ReceiverResult> receivers_beside_volumes(const Scene& scene, const ReceiverSelection& selection,
                                                     const Effort& effort) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  require_receiver("--receiver", selection.receiver, space ? space->receivers : std::vector<SceneReceiver>{});
  if (!space || space->receivers.empty() || space->lights.empty()) return {};
  const DivisionPlan plan = division_plan(scene, selection, DivisionOf::receivers);
  if (!plan.refusal.empty()) {
    print_warning("receivers are not divided into regions: " + plan.refusal);
    return {};
  }
  tell_left_out(plan);
  return divided_receivers(plan, VertexFractions::left_out, effort).receivers;
}

DiscontinuityResult scene_surfaces(const DivisionPlan& plan, const Box3& box, const Effort& effort) {
  using enum Progress::Visibility;
  const std::vector<ConvexPolygon> receivers = receivers_of(plan);
  Progress progress("light", plan.lights.size(), effort.shows_progress ? automatic : hidden);
  std::vector<SurfaceResult> made(plan.lights.size());
  for_all(made.size(), thread_count(effort.threads), [&](std::size_t i, std::size_t) {
    const SceneLight& l = plan.space->lights[plan.lights[i]];
    made[i] = {plan.lights[i], l.name, discontinuity_surfaces(l.shape, plan.bodies.obstacles.blockers, receivers, box)};
    progress.step();
  });
  return {plan.scene, box, plan.bodies.names, plan.bodies.blocker_ids, {}, std::move(made)};
}

}  // namespace gnomon
