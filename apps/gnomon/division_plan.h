#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// Which lights and receivers are asked for, by name; an empty name asks for all.
struct ReceiverSelection {
  std::string light;
  std::string receiver;
};

/// What is made of a scene: divided receivers, or the surfaces that divide them.
enum class DivisionOf { receivers, surfaces };

/// What of a scene is asked for and supported. The scene outlives it.
struct DivisionPlan {
  const Scene* scene;
  const SpaceScene* space;
  SceneBodies bodies;
  std::vector<std::uint32_t> lights;     ///< indices into the scene's
  std::vector<std::uint32_t> receivers;  ///< the same
  std::string refusal;                   ///< why nothing can be made; empty if something can
  std::vector<std::string> left_out;     ///< what is not supported beside what is, and why
};

/// Throws: UsageError for a name that the scene does not have; UnsupportedError for a scene of the plane.
DivisionPlan division_plan(const Scene& scene, const ReceiverSelection& selection, DivisionOf subject);

}  // namespace gnomon
