#include "apps/gnomon/scene_discontinuities.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

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

/// A scene as the geometry takes it.
struct Parts {
  std::vector<ConvexBlocker> blockers;
  std::vector<ClosedSurface> enclosures;
  std::vector<ConvexPolygon> receivers;     ///< the flat ones
  std::vector<std::uint32_t> receiver_ids;  ///< of each, its index in Scene::receivers
};

std::string range_refusal(const std::string& element, std::span<const Point3> points) {
  if (std::all_of(points.begin(), points.end(), is_in_event_range)) return {};
  return element +
         " has a coordinate that is not zero and smaller than 2^-200 (6.2e-61) or larger than 2^200 (1.6e60); "
         "receivers are divided for coordinates in between";
}

/// Why the scene's numbers are not supported; empty if they are.
std::string range_refusal(const Scene& scene) {
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

Parts parts_of(const Scene& scene, DiscontinuityResult& result) {
  if (scene.dimension != 3) throw UnsupportedError("discontinuities on receivers need a scene of dimension 3");
  Parts parts;
  for (std::uint32_t b = 0; b < scene.blockers.size(); ++b) {
    for (ConvexPart& part : convex_parts(scene.blockers[b])) {
      parts.blockers.push_back(std::move(part.shape));
      result.blockers.push_back(std::move(part.name));
      result.blocker_ids.push_back(b);
    }
    if (auto space = enclosed_space(scene.blockers[b])) parts.enclosures.push_back(std::move(*space));
  }
  for (std::uint32_t r = 0; r < scene.receivers.size(); ++r) {
    if (!scene.receivers[r].shape.is_flat()) continue;
    parts.receivers.push_back(scene.receivers[r].shape);
    parts.receiver_ids.push_back(r);
  }
  return parts;
}

/// Why a light is not supported; empty if it is.
std::string refusal(const SceneLight& light, const Parts& parts) {
  const auto* area = std::get_if<AreaLight>(&light.shape);
  if (area && !area->polygon.is_flat()) return "its vertices are not exactly coplanar";
  for (const Point3& p : light_points(light.shape)) {
    for (const ClosedSurface& surface : parts.enclosures) {
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

LightChoice light_choice(const Scene& scene, const std::string& name, const Parts& parts) {
  require_name("--light", "light", name, scene.lights);
  LightChoice choice;
  for (std::uint32_t l = 0; l < scene.lights.size(); ++l) {
    const SceneLight& light = scene.lights[l];
    if (!is_asked_for(name, light.name)) continue;
    const std::string reason = refusal(light, parts);
    if (reason.empty()) {
      choice.supported.push_back(l);
    } else {
      choice.reasons += (choice.reasons.empty() ? "light '" : "; light '") + light.name + "': " + reason;
    }
  }
  return choice;
}

/// The lights asked for that are supported; the others are warned of.
std::vector<std::uint32_t> supported_lights(const Scene& scene, const std::string& name, const Parts& parts) {
  LightChoice choice = light_choice(scene, name, parts);
  if (choice.supported.empty() && !choice.reasons.empty()) throw UnsupportedError(scene.source + ": " + choice.reasons);
  if (!choice.reasons.empty()) print_warning(choice.reasons);
  return std::move(choice.supported);
}

bool is_chosen(const SceneReceiver& receiver, const std::string& name) {
  return name.empty() || receiver.is_called(name);
}

/// Warns of the receivers asked for that parts_of leaves out.
void warn_of_rounded(const Scene& scene, const std::string& asked_for) {
  for (const SceneReceiver& receiver : scene.receivers) {
    if (receiver.shape.is_flat() || !is_chosen(receiver, asked_for)) continue;
    print_warning("receiver '" + receiver.name + "' is left out: its vertices are not exactly coplanar");
  }
}

/// Why nothing that is asked for can be divided; empty if something can.
std::string division_refusal(const Scene& scene, const ReceiverSelection& selection) {
  const std::string range = range_refusal(scene);
  if (!range.empty()) return range;
  DiscontinuityResult unused{&scene, {}, {}, {}};
  const LightChoice choice = light_choice(scene, selection.light, parts_of(scene, unused));
  if (choice.supported.empty() && !choice.reasons.empty()) return choice.reasons;
  const bool any = std::any_of(scene.receivers.begin(), scene.receivers.end(), [&](const SceneReceiver& receiver) {
    return is_chosen(receiver, selection.receiver) && receiver.shape.is_flat();
  });
  return any ? "" : "no receiver asked for has exactly coplanar vertices";
}

}  // namespace

DiscontinuityResult divided_receivers(const Scene& scene, const ReceiverSelection& selection, VertexFractions fractions,
                                      const Effort& effort) {
  using enum Progress::Visibility;
  DiscontinuityResult result{&scene, {}, {}, {}};
  const Parts parts = parts_of(scene, result);
  if (const std::string refusal = range_refusal(scene); !refusal.empty()) {
    throw UnsupportedError(scene.source + ": " + refusal);
  }
  require_receiver("--receiver", selection.receiver, scene.receivers);
  const std::vector<std::uint32_t> lights = supported_lights(scene, selection.light, parts);
  warn_of_rounded(scene, selection.receiver);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t r = 0; r < parts.receivers.size(); ++r) {
    if (is_chosen(scene.receivers[parts.receiver_ids[r]], selection.receiver)) chosen.push_back(r);
  }
  if (chosen.empty() && !scene.receivers.empty()) {
    throw UnsupportedError(scene.source + ": no receiver asked for has exactly coplanar vertices");
  }
  std::vector<ConvexPolygon> receivers;
  for (const std::uint32_t r : chosen) receivers.push_back(parts.receivers[r]);
  Progress progress("receiver", lights.size() * chosen.size(), effort.shows_progress ? automatic : hidden);
  // Receivers are shared among threads, and few receivers each among several.
  const unsigned threads = thread_count(effort.threads);
  const unsigned for_each = std::max(1U, threads / static_cast<unsigned>(std::max<std::size_t>(1, chosen.size())));
  for (const std::uint32_t l : lights) {
    const ReceiverDivision division(scene.lights[l].shape, parts.blockers, receivers, threads);
    std::vector<std::optional<ReceiverResult>> made(chosen.size());
    for_all(chosen.size(), threads, [&](std::size_t i, std::size_t) {
      const auto r = static_cast<std::uint32_t>(i);
      const std::uint32_t id = parts.receiver_ids[chosen[i]];
      const SceneReceiver& receiver = scene.receivers[id];
      made[i] =
          ReceiverResult{l, id, scene.lights[l].name, receiver.name, division.mesh(r, for_each), {}, receiver.side};
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
  require_receiver("--receiver", selection.receiver, scene.receivers);
  if (scene.dimension != 3 || scene.receivers.empty() || scene.lights.empty()) return {};
  if (const std::string refusal = division_refusal(scene, selection); !refusal.empty()) {
    print_warning("receivers are not divided into regions: " + refusal);
    return {};
  }
  return divided_receivers(scene, selection, VertexFractions::left_out, effort).receivers;
}

DiscontinuityResult scene_surfaces(const Scene& scene, const std::string& light, const Box3& box,
                                   const Effort& effort) {
  using enum Progress::Visibility;
  DiscontinuityResult result{&scene, box, {}, {}};
  const Parts parts = parts_of(scene, result);
  const std::vector<std::uint32_t> lights = supported_lights(scene, light, parts);
  warn_of_rounded(scene, {});
  Progress progress("light", lights.size(), effort.shows_progress ? automatic : hidden);
  std::vector<SurfaceResult> made(lights.size());
  for_all(lights.size(), thread_count(effort.threads), [&](std::size_t i, std::size_t) {
    const SceneLight& l = scene.lights[lights[i]];
    made[i] = {lights[i], l.name, discontinuity_surfaces(l.shape, parts.blockers, parts.receivers, box)};
    progress.step();
  });
  result.surfaces = std::move(made);
  return result;
}

}  // namespace gnomon
