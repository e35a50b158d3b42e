#include "apps/gnomon/division_plan.h"

#include <string_view>
#include <variant>

#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/receiver_rows.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/receiver_mesh.h"

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

}  // namespace gnomon
