#pragma once

#include <string>
#include <vector>

#include "gnomon/picture.h"
#include "viz/pictures/picture_source.h"

namespace gnomon::viz {

/// How many lights a picture can show: what several lights make of one receiver lies in one place.
enum class LightsShown { first, all_in_turn };

/// The part of a result that a picture shows: one light, or several of which a page shows one at a time; the receivers
/// asked for; the volumes of blockers that are one convex body, and those of parts if they are asked for.
///
/// Returns: `lights` and `light_count` are set. A light without any result is taken only where no light has one.
PictureSource selected(PictureSource source, const PictureSelection& selection, LightsShown lights);

/// The names of the lights that have results, or of all lights if none has, in the scene's order; and of the receivers.
ResultNames names_in(const PictureSource& source);

}  // namespace gnomon::viz
