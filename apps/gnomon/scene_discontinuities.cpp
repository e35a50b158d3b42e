#include "apps/gnomon/scene_discontinuities.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/receiver_rows.h"
#include "geometry/parallel.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

/// Why the scene's numbers are not supported; empty if they are.
std::string range_refusal(const SpaceScene& scene) {
  std::string refusal;
  const auto look = [&](std::string_view kind, const std::string& name, std::string_view found) {
    if (refusal.empty() && !found.empty()) refusal = std::string(kind) + " '" + name + "' " + std::string(found);
  };
  for (const SceneLight& l : scene.lights) look("light", l.name, range_refusal(l.shape));
  for (const SceneBlocker& b : scene.blockers) look("blocker", b.name, range_refusal(blocker_points(b.shape)));
  for (const SceneReceiver& r : scene.receivers) look("receiver", r.name, range_refusal(r.shape.points()));
  return refusal;
}

/// Adds the lights asked for that are supported; why others are not.
std::string choose_lights(DivisionPlan& plan, const std::string& name) {
  const std::vector<SceneLight>& lights = plan.space->lights;
  require_name("--light", "light", name, lights);
  std::string reasons;
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    if (!is_asked_for(name, lights[l].name)) continue;
    const std::string_view reason = division_refusal(lights[l].shape, plan.bodies.obstacles.enclosures);
    if (reason.empty()) {
      plan.lights.push_back(l);
    } else {
      reasons += (reasons.empty() ? "light '" : "; light '") + lights[l].name + "': " + std::string(reason);
    }
  }
  return reasons;
}

void choose_receivers(DivisionPlan& plan, const std::string& name) {
  const std::vector<SceneReceiver>& receivers = plan.space->receivers;
  require_receiver("--receiver", name, receivers);
  for (std::uint32_t r = 0; r < receivers.size(); ++r) {
    if (!name.empty() && !receivers[r].is_called(name)) continue;
    plan.receivers.push_back(r);
  }
}

std::vector<ConvexPolygon> receivers_of(const DivisionPlan& plan) {
  std::vector<ConvexPolygon> receivers;
  for (const std::uint32_t r : plan.receivers) receivers.push_back(plan.space->receivers[r].shape);
  return receivers;
}

}  // namespace

DivisionPlan division_plan(const Scene& scene, const ReceiverSelection& selection, DivisionOf subject) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  if (!space)
    throw UnsupportedError(facts(scene).source + ": discontinuities on receivers need a scene of dimension 3");
  DivisionPlan plan{&scene, space, scene_bodies(*space), {}, {}, {}, {}};
  if (subject == DivisionOf::receivers) plan.refusal = range_refusal(*space);
  const std::string lights_left_out = choose_lights(plan, selection.light);
  if (!lights_left_out.empty()) plan.left_out.push_back(lights_left_out);
  if (plan.lights.empty() && plan.refusal.empty()) plan.refusal = lights_left_out;
  choose_receivers(plan, selection.receiver);
  return plan;
}

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
