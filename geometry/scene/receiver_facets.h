#pragma once

#include <span>
#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// Which sides of a receiver receive.
enum class ReceiverSides { front, both };

/// The flat convex pieces of a receiver, each receiving from its front.
///
/// Definition: a polygon is itself. Of a concave polygon `board` these are `board#0`, `board#1`, ..., of a polytope its
///             facets, seen from outside, of a mesh its facets in the order of the file, `vase#12`, or pieces of these,
///             `vase#12#0`, as of blockers. Of these, what is not exactly flat is a fan of triangles. With two
///             sides `vase/front#12` for all of them, and then `vase/back#12`, turned round.
/// Orientation: seen from the front the vertices run counterclockwise.
/// Exactness:  no vertex is constructed.
std::vector<SceneReceiver> receiver_facets(const std::string& name, const BlockerShape& shape, ReceiverSides sides);

/// Facets that belong together, one after the other.
using ReceiverGroup = std::span<const SceneReceiver>;

/// The receivers of the file, in their order.
std::vector<ReceiverGroup> receiver_elements(std::span<const SceneReceiver> facets);

/// The receivers of the file, each side of those with two by itself.
std::vector<ReceiverGroup> receiver_sides(std::span<const SceneReceiver> facets);

}  // namespace gnomon
