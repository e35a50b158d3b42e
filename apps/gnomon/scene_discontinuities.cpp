#include "apps/gnomon/scene_discontinuities.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/receiver_rows.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/discontinuity/event_range.h"
#include "geometry/parallel.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

const SpaceScene& space_of(const Scene& scene) {
  if (const auto* space = std::get_if<SpaceScene>(&scene)) return *space;
  throw UnsupportedError("discontinuities on receivers need a scene of dimension 3");
}

std::string range_refusal(const std::string& element, std::span<const Point3> points) {
  if (std::all_of(points.begin(), points.end(), is_in_event_range)) return {};
  return element +
         " has a coordinate that is not zero and smaller than 2^-200 (6.2e-61) or larger than 2^200 (1.6e60); "
         "receivers are divided for coordinates in between";
}

/// Why the scene's numbers are not supported; empty if they are.
std::string range_refusal(const SpaceScene& scene) {
  std::string refusal;
  const auto look = [&](const std::string& element, std::span<const Point3> points) {
    if (refusal.empty()) refusal = range_refusal(element, points);
  };
  for (const SceneLight& light : scene.lights) {
    look("light '" + light.name + "'", light_points(light.shape));
    if (const auto* parallel = std::get_if<DirectionalLight>(&light.shape)) {
      look("light '" + light.name + "'", {&parallel->direction, 1});
    }
  }
  for (const SceneBlocker& blocker : scene.blockers) {
    look("blocker '" + blocker.name + "'", blocker_points(blocker.shape));
  }
  for (const SceneReceiver& receiver : scene.receivers) {
    look("receiver '" + receiver.name + "'", receiver.shape.points());
  }
  return refusal;
}

/// Why a light is not supported; empty if it is.
std::string refusal(const SceneLight& light, const SceneBodies& bodies) {
  const auto* area = std::get_if<AreaLight>(&light.shape);
  if (area && !area->polygon.is_flat()) return "its vertices are not exactly coplanar";
  for (const Point3& p : light_points(light.shape)) {
    for (const ClosedSurface& surface : bodies.obstacles.enclosures) {
      if (is_strictly_inside(p, surface)) return "it lies inside a closed mesh";
    }
  }
  return {};
}

/// The lights asked for that are supported, by their index, and why others are not.
struct LightChoice {
  std::vector<std::uint32_t> supported;
  std::string reasons;
};

LightChoice light_choice(const SpaceScene& scene, const std::string& name, const SceneBodies& bodies) {
  require_name("--light", "light", name, scene.lights);
  LightChoice choice;
  for (std::uint32_t l = 0; l < scene.lights.size(); ++l) {
    const SceneLight& light = scene.lights[l];
    if (!is_asked_for(name, light.name)) continue;
    const std::string reason = refusal(light, bodies);
    if (reason.empty()) {
      choice.supported.push_back(l);
    } else {
      choice.reasons += (choice.reasons.empty() ? "light '" : "; light '") + light.name + "': " + reason;
    }
  }
  return choice;
}

/// The lights asked for that are supported; the others are warned of.
std::vector<std::uint32_t> supported_lights(const SpaceScene& scene, const std::string& name,
                                            const SceneBodies& bodies) {
  LightChoice choice = light_choice(scene, name, bodies);
  if (choice.supported.empty() && !choice.reasons.empty()) throw UnsupportedError(scene.source + ": " + choice.reasons);
  if (!choice.reasons.empty()) print_warning(choice.reasons);
  return std::move(choice.supported);
}

bool is_chosen(const SceneReceiver& receiver, const std::string& name) {
  return name.empty() || receiver.is_called(name);
}

/// Asked for and flat.
bool is_divided(const SceneReceiver& receiver, const std::string& name) {
  return is_chosen(receiver, name) && receiver.shape.is_flat();
}

/// Warns of the receivers asked for that are not flat.
void warn_of_rounded(const SpaceScene& scene, const std::string& asked_for) {
  for (const SceneReceiver& receiver : scene.receivers) {
    if (receiver.shape.is_flat() || !is_chosen(receiver, asked_for)) continue;
    print_warning("receiver '" + receiver.name + "' is left out: its vertices are not exactly coplanar");
  }
}

/// Why nothing that is asked for can be divided; empty if something can.
std::string division_refusal(const SpaceScene& scene, const SceneBodies& bodies, const ReceiverSelection& selection) {
  const std::string range = range_refusal(scene);
  if (!range.empty()) return range;
  const LightChoice choice = light_choice(scene, selection.light, bodies);
  if (choice.supported.empty() && !choice.reasons.empty()) return choice.reasons;
  const bool any = std::any_of(scene.receivers.begin(), scene.receivers.end(),
                               [&](const SceneReceiver& receiver) { return is_divided(receiver, selection.receiver); });
  return any ? "" : "no receiver asked for has exactly coplanar vertices";
}

DiscontinuityResult divided_receivers(const Scene& scene, const SceneBodies& bodies, const ReceiverSelection& selection,
                                      VertexFractions fractions, const Effort& effort) {
  using enum Progress::Visibility;
  const SpaceScene& space = space_of(scene);
  if (const std::string refusal = range_refusal(space); !refusal.empty()) {
    throw UnsupportedError(space.source + ": " + refusal);
  }
  require_receiver("--receiver", selection.receiver, space.receivers);
  const std::vector<std::uint32_t> lights = supported_lights(space, selection.light, bodies);
  warn_of_rounded(space, selection.receiver);
  std::vector<ConvexPolygon> receivers;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t r = 0; r < space.receivers.size(); ++r) {
    if (!is_divided(space.receivers[r], selection.receiver)) continue;
    receivers.push_back(space.receivers[r].shape);
    ids.push_back(r);
  }
  if (ids.empty() && !space.receivers.empty()) {
    throw UnsupportedError(space.source + ": no receiver asked for has exactly coplanar vertices");
  }
  DiscontinuityResult result{&scene, {}, bodies.names, bodies.blocker_ids};
  Progress progress("receiver", lights.size() * ids.size(), effort.shows_progress ? automatic : hidden);
  // Receivers are shared among threads, and few receivers each among several.
  const unsigned threads = thread_count(effort.threads);
  const unsigned for_each = std::max(1U, threads / static_cast<unsigned>(std::max<std::size_t>(1, ids.size())));
  for (const std::uint32_t l : lights) {
    const ReceiverDivision division(space.lights[l].shape, bodies.obstacles.blockers, receivers, threads);
    std::vector<std::optional<ReceiverResult>> made(ids.size());
    for_all(ids.size(), threads, [&](std::size_t i, std::size_t) {
      const auto r = static_cast<std::uint32_t>(i);
      const SceneReceiver& receiver = space.receivers[ids[i]];
      made[i] =
          ReceiverResult{l, ids[i], space.lights[l].name, receiver.name, division.mesh(r, for_each), {}, receiver.side};
      if (fractions == VertexFractions::worked_out) {
        made[i]->visible_fractions = division.visible_fractions(r, made[i]->mesh, for_each);
      }
      progress.step();
    });
    for (auto& one : made) result.receivers.push_back(std::move(*one));
  }
  return result;
}

}  // namespace

DiscontinuityResult divided_receivers(const Scene& scene, const ReceiverSelection& selection, VertexFractions fractions,
                                      const Effort& effort) {
  return divided_receivers(scene, scene_bodies(space_of(scene)), selection, fractions, effort);
}

std::vector<ReceiverResult> receivers_beside_volumes(const Scene& scene, const ReceiverSelection& selection,
                                                     const Effort& effort) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  require_receiver("--receiver", selection.receiver, space ? space->receivers : std::vector<SceneReceiver>{});
  if (!space || space->receivers.empty() || space->lights.empty()) return {};
  const SceneBodies bodies = scene_bodies(*space);
  if (const std::string refusal = division_refusal(*space, bodies, selection); !refusal.empty()) {
    print_warning("receivers are not divided into regions: " + refusal);
    return {};
  }
  return divided_receivers(scene, bodies, selection, VertexFractions::left_out, effort).receivers;
}

DiscontinuityResult scene_surfaces(const Scene& scene, const std::string& light, const Box3& box,
                                   const Effort& effort) {
  using enum Progress::Visibility;
  const SpaceScene& space = space_of(scene);
  const SceneBodies bodies = scene_bodies(space);
  const std::vector<std::uint32_t> lights = supported_lights(space, light, bodies);
  warn_of_rounded(space, {});
  std::vector<ConvexPolygon> receivers;
  for (const SceneReceiver& receiver : space.receivers) {
    if (is_divided(receiver, {})) receivers.push_back(receiver.shape);
  }
  Progress progress("light", lights.size(), effort.shows_progress ? automatic : hidden);
  std::vector<SurfaceResult> made(lights.size());
  for_all(lights.size(), thread_count(effort.threads), [&](std::size_t i, std::size_t) {
    const SceneLight& l = space.lights[lights[i]];
    made[i] = {lights[i], l.name, discontinuity_surfaces(l.shape, bodies.obstacles.blockers, receivers, box)};
    progress.step();
  });
  return {&scene, box, bodies.names, bodies.blocker_ids, {}, std::move(made)};
}

}  // namespace gnomon
